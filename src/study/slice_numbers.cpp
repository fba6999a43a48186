// SPDX-License-Identifier: MIT
#include "study/slice_numbers.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "base/units.hpp"
#include "run/lem/section_of_case.hpp"

namespace talus::study {
namespace {

/// Numbers of a material that slices do not know.
const std::set<std::string> idle{"young_modulus", "poisson_ratio", "dilatancy_angle", "tensile_strength"};
/// Numbers that unit weights are linear in, one at a time.
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
      {"cohesion", Part::cohesion},
      {"cohesion_gradient", Part::gradient},
      {"cohesion_level", Part::level},
      {"undrained_strength", Part::cohesion},
      {"undrained_gradient", Part::gradient},
      {"undrained_level", Part::level},
      {"friction_angle", Part::friction},
      {"pore_pressure_ratio", Part::ratio},
      {"phi_b", Part::phi_b}};
  const auto make = [&](const std::vector<double>& values) {
    return run::make_section(read_sample(base, overrides, sampled, values).data);
  };
  run::SectionOfCase made = make(middle_values_);
  middle_ = std::move(made.section);
  notes_ = std::move(made.notes);
  std::set<std::string> porous;  // materials whose porosity varies: there weights are not linear in the grains' density
  for (const results::UncertainNumber& n : sampled.numbers)
    if (const auto [material, key] = split_material_key(n.key); key == "porosity" || key == "void_ratio")
      porous.insert(material);
  for (std::size_t i = 0; i < sampled.numbers.size(); ++i) {
    const results::UncertainNumber& n = sampled.numbers[i];
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
      case Part::cohesion:  // the section's may hold that of roots besides
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

}  // namespace talus::study
