// SPDX-License-Identifier: MIT
#include "report/content/sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/user_file.hpp"
#include "report/content/fields.hpp"
#include "report/folder/numbers.hpp"
#include "results/bounds.hpp"
#include "results/json.hpp"

namespace talus::report {

std::vector<std::size_t> choose_frames(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(i);
    return chosen;
  }
  // Rounding to the nearest index gives distinct frames, since most <= count.
  const std::size_t gaps = most - 1;
  for (std::size_t k = 0; k < most; ++k) chosen.push_back((k * (count - 1) + gaps / 2) / gaps);
  return chosen;
}

std::vector<std::size_t> share_out(const std::vector<std::size_t>& needs, std::size_t total) {
  std::vector<std::size_t> order(needs.size()), shares(needs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return needs[a] < needs[b]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    shares[order[k]] = std::min(needs[order[k]], total / (order.size() - k));
    total -= shares[order[k]];
  }
  return shares;
}

std::size_t choose_stride(std::size_t points, std::size_t frames, const Budget& budget) {
  const std::size_t most =
      std::max<std::size_t>(1, std::min(budget.points, budget.point_frames / std::max<std::size_t>(1, frames)));
  return std::max<std::size_t>(1, (points + most - 1) / most);
}

std::string describe_thinning(std::size_t frames, std::size_t shown_frames, std::size_t points,
                              std::size_t shown_points, std::size_t stride) {
  const auto count = [](std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  std::string text = frames == shown_frames
                         ? (frames == 1 ? "The one frame" : fmt::format("All {}", count(frames, "frame")))
                         : fmt::format("{} of {} (evenly spread, the first and the last among them)", shown_frames,
                                       count(frames, "frame"));
  text += stride == 1 ? fmt::format(" with all {}", count(points, "point"))
                      : fmt::format(" with {} of {} (those whose number is a multiple of {})", shown_points,
                                    count(points, "point"), stride);
  return text + (frames == shown_frames && stride == 1 ? "." : "; the results file holds the rest.");
}

using nlohmann::json;

namespace {

const char* to_word(SequenceKind kind) {
  switch (kind) {
    case SequenceKind::stages:
      return "stages";
    case SequenceKind::curve:
      return "curve";
    case SequenceKind::runout:
      return "runout";
    case SequenceKind::variant:
      return "variant";
  }
  return "";
}

/// The thinned content of a frame.
struct ThinFrame {
  double time = 0;
  std::string stage;
  std::vector<int> ids;
  std::vector<int> materials;
  std::vector<double> positions;            ///< [point][dimension]
  std::vector<std::vector<double>> values;  ///< [scalar][point]; empty if the frame lacks the field
};

/// Returns the rows of the points whose number is a multiple of `stride`.
std::vector<std::size_t> choose_rows(const output::Frame& frame, std::size_t stride) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < frame.ids.size(); ++i)
    if (static_cast<std::size_t>(frame.ids[i]) % stride == 0) rows.push_back(i);
  return rows;
}

class SequencePacker {
 public:
  SequencePacker(const SequencePlan& plan, std::size_t dimension, const ShownUnits& units, const Budget& budget)
      : plan_(plan), dimension_(dimension), units_(units), budget_(budget) {}

