#include "report/content/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/mohr_coulomb.hpp"
#include "report/content/roots.hpp"
#include "report/content/soil_water.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

constexpr double degree = std::numbers::pi / 180;
const ShownUnit no_unit{"-", 1}, per_cent{"%", 0.01}, per_per_cent{"1/%", 1};

/// 30° comes back from radians as 29.999999999999996°.
double drop_last_digits(double value) {
  return std::stod(fmt::format("{:.12g}", value));
}

}  // namespace

bool is_mohr_coulomb(const json& soil) {
  const std::string model = get_word(soil, "model");
  return model == "mohr_coulomb" || model == "rooted_mohr_coulomb";
}

bool is_cam_clay(const json& soil) {
  const std::string model = get_word(soil, "model");
  return model == "modified_cam_clay" || model == "rooted_cam_clay";
}

std::optional<double> find_void_ratio(const json& soil) {
  if (const auto e = find_si(soil, "void_ratio")) return e;
  const auto n = find_si(soil, "porosity");
  return n ? std::optional(*n / (1 - *n)) : std::nullopt;
}

std::optional<double> find_porosity(const json& soil) {
  if (const auto n = find_si(soil, "porosity")) return n;
  const auto e = find_si(soil, "void_ratio");
  return e ? std::optional(*e / (1 + *e)) : std::nullopt;
}

double reduce_slope(double slope, double factor) {
  const double sine = std::min(3 * slope / (6 + slope), 0.9999);
  const double reduced = std::sin(std::atan(std::tan(std::asin(sine)) / factor));
  return 6 * reduced / (3 - reduced);
}

void Properties::add(const std::string& key, const std::string& title, const std::string& symbol, const ShownUnit& unit,
                     std::optional<double> value, std::optional<double> design, std::optional<double> at_failure) {
  if (!value) return;
  const auto shown = [&](std::optional<double> si) { return si ? json(drop_last_digits(*si / unit.si)) : json(); };
  rows.push_back({{"key", key},
                  {"title", title},
                  {"symbol", symbol},
                  {"unit", unit.name},
                  {"characteristic", shown(value)},
                  {"design", shown(design)},
                  {"at_failure", shown(at_failure)}});
}

void Properties::add_mohr_coulomb(const json& soil) {
  using material::MohrCoulombStrength;
  const MohrCoulombStrength given{get_si(soil, "cohesion", 0), get_si(soil, "friction_angle", 0),
                                  get_si(soil, "dilatancy_angle", 0), get_si(soil, "tensile_strength", 0)};
  const auto reduce = [&](std::optional<double> factor) {
    return factor ? std::optional(given.reduced(*factor)) : std::nullopt;
  };
  const auto design = reduce(design_), failure = reduce(failure_);
  const auto add_one = [&](const char* key, const char* title, const char* symbol, const ShownUnit& unit,
                           double MohrCoulombStrength::*value) {
    const auto read = [&](const auto& strength) { return strength ? std::optional((*strength).*value) : std::nullopt; };
    add(key, title, symbol, unit, given.*value, read(design), read(failure));
  };
  add_one("cohesion", "cohesion", "c", stress_, &MohrCoulombStrength::cohesion);
  add_one("friction_angle", "angle of internal friction", "φ", {"°", degree}, &MohrCoulombStrength::friction_angle);
  add_one("dilatancy_angle", "angle of dilatancy", "ψ", {"°", degree}, &MohrCoulombStrength::dilatancy_angle);
  add_one("tensile_strength", "tensile strength", "σt", stress_, &MohrCoulombStrength::tensile_strength);
}

void Properties::add_slope(const std::string& key, const std::string& title, const std::string& symbol, double slope) {
  const auto reduce = [&](std::optional<double> factor) {
    return factor ? std::optional(reduce_slope(slope, *factor)) : std::nullopt;
  };
  add(key, title, symbol, no_unit, slope, reduce(design_), reduce(failure_));
}

void Properties::add_cam_clay(const json& soil) {
  add("lambda", "slope of the normal-compression line", "λ", no_unit, find_si(soil, "lambda"));
  add("kappa", "slope of the swelling lines", "κ", no_unit, find_si(soil, "kappa"));
  if (const auto slope = find_si(soil, "critical_state_slope"))
    add_slope("critical_state_slope", "slope of the critical-state line", "M₀", *slope);
  add("preconsolidation", "preconsolidation pressure, saturated and without roots", "p′c₀", stress_,
      find_si(soil, "preconsolidation"));
  add("preconsolidation_ratio", "preconsolidation ratio", "R₀", no_unit, find_si(soil, "preconsolidation_ratio"));
  if (get_si(soil, "suction_hardening", 0) != 0)
    add("suction_hardening", "hardening by suction", "b", no_unit, find_si(soil, "suction_hardening"));
  add("smallest_pressure", "floor of p′ in the bulk modulus", "p′min", stress_, find_si(soil, "smallest_pressure"));
}

