// SPDX-License-Identifier: MIT
// Checks of [timeline] against the rest of the case.
#include "input/case/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "input/case/checks.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Release& r) {
  v.key("criterion", r.criterion, plain(), "Criterion for the start of MPM, where no time is given.");
  v.key("time", r.time, quantity("day").at_least(0).example(R"("17 h")"),
        "Start of MPM; if not given, at the first time at which the criterion holds.");
  v.key("date", r.date, plain().allowed_without("time", r.time.has_value()).example("2023-07-14"),
        "The same as a date, in place of `time`; [initial] date says when time 0 is.");
  v.key("apart", r.apart, quantity("day").at_least(0).example(R"("30 min")"),
        "How much earlier and later the points are released as well, to show what the runout owes to the moment: the "
        "nearest times at which the water is kept. If not given, the next ones; 0: neither.");
}

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

namespace {

/// Returns the path of the key that gave the times, either as times or as dates.
std::string find_path(const Findings& findings, const char* times, const char* dates) {
  const std::string table = "timeline.";
  return table + (findings.places.is_given(table + dates) ? dates : times);
}

void check_release(const Case& data, Findings& findings) {
  const Timeline& timeline = *data.timeline;
  if (!timeline.release) return;
  // In a sampling study LEM analyses the samples.
  if (!uses(data, Method::mpm) && data.study.mode != StudyMode::sample)
    findings.add("timeline.release", "MPM starts from the timeline: add \"mpm\" to [analysis] methods");
  else if (uses(data, Method::mpm) && data.analysis != AnalysisKind::run)
    findings.add("timeline.release",
                 "MPM computes the slide from there: that is [analysis] kind = \"run\", not a reduction of strength");
  const std::string path = find_path(findings, "release.time", "release.date");
  if (!timeline.release->time || !findings.is_sound(path)) return;
  if (findings.places.is_given("timeline.release.criterion") &&
      timeline.release->criterion == ReleaseCriterion::equilibrium)
    findings.add("timeline.release.criterion",
                 "the time of the release is given, so no criterion finds it; take one of the two out");
  const double at = *timeline.release->time;
  if (at < 0 || at > timeline.duration * (1 + 1e-12))
    findings.add(path, "{:g} s is outside the timeline, which lasts from 0 to {:g} s", at, timeline.duration);
  else if (!timeline.times.empty() && at > 0 &&
           std::find(timeline.times.begin(), timeline.times.end(), at) == timeline.times.end())
    findings.add(path, "{:g} s is not one of [timeline] times", at);
}

void check_element_times(const Case& data, Findings& findings) {
  const Timeline& timeline = *data.timeline;
  const std::string path = find_path(findings, "element_times", "element_dates");
  if (!timeline.element_times || !findings.is_sound(path)) return;
  if (!uses(data, Method::fem) && data.study.mode != StudyMode::sample)
    findings.add(path, "strength is reduced by FEM: add \"fem\" to [analysis] methods");
  if (!std::is_sorted(timeline.element_times->begin(), timeline.element_times->end(), std::less_equal<>()))
    findings.add(path, "the times must increase");
  for (const double t : *timeline.element_times) {
    if (!(t > 0) || t > timeline.duration * (1 + 1e-12))
      findings.add(path, "{:g} s is outside the timeline, which lasts from 0 to {:g} s; time 0 is always there", t,
                   timeline.duration);
    else if (!timeline.times.empty() &&
             std::find(timeline.times.begin(), timeline.times.end(), t) == timeline.times.end())
      findings.add(path, "{:g} s is not one of [timeline] times", t);
  }
}

}  // namespace

void check_timeline(const Case& data, Findings& findings) {
  if (!data.timeline) return;
  const Timeline& timeline = *data.timeline;
  if (!uses(data, Method::lem))
    findings.add("timeline", "the factor of safety in time is computed by LEM: add \"lem\" to [analysis] methods");
  if (uses(data, Method::lem) && data.lem.search == SurfaceSearch::none && data.lem.surfaces.empty())
    findings.add("timeline", "[lem] search = \"none\" needs a [[lem.surface]], whose factor is followed");
  if (data.mesh.dimension != 2) findings.add("timeline", "the factor of safety in time needs a plane section");
  if (!is_wet(data) && findings.is_sound("materials"))
    findings.add("timeline",
                 "without pore water nothing changes in time: a soil with [materials.NAME.water] is missing");
  if (!data.initial.result.empty())
    findings.add("timeline", "not with [initial] result: a timeline starts from the water that [initial] names");
  if (timeline.pool_loading && findings.is_sound("materials") &&
      std::none_of(data.materials.begin(), data.materials.end(),
                   [](const auto& m) { return m.second.water.compressibility > 0; }))
    findings.add(
        "timeline.pool_loading",
        "pools load the pore water of soil that gives way: a `compressibility` in [materials.NAME.water] is missing");
  if (findings.is_sound("timeline.duration")) check_release(data, findings);
  const std::string path = find_path(findings, "times", "dates");
  if (!findings.is_sound(path) || !findings.is_sound("timeline.duration")) return;
  const std::vector<double>& times = timeline.times;
  if (!std::is_sorted(times.begin(), times.end(), std::less_equal<>())) findings.add(path, "the times must increase");
  check_element_times(data, findings);
  for (const double t : times)
    if (!(t > 0) || t > timeline.duration * (1 + 1e-12))
      findings.add(path, "{:g} s is outside the timeline, which lasts from 0 to {:g} s; time 0 is always there", t,
                   timeline.duration);
}

}  // namespace talus::input
