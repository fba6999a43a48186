// SPDX-License-Identifier: MIT
#pragma once
// [timeline]: the factor of safety over time, through storms and drawdown, and the transition to MPM.

#include <optional>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// Criterion of the transition from the timeline to MPM.
enum class ReleaseCriterion { target, equilibrium };

template <>
inline constexpr auto choices<ReleaseCriterion> = std::array{
    Choice{ReleaseCriterion::target, "target", "the factor of safety by LEM is below `target`"},
    Choice{ReleaseCriterion::equilibrium, "equilibrium", "FEM with the strength as given does not converge"},
};

/// [timeline.release]: transition to MPM.
struct Release {
  ReleaseCriterion criterion = ReleaseCriterion::target;
  std::optional<double> time;  ///< of the transition [s]; std::nullopt: the first time at which the criterion holds
  std::optional<Date> date;    ///< the same as a date; std::nullopt after conversion to `time`
  std::optional<double>
      apart;  ///< offset of an earlier and a later release [s], approximate; std::nullopt: the adjacent times
};

struct Timeline {
  double duration = 0;        ///< from time 0 [s]
  std::optional<Date> until;  ///< the end as a date; std::nullopt after conversion to `duration`
  std::vector<double> times;  ///< times of the factors [s]; empty: chosen automatically
  std::vector<Date> dates;    ///< the same as dates; empty after conversion to `times`
  double target = 1;          ///< failure is a factor below this value [-]
  double tolerance = 0.003;   ///< relative tolerance of the factor between automatically chosen times [-]
  int most_times = 40;        ///< limit of automatically chosen times
  std::optional<std::vector<double>>
      element_times;  ///< times of FEM factors [s]; std::nullopt: time of the lowest factor
  std::optional<std::vector<Date>> element_dates;  ///< the same as dates
  bool pool_loading =
      false;  ///< undrained loading: rising and falling pools change the pore pressure of saturated soil
  std::optional<Release> release;
};

void describe(Visitor& v, Release& r);

void describe(Visitor& v, Timeline& t);

}  // namespace talus::input