void Properties::add_cohesion(const std::string& key, const std::string& title, std::optional<double> cohesion) {
  const auto reduce = [&](std::optional<double> factor) {
    return cohesion && factor ? std::optional(*cohesion / *factor) : std::nullopt;
  };
  add(key, title, "cr", stress_, cohesion, reduce(design_), reduce(failure_));
}

void Properties::add_roots(const json& summary, const json& soil) {
  const std::string model = get_word(soil, "model");
  const bool takes_content = model == "rooted_cam_clay";
  if (!takes_content && model != "rooted_mohr_coulomb") return;
  const char* key = takes_content ? "root_content" : "root_cohesion";
  const std::string what = takes_content ? "root content" : "cohesion of roots";
  const auto own = find_si(soil, key);
  std::vector<RootBlock> blocks;
  for (const RootBlock& block : read_roots(summary))
    if (takes_content ? block.content.has_value() : block.cohesion.has_value()) blocks.push_back(block);
  const auto add_one = [&](const std::string& name, const std::string& title, std::optional<double> value) {
    if (takes_content)
      add(name, title, "mr", per_cent, value);
    else
      add_cohesion(name, title, value);
  };
  double most = own.value_or(0);
  if (blocks.empty() || most > 0) add_one(key, blocks.empty() ? what : what + " where no [[roots]] reaches", own);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const RootBlock& block = blocks[i];
    const std::optional<double>& grown = takes_content ? block.content : block.cohesion;
    add_one(fmt::format("roots_{}", i), fmt::format("{} under '{}', at the ground", what, block.ground),
            *grown * block.age_share);
    most = std::max(most, *grown * block.age_share);
  }
  if (!takes_content) return;
  add("root_hardening", "hardening by roots, per per cent", "Rp", per_per_cent, find_si(soil, "root_hardening"));
  add("root_strength", "slope gained by roots, per per cent", "Ra", per_per_cent, find_si(soil, "root_strength"));
  add("root_activation", "activation of roots, in the place of Rp mr", "Rp mr", no_unit,
      find_si(soil, "root_activation"));
  if (const auto strain = find_si(soil, "root_breaking_strain"); strain && std::isfinite(*strain)) {
    add("root_breaking_strain", "activation strain at which roots begin to break", "εr,peak", no_unit, strain);
    add("root_breaking_range", "activation strain within which they break", "Δεr", no_unit,
        find_si(soil, "root_breaking_range"));
    add("root_residual_share", "share of the roots that stays", "", no_unit, find_si(soil, "root_residual_share"));
  }
  if (most <= 0) return;
  const double percent = most / per_cent.si;
  add_slope("critical_state_slope_rooted",
            fmt::format("slope of the critical-state line with {} % of roots", show_number(percent)), "Mr",
            get_si(soil, "critical_state_slope", 0) + get_si(soil, "root_strength", 0) * percent);
}

void Properties::add_external(const json& soil) {
  const std::vector<double> constants = get_si_vector(soil, "constants");
  for (std::size_t i = 0; i < constants.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    add("constants_" + number, "constant " + number + " of the UMAT", "PROPS(" + number + ")", {"SI", 1}, constants[i]);
  }
  add("constrained_modulus", "largest constrained modulus, for the time step", "Ec", {"MPa", 1e6},
      find_si(soil, "constrained_modulus"));
}

void Properties::add_wet_weights(const json& summary, const input::PoreWater& soil, double density, double porosity,
                                 double gravity) {
  const ShownUnit weight{"kN/m³", 1000};
  const double water = read_water(summary).density;
  const auto weigh = [&](double suction) {
    return ((1 - porosity) * density + porosity * find_saturation(soil, suction) * water) * gravity;
  };
  add("unit_weight_saturated", "unit weight (below the water table)", "γ_sat", weight, weigh(0));
  const auto largest = find_largest_suction(summary);
  if (!largest || weigh(*largest) == weigh(0)) return;
  add("unit_weight_moist",
      fmt::format("unit weight (at the largest suction, S = {:.2f})", find_saturation(soil, *largest)), "γ_moist",
      weight, weigh(*largest));
}

}  // namespace talus::report
