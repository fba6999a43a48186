#include "report/content/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ground/root_content.hpp"
#include "material/mohr_coulomb.hpp"
#include "report/content/soil_water.hpp"

namespace talus::report {

using input::MaterialModel;
using nlohmann::json;

namespace {

constexpr double degree = std::numbers::pi / 180;
const ShownUnit no_unit{"-", 1}, per_cent{"%", 1}, per_per_cent{"1/%", 1};

/// 30° comes back from radians as 29.999999999999996°.
double drop_last_digits(double value) {
  return std::stod(fmt::format("{:.12g}", value));
}

}  // namespace

bool is_mohr_coulomb(const input::Material& soil) {
  return soil.model == MaterialModel::mohr_coulomb || soil.model == MaterialModel::rooted_mohr_coulomb;
}

bool is_cam_clay(const input::Material& soil) {
  return soil.model == MaterialModel::modified_cam_clay || soil.model == MaterialModel::rooted_cam_clay;
}

std::optional<double> find_porosity(const input::Material& soil) {
  return soil.slices.unit_weight && soil.porosity == 0 ? std::nullopt : std::optional(soil.porosity);
}

double reduce_slope(double slope, double factor) {
  const double sine = std::min(3 * slope / (6 + slope), 0.9999);
  const double reduced = std::sin(std::atan(std::tan(std::asin(sine)) / factor));
  return 6 * reduced / (3 - reduced);
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

void Properties::add_mohr_coulomb(const input::Material& soil) {
  using material::MohrCoulombStrength;
  const MohrCoulombStrength given{soil.cohesion, soil.friction_angle, soil.dilatancy_angle, soil.tensile_strength};
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

void Properties::add_cam_clay(const input::CamClaySoil& clay) {
  add("lambda", "slope of the normal-compression line", "λ", no_unit, clay.compression);
  add("kappa", "slope of the swelling lines", "κ", no_unit, clay.swelling);
  add_slope("critical_state_slope", "slope of the critical-state line", "M₀", clay.critical_state_slope);
  add("preconsolidation", "preconsolidation pressure, saturated and without roots", "p′c₀", stress_,
      clay.preconsolidation);
  add("preconsolidation_ratio", "preconsolidation ratio", "R₀", no_unit, clay.preconsolidation_ratio);
  if (clay.suction_hardening != 0)
    add("suction_hardening", "hardening by suction", "b", no_unit, clay.suction_hardening);
  add("smallest_pressure", "floor of p′ in the bulk modulus", "p′min", stress_, clay.smallest_pressure);
}

void Properties::add_cohesion(const std::string& key, const std::string& title, double cohesion) {
  const auto reduce = [&](std::optional<double> factor) {
    return factor ? std::optional(cohesion / *factor) : std::nullopt;
  };
  add(key, title, "cr", stress_, cohesion, reduce(design_), reduce(failure_));
}

void Properties::add_roots(const std::vector<input::Roots>& blocks, const input::Material& soil) {
  const bool takes_content = soil.model == MaterialModel::rooted_cam_clay;
  if (!takes_content && soil.model != MaterialModel::rooted_mohr_coulomb) return;
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
      add(key, title, "mr", per_cent, value);
    else
      add_cohesion(key, title, value);
  };
  double most = takes_content ? soil.roots.content : soil.roots.cohesion;
  if (worths.empty() || most > 0)
    add_one(takes_content ? "root_content" : "root_cohesion",
            worths.empty() ? what : what + " where no [[roots]] reaches", most);
  for (std::size_t i = 0; i < worths.size(); ++i) {
    add_one(fmt::format("roots_{}", i), fmt::format("{} under '{}', at the ground", what, worths[i].ground),
            worths[i].value);
    most = std::max(most, worths[i].value);
  }
  if (takes_content) add_rooted_clay(soil, most);
}

/// `content`: the largest of the model [%].
void Properties::add_rooted_clay(const input::Material& soil, double content) {
  const input::RootedSoil& roots = soil.roots;
  add("root_hardening", "hardening by roots, per per cent", "Rp", per_per_cent, roots.hardening);
  add("root_strength", "slope gained by roots, per per cent", "Ra", per_per_cent, roots.strength);
  add("root_activation", "activation of roots, in the place of Rp mr", "Rp mr", no_unit, roots.activation);
  if (std::isfinite(roots.breaking_strain)) {
    add("root_breaking_strain", "activation strain at which roots begin to break", "εr,peak", no_unit,
        roots.breaking_strain);
    add("root_breaking_range", "activation strain within which they break", "Δεr", no_unit, roots.breaking_range);
    add("root_residual_share", "share of the roots that stays", "", no_unit, roots.residual_share);
  }
  if (content <= 0) return;
  add_slope("critical_state_slope_rooted",
            fmt::format("slope of the critical-state line with {} % of roots", show_number(content)), "Mr",
            soil.cam_clay.critical_state_slope + roots.strength * content);
}

void Properties::add_external(const input::ExternalModel& external) {
  for (std::size_t i = 0; i < external.constants.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    add("constants_" + number, "constant " + number + " of the UMAT", "PROPS(" + number + ")", {"SI", 1},
        external.constants[i]);
  }
  add("constrained_modulus", "largest constrained modulus, for the time step", "Ec", {"MPa", 1e6},
      external.constrained_modulus);
}

void Properties::add_wet_weights(const ResultFolder& folder, const input::Material& soil) {
  const ShownUnit weight{"kN/m³", 1000};
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
