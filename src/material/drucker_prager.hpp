// SPDX-License-Identifier: MIT
#pragma once
// Drucker–Prager with a tension cut-off: perfectly plastic, non-associated, closed-form return.
//
//   f   = √J2 + η p - ξ c          cone, p = tr σ/3 positive in tension
//   g   = √J2 + η_ψ p              its plastic potential
//   f_t = p - σ_t                  cut-off of the mean stress, associated
//
// η, η_ψ and ξ follow from c, φ and ψ by the match to Mohr–Coulomb's pyramid (de Souza Neto, Perić and Owen 2008,
// chapter 6.4). In plane strain the flow fixes the stress across the plane, and with it the c and φ that the cone has
// there: docs/theory/09-mohr-coulomb.md.

#include "material/mohr_coulomb.hpp"

namespace talus::material {

/// Coefficients of the cone and of its potential [-].
struct DruckerPragerCone {
  double slope = 0, offset = 0, dilation = 0;  ///< η, ξ, η_ψ

  static DruckerPragerCone match(ConeMatch cone, double friction_angle, double dilatancy_angle);
  /// Returns the c and φ of the same strength in plane strain; NaN for an angle of 90° or more.
  StrengthTangent find_plane_strength(double cohesion) const;
};

/// State variables as Mohr–Coulomb's.
class DruckerPrager {
 public:
  static constexpr Traits traits{
      .word = "drucker_prager",
      .meaning = "linear elastic, perfectly plastic with the cone of Drucker and Prager",
      .title = "Drucker–Prager",
      .serves_slices = true,
      .has_friction = true,
      .paragraphs = {"drucker_prager"},
      .assumption =
          "{}: the cone of Drucker and Prager, which has the strength of Mohr–Coulomb where it was matched, and more "
          "or "
          "less elsewhere. LEM and limit analysis take the c and φ that it has in plane strain."};
  static constexpr int state_size = 2, gap_states = 1;
  static constexpr bool is_plastic = true;

  using Input = Needs<YoungInput, PoissonInput, MohrCoulombStrength, DruckerPragerInput>;
  static DruckerPrager make(const Input& in, const StrengthChange& change) {
    return {LinearElastic::make(in), in.get<MohrCoulombStrength>().changed(change), in.get<DruckerPragerInput>().cone};
  }
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  static void divide(const Input::Changeable& in, PartialDivision& division) {
    in.get<MohrCoulombStrength>().divide(division);
  }
  static bool is_total_stress(const Input& in) { return in.get<MohrCoulombStrength>().friction_angle == 0; }

  DruckerPrager(const LinearElastic& elastic, const MohrCoulombStrength& strength, ConeMatch cone);

  TALUS_PORTABLE double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return elastic_.constrained_modulus();
  }
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const { return elastic_; }
  template <int NS>
  TALUS_PORTABLE double elastic_energy(const double* sigma, const double* = nullptr) const {
    return elastic_.elastic_energy<NS>(sigma);
  }
  static std::vector<StateField> fields() { return {separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) { values[0] = state[1]; }
  TALUS_PORTABLE static double find_gap(const double* state) { return state[1]; }

  template <int NS, class T>
  TALUS_KERNEL Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                                  const Surroundings<T>& around = {}) const {
    if (around.gaps == Gaps::kept) {
      const AfterClosing<NS, T> rest(elastic_, sigma, d_epsilon, state[1], active);
      Response<T> response = update_coherent<NS>(sigma, rest.strain, state, active);
      rest.finish(response, state + 1, active);
      return response;
    }
    Response<T> response = update_coherent<NS>(sigma, d_epsilon, state, active);
    if (around.gaps == Gaps::none && response.any_plastic) response.gap = state[1] = response.opened;
    return response;
  }

 private:
  /// Performs the update without gaps.
  template <int NS, class T>
  TALUS_KERNEL Response<T> update_coherent(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active) const {
    T old[NS];
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) old[i] = sigma[i];
    elastic_.add_elastic_increment<NS>(sigma, d_epsilon);
    const T p = (sigma[0] + sigma[1] + sigma[2]) * (1.0 / 3);
    T j2(0.0);
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) j2 += 0.5 * (sigma[i] - p) * (sigma[i] - p);
    TALUS_UNROLL
    for (int i = 3; i < NS; ++i) j2 += sigma[i] * sigma[i];
    // The root has no derivative at zero shear.
    const T root = lane_sqrt(lane_max(j2, T(smallest_ * smallest_)));
    const T excess = root + slope_ * p - T(strength_);
    const auto yields = active && (excess > T(tolerance_) || p > T(tension_ + tolerance_));
    if (!any(yields)) return {false, T(0.0), T(0.0)};
    // To the cone; then to the cut-off, whose edge with the cone a radial return reaches.
    const T multiplier = lane_max(T(0.0), excess) * over_stiffness_;
    T pressure = p - (bulk_ * dilation_) * multiplier, shear = lane_max(T(0.0), root - elastic_.mu * multiplier);
    const auto tears = pressure > T(tension_);
    const T most = lane_max(T(0.0), T(strength_ - slope_ * tension_));
    shear = select(tears, lane_min(root, most), shear);
    pressure = select(tears, T(tension_), pressure);
    const T ratio = shear / root, lost = p - pressure;
    // Plastic strain: (1 - ratio) s/2μ and, in volume, lost/K. Its work is that of the mean of both stresses.
    const T share = (1.0 - ratio) * (0.5 / elastic_.mu), volume = lost * (1.0 / bulk_);
    T work(0.0), dilation = volume * (NS == 4 ? 2.0 / 3 : 1.0);
    if constexpr (NS == 4) dilation -= share * (sigma[2] - p);
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) {
      const T s = i < 3 ? sigma[i] - p : sigma[i], now = i < 3 ? s * ratio + pressure : s * ratio;
      const T strain = (i < 3 ? share * s + volume * (1.0 / 3) : 2.0 * share * s);
      work += 0.5 * (old[i] + now) * strain;
      sigma[i] = select(yields, now, sigma[i]);
    }
    state[0] = select(yields, state[0] + two_over_root3 * share * root, state[0]);
    const auto apart = yields && tears && shear < T(tolerance_);
    return {true, select(yields, dilation, T(0.0)), select(yields, work, T(0.0)), select(apart, volume, T(0.0))};
  }

  static constexpr double two_over_root3 = 1.1547005383792517;

  LinearElastic elastic_;
  double slope_, dilation_;                ///< η, η_ψ
  double strength_;                        ///< ξ c [Pa]
  double tension_, tolerance_, smallest_;  ///< [Pa]
  double bulk_, over_stiffness_;           ///< K [Pa], 1/(μ + K η η_ψ) [1/Pa]
};

}  // namespace talus::material
