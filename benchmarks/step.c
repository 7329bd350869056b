/* The step of a copy with one off-diagonal family, identity weights and hands at single nodes, as the package does it
   where its Chebyshev iteration serves: the same passes over memory, for judging what the compiler of the package's
   kernels leaves. */
#include <math.h>
#include <stdint.h>

typedef double vec __attribute__((vector_size(32), aligned(8)));

static inline double total(vec a) { return a[0] + a[1] + a[2] + a[3]; }

enum { ROWS, LINKS, PORTS, SAMPLE, CAP, STEPS, SPLIT };
enum { SHARE, MIX_B, MIX_K, LOCAL, TOLERANCE };
enum { LENGTH, MASS, DAMPING, STIFFNESS, POINTER, COLUMN, ENTRIES, MAGNITUDE, X, V, TENSION, SAMPLES, STRENGTH, PORT_ROW,
       PORT_K, PORT_B, START, END, PUSH, FORCE, DIAGONAL, INVERSE, RHS, MEAN, BOOKS, LINK_WORK };

static long advance(const long *size, const double *number, void **array, double T) {
    const long rows = size[ROWS], links = size[LINKS], ports = size[PORTS], split = size[SPLIT];
    const double share = number[SHARE], mix_b = number[MIX_B], mix_k = number[MIX_K], tol = number[TOLERANCE];
    const double *mass = array[MASS], *damping = array[DAMPING], *stiffness = array[STIFFNESS];
    const double *entries = array[ENTRIES], *magnitude = array[MAGNITUDE], *strength = array[STRENGTH], *pk = array[PORT_K], *pb = array[PORT_B];
    const int32_t *pointer = array[POINTER], *column = array[COLUMN], *port = array[PORT_ROW];
    const vec *start = array[START], *end = array[END], *push = array[PUSH];
    vec *restrict x = array[X], *restrict v = array[V], *restrict tension = array[TENSION], *restrict samples = array[SAMPLES];
    vec *restrict rhs = array[RHS], *restrict mean = array[MEAN], *force = array[FORCE];
    double *restrict diagonal = array[DIAGONAL], *restrict inverse = array[INVERSE];
    double *books = array[BOOKS], *link_work = array[LINK_WORK];
    const double half = 0.5 * T, inertia = 2.0 * share / T;
    double gain = number[LOCAL];
    const vec zero = {0};

    for (long l = 0; l < links; l++) gain += half * strength[l];
    for (long i = 0; i < rows; i++) {
        diagonal[i] = inertia * mass[i] + share * damping[i] + half * share * stiffness[i] + gain;
        vec b = inertia * mass[i] * v[i] - share * tension[i];
        for (long l = 0; l < links; l++) b -= strength[l] * (x[i] - samples[l * rows + i]);
        rhs[i] = b;
    }
    for (long p = 0; p < ports; p++) {
        const long i = port[p];
        diagonal[i] += pb[p] + half * pk[p];
        rhs[i] += 0.5 * pk[p] * (start[p] + end[p]) + pb[p] / T * (end[p] - start[p]) + push[p] - pk[p] * x[i];
    }

    const double scale = share * mix_b + half * share * mix_k;
    double bound = 0.0;
    for (long i = 0; i < rows; i++) {
        inverse[i] = 1.0 / diagonal[i];
        bound = fmax(bound, fabs(scale) * magnitude[i] * inverse[i]);
    }
    const double square = bound * bound, cut = sqrt((1.0 + square) / (1.0 - square)) / tol;
    const double enough = ceil(0.5 * (acosh(fmax(cut, 1.0)) / acosh(1.0 / bound) + 1.0));
    const long iterations = enough < size[CAP] ? (long)enough : size[CAP];
    for (long i = 0; i < rows; i++) mean[i] = i < split ? inverse[i] * rhs[i] : zero;
    double weight = 2.0;
    for (long k = 1; k < 2 * iterations; k++) {
        weight = k < 2 * iterations - 1 ? 1.0 / (1.0 - 0.25 * square * weight) : 1.0;
        const long first = k % 2 ? split : 0, last = k % 2 ? rows : split;
        for (long i = first; i < last; i++) {
            vec off = zero;
            for (int32_t e = pointer[i]; e < pointer[i + 1]; e++) off += entries[e] * mean[column[e]];
            mean[i] += weight * (inverse[i] * (rhs[i] - scale * off) - mean[i]);
        }
    }
    vec work = zero, left = zero;
    for (long i = 0; i < split; i++) {
        vec off = zero;
        for (int32_t e = pointer[i]; e < pointer[i + 1]; e++) off += entries[e] * mean[column[e]];
        work += mean[i] * rhs[i];
        left += mean[i] * (rhs[i] - diagonal[i] * mean[i] - scale * off);
    }
    for (long i = split; i < rows; i++) work += mean[i] * rhs[i];
    const double supply = total(work), missed = total(left);
    for (long i = 0; i < rows; i++) mean[i] *= supply / (supply - missed);

    double supplied = 0.0;
    for (long p = 0; p < ports; p++) {
        const long i = port[p];
        const vec rate = mean[i], stretch = 0.5 * (start[p] + end[p]) - (x[i] + half * rate);
        force[p] = pk[p] * stretch + pb[p] * ((end[p] - start[p]) / T - rate) + push[p];
        supplied += T * total(force[p] * rate);
    }
    for (long l = 0; l < links; l++) {
        vec power = zero;
        for (long i = 0; i < rows; i++) power += mean[i] * (x[i] + half * mean[i] - samples[l * rows + i]);
        link_work[l] = -T * strength[l] * total(power);
    }
    vec speed = zero, kinetic = zero, elastic = zero, lost = zero;
    for (long i = 0; i < rows; i++) {
        const vec rate = mean[i], here = x[i];
        samples[size[SAMPLE] * rows + i] = here + half * rate;
        x[i] = here + T * rate;
        v[i] = 2.0 * rate - v[i];
        speed += rate * rate;
    }
    for (long i = 0; i < rows; i++) {
        vec pull = zero, drag = zero;
        for (int32_t e = pointer[i]; e < pointer[i + 1]; e++) {
            pull += entries[e] * x[column[e]];
            drag += entries[e] * mean[column[e]];
        }
        const vec stress = stiffness[i] * x[i] + mix_k * pull;
        tension[i] = stress;
        kinetic += mass[i] * v[i] * v[i];
        elastic += x[i] * stress;
        lost += mean[i] * (damping[i] * mean[i] + mix_b * drag);
    }
    books[0] = supplied;
    books[1] = T * share * total(lost);
    books[2] = T * number[LOCAL] * total(speed);
    books[4] = 0.5 * share * total(kinetic);
    books[5] = 0.5 * share * total(elastic);
    return iterations;
}

long run(const long *size, const double *number, void **array) {
    const double *length = array[LENGTH];
    long iterations = 0;
    for (long k = 0; k < size[STEPS]; k++) iterations += advance(size, number, array, length[k]);
    return iterations;
}
