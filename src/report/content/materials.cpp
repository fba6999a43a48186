// SPDX-License-Identifier: MIT
#include "report/content/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "report/content/strength.hpp"
#include "report/content/water.hpp"
#include "report/folder/numbers.hpp"
#include "site/roots.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

double drop_last_digits(double value) {
  return round_to_digits(value, 12);
}

}  // namespace

std::optional<double> find_porosity(const input::Material& soil) {
  return soil.slices.unit_weight && soil.porosity == 0 ? std::nullopt : std::optional(soil.porosity);
}

void Properties::add(const std::string& key, const std::string& title, const std::string& symbol, const ShownUnit& unit,
                     std::optional<double> value, std::optional<double> design, std::optional<double> at_failure) {
  if (!value) return;
  const auto show = [&](std::optional<double> si) {
    return si ? std::optional(drop_last_digits(*si / unit.si)) : std::nullopt;
  };
  rows_.push_back({key, title, symbol, unit.name, show(value), show(design), show(at_failure)});
}

json Properties::list() const {
  const auto write = [](std::optional<double> value) { return value ? json(*value) : json(); };
  json list = json::array();
  for (const Row& row : rows_)
    list.push_back({{"key", row.key},
                    {"title", row.title},
                    {"symbol", row.symbol},
                    {"unit", row.unit},
                    {"characteristic", write(row.characteristic)},
                    {"design", write(row.design)},
                    {"at_failure", write(row.at_failure)}});
  return list;
}

void Properties::add(const material::Properties& list) {
  for (const material::Property& p : list) {
    const auto reduce = [&](std::optional<double> factor) {
      return factor && p.reduce && p.value ? std::optional(p.reduce(*factor)) : std::nullopt;
    };
    add(p.key, p.title, p.symbol, find_unit(p.shown_as), p.value, reduce(design_), reduce(failure_));
  }
}

ShownUnit Properties::find_unit(material::ShownAs shown_as) const {
  using material::ShownAs;
  switch (shown_as) {
    case ShownAs::angle:
      return {"°", degree};
    case ShownAs::stress:
      return units_.stress;
    case ShownAs::stiffness:
      return units_.stiffness;
    case ShownAs::per_cent:
      return {"%", 1};
    case ShownAs::per_per_cent:
      return {"1/%", 1};
    case ShownAs::stress_per_length:
      return {units_.stress.name + "/" + units_.length.name, units_.stress.si / units_.length.si};
    case ShownAs::si:
      return {"SI", 1};
    case ShownAs::number:
      break;
  }
  return {"-", 1};
}

void Properties::add_roots(const std::vector<input::Roots>& blocks, const input::Material& soil) {
  const material::RootEffect effect = soil.traits().roots;
  const bool takes_content = effect == material::RootEffect::content;
  if (effect == material::RootEffect::none) return;
  const std::string what = takes_content ? "root content" : "cohesion of roots";
  struct Worth {
    std::string ground;
    double value;  ///< at the ground [%] or [Pa]
  };
  std::vector<Worth> worths;
  for (const input::Roots& block : blocks)
    if (const auto grown = takes_content ? block.content : site::find_ground_cohesion(block))
      worths.push_back({block.ground, *grown * site::find_age_share(block)});
  const auto add_one = [&](const std::string& key, const std::string& title, double value) {
    if (takes_content)
      add(key, title, "mr", {"%", 1}, value);
    else
      add({material::make_divided(key.c_str(), title, "cr", material::ShownAs::stress, value)});
  };
  double most = takes_content ? soil.root_content : soil.root_cohesion;
  if (worths.empty() || most > 0)
    add_one(takes_content ? "root_content" : "root_cohesion",
            worths.empty() ? what : what + " where no [[roots]] reaches", most);
  for (std::size_t i = 0; i < worths.size(); ++i) {
    add_one(fmt::format("roots_{}", i), fmt::format("{} under '{}', at the ground", what, worths[i].ground),
            worths[i].value);
    most = std::max(most, worths[i].value);
  }
  if (takes_content) add(material::list_root_properties(soil.model, soil, most));
}

