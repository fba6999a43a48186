// SPDX-License-Identifier: MIT
#pragma once
// Mohr–Coulomb with tension cut-off: perfectly plastic, non-associated, closed-form return in principal stress space.
//
//   f   = k s1 - s3 - 2c√k,  k = (1+sinφ)/(1-sinφ)        shear, s1 >= s2 >= s3, positive in tension
//   g   = m s1 - s3,         m = (1+sinψ)/(1-sinψ)        its plastic potential
//   f_t = s1 - σ_t                                        Rankine's tension cut-off, associated
//
// The return goes to the shear plane, to the edges s2 = s3 or s1 = s2, to the tension planes or to a vertex, after
// Clausen, Damkilde and Andersen (2006), Comput. Struct. 84, 1795. All candidates are affine in the trial stress, so
// lanes differ by a selection only. σ_t is at most the apex c/tanφ; where both are equal, the cut-off is the apex
// return.
//
// Cohesion enters through MohrCoulombBounds alone: one set for all points here, one per point in rooted soil, by the
// same code.

#include <algorithm>

#include "material/linear_elastic.hpp"
#include "material/principal_stress.hpp"

namespace talus::material {

/// Quantities that depend on the cohesion. T is double where the cohesion is the same for all points.
template <class T>
struct MohrCoulombBounds {
  T intercept;      ///< 2c√k [Pa]
  T tension;        ///< σ_t, at most the apex [Pa]
  T tension_limit;  ///< σ_t plus the tolerance [Pa]
  T cone_offset;    ///< a stress with √J2 <= offset - slope·p is inside the pyramid [Pa]
};

class RootedMohrCoulomb;

class MohrCoulomb {
 public:
  static constexpr Traits traits{.word = "mohr_coulomb",
                                 .meaning = "linear elastic, perfectly plastic with Mohr–Coulomb's strength",
                                 .title = "Mohr–Coulomb",
                                 .serves_slices = true,
                                 .has_friction = true,
                                 .paragraphs = {"mohr_coulomb"}};
  /// State variables: 0 deviatoric plastic strain ∫√(⅔ ė^p:ė^p) dt [-]; 1 gap (linear_elastic.hpp), read and written
  /// only if Surroundings::gaps is not `ignored`.
  static constexpr int state_size = 2, gap_states = 1;
  static constexpr bool is_plastic = true;

  using Input = Needs<YoungInput, PoissonInput, MohrCoulombStrength, CohesionGradient>;
  static MohrCoulomb make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  static void divide(const Input::Changeable& in, PartialDivision& division);
  static bool is_total_stress(const Input& in) { return in.get<MohrCoulombStrength>().friction_angle == 0; }
  /// Law of the same soil with the cohesion as a state variable; varies() is true where the FEM needs it.
  using Local = RootedMohrCoulomb;
  static bool varies(const Input& in) { return in.get<CohesionGradient>().cohesion_gradient != 0; }

  MohrCoulomb(const LinearElastic& elastic, const MohrCoulombStrength& strength);

  const LinearElastic& elastic() const { return elastic_; }
  const MohrCoulombStrength& strength() const { return strength_; }
  TALUS_PORTABLE double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return elastic_.constrained_modulus();
  }
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const { return elastic_; }
  template <int NS>
  TALUS_PORTABLE double elastic_energy(const double* sigma, const double* = nullptr) const {
    return elastic_.elastic_energy<NS>(sigma);
  }

