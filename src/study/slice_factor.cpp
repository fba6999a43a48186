// SPDX-License-Identifier: MIT
#include "study/slice_factor.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/units.hpp"
#include "lem/search/search.hpp"
#include "run/common/section_of_case.hpp"
#include "run/lem/run_lem.hpp"

namespace talus::study {

namespace {

/// Properties of a material that LEM does not use.
const std::set<std::string> idle{"young_modulus", "poisson_ratio", "dilatancy_angle", "tensile_strength"};
/// Properties in which unit weights are linear, one at a time.
const std::set<std::string> weights{"unit_weight", "saturated_unit_weight", "grain_density"};

/// "cohesion" of "materials.clay.cohesion", and "clay"; empty for another key.
std::pair<std::string, std::string> split_material_key(const std::string& key) {
  const std::vector<std::string> parts = input::split_path(key);
  if (parts.size() < 3 || parts[0] != "materials") return {};
  return {parts[1], key.substr(parts[0].size() + parts[1].size() + 2)};
}

}  // namespace

SliceNumbers::SliceNumbers(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                           const SampledNumbers& sampled)
    : middle_values_(sampled.means) {
  static const std::map<std::string, Part> parts{
      {"cohesion", Part::cohesion},           {"cohesion_gradient", Part::gradient},  {"cohesion_level", Part::level},
      {"undrained_strength", Part::cohesion}, {"undrained_gradient", Part::gradient}, {"undrained_level", Part::level},
      {"friction_angle", Part::friction},     {"pore_pressure_ratio", Part::ratio},   {"phi_b", Part::phi_b}};
  const auto make = [&](const std::vector<double>& values) {
    return run::make_section(read_sample(base, overrides, sampled, values).data);
  };
  run::SectionOfCase made = make(middle_values_);
  middle_ = std::move(made.section);
  notes_ = std::move(made.notes);
  // Laws take their numbers, weights and pore pressures from a section of their own. Without reduction of all soils the
  // quick factors of the candidates are no guide.
  const bool has_law = std::any_of(middle_.soils.begin(), middle_.soils.end(),
                                   [](const lem::Soil& soil) { return soil.law != nullptr || !soil.reduced; });
  std::set<std::string>
      porous;  // materials with a varied porosity, in which weights are not linear in the grain density
  for (const results::UncertainNumber& n : sampled.numbers)
    if (const auto [material, key] = split_material_key(n.key); key == "porosity" || key == "void_ratio")
      porous.insert(material);
  for (std::size_t i = 0; i < sampled.numbers.size(); ++i) {
    const results::UncertainNumber& n = sampled.numbers[i];
    if (has_law) {
      section_keys_.push_back(n.key);
      continue;
    }
    Link link;
    link.number = i;
    link.factor = n.unit.empty() ? 1 : units::get_si_factor(n.unit);
    const auto [material, key] = split_material_key(n.key);
    if (n.key == "earthquake.horizontal" || n.key == "earthquake.vertical") {
      link.part = n.key == "earthquake.horizontal" ? Part::horizontal : Part::vertical;
      links_.push_back(link);
    } else if (const auto part = parts.find(key); part != parts.end()) {
      link.part = part->second;
      add_link(link, material);
    } else if (weights.contains(key) && !porous.contains(material)) {
      link.part = Part::weight;
      const double step = 0.5 * sampled.marginals[i].find_deviation();
      std::vector<double> moved = middle_values_;
      const double at = moved[i];
      moved[i] = at + (at + step <= sampled.marginals[i].highest ? step : -step);
      const lem::Section other = make(moved).section;
      for (std::size_t s = 0; s < middle_.soils.size(); ++s) {
        if (middle_.soils[s].name != material || moved[i] == at) continue;
        link.moist = (other.soils[s].unit_weight - middle_.soils[s].unit_weight) / (moved[i] - at);
        link.sat = (other.soils[s].saturated_unit_weight - middle_.soils[s].saturated_unit_weight) / (moved[i] - at);
      }
      add_link(link, material);
    } else if (idle.contains(key)) {
      idle_keys_.push_back(n.key);
    } else {
      section_keys_.push_back(n.key);
    }
  }
}

void SliceNumbers::add_link(Link link, const std::string& material) {
  for (std::size_t s = 0; s < middle_.soils.size(); ++s)
    if (middle_.soils[s].name == material) link.soil = static_cast<int>(s);
  if (link.soil >= 0) links_.push_back(link);
}

lem::Section SliceNumbers::make_section(const std::vector<double>& values) const {
  lem::Section section = middle_;
  apply(values, section.soils, section.horizontal_acceleration, section.vertical_acceleration);
  return section;
}

void SliceNumbers::apply(const std::vector<double>& values, std::vector<lem::Soil>& soils, double& horizontal,
                         double& vertical) const {
  horizontal = middle_.horizontal_acceleration;
  vertical = middle_.vertical_acceleration;
  for (std::size_t s = 0; s < soils.size(); ++s) {
    soils[s].unit_weight = middle_.soils[s].unit_weight;
    soils[s].saturated_unit_weight = middle_.soils[s].saturated_unit_weight;
  }
  for (const Link& link : links_) {
    const double value = values[link.number] * link.factor;
    const double moved = values[link.number] - middle_values_[link.number];
    if (link.part == Part::horizontal) horizontal = middle_.push == 0 ? std::abs(value) : value;
    if (link.part == Part::vertical) vertical = value;
    if (link.soil < 0) continue;
    const auto s = static_cast<std::size_t>(link.soil);
    lem::Soil& soil = soils[s];
    switch (link.part) {
      case Part::cohesion:  // that of the section may include root cohesion
        soil.cohesion = middle_.soils[s].cohesion + moved * link.factor;
        break;
      case Part::friction:
        soil.friction_angle = value;
        break;
      case Part::gradient:
        soil.cohesion_gradient = value;
        break;
      case Part::level:
        soil.cohesion_level = value;
        break;
      case Part::ratio:
        soil.pore_pressure_ratio = value;
        break;
      case Part::phi_b:
        soil.phi_b = value;
        break;
      case Part::weight:
        soil.unit_weight += moved * link.moist;
        soil.saturated_unit_weight += moved * link.sat;
        break;
      case Part::horizontal:
      case Part::vertical:
        break;
    }
  }
}

namespace {

/// Searches are made with one number at this score, the others at their means; about one sample of twenty lies beyond.
constexpr double corner_score = 2;

}  // namespace

SliceFactor::SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                         const SampledNumbers& sampled, const std::vector<lem::Surface>& surfaces)
    : base_(base),
      overrides_(overrides),
      sampled_(sampled),
      numbers_(base, overrides, sampled),
      options_(run::make_search_options(base.data, 1)) {
  // The method that would govern a run.
  options_.methods = {
      *std::min_element(options_.methods.begin(), options_.methods.end(),
                        [](lem::Method a, lem::Method b) { return rank_equilibrium(a) < rank_equilibrium(b); })};
  if (is_full()) return;
  slope_ = std::make_unique<lem::Slope>(numbers_.middle());
  candidates_ = std::make_unique<lem::Candidates>(*slope_, surfaces, options_, method());
}

