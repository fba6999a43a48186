// SPDX-License-Identifier: MIT
#pragma once
// Strengths that depend on the inclination of the plane: undrained ADP strengths, a table of c and φ, and bedding
// planes in soil or rock. `NoStrength` is a material without any.

#include "material/mohr_coulomb.hpp"
#include "material/point_law.hpp"
#include "material/slice_law.hpp"
#include "material/tresca.hpp"

namespace talus::material {

/// s_u = s_uD + (s_uA - s_uD) sin 2α for a base that dips with the sliding by α, s_uD + (s_uP - s_uD) sin 2|α| for one
/// that rises, constant beyond 45°.
struct Adp : SliceLaw<Adp> {
  static constexpr Traits traits{
      .word = "adp",
      .meaning = "undrained clay in total stresses with active, direct and passive strength, for LEM",
      .title = "anisotropic undrained clay (ADP, total stress)",
      .serves_slices = true,
      .only_slices = true,
      .takes_water = false,
      .paragraphs = {"linear_elastic"},
      .assumption =
          "{}: undrained clay in total stresses, whose strength changes from active to direct to passive with "
          "the inclination of the base."};

  using Input = Needs<YoungInput, PoissonInput, TrescaInput, StrengthProfile, AdpInput>;
  static void check(const Input& in, const SoilFindings& findings) { Tresca::check(in, findings); }
  static Properties list_properties(const Input& in);
  static StrengthLaw make_strength(const Input& in);
  static void divide(const Input::Changeable& in, PartialDivision& division);
  static bool is_total_stress(const Input&) { return true; }
};

struct Anisotropic : SliceLaw<Anisotropic> {
  static constexpr Traits traits{
      .word = "anisotropic",
      .meaning = "soil whose cohesion and friction angle depend on the inclination of the plane, by a table, for LEM",
      .title = "anisotropic strength",
      .serves_slices = true,
      .only_slices = true,
      .paragraphs = {"linear_elastic"},
      .assumption = "{}: cohesion and friction angle depend on the inclination of the base."};

  using Input = Needs<YoungInput, PoissonInput, AnisotropicInput>;
  static void check(const Input& in, const SoilFindings& findings);
  static StrengthLaw make_strength(const Input& in);
};

/// Mohr–Coulomb soil with one family of planes of another strength. The stress returns to both surfaces at once, with
/// the plastic strain of each at the returned stress (bedding_return.cpp). State variables are Mohr–Coulomb's.
class Bedding : public PointLaw<Bedding> {
 public:
  static constexpr Traits traits{
      .word = "bedding",
      .meaning = "Mohr–Coulomb soil or rock with weaker bedding planes in one direction",
      .title = "bedding planes in Mohr–Coulomb soil",
      .serves_slices = true,
      .has_friction = true,
      .is_opaque = true,
      .paragraphs = {"mohr_coulomb", "bedding"},
      .assumption =
          "{}: bedding planes of one direction have a cohesion and friction angle of their own. In LEM slip surfaces "
          "near that direction have them, in FEM, limit analysis and MPM the planes of that direction, which do not "
          "turn with the soil."};
  static constexpr int state_size = MohrCoulomb::state_size, gap_states = 1;
  static constexpr bool is_plastic = true;

  using Input = Needs<YoungInput, PoissonInput, MohrCoulombStrength, BeddingInput>;
  static Bedding make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  static StrengthLaw make_strength(const Input& in);

  static std::vector<StateField> fields() { return {separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) { values[0] = state[1]; }
  static double find_gap(const double* state) { return state[1]; }

  /// Writes the consistent tangent ∂σ/∂ε [Pa], NS × NS by rows, to `tangent` unless it is null.
  template <int NS>
  Response<double> update_point(double* sigma, const double* d_epsilon, double* state,
                                const Surroundings<double>& given, double* tangent = nullptr) const;

 private:
  Bedding(const MohrCoulomb& soil, const MohrCoulombStrength& planes, double angle);

  template <int NS>
  bool exceeds_planes(const double* sigma) const;
  /// Performs the update without gaps.
  template <int NS>
  Response<double> update_coherent(double* sigma, const double* d_epsilon, double* state, double* tangent) const;

  MohrCoulomb soil_;
  MohrCoulombStrength planes_;
  double along_[2];  ///< direction of the planes
};

struct NoStrength : SliceLaw<NoStrength> {
  static constexpr Traits traits{.word = "no_strength",
                                 .meaning = "a weight without any strength, such as refuse or water, for LEM",
                                 .title = "no strength",
                                 .serves_slices = true,
                                 .only_slices = true,
                                 .takes_water = false,
                                 .paragraphs = {"linear_elastic"},
                                 .assumption = "{}: acts by its weight alone."};

  using Input = Needs<YoungInput, PoissonInput>;
  static StrengthLaw make_strength(const Input&) {
    return {[](const StrengthPlane&) { return StrengthTangent{}; }, false, false};
  }
  static bool is_total_stress(const Input&) { return true; }
};

}  // namespace talus::material