  json pack(Packer& packer) {
    const std::vector<std::size_t> chosen = choose_frames(plan_.frames.size(), budget_.frames);
    for (const std::size_t i : chosen) {
      packer.throw_if_interrupted();
      frames_.push_back(read(plan_.frames[i], chosen.size()));
    }
    number_points();
    const std::size_t count = ids_.size();

    json frames = json::array();
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const SequenceFrame& source = plan_.frames[chosen[k]];
      frames.push_back({{"time", frames_[k].time},
                        {"factor", source.factor ? json(*source.factor) : json()},
                        {"stage", frames_[k].stage},
                        {"label", source.label}});
    }
    json sequence{{"id", plan_.id},
                  {"title", plan_.title},
                  {"kind", to_word(plan_.kind)},
                  {"axis", plan_.kind == SequenceKind::curve ? "factor" : "time"},
                  {"frames", frames},
                  {"thinning", describe_thinning(plan_.frames.size(), chosen.size(), most_points_, count, stride_)},
                  {"point_count", count}};
    sequence["ids"] = packer.add_numbers(plan_.id + ".ids", ids_, {count}, true);
    sequence["materials"] = packer.add_bytes(plan_.id + ".materials", materials_, {count});
    sequence["positions"] = packer.add_quantised_places(plan_.id + ".positions", gather_positions(),
                                                        {frames_.size(), count, dimension_}, true);
    json fields = json::array();
    for (std::size_t s = 0; s < scalars_.size(); ++s) fields.push_back(pack_field(s, packer));
    sequence["fields"] = fields;
    return sequence;
  }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  ThinFrame read(const SequenceFrame& source, std::size_t frame_count) {
    output::Frame frame = source.reader->read(source.index);
    show_water(frame);
    if (source.starts_count)
      for (output::Field& f : frame.point_fields)
        if (f.name == "displacement") std::fill(f.values.begin(), f.values.end(), 0.0);
    if (!plan_.fields.empty())
      std::erase_if(frame.point_fields, [&](const output::Field& f) {
        return std::find(plan_.fields.begin(), plan_.fields.end(), f.name) == plan_.fields.end();
      });
    if (scalars_.empty()) {
      scalars_ = list_scalars(frame.point_fields, dimension_, units_);
      stride_ = choose_stride(frame.ids.size(), frame_count, budget_);
    }
    most_points_ = std::max(most_points_, frame.ids.size());
    ThinFrame thin;
    thin.time = frame.time;
    thin.stage = frame.stage;
    const std::vector<std::size_t> rows = choose_rows(frame, stride_);
    for (const std::size_t i : rows) {
      thin.ids.push_back(frame.ids[i]);
      thin.materials.push_back(frame.materials[i]);
      for (std::size_t d = 0; d < dimension_; ++d) thin.positions.push_back(frame.positions[3 * i + d]);
    }
    for (const ScalarField& scalar : scalars_) {
      std::vector<double>& values = thin.values.emplace_back();
      const output::Field* stored = output::find(frame.point_fields, scalar.stored);
      if (stored == nullptr) continue;
      values.reserve(rows.size());
      for (const std::size_t i : rows) values.push_back(evaluate(scalar, *stored, i));
    }
    return thin;
  }

  /// Numbers the points of all frames, and maps the points of each frame to these numbers.
  void number_points() {
    std::map<int, int> material_of;
    for (const ThinFrame& f : frames_)
      for (std::size_t i = 0; i < f.ids.size(); ++i) material_of.emplace(f.ids[i], f.materials[i]);
    std::map<int, std::size_t> place_of;
    for (const auto& [id, material] : material_of) {
      place_of[id] = ids_.size();
      ids_.push_back(static_cast<std::uint32_t>(id));
      materials_.push_back(static_cast<std::uint8_t>(material));
    }
    for (const ThinFrame& f : frames_) {
      std::vector<std::size_t>& places = places_.emplace_back();
      for (const int id : f.ids) places.push_back(place_of.at(id));
    }
  }

  std::vector<double> gather_positions() const {
    std::vector<double> positions(frames_.size() * ids_.size() * dimension_, none);
    for (std::size_t k = 0; k < frames_.size(); ++k)
      for (std::size_t i = 0; i < places_[k].size(); ++i)
        for (std::size_t d = 0; d < dimension_; ++d)
          positions[(k * ids_.size() + places_[k][i]) * dimension_ + d] = frames_[k].positions[i * dimension_ + d];
    return positions;
  }

  json pack_field(std::size_t s, Packer& packer) const {
    const ScalarField& scalar = scalars_[s];
    std::vector<double> values(frames_.size() * ids_.size(), none);
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const std::vector<double>& from = frames_[k].values[s];
      for (std::size_t i = 0; i < from.size(); ++i) values[k * ids_.size() + places_[k][i]] = from[i];
    }
    const ColourScale scale = find_colour_scale(values, scalar.is_signed, scalar.unit.si);
    // Differences between frames compress well for all fields except velocities.
    const bool delta = scalar.stored != "velocity";
    return {{"name", scalar.name},
            {"title", scalar.title},
            {"unit", report::to_json(scalar.unit)},
            {"values", packer.add_values(plan_.id + "." + scalar.name, values, {frames_.size(), ids_.size()}, delta)},
            {"scale", scale.limits},
            {"diverging", scale.diverging}};
  }

  const SequencePlan& plan_;
  std::size_t dimension_;
  const ShownUnits& units_;
  const Budget& budget_;
  std::vector<ScalarField> scalars_;
  std::size_t stride_ = 1, most_points_ = 0;
  std::vector<ThinFrame> frames_;
  std::vector<std::uint32_t> ids_;
  std::vector<std::uint8_t> materials_;
  std::vector<std::vector<std::size_t>> places_;
};

}  // namespace

