// SPDX-License-Identifier: MIT
#pragma once
// Solution of Srivastava and Yeh (1991), Water Resour. Res. 27, 753: infiltration into homogeneous soil over a water
// table, with steady flow q_A until t = 0 and q_B afterwards. k = k_s e^(αψ), θ = θ_r + (θ_s - θ_r) e^(αψ).

#include <cmath>
#include <numbers>

namespace talus::support {

struct SrivastavaYeh {
  double alpha = 10, ks = 0.01 / 3600, theta_s = 0.4, theta_r = 0.06, length = 1;  // 1/m, m/s, m
  double q_a = 0.1, q_b = 0.9;                                                     // over k_s

  /// Suction [m] at height z [m] over the water table.
  double find_suction(double z, double t) const {
    const double zs = alpha * z, l = alpha * length, ts = alpha * ks * t / (theta_s - theta_r);
    if (t <= 0) return -std::log(q_a - (q_a - 1) * std::exp(-zs)) / alpha;
    double sum = 0;
    for (int i = 1; i < 400; ++i) {  // the roots of tan(λL) + 2λ = 0, one in each ((i-½)π/L, iπ/L)
      double a = (i - 0.5) * std::numbers::pi / l + 1e-12, b = i * std::numbers::pi / l;
      for (int k = 0; k < 80; ++k) {
        const double m = 0.5 * (a + b);
        (std::tan(m * l) + 2 * m < 0 ? a : b) = m;
      }
      const double decay = std::exp(-a * a * ts);
      sum += std::sin(a * zs) * std::sin(a * l) * decay / (1 + l / 2 + 2 * a * a * l);
      if (decay < 1e-18) break;
    }
    const double k =
        q_b - (q_b - 1) * std::exp(-zs) - 4 * (q_b - q_a) * std::exp((l - zs) / 2) * std::exp(-ts / 4) * sum;
    return -std::log(k) / alpha;
  }
};

/// The same in a slab inclined at `beta`, whose fields depend only on the height z above the water table, normal to it:
/// ∂θ/∂t = ∂/∂z[k (∂ψ/∂z + cos β)]. With ψ = ψ' cos β that is the equation of level ground for ψ', with α cos β
/// and k_s cos β; vertical rain q enters the slab as q cos β, so q/k_s is unchanged. `length`: thickness, normal
/// to the slab.
inline double find_suction_in_slab(SrivastavaYeh soil, double beta, double z, double t) {
  soil.alpha *= std::cos(beta);
  soil.ks *= std::cos(beta);
  return std::cos(beta) * soil.find_suction(z, t);
}

}  // namespace talus::support
