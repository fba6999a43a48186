// SPDX-License-Identifier: MIT
/* UMATs that fail. PROPS(1): the number of the point that does (NOEL), and all above it. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#define UMAT(name)                                                                                              \
  void name(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl, \
            double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time,        \
            double* dtime, double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi,  \
            int* nshr, int* ntens, int* nstatv, double* props, int* nprops, double* coords, double* drot,       \
            double* pnewdt, double* celent, double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer,    \
            int* kspt, int* kstep, int* kinc, size_t cmname_length)

UMAT(no_number) {
  for (int i = 0; i < *ntens; ++i) stress[i] += 1;
  statev[0] += 1;
  if (*noel >= props[0]) stress[1] = sqrt(-1 - dstran[0] * dstran[0]);
}

UMAT(no_state) {
  stress[0] += 1;
  if (*noel >= props[0]) statev[0] = 1 / (stress[3] - stress[3]);
}

UMAT(smaller_step) {
  stress[0] += 1;
  if (*noel >= props[0]) *pnewdt = 0.25;
}

UMAT(too_many_states) {
  stress[0] += 1;
  if (*noel >= props[0]) statev[*nstatv] = 0;
}

UMAT(too_long_stress) {
  for (int i = 0; i < 12; ++i) stress[i] += 1;
}

UMAT(abort_) { abort(); }

UMAT(exit_) {
  if (time[0] > 0) exit(0);
}

UMAT(endless) {
  volatile int turns = 0;
  for (;;) turns = turns + 1;
}
