// SPDX-License-Identifier: MIT
#include "report/content/sequence.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "report/content/fields.hpp"
#include "report/content/shown_water.hpp"

namespace talus::report {

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

/// What is kept of a frame.
struct ThinFrame {
  double time = 0;
  std::string stage;
  std::vector<int> ids;
  std::vector<int> materials;
  std::vector<double> positions;            ///< [point][dimension]
  std::vector<std::vector<double>> values;  ///< [scalar][point]; empty when the frame lacks the field
};

/// Rows of the points whose number is a multiple of `stride`.
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

  /// All points of all frames by number, and the place of each frame's points among them.
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
    // A velocity has little in common with that of the frame before; every other field has much.
    const bool delta = scalar.stored != "velocity";
    return {{"name", scalar.name},
            {"title", scalar.title},
            {"unit", to_json(scalar.unit)},
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

}  // namespace talus::report
