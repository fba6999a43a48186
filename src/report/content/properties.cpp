// SPDX-License-Identifier: MIT
#include "report/content/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "ground/root_content.hpp"
#include "report/content/soil_water.hpp"
#include "report/words/numbers.hpp"

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
    if (const auto grown = takes_content ? block.content : ground::find_ground_cohesion(block))
      worths.push_back({block.ground, *grown * ground::find_age_share(block)});
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

}  // namespace talus::report
