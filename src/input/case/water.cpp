// SPDX-License-Identifier: MIT
#include "input/case/water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "input/case/checks.hpp"
#include "input/case/soil_water_law.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Water& w) {
  v.key("density", w.density, quantity("kg/m3").above(0).usual(950, 1250, {{"g/cm3", 1e3}, {"kN/m3", 101.972}}),
        "Density of the water at zero pressure.");
  v.key("bulk_modulus", w.bulk_modulus, quantity("kPa").above(0).or_infinite(),
        "Bulk modulus of the water. A softer one makes the time step longer; the undrained response suffers.");
  v.key("viscosity", w.viscosity, quantity("Pa.s").above(0),
        "Dynamic viscosity; it turns a permeability into a conductivity.");
  v.key("drag_gravity", w.drag_gravity, quantity("m/s2").above(0),
        "Acceleration of gravity at which conductivities were measured. In a centrifuge model it stays 9.81 when they "
        "were measured at rest.");
}

// NOLINTNEXTLINE(readability-function-size): a list of keys
void describe(Visitor& v, PoreWater& w) {
  using R = RetentionCurve;
  using K = ConductivityCurve;
  v.key("retention", w.retention, plain().example(R"("van_genuchten")"), "How the saturation follows the suction s.");
  v.key("relative_conductivity", w.relative_conductivity,
        plain().allowed_unless("retention", w.retention, R::dry).example(R"("mualem")"),
        "How the conductivity follows the suction s or the saturation X.");
  v.key("minimum_saturation", w.minimum_saturation,
        plain()
            .at_least(0)
            .below(1)
            .allowed_with("retention", w.retention, R::van_genuchten)
            .or_with("retention", w.retention, R::linear)
            .or_with("retention", w.retention, R::exponential)
            .example("0.15"),
        "Saturation S_min of the driest soil. A table has its own.");
  v.key("maximum_saturation", w.maximum_saturation,
        plain()
            .above(0)
            .at_most(1)
            .allowed_with("retention", w.retention, R::saturated)
            .or_with("retention", w.retention, R::van_genuchten)
            .or_with("retention", w.retention, R::linear)
            .or_with("retention", w.retention, R::exponential),
        "Saturation S_max below the water table. A table has its own.");
  v.key("reference_pressure", w.reference_pressure,
        quantity("kPa").above(0).needed_with("retention", w.retention, R::van_genuchten).example("6.13"),
        "p_ref of van Genuchten's curve.");
  v.key("lambda", w.lambda,
        plain()
            .above(0)
            .below(1)
            .needed_with("retention", w.retention, R::van_genuchten)
            .or_with("relative_conductivity", w.relative_conductivity, K::mualem)
            .example("0.27"),
        "λ of van Genuchten's curve (called m by others) and of Mualem's conductivity.");
  v.key("dry_suction", w.dry_suction,
        quantity("kPa").above(0).needed_with("retention", w.retention, R::linear).example("100"),
        "Suction at which the straight line reaches S_min.");
  v.key("decay", w.decay,
        quantity("kPa-1")
            .above(0)
            .needed_with("retention", w.retention, R::exponential)
            .or_with("relative_conductivity", w.relative_conductivity, K::exponential)
            .example("0.1"),
        "α of the exponential laws: one over the suction at which they have fallen to 37 %. Tables of others give it "
        "per metre of head; divide that by the unit weight of water.");
  SuctionCurve retention{w.retention_table}, conductivity{w.conductivity_table};
  v.key("retention_table", retention,
        quantity("kPa")
            .at_least(0)
            .needed_with("retention", w.retention, R::table)
            .example(R"([[0, 1], ["10 kPa", 0.8], [100, 0.3]])"),
        "Suctions and saturations; constant beyond the ends.");
  v.key("conductivity", w.conductivity,
        quantity("m/s")
            .above(0)
            .usual(1e-13, 0.1, {{"cm/s", 0.01}, {"m/day", 1 / 86400.0}, {"mm/h", 1e-3 / 3600}})
            .allowed_unless("retention", w.retention, R::dry)
            .example("1e-5"),
        "Conductivity of the saturated soil. Either this or `permeability` is needed.");
  v.key("permeability", w.permeability,
        quantity("m2")
            .above(0)
            .usual(1e-20, 1e-8, {{"cm2", 1e-4}})
            .allowed_unless("retention", w.retention, R::dry)
            .example("6e-11"),
        "Intrinsic permeability instead; the conductivity is density · gravity · permeability/viscosity.");
  v.key("conductivity_ratio", w.conductivity_ratio,
        plain().above(0).usual(1e-3, 10).allowed_unless("retention", w.retention, R::dry).example("0.1"),
        "Conductivity across the bedding over that along it, which is `conductivity`. In seepage, not in MPM.");
  v.key("conductivity_inclination", w.conductivity_inclination,
        quantity("deg").at_least(-90).at_most(90).allowed_unless("retention", w.retention, R::dry).example("15"),
        "Inclination of the bedding of `conductivity_ratio`, positive where it rises along x.");
  v.key("compressibility", w.compressibility,
        quantity("kPa-1")
            .at_least(0)
            .usual_or_zero(1e-6, 1e-1, {{"MPa-1", 1e-3}})
            .allowed_unless("retention", w.retention, R::dry)
            .example("1e-4"),
        "Coefficient of volume compressibility m_v of the skeleton: what saturated soil at rest stores under a change "
        "of its pressure, in seepage over time (initial.season, [timeline]). Soil that moves has that of its model.");
  v.key("measure", w.measure,
        plain()
            .allowed_with("relative_conductivity", w.relative_conductivity, K::mualem)
            .or_with("relative_conductivity", w.relative_conductivity, K::hillel),
        "The saturation X of the relative conductivity.");
  v.key("exponent", w.exponent,
        plain().at_least(0).needed_with("relative_conductivity", w.relative_conductivity, K::hillel).example("3"),
        "r of Hillel's conductivity.");
  v.key("air_entry", w.air_entry,
        quantity("kPa")
            .at_least(0)
            .allowed_with("relative_conductivity", w.relative_conductivity, K::mualem)
            .example("2"),
        "Mualem's conductivity falls from this suction on only. For λ < 1/2 it would fall with infinite slope from "
        "zero, which stops seepage over time: there (initial.season, [timeline]) 0.2 kPa (2 cm of water) are used "
        "where no value is given (Vogel et al. 2001). 0: none.");
  v.key("conductivity_table", conductivity,
        quantity("kPa")
            .at_least(0)
            .needed_with("relative_conductivity", w.relative_conductivity, K::table)
            .example(R"([[0, 1], ["10 kPa", 0.1], [100, 1e-4]])"),
        "Suctions and relative conductivities, which lie above 0; constant beyond the ends.");
  v.key("chi", w.chi, plain().allowed_unless("retention", w.retention, R::dry),
        "χ of Bishop's effective stress: this share of the pore pressure acts between the grains.");
  v.key("chi_air_entry", w.chi_air_entry,
        quantity("kPa").above(0).needed_with("chi", w.chi, BishopChi::khalili_khabbaz).example("5"),
        "Air entry s_e of Khalili and Khabbaz.");
}
namespace {

/// Upper limit of K_w [Pa], a thousand times that of water: larger values only reduce the time step.
constexpr double largest_bulk_modulus = 2.2e12;

/// The findings of [materials.NAME.water].
struct Soil : BlockFindings {
  const std::string& name;
  const Material& material;
};

void check_limits(const Soil& soil) {
  const PoreWater& water = soil.material.water;
  const RetentionCurve curve = water.retention;
  if (curve == RetentionCurve::saturated || curve == RetentionCurve::table) return;
  if (!soil.is_sound("minimum_saturation") || !soil.is_sound("maximum_saturation")) return;
  if (water.minimum_saturation < water.maximum_saturation) return;
  soil.report(soil.is_given("minimum_saturation") ? "minimum_saturation" : "maximum_saturation",
              "'minimum_saturation' is {:.6g} and 'maximum_saturation' is {:.6g}; the minimum must be smaller",
              water.minimum_saturation, water.maximum_saturation);
}

/// Converts suctions to kPa, the unit of the file and of messages.
std::vector<std::array<double, 2>> in_kilopascals(std::vector<std::array<double, 2>> pairs) {
  for (auto& pair : pairs) pair[0] /= 1e3;
  return pairs;
}

/// Reports an Error that `make` throws.
void check_table(const Soil& soil, const char* key, const std::function<void()>& make) {
  if (!soil.is_sound(key)) return;
  try {
    make();
  } catch (const Error& error) {
    soil.report(key, "'{}' is no falling curve over suctions in kPa: {}", key, error.what());
  }
}

void check_curves(const Soil& soil) {
  const PoreWater& water = soil.material.water;
  if (water.retention == RetentionCurve::table && soil.is_sound("retention"))
    check_table(soil, "retention_table", [&] {
      const auto curve =
          material::make_retention_table(in_kilopascals(water.retention_table), material::Interpolation::smooth);
      if (curve.minimum == curve.maximum)
        fail_input("The saturation is the same everywhere; use retention = \"saturated\".");
    });
  if (water.relative_conductivity == ConductivityCurve::table && soil.is_sound("relative_conductivity"))
    check_table(soil, "conductivity_table", [&] {
      material::make_conductivity_table(in_kilopascals(water.conductivity_table), material::Interpolation::smooth);
    });
}

void check_conductivity(const Soil& soil) {
  const PoreWater& water = soil.material.water;
  if (!soil.is_sound("conductivity") || !soil.is_sound("permeability")) return;
  if (!water.conductivity && !water.permeability)
    soil.findings.add(
        soil.path,
        "material '{}' has pore water; give its 'conductivity', for example 1e-5 (m/s), or its 'permeability' (m2)",
        soil.name);
  else if (water.conductivity && water.permeability)
    soil.report("permeability", "material '{}' has both a conductivity and a permeability; give one of them",
                soil.name);
}

void check_porosity(const Soil& soil) {
  const bool by_ratio = soil.material.given_void_ratio.has_value();
  const std::string path = "materials." + soil.name + (by_ratio ? ".void_ratio" : ".porosity");
  const double n = soil.material.porosity;
  if (!soil.findings.is_sound(path) || (n > 0 && n < 1)) return;
  soil.findings.add(
      path,
      by_ratio
          ? fmt::format("'void_ratio' is 0; material '{}' has pore water, which needs pores: a void ratio above 0",
                        soil.name)
          : fmt::format(
                "'porosity' is {:.6g}; material '{}' has pore water, which needs pores: a porosity above 0 and below 1",
                n, soil.name));
}

/// Warns of an infinite slope of k_r at saturation in transient seepage.
void warn_of_air_entry(const Case& data, const Soil& soil) {
  const bool in_time = data.timeline || data.initial.water.season > 0;
  const PoreWater safe = add_air_entry(soil.material.water);
  if (!in_time || soil.material.water.air_entry || !safe.air_entry || !soil.is_sound("lambda")) return;
  soil.findings.warn(
      soil.path + ".relative_conductivity",
      "material '{}': Mualem's conductivity with lambda = {:.3g} falls with infinite slope at saturation; seepage over "
      "time uses air_entry = {}. Give 'air_entry' to choose another, or 0 for none",
      soil.name, soil.material.water.lambda, format_value(*safe.air_entry, data.units().stress));
}

/// Checks the upper limit of K_w: below the water table retention curves are flat, so that storage is due to the
/// compressibility of water alone.
void check_bulk_modulus(const Case& data, Findings& findings) {
  const std::string path = "water.bulk_modulus";
  if (!findings.is_sound(path) || data.water.bulk_modulus <= largest_bulk_modulus) return;
  for (const auto& [name, material] : data.materials)
    if (material.water.is_wet())
      return findings.add(path,
                          "'bulk_modulus' is {:.6g} kPa, but the retention curve of material '{}' is flat at "
                          "saturation, so that only the compression of the water stores any: a change of volume needs "
                          "a finite modulus, at most {:.6g} kPa (water has 2.2e6)",
                          data.water.bulk_modulus / 1e3, name, largest_bulk_modulus / 1e3);
}

/// Reports keys of a stage that were changed without effect: those of pore water in dry soil, and those of the
/// two-velocity formulation in the Darcy formulation.
void report_meaningless(const StepSettings& step, const StepSettings& usual, const std::string& path, bool seeps,
                        Findings& findings) {
  const std::pair<const char*, bool> changes[] = {
      {"water", !seeps && step.water != usual.water},
      {"drag", step.drag != usual.drag},
      {"water_damping", step.water_damping != usual.water_damping},
      {"damped_force", step.damped_force != usual.damped_force},
      {"pressure_smoothing", step.pressure_smoothing != usual.pressure_smoothing},
      {"water_exchange", step.water_exchange != usual.water_exchange},
      {"conductivity_factor", !seeps && step.conductivity_factor != usual.conductivity_factor}};
  for (const auto& [key, is_changed] : changes) {
    const std::string at = path + "." + key;
    if (!is_changed || !findings.places.is_given(at) || !findings.is_sound(at)) continue;
    findings.add(
        at, seeps
                ? fmt::format("'{}' has no meaning with water = \"seeps\"{}: water has no velocity of its own there. "
                              "It needs water = \"flows\"",
                              key, findings.places.is_given(path + ".water") ? "" : ", the default")
                : fmt::format("'{}' has no meaning here: no material has pore water, see [materials.NAME.water]", key));
  }
}

void check_step(const Case& data, const StepSettings& step, const StepSettings& usual, const std::string& path,
                Findings& findings) {
  if (!is_wet(data)) return report_meaningless(step, usual, path, false, findings);
  if (step.water == WaterMotion::seeps) return report_meaningless(step, usual, path, true, findings);
  if (step.water != WaterMotion::held || step.geometry == Geometry::frozen) return;
  if (!findings.is_sound(path + ".water") || !findings.is_sound(path + ".geometry")) return;
  const char* key = findings.places.is_given(path + ".water") ? "water" : "geometry";
  findings.add(path + "." + key,
               "water = \"held\" needs geometry = \"frozen\": pore pressures that stay as they are belong to soil that "
               "keeps its place");
}

}  // namespace

