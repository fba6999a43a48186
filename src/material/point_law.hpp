// SPDX-License-Identifier: MIT
#pragma once
// Lanes of laws that are computed point by point, because they iterate or have parameters of their own at every point.

#include "material/linear_elastic.hpp"

namespace talus::material {

/// Calls update_point(sigma, d_epsilon, state, around) for every active lane, with `States` state variables, and
/// collects the responses.
template <int NS, int States, class T>
Response<T> update_points(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active, const Surroundings<T>& around,
                          auto&& update_point) {
  if constexpr (std::is_same_v<T, double>) {
    return active ? update_point(sigma, d_epsilon, state, around) : Response<double>{false, 0.0, 0.0};
  } else {
    Response<T> response{false, T(0.0), T(0.0)};
    for (int l = 0; l < LaneTraits<T>::width; ++l) {
      if (!active[l]) continue;
      double s[NS], d[NS], q[States];
      for (int i = 0; i < NS; ++i) s[i] = sigma[i][l];
      for (int i = 0; i < NS; ++i) d[i] = d_epsilon[i][l];
      for (int i = 0; i < States; ++i) q[i] = state[i][l];
      Surroundings<double> own{around.saturation[l]};
      own.time = around.time, own.dt = around.dt, own.gaps = around.gaps;
      Softening<double> softening;
      if (around.softening) {
        softening.nonlocal_correction = around.softening->nonlocal_correction[l];
        own.softening = &softening;
      }
      const Response<double> one = update_point(s, d, q, own);
      response.any_plastic = response.any_plastic || one.any_plastic;
      response.plastic_dilation.value[l] = one.plastic_dilation;
      response.dissipation.value[l] = one.dissipation;
      response.opened.value[l] = one.opened;
      response.gap.value[l] = one.gap;
      if (around.softening) around.softening->softened.value[l] = softening.softened;
      for (int i = 0; i < NS; ++i) sigma[i].value[l] = s[i];
      for (int i = 0; i < States; ++i) state[i].value[l] = q[i];
    }
    return response;
  }
}

}  // namespace talus::material
