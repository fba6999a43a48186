// SPDX-License-Identifier: MIT
/* Linear elasticity as a UMAT in C. PROPS: Young's modulus [Pa], Poisson's ratio [-]. */
#include <stddef.h>

void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
           double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time, double* dtime,
           double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi, int* nshr, int* ntens,
           int* nstatv, double* props, int* nprops, double* coords, double* drot, double* pnewdt, double* celent,
           double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer, int* kspt, int* kstep, int* kinc,
           size_t cmname_length) {
  const double mu = props[0] / (2 * (1 + props[1]));
  const double lambda = 2 * mu * props[1] / (1 - 2 * props[1]);
  const double volume = lambda * (dstran[0] + dstran[1] + dstran[2]);
  for (int i = 0; i < *ndi; ++i) stress[i] += volume + 2 * mu * dstran[i];
  for (int i = *ndi; i < *ntens; ++i) stress[i] += mu * dstran[i];
  for (int i = 0; i < *ntens; ++i) {
    for (int j = 0; j < *ntens; ++j)
      ddsdde[i * *ntens + j] = (i < *ndi && j < *ndi ? lambda : 0) + (i == j ? (i < *ndi ? 2 * mu : mu) : 0);
  }
}
