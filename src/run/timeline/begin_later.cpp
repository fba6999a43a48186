// SPDX-License-Identifier: MIT
#include "run/timeline/begin_later.hpp"

#include "ground/plane_water.hpp"

namespace talus::run {
namespace {

void shift(input::TimeTable& table, double time) {
  for (double& t : table.time) t -= time;
}

}  // namespace

input::Case begin_later(input::Case data, double time, std::shared_ptr<const input::KnownWater> water) {
  // The water is that before a jump of a series, and so are the pools and the weather that go with it.
  const double before = time + ground::find_first_time(data);
  for (input::Hydraulic& h : data.hydraulics)
    for (input::TimeTable* table : {&h.head, &h.pressure, &h.rate}) shift(*table, before);
  for (input::Roots& roots : data.roots)
    if (roots.transpiration) shift(roots.transpiration->rate, before);
  data.timeline.reset();
  if (!water) return data;
  data.initial.water.pressure = input::InitialPressure::zero;
  data.initial.water.season = 0;
  data.initial.water.known = std::move(water);
  return data;
}

}  // namespace talus::run
