// SPDX-License-Identifier: MIT
// One thread per element: the point pass of src/mpm/step/block_pass.hpp with T = double in place of a pack. Compiled only.

#include "mpm/step/kernels.hpp"

namespace talus::cuda {

template <int D>
struct ElementData {
  const double* acceleration;  ///< [element][D+1][D] [m/s²]
  const double* velocity;      ///< [element][D+1][D] [m/s]
  const double* gradients;     ///< [element][D*D] [1/m]
  double* points;              ///< [element][slot][field]
  const int* count;            ///< points per element
  double* sums;                ///< [element][D+1][1+2D]
  int elements, slots;
};

template <int D, class Law>
__global__ void advance_points(ElementData<D> data, const Law* law, double dt) {
  constexpr int NS = material::stress_size<D>, fields = 2 * D + NS + 2 + Law::state_size;
  const int e = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (e >= data.elements) return;
  double a[D + 1][D], v[D + 1][D], g[D * D];
  for (int k = 0; k <= D; ++k) {
    for (int d = 0; d < D; ++d) {
      a[k][d] = data.acceleration[(e * (D + 1) + k) * D + d];
      v[k][d] = data.velocity[(e * (D + 1) + k) * D + d];
    }
  }
  for (int i = 0; i < D * D; ++i) g[i] = data.gradients[e * D * D + i];
  const mpm::ElementMotion<D, double> motion(a, v, g, dt);
  const mpm::Rotation<D, double> rotation(motion.grad);
  double d_epsilon[NS];
  motion.strain(d_epsilon);
  mpm::ElementSums<D, double> sums;
  for (int k = 0; k < data.count[e]; ++k) {
    double* p = data.points + (static_cast<long long>(e) * data.slots + k) * fields;
    double *xi = p, *u = p + D, *s = p + 2 * D, *state = s + NS + 2;
    motion.advance_velocity(xi, u);
    motion.advance_position(xi);
    rotation.apply(s);
    law->template update<NS>(s, d_epsilon, state, true);
    s[NS] *= 1 + d_epsilon[0] + d_epsilon[1] + d_epsilon[2];
    sums.add(s[NS + 1], s[NS], xi, u, s);
  }
  double out[D + 1][1 + 2 * D];
  sums.to_nodes(g, out);
  for (int k = 0; k <= D; ++k) {
    for (int q = 0; q < 1 + 2 * D; ++q) data.sums[(e * (D + 1) + k) * (1 + 2 * D) + q] = out[k][q];
  }
}

template __global__ void advance_points<2, material::MohrCoulomb>(ElementData<2>, const material::MohrCoulomb*, double);
template __global__ void advance_points<3, material::MohrCoulomb>(ElementData<3>, const material::MohrCoulomb*, double);
template __global__ void advance_points<2, material::LinearElastic>(ElementData<2>, const material::LinearElastic*, double);
template __global__ void advance_points<3, material::LinearElastic>(ElementData<3>, const material::LinearElastic*, double);

}  // namespace talus::cuda
