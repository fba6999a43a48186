// SPDX-License-Identifier: MIT
#include "report/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "report/content/choices.hpp"
#include "report/content/parts.hpp"
#include "report/content/water.hpp"
#include "report/folder/numbers.hpp"
#include "results/water.hpp"

namespace talus::report {

namespace {

using input::WaterMotion;

/// Bulk modulus of pure water [Pa].
constexpr double real_modulus = 2.2e9;
/// Error of the budget, relative to the water in the model, above which it is reported.
constexpr double noticeable = 1e-6;

/// Lists the soils that satisfy `holds`.
template <class Condition>
std::vector<std::string> list_soils(const input::Case& data, Condition holds) {
  std::vector<std::string> names;
  for (const auto& [name, soil] : data.materials)
    if (holds(soil)) names.push_back(name);
  return names;
}

/// Names the parts that satisfy `holds`.
template <class Condition>
std::string join_parts(const std::vector<WaterPart>& parts, Condition holds) {
  std::vector<std::string> names;
  for (const WaterPart& part : parts)
    if (holds(part)) names.push_back(part.name);
  return join_words(names);
}

/// Collects the assumptions of one wet case.
class WaterAssumptions {
 public:
  explicit WaterAssumptions(const ResultFolder& folder)
      : run_(folder.run), data_(folder.data), units_(read_units(run_)), parts_(list_water_parts(data_)) {}

