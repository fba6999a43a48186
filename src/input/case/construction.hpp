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

void describe(Visitor& v, ConstructionStage& s);

void describe(Visitor& v, Consolidation& c);

void describe(Visitor& v, VerticalDrains& d);

/// Returns true if a region, surcharge, support or drain is there at the start: no stage adds it before one removes it.
bool is_there_at_start(const Case& data, const std::string& name);
/// Returns true if it is there in stage `number`, counted from 0.
bool is_there(const Case& data, const std::string& name, std::size_t number);

/// Checks names, order and requirements of the stages, and the drains.
void check_construction(const Case& data, Findings& findings);

}  // namespace talus::input
