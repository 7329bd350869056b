/* Stands in for OpenHaptics' libHD: the functions that we use, with the signatures of hd.h 3.4, and a scheduler in a
   thread of its own. Checks that frames are begun and ended in that thread. $COTOUCH_STANDIN names the board of the
   device; without one no device is connected. Forces of a frame act when it ends, and stay until the next. */
#include "device.h"
#include <pthread.h>

typedef unsigned int HDuint, HDenum, HDerror, HHD, HDCallbackCode;
typedef struct { HDerror errorCode; int internalErrorCode; HHD hHD; } HDErrorInfo;
typedef HDCallbackCode (*HDSchedulerCallback)(void *);

static volatile struct board *b;
static HDErrorInfo errors[16];
static int count, framed, running, ran;
static double force[3], torque[3], held[3], moving[3];
static HDSchedulerCallback callback;
static void *data;
static pthread_t thread;

static void raise_error(HDerror code) {
  if (count < 16) errors[count++] = (HDErrorInfo){code, 0, 1};
}

HDErrorInfo hdGetError(void) { return count ? errors[--count] : (HDErrorInfo){0, 0, 1}; }
const char *hdGetErrorString(HDerror code) {
  switch (code) {
    case 0x0200: return "Motors are too warm";
    case 0x0300: return "Device fault; check the connection";
    case 0x0302: return "Communication error";
    default: return "Some error";
  }
}

HHD hdInitDevice(const char *name) {
  if (!b || b->open != getpid()) b = map_board(getenv("COTOUCH_STANDIN"));
  if (!b || b->fault == UNPLUGGED || (name && strcmp(name, "Default Device"))) { raise_error(0x0300); return 0xFFFFFFFF; }
  if (taken(b)) { raise_error(0x0301); return 0xFFFFFFFF; }
  b->open = getpid();
  b->protect = 0; /* forces stay as they were left, which may be on */
  count = framed = 0;
  return 1;
}
void hdMakeCurrentDevice(HHD device) { if (device != 1) raise_error(0x0104); }
const char *hdGetString(HDenum what) { return what == 0x2501 ? "Touch" : ""; }

void hdEnable(HDenum what) {
  if (what >= 0x4001 && what <= 0x4003) b->protect |= 1 << (what - 0x4001);
  if (what != 0x4000) return;
  if (b->protect != 7) violated(b, "hdEnable: force without clamping, ramping, limit");
  for (int a = 0; a < 3; a++) b->force[a] = b->torque[a] = 0.0;
  b->commanded = now();
  b->enabled = 1;
}
void hdDisable(HDenum what) { if (what == 0x4000 && b) b->enabled = 0; }

void hdBeginFrame(HHD device) {
  if (device != 1) raise_error(0x0104);
  if (framed || (running && !pthread_equal(pthread_self(), thread))) violated(b, "hdBeginFrame");
  framed = 1;
  for (int a = 0; a < 3; a++) force[a] = 0.0;
}
void hdEndFrame(HHD device) {
  (void)device;
  if (!framed) { violated(b, "hdEndFrame"); raise_error(0x0401); return; }
  framed = 0;
  if (faulty(b, SAFETY)) raise_error((HDerror)b->value);
  if (faulty(b, UNPLUGGED)) { raise_error(0x0302); return; }
  for (int a = 0; a < 3; a++) { b->force[a] = force[a]; b->torque[a] = 1e-3 * torque[a]; } /* which stays unless set */
  b->commanded = now();
  b->sets++;
}

