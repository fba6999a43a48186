// SPDX-License-Identifier: MIT
#pragma once
// One point of soil: its law, stress, state variables and pore water, without a mesh.

#include <array>
#include <optional>

#include "input/case/case.hpp"
#include "material/law.hpp"
#include "material/water/retention.hpp"

namespace talus::laboratory {

/// xx yy zz xy yz zx; stresses positive in tension, shear strains engineering ones.
using Voigt = std::array<double, 6>;

/// What changes from step to step.
struct PointState {
  Voigt stress{};  ///< effective [Pa]
  std::array<double, material::max_state_size> state{};
  double suction = 0;  ///< [Pa]
  double time = 0;     ///< [s]: what laws with a clock of their own are told
};

class PointSoil {
 public:
  /// `stress`: at the start, net [Pa]. Throws Error (wrong_input) when the soil does not carry it.
  PointSoil(const input::Material& material, const Voigt& stress, double suction);

  const PointState& start() const { return start_; }
  /// The state after the strain increment `d_epsilon`, at the end of which the pore water has `suction` [Pa]. If an
  /// external model fails, the stress is NaN: a smaller step may succeed.
  PointState advance(const PointState& from, const Voigt& d_epsilon, double suction) const;
  /// Throws Error (unstable) with the last failure of an external model, if there was one.
  void throw_failure() const;

  double find_saturation(double suction) const;
  /// χ s: effective less net stress [Pa].
  double find_suction_stress(double suction) const;
  /// p'_c [Pa]; 0 for laws without one.
  double find_preconsolidation(const PointState& at) const;
  /// Of the law's own, or from the volumetric strain (compression positive) since the start [-].
  double find_void_ratio(const PointState& at, double volumetric_strain) const;

 private:
  void set_start_state(const input::Material& material);

  material::Law law_;
  material::Retention retention_;
  bool is_wet_;
  double chi_air_entry_;
  double void_ratio_;
  PointState start_;
  mutable std::optional<material::LawFailure> failure_;
};

}  // namespace talus::laboratory
