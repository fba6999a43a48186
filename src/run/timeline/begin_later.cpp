// SPDX-License-Identifier: MIT
#include "run/timeline/begin_later.hpp"

namespace talus::run {
namespace {

void shift(input::TimeTable& table, double time) {
  for (double& t : table.time) t -= time;
}

}  // namespace

input::Case begin_later(input::Case data, double time, std::shared_ptr<const input::KnownWater> water) {
  for (input::Hydraulic& h : data.hydraulics)
    for (input::TimeTable* table : {&h.head, &h.pressure, &h.rate}) shift(*table, time);
  for (input::Roots& roots : data.roots)
    if (roots.transpiration) shift(roots.transpiration->rate, time);
  data.timeline.reset();
  data.initial.water.pressure = input::InitialPressure::zero;
  data.initial.water.season = 0;
  data.initial.water.known = std::move(water);
  return data;
}

}  // namespace talus::run