  std::vector<std::string> collect() {
    add_phases();
    add_modulus();
    add_conductivity();
    add_trials();
    add_steps();
    add_surfaces();
    add_budget();
    return std::move(sentences_);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> text, Values&&... values) {
    sentences_.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  void add_phases() {
    const auto dry = list_soils(data_, [](const auto& soil) { return !soil.water.is_wet(); });
    const auto khalili = list_soils(data_, [](const auto& soil) {
      return soil.water.is_wet() && soil.water.chi == input::BishopChi::khalili_khabbaz;
    });
    add("Soil and pore water are on the same points; air stays at atmospheric pressure. Effective stress "
        "after Bishop{}. Retention curves have no hysteresis, and water that leaves does not run down the slope and "
        "seep in elsewhere.",
        khalili.empty() ? ", with χ equal to the degree of saturation"
                        : "; χ after Khalili and Khabbaz in " + join_words(khalili));
    const input::InitialPressure start = data_.initial.water.pressure;
    const bool is_given = start == input::InitialPressure::water_table || start == input::InitialPressure::grid;
    if (!dry.empty() && is_given)
      add("Without pore water of its own: {}. The given pore pressures are constant in it.", join_words(dry));
    else if (!dry.empty())
      add("Without pore water: {}. There is neither seepage nor suction in it; wet soil beside it loses water to it as "
          "through a seepage face.",
          join_words(dry));
    const auto largest = find_largest_suction(run_);
    const auto limp =
        list_soils(data_, [](const auto& soil) { return soil.water.retention == input::RetentionCurve::saturated; });
    if (largest && !limp.empty())
      add("{} above the water table too, with suctions up to {}: that is on the unsafe side.",
          join_words(limp) + (limp.size() == 1 ? " stays saturated" : " stay saturated"),
          show(*largest, units_.stress));
  }

  /// Returns the oedometric modulus E_c [Pa]; nullopt if it depends on the stress.
  static std::optional<double> find_oedometric(const input::Material& soil) {
    return material::find_oedometric_modulus(soil.model, soil);
  }

  /// Returns the fraction of an undrained one-dimensional load that the water carries: 1/(1 + n E_c/K_w).
  static double find_share(const input::Material& soil, double oedometric, double modulus) {
    return 1 / (1 + soil.porosity * oedometric / modulus);
  }

  void add_modulus() {
    const double modulus = data_.water.bulk_modulus;
    const double ratio = real_modulus / modulus;
    if (!(ratio > 1.1)) return;
    double lowest = 1, real = 1;
    for (const auto& [name, soil] : data_.materials) {
      const auto oedometric = find_oedometric(soil);
      if (!soil.water.is_wet() || !oedometric) continue;
      if (const double share = find_share(soil, *oedometric, modulus); share < lowest) {
        lowest = share;
        real = find_share(soil, *oedometric, real_modulus);
      }
    }
    const std::string effect = lowest == 1
                                   ? "Of an undrained load, water carries less than it would, the less the stiffer "
                                     "the soil is under its stress"
                                   : fmt::format(
                                         "Of an undrained load, water carries {:.0f} % instead of {:.0f} % in "
                                         "the stiffest of the wet soils",
                                         100 * lowest, 100 * real);
    const bool bounds_step =
        std::any_of(parts_.begin(), parts_.end(), [](const WaterPart& p) { return p.has_inertia(); });
    add("The bulk modulus of the water is {}, {} times less than that of real water ({}){}. "
        "{}: excess pore pressures from shearing are too small.",
        show(modulus, units_.stiffness, 4), show_number(ratio, ratio < 10 ? 2 : 3),
        show(real_modulus, units_.stiffness, 4),
        bounds_step ? ", for a longer time step" : ", though the time step does not depend on it", effect);
  }

  void add_conductivity() {
    const auto constant = list_soils(data_, [](const auto& soil) {
      return soil.water.is_wet() && soil.water.retention != input::RetentionCurve::saturated &&
             soil.water.relative_conductivity == input::ConductivityCurve::constant;
    });
    if (!constant.empty())
      add("The conductivity of {} does not fall with suction: above the water table the soil lets as much water "
          "through as "
          "below it, and rain enters and drains faster than in real soil.",
          join_words(constant));
    for (const WaterPart& part : parts_)
      if (const double factor = part.step.conductivity_factor; part.flows() && factor != 1)
        add("Conductivities are multiplied by {:g} in {}: flow changes there {} times {} than in reality.", factor,
            part.name, show_number(std::max(factor, 1 / factor)), factor > 1 ? "faster" : "slower");
  }

  void add_trials() {
    const input::StepSettings *frozen = find_frozen_steps(data_), *curve = find_curve_steps(data_);
    if (frozen != nullptr && frozen->water == WaterMotion::held)
      add("The factor at frozen geometry is drained: pore pressures and suctions stay as they were at the start, "
          "whatever "
          "the soil does. Pressures that shearing raises in loose soil, and those of a rapid drawdown, are not in it.");
    else if (frozen != nullptr)
      add("The factor at frozen geometry is coupled: water moves in its trials, and shearing changes the pore "
          "pressures.");
    if (curve != nullptr && moves(curve->water))
      add("The criteria on the displacement curve are coupled: in the {:g} s of a trial water moves, and shearing "
          "raises or lowers pore pressures that may have no time to even out.",
          data_.strength_reduction.curve.window);
    else if (curve != nullptr)
      add("The criteria on the displacement curve are drained: pore pressures are held.");
    if (frozen != nullptr && curve != nullptr && moves(frozen->water) != moves(curve->water))
      add("The drained and the coupled factors answer different questions and need not agree.");
  }

  void add_steps() {
    if (const auto scaled =
            join_parts(parts_, [](const auto& p) { return p.has_inertia() && p.step.mass_scaling > 1; });
        !scaled.empty())
      add("Mass scaling in {} multiplies the inertia of the water too: a water hammer grows with the square root of "
          "the mass scaling.",
          scaled);
    if (const auto pressed =
            join_parts(parts_, [](const auto& p) { return p.flows() && p.step.geometry == input::Geometry::frozen; });
        !pressed.empty())
      add("Geometry is frozen while water moves in {}: pores keep their volume, and the water that straining would "
          "press "
          "out of them stays in them under a higher pressure.",
          pressed);
    if (const auto lowered = join_parts(parts_,
                                        [](const auto& p) {
                                          return p.flows() && p.step.water_damping > 0 &&
                                                 p.step.damped_force == input::DampedForce::without_drag;
                                        });
        !lowered.empty())
      add("The damping of the water without drag in {} acts like a conductivity that is lower by the share of the "
          "damping.",
          lowered);
    const double measured = data_.water.drag_gravity, gravity = data_.gravity.acceleration;
    if (std::abs(gravity / measured - 1) > 1e-3)
      add("Conductivities hold at {} while gravity is {}: water flows in proportion to gravity.",
          format_value(measured, units_.acceleration()), format_value(gravity, units_.acceleration()));
  }

  void add_surfaces() {
    add("Hydraulic conditions go with the soil: a surface that moves takes the condition of the nearest line, and a "
        "surface "
        "without any is a seepage face. Outer water and its weight act on the sides of the mesh beside the soil, so "
        "that a "
        "surface under water is known to about one element.");
    if (const int undecided = run_.seepage ? run_.seepage->undecided : 0; undecided > 0)
      add("In the steady seepage {} {} a surface did not converge between inflow and outflow.", undecided,
          undecided == 1 ? "node of" : "nodes of");
  }

  void add_budget() {
    if (!run_.water || !(run_.water->stored > 0)) return;
    const results::WaterBudget& water = *run_.water;
    if (const double error = std::abs(water.error); error > noticeable)
      add("The water budget has an error of {} of the water.", show_number(error, 2));
    if (const double between = std::abs(water.lost_between) / water.stored; between > noticeable)
      add("Between elements that are integrated differently {} of the water came or went.", show_number(between, 2));
    if (water.left_grid > 0) add("{} kg of water left the grid with its soil.", show_number(water.left_grid));
  }

  const results::RunResult& run_;
  const input::Case& data_;
  ShownUnits units_;
  std::vector<WaterPart> parts_;
  std::vector<std::string> sentences_;
};

std::string describe_closure(double error) {
  const double size = std::abs(error);
  return size < 1e-12 ? "balances to round-off"
                      : "has an error of " + show_number(size, 1) + " of the water in the model";
}

}  // namespace

std::vector<std::string> describe_water(const ResultFolder& folder) {
  std::vector<std::string> sentences = describe_water_state(folder);
  if (!is_wet(folder)) return sentences;
  const ShownUnits units = read_units(folder.run);
  const ShownUnit& stress = units.stress;
  const std::size_t dimension = get_dimension(folder.run);
  if (const auto& seepage = folder.run.seepage) {
    const std::string suction = show(seepage->largest_suction, stress);
    sentences.push_back(folder.run.season
                            ? fmt::format("In the steady seepage before the season {} flow through the ground; its "
                                          "largest suction is {}.",
                                          show_per_thickness(seepage->outflow, units.flow(dimension)), suction)
                            : fmt::format("The largest suction in the steady seepage is {}.", suction));
  }
  if (const auto& water = folder.run.water) {
    std::string text =
        fmt::format("At the end of the stages the largest pore pressure is {}", show(water->largest_pressure, stress));
    text += water->largest_suction > 0 ? " and the largest suction " + show(water->largest_suction, stress)
                                       : ", and there is no suction";
    if (water->runoff > 0)
      text += fmt::format("; {} of rain ran off",
                          show_per_thickness(water->runoff / water->density, units.volume(dimension)));
    sentences.push_back(text + "; the water budget " + describe_closure(water->error) + ".");
  }
  return sentences;
}

std::vector<std::string> list_water_assumptions(const ResultFolder& folder) {
  return is_wet(folder) ? WaterAssumptions(folder).collect() : std::vector<std::string>{};
}

using results::WaterFlow;

namespace {

/// Flows below this fraction of the total are round-off of the solver.
constexpr double no_flow = 1e-6;

std::string name_side(const std::string& name) {
  return name == results::other_surfaces ? "the ground without a name" : "'" + name + "'";
}

class StateWords {
 public:
  StateWords(const ResultFolder& folder, const results::WaterState& state)
      : folder_(folder),
        state_(state),
        length_(read_units(folder.run).length),
        rate_(read_units(folder.run).flow(get_dimension(folder.run))) {}