void Properties::add_wet_weights(const ResultFolder& folder, const input::Material& soil) {
  const ShownUnit& weight = units_.unit_weight;
  const auto weigh = [&](double suction) {
    const double water = soil.porosity * find_saturation(soil.water, suction) * folder.data.water.density;
    return (soil.density() + water) * folder.data.gravity.acceleration;
  };
  add("unit_weight_saturated", "unit weight (below the water table)", "γ_sat", weight, weigh(0));
  const auto largest = find_largest_suction(folder.run);
  if (!largest || weigh(*largest) == weigh(0)) return;
  add("unit_weight_moist",
      fmt::format("unit weight (at the largest suction, S = {:.2f})", find_saturation(soil.water, *largest)), "γ_moist",
      weight, weigh(*largest));
}

using nlohmann::json;

namespace {

/// Returns true if the case gives Poisson's ratio, which LEM does not need.
bool has_poisson_ratio(const input::Case& data, const input::Material& soil) {
  if (!material::needs<material::PoissonInput>(soil.model)) return false;
  return soil.poisson_ratio != 0 || input::uses(data, input::Method::fem) || input::uses(data, input::Method::mpm) ||
         !data.tests.empty();
}

void add_weights(const ResultFolder& folder, const input::Material& soil, Properties& properties) {
  const double gravity = folder.data.gravity.acceleration;
  const auto porosity = find_porosity(soil);
  const auto& unit_weight = soil.slices.unit_weight;
  const bool has_grains = soil.grain_density > 0 && porosity;
  const ShownUnit weight = read_units(folder.run).unit_weight;
  // A given unit weight replaces density and porosity.
  if (!unit_weight) {
    if (soil.grain_density > 0)
      properties.add("grain_density", "density of the grains", "ρ_s", {"kg/m³", 1}, soil.grain_density);
    properties.add("porosity", "porosity", "n", {"-", 1}, porosity);
  }
  if (porosity && (soil.given_void_ratio || material::needs<material::Preconsolidation>(soil.model)))
    properties.add("void_ratio", "void ratio at the start", "e₀", {"-", 1},
                   soil.given_void_ratio.value_or(soil.void_ratio()));
  if (unit_weight) {
    properties.add("unit_weight", "unit weight above the water table", "γ", weight, unit_weight);
    properties.add("saturated_unit_weight", "unit weight below the water table", "γ_sat", weight,
                   soil.slices.saturated_unit_weight);
  } else if (has_grains) {
    properties.add("unit_weight", "unit weight (dry)", "γ", weight, soil.density() * gravity);
  }
  if (has_grains && soil.water.is_wet()) properties.add_wet_weights(folder, soil);
}

Properties list_properties(const ResultFolder& folder, const input::Material& soil, std::optional<double> stage_factor,
                           std::optional<double> factor_of_safety) {
  const ShownUnits units = read_units(folder.run);
  Properties properties(units, stage_factor, factor_of_safety);
  add_weights(folder, soil, properties);
  if (soil.young_modulus > 0)
    properties.add("young_modulus", "Young's modulus", "E", units.stiffness, soil.young_modulus);
  if (has_poisson_ratio(folder.data, soil))
    properties.add("poisson_ratio", "Poisson's ratio", "ν", {"-", 1}, soil.poisson_ratio);
  properties.add(material::list_properties(soil.model, soil));
  if (const double ratio = soil.slices.pore_pressure_ratio; ratio > 0)
    properties.add("pore_pressure_ratio", "pore pressure over the weight above", "r_u", {"-", 1}, ratio);
  if (soil.slices.suction_strength == input::SuctionStrength::phi_b)
    properties.add("phi_b", "angle of the strength from suction", "φ_b", {"°", degree}, soil.slices.phi_b);
  properties.add_roots(folder.data.roots, soil);
  return properties;
}

}  // namespace

