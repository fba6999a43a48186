#pragma once
// Strength reduction by finite elements on a case.

#include <functional>
#include <optional>

#include "base/progress.hpp"
#include "input/case/case.hpp"
#include "results/elements.hpp"

namespace talus::run {

/// What finite elements found, with the mesh and the fields at failure.
struct ElementOutcome {
  results::ElementResult result;
  results::ElementMesh mesh;
};

struct FemOptions {
  int threads = 1;
  Progress* progress = nullptr;
  /// Called when mesh and model stand, before the first calculation.
  std::function<void()> ready;
  /// What an interrupted run has found: its flow rules are not calculated again.
  std::optional<ElementOutcome> known;
  /// Called when a flow rule is done, with all that is known by then.
  std::function<void(const ElementOutcome&)> keep;
};

/// Throws Error (wrong_input) when there is no equilibrium at any factor or an element is inverted; Error
/// (interrupted).
ElementOutcome run_fem(const input::Case& data, const FemOptions& options);

}  // namespace talus::run
