/* Stands in for Force Dimension's libdrd (which holds libdhd): the functions that we use, with the signatures of dhdc.h
   3.17 and drdc.h. Checks the order of calls, and keeps to the return codes of the manual. $COTOUCH_STANDIN names the
   board of the device; without one no device is connected. */
#include "device.h"
#include <stdbool.h>

static volatile struct board *b;
static int expert;
static const char *last = "no error";
static double held[3], moving[3], frame[9], spinning[3];

static volatile struct board *device(void) { return b; }

/* Every call that names a device must name what drdOpenID returned: -1 if it cannot be reached. */
static int reach(char ID, const char *name) {
  if (!device() || ID != b->offset || b->open != getpid()) {
    violated(b, name);
    last = "invalid device";
    return -1;
  }
  if (faulty(b, UNPLUGGED)) {
    last = "communication error between the host and the device";
    return -1;
  }
  return 0;
}

const char *dhdErrorGetLastStr(void) { return last; }
int dhdGetDeviceCount(void) {
  if (!b || b->open != getpid()) b = map_board(getenv("COTOUCH_STANDIN"));
  return device() && b->fault != UNPLUGGED ? 1 : 0;
}

int drdOpenID(char ID) {
  if (!device() || ID != 0) { last = "no device found"; return -1; }
  if (b->fault == REFUSED) { last = "device is already in use by another application"; return -1; }
  if (taken(b) && b->open == getpid()) violated(b, "drdOpenID: open already");
  if (taken(b)) { last = "device is already in use by another application"; return -1; }
  b->open = getpid();
  b->gravity = b->emulated = 0; /* forces stay as they were left, which may be on */
  b->commanded = now();
  return b->offset;
}

int drdClose(char ID) {
  if (!device() || !b->open || ID != b->offset) { violated(b, "drdClose"); last = "invalid device"; return -1; }
  b->open = 0;
  b->enabled = 0;
  for (int a = 0; a < 3; a++) b->force[a] = b->torque[a] = 0.0;
  return 0;
}

int dhdGetSystemType(char ID) { return reach(ID, "dhdGetSystemType") ? -1 : b->system; }
bool drdIsInitialized(char ID) { return reach(ID, "drdIsInitialized") ? false : b->initialized == 1; }
int drdAutoInit(char ID) {
  if (reach(ID, "drdAutoInit")) return -1;
  if (b->fault == REFUSED) { last = "cannot find the index of an encoder"; return -1; }
  b->initialized = 1;
  b->enabled = 1; /* it regulates, and its motors stay on when it ends */
  b->commanded = now();
  return 0;
}
int drdStop(bool force, char ID) {
  if (reach(ID, "drdStop")) return -1;
  if (!force) violated(b, "drdStop: brakes");
  return 0;
}
int dhdWaitForReset(int timeout, char ID) {
  if (reach(ID, "dhdWaitForReset")) return -1;
  for (int ms = 0; ms < timeout && b->initialized != 1; ms++) rest(1e-3);
  if (b->initialized == 1) return 0;
  last = "timeout";
  return -1;
}

int dhdEnableExpertMode(void) { expert = 1; return 0; }
int dhdDisableExpertMode(void) { expert = 0; return 0; }
int dhdSetWatchdog(unsigned char val, char ID) {
  if (reach(ID, "dhdSetWatchdog")) return -1;
  if (!expert) { violated(b, "dhdSetWatchdog: expert mode is off"); last = "expert mode disabled"; return -1; }
  if (b->system == 60) { last = "command not available on this device"; return -1; }
  b->watchdog = 125e-6 * val;
  return 0;
}
static unsigned threshold = 50;
int dhdSetVelocityThreshold(unsigned val, char ID) {
  if (reach(ID, "dhdSetVelocityThreshold")) return -1;
  if (!expert) { violated(b, "dhdSetVelocityThreshold: expert mode is off"); last = "expert mode disabled"; return -1; }
  threshold = val;
  return 0;
}
int dhdGetVelocityThreshold(unsigned *val, char ID) {
  if (reach(ID, "dhdGetVelocityThreshold")) return -1;
  if (!expert) { violated(b, "dhdGetVelocityThreshold: expert mode is off"); last = "expert mode disabled"; return -1; }
  *val = threshold;
  return 0;
}
int dhdSetMaxForce(double f, char ID) {
  if (reach(ID, "dhdSetMaxForce")) return -1;
  b->max_force = f;
  return 0;
}
int dhdSetGravityCompensation(int val, char ID) {
  if (reach(ID, "dhdSetGravityCompensation")) return -1;
  b->gravity = val;
  return 0;
}
int dhdEmulateButton(unsigned char val, char ID) {
  if (reach(ID, "dhdEmulateButton")) return -1;
  int grips = b->system == 35 || b->system == 37 || (b->system >= 102 && b->system <= 105) || b->system == 209;
  if (!grips) { last = "command not available on this device"; return -1; }
  b->emulated = val;
  return 0;
}
int dhdEnableForce(unsigned char val, char ID) {
  if (reach(ID, "dhdEnableForce")) return -1;
  if (val) { for (int a = 0; a < 3; a++) b->force[a] = b->torque[a] = 0.0; b->commanded = now(); b->cause = 0; }
  b->enabled = val ? 1 : 0;
  return 0;
}
int dhdStop(char ID) {
  if (reach(ID, "dhdStop")) return -1;
  b->enabled = 0;
  return 0;
}

