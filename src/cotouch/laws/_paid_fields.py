"""Where `paid` keeps what: fields and numbers of a copy, of an end, and of a message."""

# Of a copy; the past of x̂ and v̂ follows the fields, its times the numbers.
W, WISH, FELT, X, V, X_BEFORE, V_BEFORE, X_RATE, V_RATE, F_RATE, ALL_W, ALL_P, ALL_Q = range(13)
ASKED, TOUCH, TOLD, WAY, ACTING, EXERTED = range(13, 19)
PAST, KEPT, EVERY = 19, 128, 0.004
ACCOUNT, TIME, K, LEVEL, EPOCH, XX, XV, VV, XF, VF = range(10)
HELD, COUNT, BRAKE, OWN_B, NEW_K, NEW_B, STEADY = range(10, 17)
ALL_K, ALL_B, ALL_EPOCH, ALL_HANDS = range(17, 21)  # of the hands that all links bring
AS_ONE, GRASPED, ALL_GRASPED, LONGEST, BACK, DEGREE, NEWEST, GRASPED_AT, UNHEARD = range(21, 30)
TIMES = 30

# Of an end. What is alive is where the neighbour's hand acts or acted; elsewhere all that is kept of it is 0.
WAVE_IN, WAVE_OUT, WAVE, A, A2, WISHED, W_LAST, SLOPE, PART_W, STRETCH, SUM, SUM2, HAND, DONE = range(14)
SUM_THERE, SUM2_THERE, PART_P, PART_Q, ALIVE, GRIP = range(14, 20)
E_IN, E_OUT, AGE, CREDITED, GIVEN, KNOWN, HORIZON, STAMP, SPAN = range(9)
PART_K, PART_B, PART_EPOCH, PART_HANDS, TOLD_EPOCH, SINCE, ROUNDS, PART_GRASPED = range(9, 17)
CHECKED, RIGHT, GUESSED, SETTLED, TELLS = range(17, 22)
EVENLY = 22  # and one for each other axis
# What was done to the copy by a hand is kept at every so many of the times at which its past is kept.
LOG, EACH = 20, 4
LOGGED = KEPT // EACH
# So is what the neighbour's hand was guessed to do beyond the own one and, of the copy, the own hand's force.
GUESS, EVEN_GUESS, EVEN_TRUTH = range(LOG + LOGGED, LOG + LOGGED + 3)
GUESSES = EVEN_TRUTH + 1
FORCES = PAST + 2 * KEPT

# Of a message.
M_WAVE, M_P, M_Q, M_W, M_V, M_WAY = range(6)
M_E, M_K, M_B, M_EPOCH, M_GIVEN, M_T, M_HANDS, M_AS_ONE, M_SINCE, M_AGE = range(10)

# Parameters.
SEED, FLOOR, BETA, GK, GD, LINE, MASS, AHEAD, CALM, FORCE_LIMIT, RELAY, STILL, LIGHTEST = range(13)
# What a hand may be [N/m, Ns/m].
STIFFEST, DAMPEST = 5000.0, 100.0