json pack_sequence(const SequencePlan& plan, std::size_t dimension, const ShownUnits& units, const Budget& budget,
                   Packer& packer) {
  return SequencePacker(plan, dimension, units, budget).pack(packer);
}

namespace {

SequencePlan plan_stages(const std::shared_ptr<const output::ResultsReader>& frames, std::string id,
                         std::string title) {
  SequencePlan plan{SequenceKind::stages, std::move(id), std::move(title), {}};
  if (!frames) return plan;
  for (int i = 0; i < frames->size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    plan.frames.push_back(
        {frames, i, std::nullopt, fmt::format("{}, t = {:.3g} s", frames->stages()[k], frames->times()[k])});
  }
  return plan;
}

/// Returns the sequences of the stages of the run, and of the MPM runs that a timeline released earlier and later.
std::vector<SequencePlan> plan_all_stages(const ResultFolder& folder) {
  std::vector<SequencePlan> plans;
  if (!folder.run.timeline || folder.run.timeline->releases.empty())
    plans.push_back(plan_stages(folder.frames, "stages", "Stages"));
  else
    for (const results::Release& r : folder.run.timeline->releases)
      plans.push_back(plan_stages(r.folder.empty() ? folder.frames : open_frames(join_name(folder.path, r.folder)),
                                  r.folder.empty() ? "stages" : r.folder,
                                  "Released at " + results::format_moment(*folder.run.timeline, r.time)));
  std::erase_if(plans, [](const SequencePlan& plan) { return plan.frames.empty(); });
  return plans;
}

/// Returns the index of the last frame before the runout of the trial.
int find_end_of_trial(const output::ResultsReader& frames) {
  int last = 0;
  for (int i = 0; i < frames.size(); ++i)
    if (!frames.stages()[static_cast<std::size_t>(i)].starts_with("runout")) last = i;
  return last;
}

std::vector<SequencePlan> plan_trials(const ResultFolder& folder) {
  SequencePlan curve{SequenceKind::curve, "curve", "Trials of the displacement curve", {}};
  std::vector<SequencePlan> plans;
  for (const TrialFolder& trial : folder.trials) {
    const auto frames = open_frames(trial.path);
    if (!frames || frames->size() == 0) continue;
    if (!trial.runs_out || frames->size() > 1)
      curve.frames.push_back({frames, find_end_of_trial(*frames), trial.factor, fmt::format("SRF {:g}", trial.factor)});
    if (!trial.runs_out) continue;
    SequencePlan runout{SequenceKind::runout,
                        fmt::format("runout_{:g}", trial.factor),
                        fmt::format("Runout at SRF {:g}", trial.factor),
                        {}};
    for (int i = 0; i < frames->size(); ++i)
      runout.frames.push_back(
          {frames, i, trial.factor, fmt::format("t = {:.3g} s", frames->times()[static_cast<std::size_t>(i)])});
    plans.push_back(std::move(runout));
  }
  if (!curve.frames.empty()) plans.insert(plans.begin(), std::move(curve));
  return plans;
}

}  // namespace

nlohmann::json pack_sequences(const ResultFolder& folder, Packer& packer) {
  std::vector<SequencePlan> plans = plan_all_stages(folder);
  for (SequencePlan& plan : plan_trials(folder)) plans.push_back(std::move(plan));
  nlohmann::json sequences = nlohmann::json::array();
  // A sequence whose frames have no points is omitted.
  std::erase_if(plans, [](const SequencePlan& plan) {
    const SequenceFrame& start = plan.frames.front();
    return start.reader->read(start.index).point_count() == 0;
  });
  if (plans.empty()) return sequences;
  // All sequences start from the points of the same body.
  const SequenceFrame& first = plans[0].frames[0];
  const std::size_t points = static_cast<std::size_t>(first.reader->read(first.index).point_count());
  Budget budget;
  std::vector<std::size_t> needs;
  for (const SequencePlan& plan : plans) needs.push_back(points * std::min(plan.frames.size(), budget.frames));
  const std::vector<std::size_t> shares = share_out(needs, find_most_point_frames(get_dimension(folder.run)));
  const ShownUnits units = read_units(folder.run);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    budget.point_frames = shares[k];
    sequences.push_back(pack_sequence(plans[k], get_dimension(folder.run), units, budget, packer));
  }
  return sequences;
}

}  // namespace talus::report
