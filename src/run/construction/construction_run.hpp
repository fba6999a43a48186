// SPDX-License-Identifier: MIT
#pragma once
// Stages of construction in a run: their consolidation by FEM, and the methods at their ends.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "run/construction/stage_model.hpp"
#include "run/construction/stage_record.hpp"
#include "run/construction/steady_water.hpp"

namespace talus::run {

inline constexpr const char *construction_file = "construction.json", *restart_file = "construction_state.json";

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
  /// Computes the stages alone, without factors and without files. Returns their steps and monitors.
  results::Construction follow();
  void write_result(results::RunResult& run) const;
  /// Removes the file that only a resumed run needs.
  void forget() const;

 private:
  void find_start();
  bool restore();
  void keep_state() const;
  bool run_stage(int number);
  fem::ConsolidationSchedule make_schedule(int number) const;
  void add_step(const StageModel& stage, const fem::ConsolidationStep& step, const fem::SolidState<2>& solid,
                const std::vector<double>& head, results::ConstructionStage& result);
  void add_water_warning(const input::ConstructionStage& asked, const SteadyWater& steady);
  bool keeps_excess(const results::ConstructionStage& result) const;
  bool add_undrained_factors(const input::Case& later, int number, results::ConstructionStage& result);
  void add_warnings(const std::string& stage, const std::vector<std::string>& warnings);
  double find_most_displacement() const;
  void add_factors(int number, results::ConstructionStage& result);
  void release(int number, results::ConstructionStage& result);
  void find_least();
  input::Case make_later_case() const;
  void keep();
  void show(const std::string& what) const;

  const input::LoadedCase& loaded_;
  const input::Case& data_;
  const RunOptions& options_;
  const std::string hash_;
  std::shared_ptr<const mesh::Mesh<2>> mesh_;
  std::unique_ptr<StageModel> stage_;   ///< the last one
  fem::ConsolidationState<2> state_;    ///< at its end
  std::vector<double> start_pressure_;  ///< nodal, at its start [Pa]; empty before the first stage
  std::vector<double> steady_head_;     ///< of steady flow at its end [m]; before the first stage those of the start
  std::optional<StageRecord> record_;   ///< from prepare() on
  results::Construction summary_;
  std::vector<std::string> warnings_;
  std::map<std::string, std::vector<std::string>> stage_warnings_;  ///< of the methods, with the stages that have them
};

}  // namespace talus::run
