/* The device itself, in a process of its own: motors, a mass in a hand, and what its firmware does when nobody speaks.
   Usage: firmware board log. Every change of what the motors do goes into the log: time, three forces and three torques, as doubles. */
#include "device.h"

int main(int count, char **arguments) {
  if (count != 3) return 2;
  volatile struct board *b = map_board(arguments[1]);
  int log = open(arguments[2], O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (!b || log < 0) return 2;
  const double mass = 0.8, damping = 6.45, stiffness = 135.0, radius = 0.03, turn = 6.283185307;
  int pressed = 0, off = 0;
  double q[4] = {0, 0, 0, 1}, w[3] = {0, 0, 0};
  double x[3] = {0, 0, 0}, v[3] = {0, 0, 0}, begun = now(), then = begun;
  while (!b->stop && now() - begun < 120.0) {
    double t = now();
    if (b->fault == UNPLUGGED && b->enabled) { b->enabled = 0; b->cause = 5; }
    if (b->fault == TAKEN_AWAY && b->enabled) {
      if (b->struck == 0.0) b->struck = t;
      b->enabled = 0;
      b->cause = (int32_t)b->value;
    }
    /* The force button takes force away at one press and gives it back at the next. */
    if (b->force_button != pressed) {
      pressed = b->force_button;
      if (pressed % 2) { off = b->enabled; b->enabled = 0; b->cause = 1; }
      else { b->enabled = off; b->cause = 0; }
    }
    if (b->enabled && b->watchdog > 0.0 && t - b->commanded > b->watchdog) { b->enabled = 0; b->cause = 3; }
    double record[7] = {t, 0, 0, 0, 0, 0, 0};
    int changed = 0;
    for (int a = 0; a < 3; a++) {
      double f = b->enabled ? b->force[a] : 0.0;
      changed |= f != b->motor[a];
      b->motor[a] = record[a + 1] = f;
      double twist = b->enabled && b->wrist ? b->torque[a] : 0.0;
      changed |= twist != b->twist[a];
      b->twist[a] = record[a + 4] = twist;
    }
    if (changed && write(log, record, sizeof record) != sizeof record) return 1;
    for (double left = t - then; left > 0.0; left -= 5e-4) {
      double T = left < 5e-4 ? left : 5e-4;
      for (int a = 0; a < 3; a++) {
        double hand = radius * sin(turn * (t - begun) + a);
        v[a] += T / mass * (stiffness * (hand - x[a]) - damping * v[a] + b->motor[a]);
        x[a] += T * v[a];
      }
      /* A handle of 1e-4 kg m^2 in a hand that turns it to and fro about all three axes. */
      double qx = q[0], qy = q[1], qz = q[2], qw = q[3];
      for (int a = 0; a < 3; a++) {
        double hand = 0.3 * sin(turn * (t - begun) + a);
        w[a] += T / 1e-4 * (1.0 * (hand - 2.0 * q[a] * (qw < 0 ? -1 : 1)) - 0.02 * w[a] + b->twist[a]) / (1.0 + T * 0.02 / 1e-4);
      }
      q[0] += 0.5 * T * (w[0] * qw + w[1] * qz - w[2] * qy);
      q[1] += 0.5 * T * (w[1] * qw + w[2] * qx - w[0] * qz);
      q[2] += 0.5 * T * (w[2] * qw + w[0] * qy - w[1] * qx);
      q[3] -= 0.5 * T * (w[0] * qx + w[1] * qy + w[2] * qz);
      double size = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      for (int a = 0; a < 4; a++) q[a] /= size;
    }
    for (int a = 0; a < 4; a++) b->turned[a] = q[a];
    for (int a = 0; a < 3; a++) b->spin[a] = w[a];
    then = t;
    for (int a = 0; a < 3; a++) { b->position[a] = x[a]; b->velocity[a] = v[a]; }
    b->stamp = t;
    rest(2e-4);
  }
  return 0;
}
