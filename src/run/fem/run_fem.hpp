#pragma once
// Strength reduction by finite elements on a case, and what summary.json and fem.json tell of it.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "base/progress.hpp"
#include "input/case/case.hpp"

namespace talus::run {

struct FemResult {
  nlohmann::json block;  ///< "fem" of summary.json
  nlohmann::json file;   ///< fem.json: the quadratic mesh and its fields at failure
};

struct FemOptions {
  int threads = 1;
  Progress* progress = nullptr;
  /// Called when mesh and model stand, before the first calculation.
  std::function<void()> ready;
  /// What an interrupted run has found: its flow rules are not calculated again.
  FemResult known;
  /// Called when a flow rule is done, with all that is known by then.
  std::function<void(const FemResult&)> keep;
};

/// Throws Error (wrong_input) when there is no equilibrium at any factor or an element is inverted; Error
/// (interrupted).
FemResult run_fem(const input::Case& data, const FemOptions& options);

}  // namespace talus::run
