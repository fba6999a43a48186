// SPDX-License-Identifier: MIT
#pragma once
// The weather before the run: transient seepage with rain and transpiration in rigid soil (docs/theory/16-season.md).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "input/case/case.hpp"
#include "results/water.hpp"

namespace talus::site {

/// Record of a season in 100 equal intervals. Volumes [m³] (2D: per metre of thickness) count from its start.
struct SeasonRecord {
  struct Suctions {
    double mean = 0, least = 0, greatest = 0;  ///< of a layer; negative is pressure [Pa]
  };
  struct Row {
    double time = 0;    ///< [s]; negative: before the run
    double stored = 0;  ///< growth of the water stored in the soil
    double inflow = 0, outflow = 0, runoff = 0;
    double potential = 0, transpired = 0;
    std::vector<Suctions> layers;
  };
  std::vector<double> depths;  ///< lower limits of the layers under the ground [m]
  std::vector<Row> rows;       ///< the first is the start
  double initial = 0;          ///< water stored in the soil at the start [m³]
  std::vector<fem::Discharge> discharges;
  std::vector<fem::Uptake> uptakes;
  int steps = 0, rejected = 0, iterations = 0;
  /// State of the water at the end of each tenth of the season.
  std::vector<results::WaterState> states;
  std::vector<results::WaterField> fields;  ///< fields of `states`; none in 3D

  /// Returns the imbalance inflow - outflow - transpired - growth over the largest of these [-].
  double find_error() const;
};

template <int D>
struct Season {
  fem::SeepageResult<D> end;
  SeasonRecord record;
};

/// Transient seepage with transpiration: states and volumes at the times of `schedule`, and their record.
template <int D>
struct FlowInTime {
  fem::SeepageHistory<D> history;
  SeasonRecord record;  ///< without states and fields
};
/// Runs transient seepage from the heads `initial` per node. `key` names the option that requires it, for messages.
/// Throws as run_season().
template <int D>
FlowInTime<D> follow_flow(const input::Case& data, const fem::SeepageModel<D>& model,
                          const std::vector<double>& initial, const fem::SeepageSchedule& schedule,
                          const std::string& key, const fem::SeepageOutput<D>& on_output = {});

/// Error of a time step that controls the next one [m of water]: 0.1 kPa.
inline constexpr double head_tolerance = 0.01;

/// Runs the season from the heads `initial` per node at the time -season to 0. `mesh` of the model has dry soil empty.
/// Throws as solve_transient_seepage() and make_root_sinks().
template <int D>
Season<D> run_season(const input::Case& data, const fem::SeepageModel<D>& model, const std::vector<double>& initial);

results::Season make_season_result(const SeasonRecord& record);

/// Writes season.csv, the rows of the record. Throws Error (cannot_write).
void write_season(const std::filesystem::path& path, const SeasonRecord& record);

}  // namespace talus::site
