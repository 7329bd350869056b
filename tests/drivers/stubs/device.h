/* What a stub library and the firmware of its device share: a page of memory in a file. Offsets are in board.py. */
#ifndef COTOUCH_DEVICE_H
#define COTOUCH_DEVICE_H
#define _GNU_SOURCE
#include <fcntl.h>
#include <signal.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

enum fault {
  NO_FAULT = 0, UNPLUGGED = 1, NOT_A_NUMBER = 2, FROZEN = 3, SLOW = 4, TAKEN_AWAY = 5, REFUSED = 6, SILENT = 7, SAFETY = 8,
  TIME_GUARD = 18, STUCK = 19, BENT = 20
};

struct board {
  double force[3];     /*   0 that the host commanded [N], in the vendor's axes */
  double commanded;    /*  24 when [s] */
  int32_t enabled;     /*  32 motors follow */
  int32_t cause;       /*  36 why the firmware took forces away; 0: it did not */
  double watchdog;     /*  40 [s]; 0: none */
  int32_t fault;       /*  48 injected */
  int32_t stop;        /*  52 the firmware ends */
  double value;        /*  56 of the fault */
  double struck;       /*  64 when the fault was first met [s] */
  double position[3];  /*  72 [m] */
  double velocity[3];  /*  96 [m/s] */
  int32_t initialized; /* 120 1: positions are absolute; 2: an update is needed; 0: a hand is needed */
  int32_t buttons;     /* 124 */
  int32_t violations;  /* 128 calls that the vendor's manual forbids */
  int32_t system;      /* 132 kind of device */
  double motor[3];     /* 136 force that the motors have [N] */
  double max_force;    /* 160 that the host allowed [N] */
  int32_t open;        /* 168 process that has it; 0: none */
  int32_t sets;        /* 172 forces set so far */
  char said[64];       /* 176 the last violation */
  double stamp;        /* 240 of position and velocity [s] */
  int32_t styles;      /* 248 of calibration, as a mask; 0: by the inkwell */
  int32_t protect;     /* 252 protections of the library that are on, bit 0 to 2 */
  int32_t gravity;     /* 256 it is compensated */
  int32_t asked;       /* 260 how often the status was asked */
  int32_t pushes;      /* 264 forces set so far that were not zero */
  int32_t force_button;/* 268 of the force button: odd while it keeps forces away */
  int32_t emulated;    /* 272 a closed gripper counts as a button */
  int32_t offset;      /* 276 what drdOpenID returns beyond the index */
  double torque[3];    /* 280 that the host commanded [Nm] */
  double twist[3];     /* 304 torque that the motors have [Nm] */
  double max_torque;   /* 328 that the host allowed [Nm] */
  int32_t wrist;       /* 336 it has motors that turn the handle */
  int32_t unused;      /* 340 */
  double turned[4];    /* 344 orientation of the handle, xyzw */
  double spin[3];      /* 376 its angular velocity [rad/s] */
};

/* The rotation of the handle, by rows. */
static inline void rotation(volatile struct board *b, double m[9]) {
  double x = b->turned[0], y = b->turned[1], z = b->turned[2], w = b->turned[3];
  double r[9] = {
    1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
    2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
    2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)};
  memcpy(m, r, sizeof r);
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void rest(double seconds) {
  struct timespec t = {(time_t)seconds, (long)(1e9 * (seconds - (double)(time_t)seconds))};
  nanosleep(&t, NULL);
}

static volatile struct board *map_board(const char *path) {
  int file = path ? open(path, O_RDWR) : -1;
  if (file < 0) return NULL;
  void *page = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return page == MAP_FAILED ? NULL : page;
}

/* Whether a living program has it: the system closes what a dead one had open. */
static inline int taken(volatile struct board *b) { return b->open && kill(b->open, 0) == 0; }

static inline void violated(volatile struct board *b, const char *what) {
  if (!b) return;
  b->violations++;
  strncpy((char *)b->said, what, 63);
}

/* Where the tip is now, on the way that it had when the firmware looked last: on a busy machine that was a while ago. */
static inline double place(volatile struct board *b, int a) {
  double since = now() - b->stamp;
  return b->position[a] + b->velocity[a] * (since < 0.2 ? since : 0.2);
}

/* Whether a fault is on; notes when it was first met. */
static inline int faulty(volatile struct board *b, int fault) {
  if (!b || b->fault != fault) return 0;
  if (b->struck == 0.0) b->struck = now();
  return 1;
}
#endif