void hdGetDoublev(HDenum what, double *out) {
  int frozen = faulty(b, FROZEN);
  switch (what) {
    case 0x2050:
      if (!framed) { violated(b, "hdGetDoublev: no frame"); raise_error(0x0402); }
      if (faulty(b, SLOW)) rest(b->value);
      for (int a = 0; a < 3; a++) { if (!frozen) held[a] = 1e3 * place(b, a); out[a] = held[a]; }
      out[1] += 10.0; /* the middle of the workspace is 10 mm up */
      if (faulty(b, NOT_A_NUMBER)) out[0] = NAN;
      break;
    case 0x2051:
      for (int a = 0; a < 3; a++) { if (!frozen) moving[a] = 1e3 * b->velocity[a]; out[a] = moving[a]; }
      break;
    case 0x2052:
      memset(out, 0, 16 * sizeof(double));
      out[0] = out[5] = out[10] = out[15] = 1.0;
      if (b->wrist) {
        double m[9];
        rotation(b, m);
        for (int a = 0; a < 9; a++) out[a % 3 * 4 + a / 3] = m[a];
      }
      if (faulty(b, BENT)) out[5] = NAN;
      break;
    case 0x2551: {
      double box[6] = {-80, -50, -35, 80, 70, 35};
      memcpy(out, box, sizeof box);
      break;
    }
    case 0x2603: out[0] = 3.3; break;
    case 0x2604: out[0] = 0.88; break;
    case 0x2622: out[0] = b->wrist ? 515.0 : 0.0; break;
    case 0x2623: out[0] = b->wrist ? 40.0 : 0.0; break;
    default: raise_error(0x0100);
  }
}
void hdGetIntegerv(HDenum what, int *out) {
  if (what == 0x2000) *out = b->buttons;
  else if (what == 0x2554) *out = b->wrist ? 6 : 3;
  else if (what == 0x2555) *out = b->styles ? b->styles : 4;
  else raise_error(0x0100);
}
void hdSetDoublev(HDenum what, const double *in) {
  if (what != 0x2700 && !(what == 0x2701 && b->wrist)) { raise_error(0x0100); return; }
  if (!framed) { violated(b, "hdSetDoublev: no frame"); raise_error(0x0402); return; }
  if (!isfinite(in[0] + in[1] + in[2])) { violated(b, "hdSetDoublev: not a number"); raise_error(0x0101); return; }
  for (int a = 0; a < 3; a++) { if (what == 0x2700) force[a] = in[a]; else torque[a] = in[a]; }
}

HDenum hdCheckCalibration(void) {
  if (!framed) violated(b, "hdCheckCalibration: no frame");
  return b->initialized == 1 ? 0x5000 : b->initialized == 2 ? 0x5001 : 0x5002;
}
void hdUpdateCalibration(HDenum style) {
  int styles = b->styles ? b->styles : 4;
  if ((style & (style - 1)) || !(style & (HDenum)styles)) violated(b, "hdUpdateCalibration: one style that it has");
  else if (b->enabled) violated(b, "hdUpdateCalibration: with force");
  else if (b->initialized == 2 || style == 1) { b->initialized = 1; b->asked++; }
  else violated(b, "hdUpdateCalibration: not yet");
}

static void *schedule(void *unused) {
  while (running) {
    if (callback && !faulty(b, SILENT) && callback(data) == 0) callback = NULL;
    rest(9e-4);
  }
  return unused;
}
unsigned long hdScheduleAsynchronous(HDSchedulerCallback function, void *argument, unsigned short priority) {
  (void)priority;
  if (callback) raise_error(0x0501);
  callback = function;
  data = argument;
  return 7;
}
void hdUnschedule(unsigned long handle) {
  if (handle != 7) raise_error(0x0104);
  callback = NULL;
}
void hdStartScheduler(void) {
  if (running) { violated(b, "hdStartScheduler: runs already"); return; }
  running = 1;
  b->cause = b->enabled; /* whether its motors were on when its servo began */
  ran = pthread_create(&thread, NULL, schedule, NULL) == 0;
}
void hdStopScheduler(void) {
  if (!running) return;
  if (pthread_equal(pthread_self(), thread)) { violated(b, "hdStopScheduler: from a callback"); return; }
  running = 0;
  if (ran) pthread_join(thread, NULL);
}
void hdDisableDevice(HHD device) {
  if (device != 1) return;
  if (running) violated(b, "hdDisableDevice: the scheduler runs");
  b->enabled = 0;
  b->open = 0;
}
