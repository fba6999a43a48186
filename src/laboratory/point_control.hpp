// SPDX-License-Identifier: MIT
#pragma once
// Mixed control of a point of soil: some strains are prescribed, others follow from stresses that are.

#include <array>

#include "laboratory/point_soil.hpp"

namespace talus::laboratory {

/// One step: its strain increment is `fixed` + Σ x_k free_k, and measure_k·σ' must reach target_k at its end.
struct PointStep {
  static constexpr std::size_t most_free = 2;
  Voigt fixed{};
  std::size_t free_count = 0;
  std::array<Voigt, most_free> free{}, measure{};
  std::array<double, most_free> target{};  ///< [Pa]
  double suction = 0;                      ///< at the end [Pa]

  void add(const Voigt& direction, const Voigt& stress, double goal);
};

/// Makes steps of one test one after the other. Newton's method on x with a tangent by differences of the law, which is
/// kept from step to step and corrected by Broyden's rank-one formula; a step that does not converge is halved.
class PointController {
 public:
  explicit PointController(const PointSoil& soil) : soil_(soil) {}

  /// The state at the end of the step, and the whole strain increment; false where the soil does not follow: `state`
  /// and `strain` are then those of the part that it did follow.
  bool advance(PointState& state, Voigt& strain, const PointStep& step);

  /// Whether a step that was not followed ended with a model that yields no number.
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
