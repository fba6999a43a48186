// SPDX-License-Identifier: MIT
// Checks of [timeline] against the rest of the case.
#include "input/case/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "input/case/checks.hpp"

namespace talus::input {

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
