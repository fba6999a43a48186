#pragma once
// Finite elements in a run: calculated or taken from what an interrupted run has left, and kept in the folder.

#include <functional>
#include <optional>
#include <string>

#include "results/run.hpp"
#include "run/fem/run_fem.hpp"
#include "run/options.hpp"

namespace talus::run {

class ElementRun {
 public:
  /// `data`: what is calculated. `alone`: no other method answers.
  ElementRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash);

  /// `open` is called when mesh and model stand, before anything is written. Throws Error (interrupted), and what
  /// run_fem() throws where finite elements answer alone; beside others the reason stands in the result.
  void calculate(const std::function<void()>& open);
  void tell(results::RunResult& run) const;

 private:
  void keep(const ElementOutcome& outcome) const;

  const input::Case& data_;
  const RunOptions& options_;
  std::string hash_;
  bool alone_;
  std::optional<ElementOutcome> outcome_;
};

}  // namespace talus::run
