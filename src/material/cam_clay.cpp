#include "material/cam_clay.hpp"

#include <cmath>

namespace talus::material {

template <bool Rooted>
CamClay<Rooted>::CamClay(const CamClayParameters& soil, const RootParameters& roots)
    : soil_(soil),
      roots_(roots),
      over_swelling_(1 / soil.swelling),
      over_plastic_slope_(1 / (soil.compression - soil.swelling)),
      shear_ratio_(1.5 * (1 - 2 * soil.poisson_ratio) / (1 + soil.poisson_ratio)),
      floor_(1e-3 * soil.smallest_pressure),
      over_range_(1 / std::max(roots.breaking_range, 1e-12)),
      breaks_(std::isfinite(roots.breaking_strain)) {
  const double slope = reduce(soil_.critical_state_slope);
  slope_square_ = slope * slope;
}

template <bool Rooted>
double CamClay<Rooted>::constrained_modulus(const double* sigma, const double* state) const {
  const double bulk = (1 + state[2]) / soil_.swelling * std::max(find_pressure(sigma), soil_.smallest_pressure);
  return bulk * (1 + 4.0 / 3 * shear_ratio_);
}

template <bool Rooted>
double CamClay<Rooted>::find_preconsolidation(const double* state, double saturation) const {
  if (!(state[1] < set_below)) return not_set;
  double exponent = soil_.suction_hardening * (1 - saturation);
  if constexpr (Rooted) exponent += state[6] * state[4];
  return find_preconsolidation(state[1], exponent);
}

template <bool Rooted>
void CamClay<Rooted>::set_initial_state(const double* sigma, double e, double content, double preconsolidation,
                                        double saturation, double* state) const {
  state[0] = 0;
  state[2] = e;
  double exponent = soil_.suction_hardening * (1 - saturation);
  if constexpr (Rooted) {
    state[3] = content;
    state[4] = roots_.hardening * content;
    state[5] = 0;
    state[6] = 1;
    exponent += state[4];
  }
  const double needed = std::max(find_pressure(sigma), floor_) * std::exp(-limit_exponent(exponent));
  state[1] = preconsolidation < set_below ? std::max(preconsolidation, needed) : not_set;
}

template <bool Rooted>
void CamClay<Rooted>::show(const double* state, double saturation, double* values) const {
  values[0] = find_preconsolidation(state, saturation);
  values[1] = state[2];
  if constexpr (Rooted) {
    values[2] = state[3];
    values[3] = state[5];
    values[4] = state[6];
  }
}

template class CamClay<false>;
template class CamClay<true>;

}  // namespace talus::material
