// SPDX-License-Identifier: MIT
#pragma once
// [[construction]], [consolidation] and [[vertical_drains]]: stages of construction by FEM with consolidation.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/language/spec.hpp"

namespace talus::input {

struct Case;
class Findings;

/// How the pore water of a stage moves.
enum class StageDrainage { consolidation, undrained, drained };

template <>
inline constexpr auto choices<StageDrainage> = std::array{
    Choice{StageDrainage::consolidation, "consolidation", "it flows while the soil deforms (Biot)"},
    Choice{StageDrainage::undrained, "undrained", "none flows: the change is borne by soil and water together"},
    Choice{StageDrainage::drained, "drained", "pore pressures reach those of steady flow at the end of the stage"},
};

struct ConstructionStage {
  std::string name;
  double duration = 0;                       ///< [s]; 0: the change acts at once, without flow
  std::vector<std::string> add;              ///< regions, surcharges, supports and vertical drains
  std::vector<std::string> remove;           ///< the same
  std::map<std::string, std::string> soils;  ///< material of regions from now on
  StageDrainage drainage = StageDrainage::consolidation;
  bool factor = true;               ///< the other methods run on its end
  bool reset_displacement = false;  ///< displacements are counted from its start
  bool release = false;             ///< MPM starts from its end
};

/// Settings of the time steps.
struct Consolidation {
  double tolerance = 2e-3;           ///< error of a step over the largest change of pore pressure [-]
  std::optional<double> first_step;  ///< [s]; not given: a thousandth of the stage
  int most_iterations = 25;          ///< linear systems in a step
};

enum class DrainPattern { triangular, square };

template <>
inline constexpr auto choices<DrainPattern> = std::array{
    Choice{DrainPattern::triangular, "triangular", "D_e = 1.05 spacings"},
    Choice{DrainPattern::square, "square", "D_e = 1.13 spacings"},
};

/// Prefabricated or sand drains in regions, after Hansbo (1981).
struct VerticalDrains {
  std::string name;
  std::vector<std::string> regions;
  double spacing = 0;   ///< [m]
  double diameter = 0;  ///< d_w [m]; of a band its equivalent one
  DrainPattern pattern = DrainPattern::triangular;
  std::optional<double> conductivity;  ///< k_h of the soil [m/s]; not given: that of the soil
  double smear = 1;                    ///< diameter of the smeared zone over d_w [-]
  double smear_conductivity = 1;       ///< k_h over that of the smeared zone [-]
  double head = 0;                     ///< in the drains [m]
};

/// Returns D_e [m], the diameter of the cylinder of soil that a drain serves.
double find_served_diameter(const VerticalDrains& drains);
/// Returns μ of equal strain with smear, without well resistance: Hansbo (1981), which is Barron's (1948) F without
/// smear.
double find_drain_factor(const VerticalDrains& drains);

void describe(auto& v, ConstructionStage& s) {
  v.key("name", s.name, plain().required().example(R"("lift 1")"), "Name of the stage in the results.");
  v.key("duration", s.duration, quantity("day").at_least(0).required().example("30"),
        "How long it lasts. Its change of weights, loads and soil acts linearly over this time; with 0 at once, before "
        "any water flows.");
  v.key("add", s.add, plain().example(R"(["lift_1"])"),
        "Regions, surcharges, supports and vertical drains that are there from now on. What no stage adds is there at "
        "the start. Placed soil is free of stress.");
  v.key("remove", s.remove, plain().example(R"(["cut_1"])"), "Regions, surcharges and supports that are taken away.");
  v.entries(
      "soils", s.soils, "soil", 0, plain().example(R"("clay_undrained")"),
      "Material of a region from this stage on: another strength or drainage of the same soil, whose stress stays, "
      "or the soil that fills a region which the stage adds.");
  v.key("drainage", s.drainage, plain(), "What the pore water does.");
  v.key("factor", s.factor, plain(),
        "The methods of [analysis] find the factor of safety at its end, with the pore pressures and stresses of the "
        "stage.");
  v.key("reset_displacement", s.reset_displacement, plain(), "Count displacements from the start of this stage.");
  v.key("release", s.release, plain(),
        "MPM starts from its end, with its pore pressures and stresses, or from the place where it fails: the runout.");
}

void describe(auto& v, Consolidation& c) {
  v.key("tolerance", c.tolerance, plain().above(0).below(0.5),
        "Error of a time step, over the largest change of pore pressure of the stage so far; it is estimated for every "
        "step and written.");
  v.key("first_step", c.first_step, quantity("day").above(0).example(R"("1 h")"),
        "First time step of a stage; if not given, a thousandth of its duration.");
  v.key("iterations", c.most_iterations, plain().at_least(3), "Linear systems in a step, after which it is halved.");
}

void describe(auto& v, VerticalDrains& d) {
  v.key("name", d.name, plain().required().example(R"("wicks")"), "Name of the drains, which a stage may add.");
  v.key("regions", d.regions, plain().required().example(R"(["clay"])"), "Regions that they drain.");
  v.key("spacing", d.spacing, quantity("m").above(0).required().example("1.5"), "Distance of neighbouring drains.");
  v.key("diameter", d.diameter, quantity("m").above(0).required().usual(0.02, 1).example("0.066"),
        "Diameter of a drain; of a band (a + b)/2, or 2 (a + b)/π.");
  v.key("pattern", d.pattern, plain(), "How they are arranged.");
  v.key("conductivity", d.conductivity, quantity("m/s").above(0).example("2e-9"),
        "Horizontal conductivity of the soil; if not given, that of [materials.NAME.water].");
  v.key("smear", d.smear, plain().at_least(1).example("3"), "Diameter of the smeared zone over that of the drain.");
  v.key("smear_conductivity", d.smear_conductivity, plain().at_least(1).example("2"),
        "Horizontal conductivity over that of the smeared zone.");
  v.key("head", d.head, quantity("m").required().example("0"), "Level to which water stands in the drains.");
}

/// Returns true if a region, surcharge, support or drain is there at the start: no stage adds it before one removes it.
bool is_there_at_start(const Case& data, const std::string& name);
/// Returns true if it is there in stage `number`, counted from 0.
bool is_there(const Case& data, const std::string& name, std::size_t number);

/// Checks names, order and requirements of the stages, and the drains.
void check_construction(const Case& data, Findings& findings);

}  // namespace talus::input