json list_materials(const ResultFolder& folder, std::optional<double> factor_of_safety) {
  json rows = json::array();
  const input::Case& data = folder.data;
  std::optional<double> stage_factor;
  if (!data.stages.empty()) stage_factor = data.stages.back().strength_factor;
  if (stage_factor == 1.0) stage_factor.reset();
  const bool has_flow_alone = data.methods == std::vector<input::Method>{input::Method::seepage};
  int index = 0;  // material number of the points, in alphabetical order of the names
  for (const auto& [name, soil] : data.materials) {
    json regions = json::array();
    for (const auto& [region, material] : data.regions)
      if (material == name) regions.push_back(region);
    json row{{"name", name},
             {"index", index++},
             {"model", has_flow_alone && soil.traits().strength == material::Strength::none
                           ? "soil with flow of water only"
                           : material::describe_model(soil.model, soil)},
             {"regions", regions},
             {"properties", list_properties(folder, soil, soil.reduced ? stage_factor : std::nullopt,
                                            soil.reduced ? factor_of_safety : std::nullopt)
                                .list()}};
    if (json strength = sample_strength(data, soil); !strength.is_null()) row["strength"] = std::move(strength);
    if (json water = describe_soil_water(folder, soil.water); !water.is_null()) row["water"] = std::move(water);
    rows.push_back(std::move(row));
  }
  return rows;
}

namespace {

/// Returns the name of the root bundle model and its number of classes.
std::string describe_bundle(const input::RootBundle& bundle) {
  const std::size_t classes = bundle.area_ratios.size();
  return fmt::format(
      "{} {} class{} of roots",
      bundle.model == input::RootBundleModel::fibre_bundle ? "a fibre bundle of" : "Wu and Waldron's sum over", classes,
      classes == 1 ? "" : "es");
}

/// Returns a text such as "falling with exp(−z/0.2 m) down to 0.5 m".
std::string describe_profile(const input::Roots& roots, const ShownUnit& length) {
  const std::string depth = show(roots.depth, length);
  const std::string along = roots.along.empty() ? "" : ", not the same along the ground";
  switch (roots.profile) {
    case input::RootProfile::exponential:
      return fmt::format("falling with exp(−z/{}) down to {}{}", show(roots.decay_depth, length), depth, along);
    case input::RootProfile::table:
      return fmt::format("by a table of depth down to {}{}", depth, along);
    default:
      return fmt::format("the same down to {}{}", depth, along);
  }
}

/// Returns the root content or the root cohesion at the ground for roots of full age; empty if the plants only
/// transpire.
std::string describe_worth(const input::Roots& roots, const ShownUnits& units) {
  if (roots.content) return fmt::format("{} % of the dry mass at the ground", show_number(*roots.content));
  const auto cohesion = site::find_ground_cohesion(roots);
  if (!cohesion) return "";
  return fmt::format("a cohesion of {} at the ground{}", show(*cohesion, units.stress),
                     roots.cohesion ? "" : " (" + describe_bundle(*roots.bundle) + ")");
}

}  // namespace

std::vector<std::string> list_root_assumptions(const ResultFolder& folder) {
  std::vector<std::string> sentences;
  const ShownUnits units = read_units(folder.run);
  for (const input::Roots& roots : folder.data.roots) {
    const double age_share = site::find_age_share(roots);
    if (const std::string worth = describe_worth(roots, units); !worth.empty())
      sentences.push_back(fmt::format(
          "Roots under '{}': {}, {}.{}", roots.ground, worth, describe_profile(roots, units.length),
          age_share == 1 ? "" : fmt::format(" {} % of that holds at their age.", show_number(100 * age_share))));
    if (roots.transpiration)
      sentences.push_back(
          fmt::format("Plants on '{}' transpire at the given rate, reduced after Feddes; interception and the effect "
                      "of roots on the conductivity are not modelled.",
                      roots.ground));
  }
  std::vector<std::string> clay, cohesive, breaking;
  for (const auto& [name, soil] : folder.data.materials) {
    if (soil.traits().roots == material::RootEffect::content)
      (std::isfinite(soil.breaking_strain) ? breaking : clay).push_back(name);
    if (soil.traits().roots == material::RootEffect::cohesion) cohesive.push_back(name);
  }
  if (!clay.empty())
    sentences.push_back(
        fmt::format("Soil and roots are one material in {}, and the roots never break: after large "
                    "movements their part of the strength is too high.",
                    join_words(clay)));
  if (!breaking.empty())
    sentences.push_back(
        fmt::format("Soil and roots are one material in {}; roots break as the activation strain grows, "
                    "in every direction alike.",
                    join_words(breaking)));
  if (!cohesive.empty())
    sentences.push_back(
        fmt::format("The roots of {} are modelled as a constant cohesion: it raises the strength at failure, and "
                    "describes neither the mobilisation of the roots nor their breakage.",
                    join_words(cohesive)));
  return sentences;
}

}  // namespace talus::report
