/* The device itself, in a process of its own: motors, a mass in a hand, and what its firmware does when nobody speaks.
   Usage: firmware board log. Every change of the motors' force goes into the log: time and three forces, as doubles. */
#include "device.h"

int main(int count, char **arguments) {
  if (count != 3) return 2;
  volatile struct board *b = map_board(arguments[1]);
  int log = open(arguments[2], O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (!b || log < 0) return 2;
  const double mass = 0.8, damping = 6.45, stiffness = 135.0, radius = 0.03, turn = 6.283185307;
  int pressed = 0, off = 0;
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
    double record[4] = {t, 0, 0, 0};
    int changed = 0;
    for (int a = 0; a < 3; a++) {
      double f = b->enabled ? b->force[a] : 0.0;
      changed |= f != b->motor[a];
      b->motor[a] = record[a + 1] = f;
    }
    if (changed && write(log, record, sizeof record) != sizeof record) return 1;
    for (double left = t - then; left > 0.0; left -= 5e-4) {
      double T = left < 5e-4 ? left : 5e-4;
      for (int a = 0; a < 3; a++) {
        double hand = radius * sin(turn * (t - begun) + a);
        v[a] += T / mass * (stiffness * (hand - x[a]) - damping * v[a] + b->motor[a]);
        x[a] += T * v[a];
      }
    }
    then = t;
    for (int a = 0; a < 3; a++) { b->position[a] = x[a]; b->velocity[a] = v[a]; }
    b->stamp = t;
    rest(2e-4);
  }
  return 0;
}
