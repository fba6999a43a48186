// SPDX-License-Identifier: MIT
#pragma once
// A material point without a mesh: its law, stress, state variables and pore water, and its mixed control by strains
// and stresses.

#include <array>
#include <memory>
#include <optional>

#include "input/case/case.hpp"
#include "material/law.hpp"
#include "material/water/retention.hpp"

namespace talus::laboratory {

/// xx yy zz xy yz xz; stresses positive in tension, engineering shear strains.
using Voigt = std::array<double, 6>;

/// Variables of the point that change from step to step.
struct PointState {
  Voigt stress{};  ///< effective [Pa]
  std::array<double, material::max_state_size> state{};
  double suction = 0;  ///< [Pa]
  double time = 0;     ///< for rate-dependent laws [s]
};

class PointSoil {
 public:
  /// `stress`: initial net stress [Pa]. Throws Error (wrong_input) if it exceeds the strength of the soil.
  PointSoil(const input::Material& material, const Voigt& stress, double suction, const ShownUnit& unit);

  const PointState& start() const { return start_; }
  /// Returns the state after the strain increment `d_epsilon`, with the final `suction` [Pa]. If an external model
  /// fails, the stress is NaN, and a smaller step may succeed.
  PointState advance(const PointState& from, const Voigt& d_epsilon, double suction) const;
  /// Throws Error (unstable) with the last failure of an external model, if there was one.
  void throw_failure() const;

  double find_saturation(double suction) const;
  /// χ s: effective less net stress [Pa].
  double find_suction_stress(double suction) const;
  /// p'_c [Pa]; 0 for laws without one.
  double find_preconsolidation(const PointState& at) const;
  /// Void ratio of the law, or from the volumetric strain (compression positive) since the start [-].
  double find_void_ratio(const PointState& at, double volumetric_strain) const;

 private:
  void set_start_state(const input::Material& material);

  std::shared_ptr<const material::Law> law_;
  material::Retention retention_;
  bool is_wet_;
  double chi_air_entry_;
  double void_ratio_;
  PointState start_;
  mutable std::optional<material::LawFailure> failure_;
};

// In mixed control some strain components are prescribed, and the others follow from prescribed stresses.

/// One step: its strain increment is `fixed` + Σ x_k free_k, and measure_k·σ' must be target_k at its end.
struct PointStep {
  static constexpr std::size_t most_free = 2;
  Voigt fixed{};
  std::size_t free_count = 0;
  std::array<Voigt, most_free> free{}, measure{};
  std::array<double, most_free> target{};  ///< [Pa]
  double suction = 0;                      ///< at the end [Pa]

  void add(const Voigt& direction, const Voigt& stress, double goal);
};

/// Advances one test by consecutive steps. Newton's method on x with a tangent by differences of the law, which is
/// kept from step to step and corrected by Broyden's rank-one formula; a step that does not converge is halved.
class PointController {
 public:
  explicit PointController(const PointSoil& soil) : soil_(soil) {}

  /// Advances `state` by the step; `strain` is the total strain increment. Returns false if the step does not
  /// converge; `state` and `strain` are then those of the part that did.
  bool advance(PointState& state, Voigt& strain, const PointStep& step);

  /// Returns true if a step failed because the model returned NaN.
  bool has_model_failed() const { return has_model_failed_; }

 private:
  using Vector = std::array<double, PointStep::most_free>;

  bool advance(PointState& state, Voigt& strain, const PointStep& step, int halvings);
  bool solve(PointState& state, Voigt& strain, const PointStep& step);
  void find_tangent(const PointState& from, const PointStep& step, const Vector& x, const Vector& error);

  const PointSoil& soil_;
  std::array<Vector, PointStep::most_free> tangent_{};  ///< [row: measure][column: x]
  Vector last_{};                                       ///< x of the last step
  bool has_tangent_ = false, has_model_failed_ = false;
};

}  // namespace talus::laboratory
