// SPDX-License-Identifier: MIT
#include "fem/solid/known_springs.hpp"

#include <optional>

#include "fem/solid/system.hpp"

namespace talus::fem {
namespace {

/// Returns the deformations of a bar or wall at a place, between those that are known; nullopt: none is.
std::optional<std::array<double, 2>> find_known(const std::vector<KnownSpring>& known, int bar, int kind,
                                                double place) {
  const KnownSpring *below = nullptr, *above = nullptr;
  for (const KnownSpring& k : known) {
    if (k.bar != bar || k.kind != kind) continue;
    if (k.place <= place && (!below || k.place > below->place)) below = &k;
    if (k.place >= place && (!above || k.place < above->place)) above = &k;
  }
  if (!below || !above || below->place == above->place) {
    const KnownSpring* one = below ? below : above;
    return one ? std::optional(one->elastic) : std::nullopt;
  }
  const double t = (place - below->place) / (above->place - below->place);
  std::array<double, 2> elastic;
  for (std::size_t i = 0; i < 2; ++i) elastic[i] = below->elastic[i] + t * (above->elastic[i] - below->elastic[i]);
  return elastic;
}

}  // namespace

void read_known_springs(const SpringSet& springs, const std::vector<KnownSpring>& known, std::vector<double>& bars) {
  if (known.empty()) return;
  for (std::size_t s = 0; s < springs.list.size(); ++s) {
    const Spring& spring = springs.list[s];
    if (const auto at = find_known(known, spring.bar, static_cast<int>(spring.kind), spring.place)) bars[s] = (*at)[0];
  }
  for (std::size_t s = 0; s < springs.joints.size(); ++s) {
    const Joint& joint = springs.joints[s];
    const auto at = find_known(known, joint.wall, find_joint_kind(joint), joint.place);
    for (std::size_t i = 0; at && i < 2; ++i) bars[springs.list.size() + 2 * s + i] = (*at)[i];
  }
}

std::vector<KnownSpring> list_known_springs(const SolidModel<2>& model, const SolidState<2>& state) {
  const SpringSet springs = SolidSystem<2>(model).springs;
  std::vector<KnownSpring> known;
  for (std::size_t s = 0; s < springs.list.size(); ++s)
    known.push_back(
        {springs.list[s].bar, static_cast<int>(springs.list[s].kind), springs.list[s].place, {state.bars[s], 0}});
  for (std::size_t s = 0; s < springs.joints.size(); ++s) {
    const std::size_t at = springs.list.size() + 2 * s;
    known.push_back({springs.joints[s].wall,
                     find_joint_kind(springs.joints[s]),
                     springs.joints[s].place,
                     {state.bars[at], state.bars[at + 1]}});
  }
  return known;
}

}  // namespace talus::fem
