// SPDX-License-Identifier: MIT
#pragma once
// Stages of construction in a run: their consolidation by FEM, and the methods at their ends.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "run/construction/stage_model.hpp"

namespace talus::run {

inline constexpr const char* construction_file = "construction.json";

class ConstructionRun {
 public:
  /// All arguments must outlive this object. `data`: the case or its design values.
  ConstructionRun(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options,
                  std::string input_hash);

  /// Makes the mesh and the models of all stages once, so that their faults are found before anything is written.
  void prepare();
  /// Computes the stages one after the other, and the factors at their ends. A stage without equilibrium ends the
  /// sequence, and its reason is part of the result. Throws Error (interrupted).
  void calculate();
  void write_result(results::RunResult& run) const;

 private:
  void find_start();
  bool run_stage(int number);
  fem::ConsolidationSchedule make_schedule(int number) const;
  void add_step(const StageModel& stage, const fem::ConsolidationStep& step, const fem::SolidState<2>& solid,
                const std::vector<double>& head, results::ConstructionStage& result);
  void add_monitors(const StageModel& stage, const fem::SolidState<2>& solid, const std::vector<double>& head);
  void add_fields(const StageModel& stage, const std::string& name);
  void add_factors(int number, results::ConstructionStage& result);
  void find_least();
  input::Case make_later_case() const;
  void keep() const;
  void show(const std::string& what) const;

  /// A monitored place in an element.
  struct Place {
    int element = -1;
    std::array<double, 3> share{};  ///< barycentric
  };

  const input::LoadedCase& loaded_;
  const input::Case& data_;
  const RunOptions& options_;
  const std::string hash_;
  std::shared_ptr<const mesh::Mesh<2>> mesh_;
  std::unique_ptr<StageModel> stage_;  ///< the last one
  fem::ConsolidationState<2> state_;   ///< at its end
  std::vector<double> first_head_;     ///< at the start of the stages [m]
  std::vector<Place> places_;
  results::Construction summary_;
  results::ConstructionFile file_;
  std::vector<std::string> warnings_;
  std::map<std::string, std::vector<std::string>> stage_warnings_;  ///< of the methods, with the stages that have them
};

}  // namespace talus::run