  std::vector<std::string> collect() {
    if (state_.flow == WaterFlow::steady || state_.flow == WaterFlow::transient) {
      format_flow();
      format_closed_sides();
    }
    format_ponds();
    return std::move(sentences_);
  }

 private:
  std::string place(const std::vector<double>& x) const {
    std::vector<double> shown;
    for (const double v : x) shown.push_back(std::round(1e3 * v / length_.si) / 1e3);
    return format_point(shown) + " " + length_.name;
  }

  /// Returns "; up to (45.1, 10.8) m" if the seepage exit of the side is above the ponded water.
  std::string find_exit(const std::string& name) const {
    for (const results::SeepageExit& e : state_.exits)
      if (e.name == name) return ", up to the exit point " + place(e.highest);
    return "";
  }

  std::vector<std::string> list_sides(double results::Discharge::*flow, bool with_exit) const {
    const double all = std::max(state_.inflow, state_.outflow);
    std::vector<std::string> sides;
    for (const results::Discharge& d : state_.discharges)
      if (d.*flow > no_flow * all)
        sides.push_back(fmt::format("{} through {}{}", show_per_thickness(d.*flow, rate_), name_side(d.name),
                                    with_exit ? find_exit(d.name) : ""));
    return sides;
  }

  void format_flow() {
    const auto in = list_sides(&results::Discharge::inflow, false),
               out = list_sides(&results::Discharge::outflow, true);
    const char* when =
        state_.flow == WaterFlow::steady ? "In the steady seepage" : "At the end of the transient seepage";
    sentences_.push_back(fmt::format("{} water enters with {}, and leaves with {}.", when,
                                     in.empty() ? "nothing" : join_words(in),
                                     out.empty() ? "nothing" : join_words(out)));
  }

  /// Adds the base and the outer sides that no block opens, which are impermeable.
  void format_closed_sides() {
    std::vector<std::string> sides{"bottom", "left", "right"};
    if (get_dimension(folder_.run) == 3) sides.insert(sides.end(), {"front", "back"});
    std::erase_if(sides, [&](const std::string& side) {
      return std::any_of(
          folder_.data.hydraulics.begin(), folder_.data.hydraulics.end(),
          [&](const input::Hydraulic& h) { return h.on == side && h.condition != input::WaterCondition::no_flow; });
    });
    for (std::string& side : sides) side = fmt::format("'{}'", side);
    if (!sides.empty()) sentences_.push_back(fmt::format("No water passes {}.", join_words(sides)));
  }

  void format_ponds() {
    std::vector<std::string> levels;
    for (const results::StandingWater& pond : state_.ponds)
      for (const double level : {pond.level_from, pond.level_to})
        if (const std::string text = show_coordinate(level, length_);
            std::find(levels.begin(), levels.end(), text) == levels.end())
          levels.push_back(text);
    if (!levels.empty())
      sentences_.push_back(fmt::format("{} stands on the ground up to y = {}.",
                                       state_.flow == WaterFlow::lowered ? "After drawdown water" : "Water",
                                       join_words(levels)));
  }

  const ResultFolder& folder_;
  const results::WaterState& state_;
  ShownUnit length_;
  ShownUnit rate_;
  std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> describe_water_state(const ResultFolder& folder) {
  const std::vector<results::WaterState> states = find_water_states(folder);
  return states.empty() ? std::vector<std::string>{} : StateWords(folder, states.back()).collect();
}

}  // namespace talus::report
