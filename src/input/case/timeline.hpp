// SPDX-License-Identifier: MIT
#pragma once
// [timeline]: the factor of safety through storms and drawdown.

#include <optional>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// [timeline.release]: material points take over.
struct Release {
  std::optional<double> time;   ///< when [s]; nothing: where the factor is first below the target
  std::optional<double> apart;  ///< about how much earlier and later as well [s]; nothing: the next times
};

struct Timeline {
  double duration = 0;        ///< from time 0 on [s]
  std::optional<Date> until;  ///< its end, where it is given instead; nothing once `duration` is known
  std::vector<double> times;  ///< when factors are found [s]; empty: chosen
  double target = 1;          ///< a factor below it is failure [-]
  double tolerance = 0.003;   ///< of the factor between the times that are chosen, over it [-]
  int most_times = 40;        ///< that are chosen
  std::optional<std::vector<double>> element_times;  ///< of finite elements [s]; nothing: the time of the least factor
  std::optional<Release> release;
};

template <class Visitor>
void describe(Visitor& v, Release& r) {
  v.key("time", r.time, quantity("day").at_least(0).example(R"("17 h")"),
        "When material points take over; if not given, at the first time that is found below the target.");
  v.key("apart", r.apart, quantity("day").at_least(0).example(R"("30 min")"),
        "How much earlier and later the points are released as well, to show what the runout owes to the moment: the "
        "nearest times at which the water is kept. If not given, the next ones; 0: neither.");
}

template <class Visitor>
void describe(Visitor& v, Timeline& t) {
  v.key("until", t.until, plain().example("2023-07-31"),
        "The date of its end, in place of `duration`; [initial] date says when it begins.");
  v.key("duration", t.duration,
        quantity("day").above(0).required().unless_given("until", t.until.has_value()).example("3"),
        "How long it lasts. It begins at time 0 with the pore pressure that [initial] names; the [[hydraulic]] series "
        "give rain, evaporation and pools.");
  v.key("times", t.times, quantity("day").example(R"(["6 h", 0.5, 1, 3])"),
        "When the factor of safety is found, beside time 0. If not given, times are chosen where the factor bends, "
        "passes the target or is least.");
  v.key("target", t.target, plain().above(0), "The slope fails where its factor falls below this.");
  v.key("tolerance", t.tolerance, plain().above(0).below(0.5),
        "Times are chosen until the straight lines between them are this near to the factor, over the factor.");
  v.key("most_times", t.most_times, plain().at_least(3).at_most(1000), "Most times that are chosen.");
  v.key("element_times", t.element_times, quantity("day").example(R"(["1 day", 3])"),
        "When finite elements reduce the strength as well, beside time 0, where they are among the methods. If not "
        "given, at the time at which slices find the least factor.");
  v.optional_table("release", t.release,
                   "Material points take over at a time: the stages of the case, which begin with the pore water of "
                   "that time and go on with the rain and the pools that follow. Let the first of them hold the slope "
                   "until it rests, and the next one let it go.");
}

}  // namespace talus::input
