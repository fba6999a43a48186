// SPDX-License-Identifier: MIT
#pragma once
// Laws that are computed point by point, because they iterate or have parameters of their own at every point.

#include "material/linear_elastic.hpp"

namespace talus::material {

/// Base of these laws. `L` is the law, with update_point<NS>(sigma, d_epsilon, state, around) for one point.
template <class L>
struct PointLaw : LinearElastic {
  explicit PointLaw(const LinearElastic& elastic) : LinearElastic(elastic) {}

  template <int NS, class T>
  Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                     const Surroundings<T>& around = {}) const {
    const L& law = static_cast<const L&>(*this);
    if constexpr (std::is_same_v<T, double>) {
      return active ? law.template update_point<NS>(sigma, d_epsilon, state, around)
                    : Response<double>{false, 0.0, 0.0};
    } else {
      constexpr int states = L::state_size;
      Response<T> response{false, T(0.0), T(0.0)};
      for (int l = 0; l < LaneTraits<T>::width; ++l) {
        if (!active[l]) continue;
        double s[NS], d[NS], q[states];
        for (int i = 0; i < NS; ++i) s[i] = sigma[i][l];
        for (int i = 0; i < NS; ++i) d[i] = d_epsilon[i][l];
        for (int i = 0; i < states; ++i) q[i] = state[i][l];
        Surroundings<double> own{around.saturation[l]};
        own.time = around.time, own.dt = around.dt, own.gaps = around.gaps;
        Softening<double> softening;
        if (around.softening) {
          softening.nonlocal_correction = around.softening->nonlocal_correction[l];
          own.softening = &softening;
        }
        const Response<double> one = law.template update_point<NS>(s, d, q, own);
        response.any_plastic = response.any_plastic || one.any_plastic;
        response.plastic_dilation.value[l] = one.plastic_dilation;
        response.dissipation.value[l] = one.dissipation;
        response.opened.value[l] = one.opened;
        response.gap.value[l] = one.gap;
        if (around.softening) around.softening->softened.value[l] = softening.softened;
        for (int i = 0; i < NS; ++i) sigma[i].value[l] = s[i];
        for (int i = 0; i < states; ++i) state[i].value[l] = q[i];
      }
      return response;
    }
  }
};

}  // namespace talus::material
