// SPDX-License-Identifier: MIT
#pragma once
// Results of the stages of construction at places: monitors in time, section lines and fields at the ends of stages.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fem/consolidation/consolidation.hpp"
#include "results/construction_restart.hpp"
#include "run/construction/stage_model.hpp"

namespace talus::run {

/// Returns the value of a curve between its points, of several at one time the last; NaN beyond its ends.
double read_in_time(const std::vector<double>& time, const std::vector<double>& value, double t);

class StageRecord {
 public:
  /// `whole`: mesh of the section with all regions. Throws Error (wrong_input) for a monitor outside it.
  StageRecord(const input::Case& data, std::shared_ptr<const mesh::Mesh<2>> whole);

  /// Heads of steady flow, from which excess pressures are counted until the next ones.
  void set_steady(const std::vector<double>& head) { steady_head_ = head; }
  /// Adds the monitored places at the end of a step.
  void add_step(double time, const StageModel& stage, const fem::SolidState<2>& solid, const std::vector<double>& head);
  /// Adds fields and section lines at the end of a stage.
  void add_stage(const std::string& name, const StageModel& stage, const fem::ConsolidationState<2>& state);

  /// Monitors with their measurements.
  std::vector<results::ConstructionMonitor> make_monitors() const;
  const std::vector<results::ConstructionLine>& lines() const { return lines_; }
  /// Times of the monitors [s].
  const std::vector<double>& times() const { return times_; }
  const results::ConstructionFile& fields() const { return file_; }
  /// Copies all that is recorded, and takes it back.
  void keep(results::ConstructionRestart& restart) const;
  void restore(results::ConstructionRestart& restart);

 private:
  /// An element at a place; neighbours share the places between them.
  struct Inside {
    int element = -1;
    std::array<double, 3> share{};  ///< barycentric
  };
  using Place = std::vector<Inside>;
  /// Displacement, pore pressure, excess [Pa] and effective stress at a place; NaN where no soil is.
  struct Values {
    Vec<2> displacement{};
    double pressure = 0, excess = 0;
    std::array<double, 6> stress{};
  };
  class Reader;

  Place find_place(const Vec<2>& x) const;
  std::pair<double, double> find_pressures(const StageModel& stage, const std::vector<double>& head,
                                           std::size_t node) const;

  const input::Case& data_;
  std::shared_ptr<const mesh::Mesh<2>> mesh_;
  std::vector<double> steady_head_, times_;
  std::vector<Place> places_;                    ///< of the monitors
  std::vector<std::vector<Place>> line_places_;  ///< of each line
  std::vector<results::ConstructionMonitor> monitors_;
  std::vector<results::ConstructionLine> lines_;
  results::ConstructionFile file_;
};

/// Converts the fields at the end of a stage to VTK's XML format: triangles with soil, displacement, pore pressures,
/// and the fraction of each that has yielded.
std::string write_stage_vtu(const results::ConstructionFile& file, std::size_t stage);

}  // namespace talus::run
