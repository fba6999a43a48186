// SPDX-License-Identifier: MIT
#pragma once
// Tresca: undrained soil in total stresses with a strength s_u that may grow with depth or follow a profile. The code
// is that of Mohr–Coulomb with φ = 0 and c = s_u, with the growth of s_u as a state variable and without a tension
// cut-off.

#include <vector>

#include "material/mohr_coulomb.hpp"
#include "material/strength_profile.hpp"

namespace talus::material {

/// State variables: 0 as for Mohr–Coulomb; 1 increase of s_u with depth in the initial geometry [Pa], which moves with
/// the soil.
class Tresca {
 public:
  static constexpr Traits traits{
      .word = "tresca",
      .meaning = "undrained soil in total stresses: linear elastic, perfectly plastic with Tresca's strength",
      .title = "Tresca (undrained, total stress)",
      .serves_slices = true,
      .takes_water = false,
      .paragraphs = {"mohr_coulomb"},
      .assumption =
          "{}: undrained soil in total stresses (Tresca, φ = 0, c = s_u), perfectly plastic and without softening. "
          "Pore pressures do not act on it, and tension is limited by s_u alone."};
  static constexpr int state_size = 2;
  static constexpr bool is_plastic = true;

  using Input = Needs<YoungInput, PoissonInput, TrescaInput, StrengthProfile>;
  static void check(const Input& in, const SoilFindings& findings);
  static Tresca make(const Input& in, const StrengthChange& change) {
    return {LinearElastic::make(in), in.get<TrescaInput>().undrained_strength, change.factor};
  }
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  static void divide(const Input::Changeable& in, PartialDivision& division);
  static bool is_total_stress(const Input&) { return true; }
  using Local = Tresca;
  static bool varies(const Input& in) {
    const TrescaInput& s = in.get<TrescaInput>();
    return s.undrained_gradient != 0 || !s.profile_strengths.empty();
  }
  void set_initial_state(const Input& in, const StateStart& start, double* state) const;
  static void read_start(const double* state, StateStart& start) { start.strength_growth = state[1]; }

  /// `undrained_strength` is that of the case [Pa]; `factor` divides it and its growth.
  Tresca(const LinearElastic& elastic, double undrained_strength, double factor = 1)
      : soil_(elastic, {undrained_strength / factor, 0, 0, unlimited_tension}),
        undrained_strength_(undrained_strength),
        share_(1 / factor) {}

  TALUS_PORTABLE double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return soil_.constrained_modulus();
  }
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const { return soil_.elastic(); }
  template <int NS>
  TALUS_PORTABLE double elastic_energy(const double* sigma, const double* = nullptr) const {
    return soil_.elastic_energy<NS>(sigma);
  }
  template <int NS, class T>
  TALUS_KERNEL Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                                  const Surroundings<T>& = {}) const {
    // Without a tension cut-off the soil does not separate, so no gap is passed.
    return soil_.update_within<NS>(sigma, d_epsilon, state, static_cast<T*>(nullptr), active,
                                   soil_.widen_bounds<T>(state[1] * share_), {});
  }

  static std::vector<StateField> fields() { return {{"undrained_strength", "Pa"}}; }
  void show(const double* state, double /*saturation*/, double* values) const {
    values[0] = undrained_strength_ + state[1];
  }

 private:
  static constexpr double unlimited_tension = 1e15;  ///< [Pa]
  MohrCoulomb soil_;
  double undrained_strength_, share_;
};

}  // namespace talus::material
