// SPDX-License-Identifier: MIT
#pragma once
// The pore water of a slope in time: transient seepage, and the slope and the case at each of its times.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "results/timeline.hpp"
#include "results/water.hpp"
#include "run/lem/run_lem.hpp"
#include "run/timeline/moment.hpp"
#include "site/season.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {

class WaterInTime {
 public:
  /// Prepares the model of the seepage. Throws Error (wrong_input) if the soil has no water storage.
  explicit WaterInTime(const input::Case& data);

  /// Computes the seepage from the pore water of the slope at time 0, and adds its measures to `summary`. Throws what
  /// transient seepage throws.
  void calculate(const PreparedSlope& prepared, results::Timeline& summary);

  /// The case with closed sides, for the seepage.
  const input::Case& data() const { return data_; }
  /// The stored times, including 0 [s].
  const std::vector<double>& times() const { return times_; }
  std::size_t find_nearest(double time) const;

  /// Returns the slope at a time. At a jump of a series the state is that before the jump.
  Moment make_moment(std::size_t number) const;
  /// Returns the case that starts from the pore water of a time.
  input::Case begin_at(std::size_t number) const;
  /// Returns true if water of that level stands on the ground of a condition, and not on a side of the model or inside
  /// it.
  bool stands_on_ground(const input::Hydraulic& condition, double level) const;

  /// Adds the water levels at `times` to `summary`, and makes the fields of the pressure there.
  void keep_states(const std::vector<double>& times, results::Timeline& summary);
  /// Returns these fields; nullptr if they are too large for a report.
  const results::WaterFields* fields() const { return fields_ ? &*fields_ : nullptr; }

 private:
  const std::vector<double>& find_pressure(std::size_t number) const;
  results::WaterField make_first_field() const;

  const input::Case& given_;
  const input::Case data_;
  mesh::Mesh<2> mesh_, wet_mesh_;
  fem::SeepageModel<2> model_;
  lem::Section section_;                ///< at time 0
  std::vector<double> first_pressure_;  ///< at the nodes, positive in tension [Pa]
  site::FlowInTime<2> flow_;
  std::vector<double> times_;
  site::WaterResult water_;
  std::optional<results::WaterFields> fields_;
};

}  // namespace talus::run
