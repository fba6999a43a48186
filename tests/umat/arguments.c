// SPDX-License-Identifier: MIT
/* A UMAT that returns its arguments, so that a test can check every one of them. */
#include <math.h>
#include <stddef.h>
#include <string.h>

void arguments(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
               double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time,
               double* dtime, double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi,
               int* nshr, int* ntens, int* nstatv, double* props, int* nprops, double* coords, double* drot,
               double* pnewdt, double* celent, double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer,
               int* kspt, int* kstep, int* kinc, size_t cmname_length) {
  const double calls = statev[0] + 1;
  /* Stress: which component is which. */
  for (int i = 0; i < *ntens; ++i) stress[i] = 10 * stress[i] + dstran[i];
  double identity = 0;
  for (int i = 0; i < 9; ++i) {
    const double one = i % 4 == 0;
    identity += fabs(drot[i] - one) + fabs(dfgrd0[i] - one) + fabs(dfgrd1[i] - one);
  }
  for (int i = 0; i < *ntens * *ntens; ++i) ddsdde[i] = 1; /* the array must be allocated */
  for (int i = 0; i < *ntens; ++i) ddsddt[i] = drplde[i] = 1;
  const double told[20] = {
      calls,
      *ndi,
      *nshr,
      *ntens,
      *nstatv,
      *nprops,
      props[*nprops - 1],
      predef[0],
      time[0],
      time[1],
      *dtime,
      *noel,
      *npt + 10.0 * *layer + 100.0 * *kspt,
      kstep[0] + 10.0 * *kinc,
      (double)cmname_length + (strncmp(cmname, "clay of Oslo  ", 14) == 0 ? 0.5 : 0) + (cmname[79] == ' ' ? 0.25 : 0),
      stran[*ntens - 1],
      identity,
      isnan(coords[0]) && isnan(coords[2]) && isnan(*celent),
      *sse + *scd + *rpl + *drpldt + *temp + *dtemp + dpred[0],
      *pnewdt};
  memcpy(statev, told, sizeof told);
  *spd += 7;
}
