// SPDX-License-Identifier: MIT
#pragma once
// Modified Cam-clay and, as an extension, the rooted-soil model of Świtała et al. (4.1-4.15): hardening by plastic
// volumetric strain, saturation and root activation, associated flow, implicit return mapping.

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "material/cam_clay_return.hpp"
#include "material/linear_elastic.hpp"

namespace talus::material {

struct CamClayParameters {
  double compression = 0;           ///< λ, slope of the normal compression line in e - ln p' [-]
  double swelling = 0;              ///< κ, slope of the swelling line [-]
  double poisson_ratio = 0;         ///< ν [-]
  double critical_state_slope = 0;  ///< M_0 [-]
  double suction_hardening = 0;     ///< b of (4.6), (4.9) [-]
  double smallest_pressure = 1e3;   ///< p'_min in K = (1+e) max(p', p'_min)/κ [Pa]
  double strength_factor = 1;       ///< divides tan φ of the critical state [-]
};

/// State variables: 0 deviatoric plastic strain [-]; 1 preconsolidation pressure p'_c without suction and roots [Pa],
/// positive; 2 void ratio e [-]; rooted also 3 root content m_r [%]; 4 exponent of the contribution of intact roots to
/// p'_c [-]; 5 activation strain ε_r [-]; 6 fraction of the roots that is intact [-].
template <bool Rooted>
class CamClay {
 public:
  static constexpr Traits traits{
      .word = Rooted ? "rooted_cam_clay" : "modified_cam_clay",
      .meaning = Rooted ? "the same with roots that harden and strengthen the soil (Świtała et al.)"
                        : "modified Cam-clay, hardening with plastic volume and with suction (Tamagnini)",
      .title = Rooted ? "rooted Cam-clay" : "modified Cam-clay",
      .changes_stiffness = true,
      .stores_always = true,
      .softens = true,
      .roots = Rooted ? RootEffect::content : RootEffect::none,
      .family = "Cam-clay",
      .family_states = 3,
      .paragraphs = {"modified_cam_clay", Rooted ? "rooted_cam_clay" : nullptr},
      .assumption =
          "{}: modified Cam-clay, the same in all directions. Soil that is preconsolidated beyond the critical state "
          "dilates and softens; contraction together with softening, as of loose or cemented soil, is not in it.",
      .reduction =
          "In Cam-clay soils the factor divides tan φ of the critical state. The preconsolidation stays as it is."};
  static constexpr int state_size = Rooted ? 7 : 3;
  static constexpr bool is_plastic = true;
  /// p'_c of a point whose preconsolidation is not set yet: the response is elastic at any stress [Pa].
  static constexpr double not_set = 1e30;
  /// Returns false also for an average over points of which some are `not_set`.
  static constexpr bool is_set(double preconsolidation) { return preconsolidation < set_below; }

  using Input = std::conditional_t<Rooted, Needs<PoissonInput, CamClayInput, Preconsolidation, RootParameters>,
                                   Needs<PoissonInput, CamClayInput, Preconsolidation>>;
  static CamClay make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  /// Lists the properties that follow from the roots, of which the soil has at most `content` [%].
  static Properties list_root_properties(const Input& in, double content);

  explicit CamClay(const CamClayParameters& soil, const RootParameters& roots = {});

  const CamClayParameters& soil() const { return soil_; }
  const RootParameters& roots() const { return roots_; }
  /// Returns E_c at a stress and state, for the critical time step [Pa].
  TALUS_PORTABLE double constrained_modulus(const double* sigma, const double* state) const {
    const double bulk = (1 + state[2]) / soil_.swelling * std::max(find_pressure(sigma), soil_.smallest_pressure);
    return bulk * (1 + 4.0 / 3 * shear_ratio_);
  }
  /// Returns the elastic stiffness at a stress and state.
  LinearElastic find_elastic(const double* sigma, const double* state) const {
    return LinearElastic::from_constrained_modulus(constrained_modulus(sigma, state), soil_.poisson_ratio);
  }
  /// Returns the elastic energy density: compression from zero along the swelling line, plus q²/(6G) [J/m³].
  template <int NS>
  TALUS_PORTABLE double elastic_energy(const double* sigma, const double* state) const {
    const double p = find_pressure(sigma),
                 bulk = (1 + state[2]) / soil_.swelling * std::max(p, soil_.smallest_pressure);
    const double volume = soil_.swelling / (1 + state[2]);
    double squares = 0;
    for (int i = 0; i < NS; ++i) squares += i < 3 ? (sigma[i] + p) * (sigma[i] + p) : 2 * sigma[i] * sigma[i];
    const double small = soil_.smallest_pressure;
    return volume * (p > small ? p - 0.5 * small : p * p / (2 * small)) + squares / (4 * shear_ratio_ * bulk);
  }