int dhdGetPosition(double *px, double *py, double *pz, char ID) {
  if (reach(ID, "dhdGetPosition")) return -1;
  if (faulty(b, SLOW)) rest(b->value);
  double *out[3] = {px, py, pz};
  int frozen = faulty(b, FROZEN) || faulty(b, TIME_GUARD);
  for (int a = 0; a < 3; a++) {
    if (!frozen) held[a] = place(b, a);
    *out[a] = held[a];
  }
  if (faulty(b, NOT_A_NUMBER)) *px = NAN;
  return faulty(b, TIME_GUARD) ? 1 : 0;
}
int dhdGetLinearVelocity(double *vx, double *vy, double *vz, char ID) {
  if (reach(ID, "dhdGetLinearVelocity")) return -1;
  double *out[3] = {vx, vy, vz};
  int frozen = faulty(b, FROZEN);
  for (int a = 0; a < 3; a++) {
    if (!frozen) moving[a] = b->velocity[a];
    *out[a] = moving[a];
  }
  return 0;
}
bool dhdHasActiveWrist(char ID) { return reach(ID, "dhdHasActiveWrist") ? false : b->wrist; }
int dhdGetOrientationFrame(double *matrix, char ID) {
  if (reach(ID, "dhdGetOrientationFrame")) return -1;
  if (!faulty(b, FROZEN) && !faulty(b, STUCK)) rotation(b, frame);
  memcpy(matrix, frame, sizeof frame);
  if (faulty(b, BENT)) matrix[4] = NAN;
  return 0;
}
int dhdGetAngularVelocityRad(double *wx, double *wy, double *wz, char ID) {
  if (reach(ID, "dhdGetAngularVelocityRad")) return -1;
  double *out[3] = {wx, wy, wz};
  for (int a = 0; a < 3; a++) {
    if (!faulty(b, FROZEN)) spinning[a] = b->spin[a];
    *out[a] = spinning[a];
  }
  return 0;
}
int dhdSetMaxTorque(double t, char ID) {
  if (reach(ID, "dhdSetMaxTorque")) return -1;
  b->max_torque = t;
  return 0;
}
int dhdSetForce(double fx, double fy, double fz, char ID) { /* what torque there is stays */
  if (reach(ID, "dhdSetForce")) return -1;
  if (faulty(b, SAFETY)) { last = "redundant encoders disagree"; return -1; }
  double f[3] = {fx, fy, fz}, size = sqrt(fx * fx + fy * fy + fz * fz);
  if (!isfinite(size)) { violated(b, "dhdSetForce: not a number"); last = "invalid parameter"; return -1; }
  double share = b->max_force > 0.0 && size > b->max_force ? b->max_force / size : 1.0;
  for (int a = 0; a < 3; a++) b->force[a] = share * f[a];
  b->commanded = now();
  b->sets++;
  b->pushes += size > 0.0;
  return share < 1.0 ? 2 : 0;
}
int dhdSetForceAndTorque(double fx, double fy, double fz, double tx, double ty, double tz, char ID) {
  int code = dhdSetForce(fx, fy, fz, ID);
  if (code < 0) return -1;
  double t[3] = {tx, ty, tz}, size = sqrt(tx * tx + ty * ty + tz * tz);
  if (!isfinite(size)) { violated(b, "dhdSetForceAndTorque: not a number"); last = "invalid parameter"; return -1; }
  if (!b->wrist) violated(b, "dhdSetForceAndTorque: no wrist");
  double share = b->max_torque > 0.0 && size > b->max_torque ? b->max_torque / size : 1.0;
  for (int a = 0; a < 3; a++) b->torque[a] = share * t[a];
  return share < 1.0 ? 2 : code;
}
int dhdGetForceAndTorque(double *fx, double *fy, double *fz, double *tx, double *ty, double *tz, char ID) {
  if (reach(ID, "dhdGetForceAndTorque")) return -1;
  *fx = b->force[0]; *fy = b->force[1]; *fz = b->force[2];
  *tx = b->torque[0]; *ty = b->torque[1]; *tz = b->torque[2];
  return 0;
}
int dhdGetForce(double *fx, double *fy, double *fz, char ID) {
  if (reach(ID, "dhdGetForce")) return -1;
  *fx = b->force[0]; *fy = b->force[1]; *fz = b->force[2];
  return 0;
}
unsigned dhdGetButtonMask(char ID) { return reach(ID, "dhdGetButtonMask") ? 0 : (unsigned)b->buttons; }
int dhdGetStatus(int status[17], char ID) {
  if (reach(ID, "dhdGetStatus")) return -1;
  memset(status, 0, 17 * sizeof(int));
  b->asked++;
  status[0] = status[1] = status[2] = 1;
  status[5] = b->enabled;
  status[6] = !b->enabled;
  status[14] = b->cause;
  return 0;
}
