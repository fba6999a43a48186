// SPDX-License-Identifier: MIT
// What must hold between the keys of [timeline] and the rest of a case.

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "input/case/checks.hpp"

namespace talus::input {

void check_timeline(const Case& data, Findings& findings) {
  if (!data.timeline) return;
  const Timeline& timeline = *data.timeline;
  if (!uses(data, Method::lem))
    findings.add("timeline", "the factor of safety in time is found by slices: add \"lem\" to [analysis] methods");
  if (uses(data, Method::lem) && data.lem.search == SurfaceSearch::none && data.lem.surfaces.empty())
    findings.add("timeline", "[lem] search = \"none\" needs a [[lem.surface]], whose factor is followed");
  if (data.mesh.dimension != 2) findings.add("timeline", "the factor of safety in time needs a plane section");
  if (!is_wet(data) && findings.is_sound("materials"))
    findings.add("timeline",
                 "without pore water nothing changes in time: a soil with [materials.NAME.water] is missing");
  if (!data.initial.result.empty())
    findings.add("timeline", "not with [initial] result: a timeline begins with the water that [initial] names");
  if (!findings.is_sound("timeline.times") || !findings.is_sound("timeline.duration")) return;
  const std::vector<double>& times = timeline.times;
  if (!std::is_sorted(times.begin(), times.end(), std::less_equal<>()))
    findings.add("timeline.times", "the times must increase");
  for (const double t : times)
    if (!(t > 0) || t > timeline.duration * (1 + 1e-12))
      findings.add("timeline.times", fmt::format("{:g} s is outside the timeline, which lasts from 0 to {:g} s; time 0 "
                                                 "is always there",
                                                 t, timeline.duration));
}

}  // namespace talus::input