  /// Updates the stress over a step with strain increment `d_epsilon`. Lanes outside `active` may hold any values.
  template <int NS, class T>
  TALUS_KERNEL Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                                  const Surroundings<T>& around = {}) const {
    return update_within<NS>(sigma, d_epsilon, state, state + 1, active, bounds_, around);
  }
  static std::vector<StateField> fields() { return {separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) { values[0] = state[1]; }
  TALUS_PORTABLE static double find_gap(const double* state) { return state[1]; }

  /// Returns the bounds with the additional cohesion `extra` of each point [Pa]. The given σ_t is unchanged: roots
  /// raise the tension limit only where the apex was below σ_t.
  template <class T>
  TALUS_KERNEL MohrCoulombBounds<T> widen_bounds(T extra) const {
    const T intercept = bounds_.intercept + extra * intercept_per_cohesion_;
    const T tension = lane_min(T(strength_.tensile_strength), intercept * apex_per_intercept_);
    return {intercept, tension, tension + tolerance_, bounds_.cone_offset + extra * cone_per_cohesion_};
  }
  /// Performs update() with other bounds. `gap` points to the gap of the points' state.
  template <int NS, class T, class B>
  TALUS_KERNEL Response<T> update_within(T* sigma, const T* d_epsilon, T* state, T* gap, MaskOf<T> active,
                                         const MohrCoulombBounds<B>& bounds, const Surroundings<T>& around) const {
    if (around.gaps == Gaps::kept) {
      const AfterClosing<NS, T> rest(elastic_, sigma, d_epsilon, *gap, active);
      Response<T> response = update_coherent<NS>(sigma, rest.strain, state, active, bounds);
      rest.finish(response, gap, active);
      return response;
    }
    Response<T> response = update_coherent<NS>(sigma, d_epsilon, state, active, bounds);
    if (around.gaps == Gaps::none && response.any_plastic) response.gap = *gap = response.opened;
    return response;
  }

  /// Returns principal stresses s1 >= s2 >= s3 [Pa] outside the yield surface to it. Public for the tests.
  template <class T>
  TALUS_KERNEL void return_principal(T& s1, T& s2, T& s3) const {
    return_principal(s1, s2, s3, bounds_);
  }
  template <class T, class B>
  TALUS_KERNEL void return_principal(T& s1, T& s2, T& s3, const MohrCoulombBounds<B>& bounds) const {
    const T f = k_ * s1 - s3 - bounds.intercept;
    const T t1 = s1, t2 = s2, t3 = s3;
    T a = s1 - f * plane_[0], b = s2 - f * plane_[1], c = s3 - f * plane_[2];
    const auto below = c > b + tolerance_;  // outside the plane, beyond the edge s2 = s3
    const auto above = b > a + tolerance_;  // outside the plane, beyond the edge s1 = s2
    if (any(below || above)) {
      const T f12 = k_ * s1 - s2 - bounds.intercept, f23 = k_ * s2 - s3 - bounds.intercept;
      T a1, b1, c1, a2, b2, c2;
      edge_low_.apply(f, f12, s1, s2, s3, a1, b1, c1);
      edge_high_.apply(f, f23, s1, s2, s3, a2, b2, c2);
      const auto high = above && !below;
      a = select(below, a1, select(high, a2, a));
      b = select(below, b1, select(high, b2, b));
      c = select(below, c1, select(high, c2, c));
    }
    const auto shears = f > T(tolerance_);
    a = select(shears, a, t1);
    b = select(shears, b, t2);
    c = select(shears, c, t3);
    const auto tears = a > T(bounds.tension_limit);
    if (any(tears)) {
      T u = t1, v = t2, w = t3;
      return_tension(u, v, w, bounds);
      a = select(tears, u, a);
      b = select(tears, v, b);
      c = select(tears, w, c);
    }
    s1 = a;
    s2 = b;
    s3 = c;
  }

 private:
  /// Return to the edge of two shear planes: the trial stress minus two multipliers times two plastic directions.
  struct Edge {
    double inverse[4];           ///< inverse of the planes' hardening matrix
    double first[3], second[3];  ///< C:b of the two planes
    template <class T>
    // NOLINTNEXTLINE(readability-function-size): principal stresses in registers, each by its name
    TALUS_KERNEL void apply(T f, T g, T s1, T s2, T s3, T& a, T& b, T& c) const {
      const T l = inverse[0] * f + inverse[1] * g, m = inverse[2] * f + inverse[3] * g;
      a = s1 - l * first[0] - m * second[0];
      b = s2 - l * first[1] - m * second[1];
      c = s3 - l * first[2] - m * second[2];
    }
  };
  static constexpr double two_over_root3 = 1.1547005383792517;

  /// Performs the update without gaps.
  template <int NS, class T, class B>
  TALUS_KERNEL Response<T> update_coherent(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                                           const MohrCoulombBounds<B>& bounds) const {
    elastic_.add_elastic_increment<NS>(sigma, d_epsilon);
    if constexpr (NS == 4) {
      return return_to_surface<NS>(PlanePrincipal<T>(sigma), sigma, d_epsilon, state, active, bounds);
    } else {
      // Most points are inside a cone inscribed in the pyramid and need no principal stresses.
      const T p = (sigma[0] + sigma[1] + sigma[2]) * (1.0 / 3);
      const T x = sigma[0] - p, y = sigma[1] - p, z = sigma[2] - p;
      const T root_j2 =
          lane_sqrt(0.5 * (x * x + y * y + z * z) + sigma[3] * sigma[3] + sigma[4] * sigma[4] + sigma[5] * sigma[5]);
      const auto outside = active && (root_j2 > bounds.cone_offset - cone_slope_ * p ||
                                      p + two_over_root3 * root_j2 > T(bounds.tension_limit));
      if (!any(outside)) return {false, T(0.0), T(0.0)};
      return return_to_surface<NS>(SpacePrincipal<T>(sigma, cosine_), sigma, d_epsilon, state, outside, bounds);
    }
  }
  template <int NS, class T, class Principal, class B>
  TALUS_KERNEL Response<T> return_to_surface(const Principal& trial, T* sigma, const T* d_epsilon, T* state,
                                             MaskOf<T> active, const MohrCoulombBounds<B>& bounds) const {
    const auto yields =
        active && (k_ * trial.s1 - trial.s3 > T(bounds.intercept + tolerance_) || trial.s1 > T(bounds.tension_limit));
    if (!any(yields)) return {false, T(0.0), T(0.0)};
    constexpr int D = NS == 4 ? 2 : 3;  // directions in the plane of motion
    T n1 = trial.s1, n2 = trial.s2, n3 = trial.s3;
    return_principal(n1, n2, n3, bounds);
    const T d1 = trial.s1 - n1, d2 = trial.s2 - n2, d3 = trial.s3 - n3;
    const T trace = d1 + d2 + d3, mean = trace * (1.0 / 3);
    // Plastic strain ε^p = C⁻¹:(σ_trial - σ) in principal values.
    const T e_mean = trace * compliance_trace_;
    const T work = (n1 * (d1 - e_mean) + n2 * (d2 - e_mean) + n3 * (d3 - e_mean)) * half_over_mu_;
    const T x = d1 - mean, y = d2 - mean, z = d3 - mean;
    const T shear = lane_sqrt((x * x + y * y + z * z) * (2.0 / 3)) * half_over_mu_;
    T composed[NS];
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) composed[i] = sigma[i];
    trial.compose(n1, n2, n3, composed);
    // Work of the old stress: σ_old:Δε^p = (σ_trial - C:Δε):C⁻¹:(σ_trial - σ).
    T old_work = (trial.s1 * (d1 - e_mean) + trial.s2 * (d2 - e_mean) + trial.s3 * (d3 - e_mean)) * half_over_mu_;
    T dilation = -static_cast<double>(D) * e_mean;
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) dilation += sigma[i] - composed[i];
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) {
      old_work -= d_epsilon[i] * (sigma[i] - composed[i]);
      sigma[i] = select(yields, composed[i], sigma[i]);
    }
    state[0] = select(yields, state[0] + shear, state[0]);
    // The soil separates where all D directions are at the tension limit; tr ε^p = tr(σ_trial - σ)/3K.
    T borne = composed[0] + composed[1];
    if constexpr (D == 3) borne += composed[2];
    const auto apart = yields && borne > T(D * bounds.tension - tolerance_);
    return {true, select(yields, dilation * half_over_mu_, T(0.0)), select(yields, 0.5 * (old_work + work), T(0.0)),
            select(apart, (trace - 3.0 * e_mean) * half_over_mu_, T(0.0))};
  }

  /// Returns the trial stress to the tension planes or to their intersection with the shear planes.
  template <class T, class B>
  TALUS_KERNEL void return_tension(T& s1, T& s2, T& s3, const MohrCoulombBounds<B>& bounds) const {
    const T limit(bounds.tension);
    const double l = elastic_.lambda, l2m = elastic_.lambda + 2 * elastic_.mu;
    const T one = (s1 - limit) * (l / l2m);
    T v = s2 - one, w = s3 - one;
    const auto two_planes = v > limit;
    w = select(two_planes, s3 - (s1 + s2 - 2.0 * limit) * (l / (l + l2m)), w);
    v = lane_min(v, limit);
    w = lane_min(w, limit);
    const auto shears = k_ * limit - w - bounds.intercept > T(tolerance_);
    if (any(shears)) {  // the edge s1 = σ_t, s3 = kσ_t - 2c√k, between its two vertices
      const T s3_line = k_ * limit - bounds.intercept;
      // s - γ C:b - τ C:(1,0,0) with s1 and s3 prescribed gives two equations for γ and τ.
      const T r1 = s1 - limit, r3 = s3 - s3_line;
      const T gamma = (r1 * corner_inverse_[0] + r3 * corner_inverse_[1]);
      const T tau = (r1 * corner_inverse_[2] + r3 * corner_inverse_[3]);
      const T s2_line = lane_min(limit, lane_max(s3_line, s2 - gamma * shear_direction_[1] - tau * l));
      v = select(shears, s2_line, v);
      w = select(shears, s3_line, w);
    }
    s1 = limit;
    s2 = v;
    s3 = w;
  }

  LinearElastic elastic_;
  MohrCoulombStrength strength_;
  double k_, tolerance_;
  MohrCoulombBounds<double> bounds_{};
  double plane_[3]{};              ///< C:b / (a:C:b) of the shear plane
  Edge edge_low_{}, edge_high_{};  ///< edges s2 = s3 and s1 = s2
  double shear_direction_[3]{};    ///< C:b of the shear plane [Pa]
  double corner_inverse_[4]{};
  double cone_slope_;
  /// Derivatives of the bounds: intercept and cone offset per Pa of cohesion, apex per Pa of intercept (a huge number
  /// for φ = 0).
  double intercept_per_cohesion_, cone_per_cohesion_, apex_per_intercept_;
  double compliance_trace_, half_over_mu_;
  CosineThird cosine_;
};

}  // namespace talus::material