bool is_wet(const Case& data) {
  return std::any_of(data.materials.begin(), data.materials.end(),
                     [](const auto& entry) { return entry.second.water.is_wet(); });
}

void check_water(const Case& data, Findings& findings) {
  for (const auto& [name, material] : data.materials) {
    const Soil soil{{findings, "materials." + name + ".water"}, name, material};
    if (!material.water.is_wet() || !soil.is_sound("retention")) continue;
    // In stages FEM has pore pressures in total-stress laws too: the "undrained B" of practice.
    if (!material.traits().takes_water && (data.construction.empty() || uses(data, Method::mpm))) {
      findings.add(
          soil.path,
          "material '{}' is described in total stresses, model = \"{}\": it has no pore water of its own but in "
          "stages of construction without MPM; take [{}] out",
          name, material.traits().word, soil.path);
      continue;
    }
    check_limits(soil);
    check_curves(soil);
    check_conductivity(soil);
    if (material.water.conductivity_ratio != 1 && uses(data, Method::mpm) && soil.is_sound("conductivity_ratio"))
      soil.report(
          "conductivity_ratio",
          "material '{}' has different conductivities along and across its bedding; MPM has one: leave it out, or "
          "\"mpm\" out of 'methods'",
          name);
    check_porosity(soil);
    warn_of_air_entry(data, soil);
  }
  check_bulk_modulus(data, findings);
  // If the water of some material is faulty, is_wet() is not reliable.
  if (!findings.is_sound("materials") && !is_wet(data)) return;
  for (std::size_t i = 0; i < data.stages.size(); ++i)
    check_step(data, data.stages[i].step, Stage().step, fmt::format("stage.{}", i), findings);
  const StrengthReduction& reduction = data.strength_reduction;
  check_step(data, reduction.curve.step_settings, DisplacementCurve().step_settings, "strength_reduction.curve",
             findings);
  check_step(data, reduction.frozen.step_settings, FrozenFactor().step_settings, "strength_reduction.frozen", findings);
}

}  // namespace talus::input
