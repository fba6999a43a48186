// SPDX-License-Identifier: MIT
#pragma once
// Elastic, perfectly plastic soil with a curved envelope τ(σ'_n). The return is that of Mohr–Coulomb to the tangent at
// the normal stress of the plane that fails, repeated with the tangent at the new normal stress until both agree: the
// stress then lies on the envelope, and flow is that of its tangent plane.

#include <variant>

#include "material/mohr_coulomb.hpp"
#include "material/point_law.hpp"

namespace talus::material {

/// Parameters of the rock mass of Hoek and Brown. Stresses are positive in compression here.
struct HoekBrownMass {
  double intact_strength = 0, m = 0, s = 0, a = 0;

  double tensile_strength() const { return s * intact_strength / m; }  ///< [Pa]
  double straight_below() const { return -tensile_strength(); }
  double find_major(double minor) const;  ///< σ1 at failure [Pa]
  double find_ratio(double minor) const;  ///< dσ1/dσ3 [-]
  /// Returns the tangent to the envelope at an effective normal stress [Pa]; below the tensile strength that near it.
  StrengthTangent find_tangent(double normal) const;
};

/// τ = factor (σ' + shift)^exponent + cohesion for stresses in kPa. Its secant replaces it where its slope would tend
/// to infinity.
struct PowerEnvelope {
  double factor = 0, exponent = 0;
  double shift = 0, cohesion = 0;  ///< [Pa]

  static double tensile_strength() { return 0; }
  double straight_below() const { return -shift; }
  StrengthTangent find_tangent(double normal) const;
};

/// Straight between pairs, and beyond them with the first and last slopes.
struct StrengthPairs {
  std::vector<double> normal, shear;  ///< [Pa]

  static double tensile_strength() { return 0; }
  double straight_below() const { return normal.front(); }
  StrengthTangent find_tangent(double normal_stress) const;
};

using CurvedEnvelope = std::variant<HoekBrownMass, PowerEnvelope, StrengthPairs>;

/// State variables as Mohr–Coulomb's.
class CurvedLaw : public PointLaw<CurvedLaw> {
 public:
  static constexpr Traits traits{.word = "curved", .meaning = "", .title = "curved envelope", .is_opaque = true};
  static constexpr int state_size = MohrCoulomb::state_size, gap_states = 1;
  static constexpr bool is_plastic = true;

  CurvedLaw(const LinearElastic& elastic, CurvedEnvelope envelope, double dilatancy_ratio, double factor)
      : PointLaw(elastic), envelope_(std::move(envelope)), dilatancy_ratio_(dilatancy_ratio), factor_(factor) {}

  static std::vector<StateField> fields() { return {separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) { values[0] = state[1]; }
  static double find_gap(const double* state) { return state[1]; }

  template <int NS>
  Response<double> update_point(double* sigma, const double* d_epsilon, double* state,
                                const Surroundings<double>& around) const;
  /// Returns the strength, divided by the factor, at an effective normal stress [Pa].
  StrengthTangent find_tangent(double normal) const;

 private:
  /// Returns true if the circle of the principal stresses s1 >= s3 lies within the envelope; else a normal stress near
  /// which it crosses it.
  bool is_within(double s1, double s3, double& normal) const;
  double find_tension() const;

  CurvedEnvelope envelope_;
  double dilatancy_ratio_, factor_;
};

/// Base of the laws with a curved envelope; `L` is the law.
template <class L>
struct CurvedSoil : CurvedLaw {
  using Kernel = CurvedLaw;

  template <class In>
  static L make(const In& in, const StrengthChange& change) {
    return L(CurvedLaw(LinearElastic::make(in), L::make_envelope(in), in.template get<FlowRatio>().dilatancy_ratio,
                       change.factor));
  }
  template <class In>
  static SliceStrength find_slice_strength(const In& in) {
    SliceStrength strength;
    strength.law = std::make_shared<const StrengthLaw>(make_strength(in));
    return strength;
  }
  template <class In>
  static StrengthLaw make_strength(const In& in) {
    StrengthLaw law;
    const auto envelope = L::make_envelope(in);
    law.is_curved = true;
    law.straight_below = envelope.straight_below();
    law.tensile_strength = envelope.tensile_strength();
    law.find_tangent = [envelope](const StrengthPlane& plane) { return envelope.find_tangent(plane.normal); };
    return law;
  }

 protected:
  explicit CurvedSoil(const CurvedLaw& law) : CurvedLaw(law) {}
};

}  // namespace talus::material
