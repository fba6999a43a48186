// SPDX-License-Identifier: MIT
#include "report/content/study_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/content/clock.hpp"
#include "report/content/sequence.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Variants beyond these would take the space of the others for pictures too small to see.
constexpr std::size_t most_sources = 12;
/// Frames of a variant besides those that stand side by side.
constexpr std::size_t most_frames = 13;

struct Choice {
  SequencePlan plan;
  std::vector<double> clock;
  std::vector<std::size_t> pictures;
  std::size_t points = 0;
};

/// Frames from the start of the clock on, without the earlier of two at one time.
std::optional<Choice> choose(const PictureSource& source, std::size_t number) {
  const std::optional<results::Clock>& clock = source.folder.run.clock;
  if (!clock || !source.folder.frames) return std::nullopt;
  const output::ResultsReader& reader = *source.folder.frames;
  std::vector<int> indices;
  std::vector<double> times;
  for (int i = 0; i < reader.size(); ++i) {
    const double time = reader.times()[static_cast<std::size_t>(i)];
    if (!times.empty() && times.back() == time) {
      indices.back() = i;
      continue;
    }
    indices.push_back(i);
    times.push_back(time);
  }
  const std::vector<std::size_t> shown = choose_shown(times, *clock);
  if (shown.empty()) return std::nullopt;
  std::vector<std::size_t> chosen = shown;
  const std::size_t first = shown.front();
  for (const std::size_t i : choose_frames(times.size() - first, most_frames)) chosen.push_back(first + i);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Choice choice;
  choice.plan = {SequenceKind::variant, fmt::format("variant_{}", number), source.title, {}, {}};
  choice.plan.fields = {"displacement",  "deviatoric_strain", "plastic_strain",           "volume",
                        "pore_pressure", "saturation",        "preconsolidation_pressure"};
  for (const std::size_t i : chosen) {
    const double time = times[i] - clock->start;
    if (std::find(shown.begin(), shown.end(), i) != shown.end()) choice.pictures.push_back(choice.clock.size());
    choice.clock.push_back(time);
    choice.plan.frames.push_back({source.folder.frames, indices[i], std::nullopt, fmt::format("t = {:.4g} s", time),
                                  clock->resets && time == 0});
  }
  choice.points = static_cast<std::size_t>(reader.read(indices[first]).point_count());
  return choice.points > 0 ? std::optional(choice) : std::nullopt;
}

}  // namespace

std::vector<Pictures> pack_pictures(const std::vector<PictureSource>& sources, Packer& packer) {
  std::vector<Pictures> pictures(sources.size());
  std::vector<std::optional<Choice>> choices;
  std::vector<std::size_t> needs;
  for (std::size_t k = 0; k < std::min(sources.size(), most_sources); ++k) {
    choices.push_back(choose(sources[k], k));
    needs.push_back(choices[k] ? choices[k]->points * choices[k]->plan.frames.size() : 0);
  }
  if (choices.empty()) return pictures;
  const std::size_t dimension = get_dimension(sources[0].folder.run);
  const std::vector<std::size_t> shares = share_out(needs, find_most_point_frames(dimension));
  for (std::size_t k = 0; k < choices.size(); ++k) {
    if (!choices[k]) continue;
    Budget budget;
    budget.point_frames = shares[k];
    const ShownUnits units = read_units(sources[k].folder.run);
    pictures[k].sequence = JsonTree(pack_sequence(choices[k]->plan, dimension, units, budget, packer));
    pictures[k].frames =
        JsonTree({{"sequence", choices[k]->plan.id}, {"clock", choices[k]->clock}, {"pictures", choices[k]->pictures}});
  }
  return pictures;
}

}  // namespace talus::report
