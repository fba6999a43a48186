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

void describe(auto& v, Release& r) {
  v.key("criterion", r.criterion, plain(), "Criterion for the start of MPM, where no time is given.");
  v.key("time", r.time, quantity("day").at_least(0).example(R"("17 h")"),
        "Start of MPM; if not given, at the first time at which the criterion holds.");
  v.key("date", r.date, plain().allowed_without("time", r.time.has_value()).example("2023-07-14"),
        "The same as a date, in place of `time`; [initial] date says when time 0 is.");
  v.key("apart", r.apart, quantity("day").at_least(0).example(R"("30 min")"),
        "How much earlier and later the points are released as well, to show what the runout owes to the moment: the "
        "nearest times at which the water is kept. If not given, the next ones; 0: neither.");
}

void describe(auto& v, Timeline& t) {
  v.key("until", t.until, plain().example("2023-07-31"),
        "The date of its end, in place of `duration`; [initial] date says when it begins.");
  v.key("duration", t.duration,
        quantity("day").above(0).required().unless_given("until", t.until.has_value()).example("3"),
        "How long it lasts. It begins at time 0 with the pore pressure that [initial] names; the [[hydraulic]] series "
        "give rain, evaporation and pools.");
  v.key("times", t.times, quantity("day").example(R"(["6 h", 0.5, 1, 3])"),
        "When the factor of safety is found, beside time 0. If not given, times are chosen where the factor bends, "
        "passes the target or is least.");
  v.key("dates", t.dates, plain().allowed_without("times", !t.times.empty()).example("[2023-07-04, 2023-07-09]"),
        "The same as dates, in place of `times`; [initial] date says when time 0 is.");
  v.key("target", t.target, plain().above(0), "The slope fails where its factor falls below this.");
  v.key("tolerance", t.tolerance, plain().above(0).below(0.5),
        "Times are chosen until the straight lines between them are this near to the factor, over the factor.");
  v.key("most_times", t.most_times, plain().at_least(3).at_most(1000), "Most times that are chosen.");
  v.key("element_times", t.element_times, quantity("day").example(R"(["1 day", 3])"),
        "Times of strength reduction by FEM besides time 0, if \"fem\" is among the methods. If not given, the time of "
        "the least factor by LEM.");
  v.key("element_dates", t.element_dates,
        plain().allowed_without("element_times", t.element_times.has_value()).example("[2023-07-04]"),
        "The same as dates, in place of `element_times`.");
  v.key("pool_loading", t.pool_loading, plain(),
        "The weight of pools that rise or fall compresses the saturated soil under them, so that its pore pressure "
        "follows at once (vertical compression; B̄ = m_v / (m_v + n / K_w)). Without it the total stress is taken as "
        "constant, as seepage programs do.");
  v.optional_table("release", t.release,
                   "Start of MPM at a time of the timeline: the stages of the case start from the pore water of that "
                   "time and continue with the rain and the pools that follow. Let the first stage hold the slope "
                   "until it rests, and the next one release it.");
}

}  // namespace talus::input