  /// Updates stress and state over a step with strain increment `d_epsilon`. Lanes outside `active` may hold any
  /// values. `any_plastic` is always true because void ratio and activation strain change in every step.
  template <int NS, class T>
  TALUS_KERNEL Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                                  const Surroundings<T>& around = {}) const {
    const T p_before = (sigma[0] + sigma[1] + sigma[2]) * (-1.0 / 3);
    const T volume = -(d_epsilon[0] + d_epsilon[1] + d_epsilon[2]), third = volume * (1.0 / 3);
    const T specific = change_void_ratio(volume, state[2]);  // mean of 1 + e over the step
    const T bulk = find_secant_bulk(p_before, volume, specific), shear = bulk * shear_ratio_;
    const T p_trial = p_before + bulk * volume;
    T squares(0.0), strain_squares(0.0);  // s:s of the trial stress and e:e of the strain deviator
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) {
      const T e = d_epsilon[i] + third;
      strain_squares += e * e;
      sigma[i] += p_before + 2.0 * shear * e;
      squares += sigma[i] * sigma[i];
    }
    TALUS_UNROLL
    for (int i = 3; i < NS; ++i) {
      strain_squares += 0.5 * d_epsilon[i] * d_epsilon[i];
      sigma[i] += shear * d_epsilon[i];
      squares += 2.0 * sigma[i] * sigma[i];
    }
    const auto set = active && state[1] < T(set_below);
    if (around.softening) {
      const T share =
          lane_max(T(-1.0), lane_min(T(1.0), specific * over_plastic_slope_ * around.softening->nonlocal_correction));
      state[1] = select(set, state[1] * lane_exp(-share), state[1]);
    }
    T m_square(slope_square_), exponent = (1.0 - around.saturation) * soil_.suction_hardening;
    if constexpr (Rooted) {
      activate_roots(volume + lane_sqrt(strain_squares * (2.0 / 3)), specific - 1.0, set, state);
      const T m = reduce(soil_.critical_state_slope + roots_.strength * state[3] * state[6]);
      m_square = m * m;
      exponent += state[6] * state[4];
    }
    const T p_c = find_preconsolidation(state[1], exponent);
    const T q_square = 1.5 * squares;
    const auto yields =
        set && q_square - m_square * p_trial * (p_c - p_trial) > cam_clay_tolerance * m_square * p_c * p_c;
    if (!any(yields)) {
      TALUS_UNROLL
      for (int i = 0; i < 3; ++i) sigma[i] -= p_trial;
      return {true, T(0.0), T(0.0)};
    }
    const T over_both = 1.0 / (p_c * m_square), over_c = over_both * m_square, over_m = over_both * p_c;
    const CamClayReturn<T> back =
        return_cam_clay<T>({p_trial * over_c, q_square * over_m * over_c * over_c, bulk * over_c,
                            6.0 * shear * over_m * over_c, specific * over_plastic_slope_, floor_ * over_c},
                           yields);
    const T p = select(yields, back.pressure * p_c, p_trial), ratio = select(yields, back.shear, T(1.0));
    T dilation = (p - p_trial) / bulk;
    if (around.softening) around.softening->softened = select(yields, dilation, around.softening->softened);
    if constexpr (NS == 4) dilation = dilation * (2.0 / 3) - sigma[2] * (1.0 - ratio) / (2.0 * shear);
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) sigma[i] = sigma[i] * ratio - p;
    TALUS_UNROLL
    for (int i = 3; i < NS; ++i) sigma[i] *= ratio;
    const T multiplier = select(yields, back.multiplier, T(0.0));
    state[0] += multiplier * (2.0 * over_c * over_m) * lane_sqrt(q_square) * ratio;
    state[1] = select(yields, raise_to_floor(state[1], p_c, exponent) * back.growth, state[1]);
    return {true, dilation, multiplier * back.pressure * back.growth * p_c};
  }

  /// Returns p'_c with suction and roots (4.6-4.10) [Pa]; `not_set` is returned unchanged.
  double find_preconsolidation(const double* state, double saturation) const;
  /// Sets the state at a stress: void ratio `e`, root content `content` [%] and state[1] such that the saturated soil
  /// without roots has p'_c = max(`preconsolidation`, the least p'_c that admits the stress) [Pa]. `preconsolidation` =
  /// not_set leaves it unset.
  void set_initial_state(const double* sigma, double e, double content, double preconsolidation, double saturation,
                         double* state) const;
  void set_initial_state(const Input& in, const StateStart& start, double* state) const {
    set_initial_state(start.stress, start.void_ratio, start.root_content,
                      in.template get<Preconsolidation>().preconsolidation.value_or(not_set), start.saturation, state);
  }
  /// Copies the root content of a point to `start`.
  static void read_start(const double* state, StateStart& start) requires Rooted { start.root_content = state[3]; }
  /// Sets p'_c to `ratio` times the mean effective stress [Pa].
  void set_preconsolidation(double ratio, const double* sigma, double* state) const {
    state[1] = ratio * std::max(find_pressure(sigma), soil_.smallest_pressure);
  }
  static double find_void_ratio(const double* state) { return state[2]; }
  /// State fields of the results: p'_c (NaN while it is not set) and e; rooted also m_r, ε_r and the intact fraction.
  static std::vector<StateField> fields() {
    if constexpr (Rooted)
      return {{"preconsolidation_pressure", "Pa"},
              {"void_ratio", "-"},
              {"root_content", "%", 0},
              {"root_activation_strain", "-", 0},
              {"intact_roots", "-", 0}};
    else
      return {{"preconsolidation_pressure", "Pa"}, {"void_ratio", "-"}};
  }
  void show(const double* state, double saturation, double* values) const;

 private:
  static constexpr double set_below = 1e28;
  static constexpr double least_void_ratio = 0.01, most_void_ratio = 4;
  static constexpr double most_exponent = 50;  ///< upper limit of the exponent of suction and roots together

  TALUS_PORTABLE static double find_pressure(const double* sigma) { return -(sigma[0] + sigma[1] + sigma[2]) / 3; }

  /// Updates the void ratio by the volumetric strain `volume` (positive in compression) and returns the mean of 1 + e
  /// over the step.
  template <class T>
  static TALUS_KERNEL T change_void_ratio(T volume, T& e) {
    const T v = lane_max(T(-0.5), lane_min(T(0.5), volume));
    const T specific = (1.0 + e) * (1.0 - v * (0.5 - v * (1.0 / 6 - v * (1.0 / 24))));  // (1 - exp(-v))/v
    const T after = e - specific * v;
    e = lane_max(lane_min(after, lane_max(e, T(most_void_ratio))), lane_min(e, T(least_void_ratio)));
    return specific;
  }

  /// Returns Δp'/Δε_v of an elastic step: exact along the swelling line, constant below the smallest pressure.
  template <class T>
  TALUS_KERNEL T find_secant_bulk(T p, T volume, T specific) const {
    const T stiffness = specific * over_swelling_;
    T x = lane_max(T(-1.0), lane_min(T(1.0), stiffness * volume));
    x = select(p > T(soil_.smallest_pressure), x, T(0.0));
    const T growth = 1.0 + x * (0.5 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720)))));
    return stiffness * lane_max(p, T(soil_.smallest_pressure)) * growth;
  }

  /// Updates activation strain, exponent and intact fraction by the increment `d_activation` (4.5, 4.10).
  template <class T>
  TALUS_KERNEL void activate_roots(T d_activation, T e, MaskOf<T> set, T* state) const {
    const T d = select(set, d_activation, T(0.0));
    const T rate = activation_ < 0 ? state[3] * roots_.hardening : T(activation_);
    state[4] += rate * e * d;
    state[5] += d;
    if (breaks_) {
      const T left = 1.0 - lane_max(T(0.0), lane_min(T(1.0), (state[5] - roots_.breaking_strain) * over_range_));
      state[6] = lane_min(state[6], roots_.residual_share + (1 - roots_.residual_share) * left);
    }
  }

  /// Returns M with its tan φ divided by the strength factor.
  template <class T>
  TALUS_KERNEL T reduce(T m) const {
    if (soil_.strength_factor == 1) return m;
    const T sine = lane_min(3.0 * m / (6.0 + m), T(0.9999));
    const T tangent = sine / (lane_sqrt(1.0 - sine * sine) * soil_.strength_factor);
    const T reduced = tangent / lane_sqrt(1.0 + tangent * tangent);
    return 6.0 * reduced / (3.0 - reduced);
  }

  template <class T>
  static TALUS_KERNEL T limit_exponent(T x) {
    return lane_max(T(-most_exponent), lane_min(T(most_exponent), x));
  }
  template <class T>
  TALUS_KERNEL T find_preconsolidation(T p_b, T exponent) const {
    if (!Rooted && soil_.suction_hardening == 0) return lane_max(p_b, T(floor_));
    return lane_max(p_b * lane_exp(limit_exponent(exponent)), T(floor_));
  }
  /// Returns p_b, raised where necessary such that p'_c is at least `floor_`.
  template <class T>
  TALUS_KERNEL T raise_to_floor(T p_b, T p_c, T exponent) const {
    const auto raised = !(p_c > T(floor_));
    if (!any(raised)) return p_b;
    return select(raised, floor_ * lane_exp(-limit_exponent(exponent)), p_b);
  }

  CamClayParameters soil_;
  RootParameters roots_;
  double activation_;                          ///< negative if not given
  double over_swelling_, over_plastic_slope_;  ///< 1/κ, 1/(λ-κ)
  double shear_ratio_;                         ///< G/K
  double slope_square_;                        ///< M² without roots, after strength reduction
  double floor_;                               ///< lower limit of p'_c [Pa]
  double over_range_;
  bool breaks_;
};

using ModifiedCamClay = CamClay<false>;
using RootedCamClay = CamClay<true>;

}  // namespace talus::material