SliceFactor::SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                         const SampledNumbers& sampled, int threads)
    : SliceFactor(base, overrides, sampled, std::vector<lem::Surface>()) {
  options_.threads = threads;
  if (is_full()) return;
  std::vector<lem::Surface> given;
  for (const input::SlipSurface& s : base.data.lem.surfaces) given.push_back(run::make_surface(*slope_, s));
  if (searches()) {
    const std::vector<lem::Section> corners = make_corners();
    corners_ = static_cast<int>(corners.size());
    candidates_ = std::make_unique<lem::Candidates>(*slope_, corners, options_, method(), threads);
    if (!given.empty()) add(given);
  } else {
    candidates_ = std::make_unique<lem::Candidates>(*slope_, given, options_, method());
  }
}

std::vector<lem::Section> SliceFactor::make_corners() const {
  std::vector<lem::Section> corners;
  for (std::size_t i = 0; i < sampled_.means.size(); ++i)
    for (const double score : {-corner_score, corner_score}) {
      std::vector<double> corner = sampled_.means;
      corner[i] = sampled_.marginals[i].find_value(score);
      corners.push_back(numbers_.make_section(corner));
    }
  return corners;
}

std::vector<lem::Surface> SliceFactor::list_surfaces() const {
  std::vector<lem::Surface> all;
  for (int i = 0; i < count_surfaces(); ++i) all.push_back(candidates_->surface(i));
  return all;
}

void SliceFactor::add(const std::vector<lem::Surface>& surfaces) {
  if (!candidates_) return;
  std::vector<lem::Surface> all = list_surfaces();
  all.insert(all.end(), surfaces.begin(), surfaces.end());
  candidates_ = std::make_unique<lem::Candidates>(*slope_, all, options_, method());
}

std::optional<double> SliceFactor::find(const std::vector<double>& values, Workspace& work) const {
  if (is_full()) {
    const std::optional<Searched> searched = search(values);
    return searched ? std::optional(searched->factor) : std::nullopt;
  }
  if (work.soils.empty()) work.soils = numbers_.middle().soils;
  double horizontal = 0, vertical = 0;
  numbers_.apply(values, work.soils, horizontal, vertical);
  const double factor = candidates_->find_factor(work.soils, horizontal, vertical, work.candidates);
  return factor > 0 ? std::optional(factor) : std::nullopt;
}

std::optional<SliceFactor::Searched> SliceFactor::search(const std::vector<double>& values) const {
  lem::SearchOptions options = options_;
  options.threads = 1;
  Searched result;
  const auto take = [&](double factor) {
    if (factor > 0 && (result.factor == 0 || factor < result.factor)) result.factor = factor;
  };
  const lem::Slope slope(is_full() ? run::make_section(read_sample(base_, overrides_, sampled_, values).data).section
                                   : numbers_.make_section(values));
  lem::Evaluator evaluate(slope, method(), options.checks, options.slices);
  for (const input::SlipSurface& given : base_.data.lem.surfaces) {
    const double factor = evaluate(run::make_surface(slope, given));
    if (factor < lem::Evaluator::refused) take(factor);
  }
  if (searches()) {
    try {
      const lem::SearchResult found = lem::search(slope, options);
      for (const auto* list : {&found.circular, &found.noncircular})
        for (const lem::Critical& c : *list) {
          take(c.solution.factor);
          result.surfaces.push_back(c.surface);
        }
      for (const auto& minima : found.minima)
        for (const lem::Critical& c : minima) result.surfaces.push_back(c.surface);
    } catch (const Error& error) {
      if (error.code() == ExitCode::interrupted) throw;
      // Without an admissible surface this sample has no factor.
    }
  }
  return result.factor > 0 ? std::optional(result) : std::nullopt;
}

}  // namespace talus::study
