// SPDX-License-Identifier: MIT
#include "results/runout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, Clock& r) {
  v.key("stage", r.stage, {"", "stage at whose start the clock is zero"});
  v.key("start", r.start, {"s", "start of that stage"});
  v.key("resets", r.resets, {"", "whether displacements are counted from there"});
  v.key("shown_times", r.shown_times, {"s", "times of sections and pictures"});
}

void describe(Visitor& v, MonitorMotion& r) {
  v.key("name", r.name, {"", "monitored place"});
  v.key("onset", r.onset, {"s", "onset of movement"});
  v.key("displacement", r.displacement, {"m", "displacement at the end"});
  v.maybe("settled", r.settled, {"m", "displacement at which an earlier movement came to rest"});
}

void describe(Visitor& v, Motion& r) {
  v.key("stage", r.stage, {"", "stage at whose start the clock is zero"});
  v.key("start", r.start, {"s", "start of that stage"});
  v.key("threshold", r.threshold, {"m", "displacement that counts as movement"});
  v.key("monitors", r.monitors, {"", "monitored places"});
  v.key("order", r.order, {"", "places in the order of their onset"});
  v.key("pattern", r.pattern, {"", "order of movement"});
  v.key("sentence", r.sentence, {"", "the same in words"});
}

void describe(Visitor& v, SectionLine& r) {
  v.key("name", r.name, {"", "section"});
  v.key("from", r.from, {"m", "one end"});
  v.key("to", r.to, {"m", "other end"});
  v.key("width", r.width, {"m", "width of the band"});
}

void describe(Visitor& v, Profile& r) {
  v.key("bin", r.bin, {"m", "width of a bin"});
  v.key("x", r.x, {"m", "centres of the bins"});
  v.key("height", r.height, {"m", "level of the ground"});
}

void describe(Visitor& v, BoxLimit& r) {
  v.key("front", r.front, {"", "soil that moved lies at the end of the box that it moves to"});
  v.key("crest", r.crest, {"", "soil that moved reaches back to the other end of the box"});
}

void describe(Visitor& v, RunoutSide& r) {
  v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
  v.key("deposit_volume", r.deposit_volume, {"m3", "volume over the old ground"});
  v.key("front_advance", r.front_advance, {"m", "advance of the front"});
  v.key("toe_distance", r.toe_distance, {"m", "runout beyond the toe"});
  v.key("crest_retreat", r.crest_retreat, {"m", "retreat of the crest"});
  v.key("centre_advance", r.centre_advance, {"m", "advance of the centre"});
  v.key("centre_drop", r.centre_drop, {"m", "drop of the centre"});
  v.key("largest_displacement", r.largest_displacement, {"m", "largest displacement"});
  v.key("direction", r.direction, {"", "1: towards larger x, -1: towards smaller x"});
  v.key("mass_front", r.mass_front, {"m", "x behind which 99 % of the moved mass lie"});
  v.key("mass_front_advance", r.mass_front_advance, {"m", "advance of 99 % of the moved mass"});
  v.key("farthest_advance", r.farthest_advance, {"m", "advance of the farthest point"});
  v.key("toe", r.toe, {"m", "x of the front"});
  v.key("initial_toe", r.initial_toe, {"m", "x of the toe at the start"});
  v.key("crest", r.crest, {"m", "x of the crest at the start"});
  v.maybe("limits", r.limits, {"", "what the ends of the box limit"});
}

void describe(Visitor& v, CoarserRunout& r) {
  v.key("size", r.size, {"m", "size of its elements"});
  v.key("front_advance", r.front_advance, {"m", "advance of the front"});
  v.key("toe_distance", r.toe_distance, {"m", "runout beyond the toe"});
  v.key("crest_retreat", r.crest_retreat, {"m", "retreat of the crest"});
  v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
  v.key("deposit_volume", r.deposit_volume, {"m3", "volume over the old ground"});
  v.key("highest_ground", r.highest_ground, {"m", "level of the highest ground"});
}

void describe(Visitor& v, Runout& r) {
  describe(v, static_cast<RunoutSide&>(r));
  v.key("moved_threshold", r.threshold, {"m", "displacement beyond which soil counts as moved"});
  v.key("deposit_threshold", r.deposit_threshold,
        {"m", "least thickness of a deposit, and least drop of ground that sank"});
  v.key("lowest_ground", r.lowest_ground, {"m", "level of the lowest ground at the start"});
  v.key("highest_ground", r.highest_ground, {"m", "level of the highest ground at the end"});
  v.maybe(
      "coarser_mesh", r.coarser_mesh,
      {"", "the same on elements twice as large; three times the difference is the uncertainty that the mesh leaves"});
  v.maybe("undetermined", r.undetermined,
          {"", "measures whose uncertainty exceeds half of them: their numbers hold for this mesh alone"});
  v.maybe("sides", r.sides, {"", "the same of each side, where the soil moved to both"});
}

bool Estimate::is_determined() const {
  constexpr double rounding = 1 + 1e-9;
  return !coarser || *uncertainty() <= rounding * std::max(most_uncertain * std::abs(value - datum), resolution);
}

std::string format_estimate(const Estimate& estimate, const ShownUnit& unit) {
  if (estimate.is_determined()) return format_uncertain(estimate.value, estimate.uncertainty(), unit);
  return fmt::format("not determined (two meshes: {} and {})", format_uncertain(estimate.value, std::nullopt, unit),
                     format_uncertain(*estimate.coarser, std::nullopt, unit));
}

RunoutEstimates::RunoutEstimates(const RunoutSide& side)
    : front_advance{side.front_advance},
      toe_distance{side.toe_distance},
      crest_retreat{side.crest_retreat},
      moved_volume{side.moved_volume},
      deposit_volume{side.deposit_volume} {}

RunoutEstimates::RunoutEstimates(const Runout& r) : RunoutEstimates(static_cast<const RunoutSide&>(r)) {
  highest_ground.value = r.highest_ground;
  if (!r.coarser_mesh) return;
  const CoarserRunout& c = *r.coarser_mesh;
  const double element = 0.5 * c.size;  // of the finer mesh
  front_advance = {r.front_advance, c.front_advance, 0, element};
  toe_distance = {r.toe_distance, c.toe_distance, 0, element};
  crest_retreat = {r.crest_retreat, c.crest_retreat, 0, element};
  moved_volume.coarser = c.moved_volume;
  deposit_volume.coarser = c.deposit_volume;
  highest_ground = {r.highest_ground, c.highest_ground, r.lowest_ground, element};
}

const Estimate* RunoutEstimates::find(const std::string& key) const {
  if (key == "front_advance") return &front_advance;
  if (key == "toe_distance") return &toe_distance;
  if (key == "crest_retreat") return &crest_retreat;
  if (key == "moved_volume") return &moved_volume;
  if (key == "deposit_volume") return &deposit_volume;
  return key == "highest_ground" ? &highest_ground : nullptr;
}

std::vector<std::string> RunoutEstimates::list_undetermined() const {
  std::vector<std::string> keys;
  for (const char* key :
       {"front_advance", "toe_distance", "crest_retreat", "moved_volume", "deposit_volume", "highest_ground"})
    if (!find(key)->is_determined()) keys.emplace_back(key);
  return keys;
}

}  // namespace talus::results
