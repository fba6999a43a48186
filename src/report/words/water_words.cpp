#include "report/words/water_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/content/properties.hpp"
#include "report/content/soil_water.hpp"
#include "report/content/water_choices.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Of water as it is [Pa].
constexpr double real_modulus = 2.2e9;
/// Water that the budget does not explain, over the water in the model, from which on it is worth a sentence.
constexpr double noticeable = 1e-6;

/// Lists the soils of which `holds` is true.
template <class Condition>
std::vector<std::string> list_soils(const json& summary, Condition holds) {
  std::vector<std::string> names;
  const json* materials = find(summary, {"input", "materials"});
  if (materials == nullptr || !materials->is_object()) return names;
  for (const auto& [name, material] : materials->items())
    if (holds(read_pore_water(material), material)) names.push_back(name);
  return names;
}

/// Names the parts of which `holds` is true.
template <class Condition>
std::string join_parts(const std::vector<WaterPart>& parts, Condition holds) {
  std::vector<std::string> names;
  for (const WaterPart& part : parts)
    if (holds(part)) names.push_back(part.name);
  return join_words(names);
}

/// Collects the sentences about one wet case.
class WaterAssumptions {
 public:
  explicit WaterAssumptions(const json& summary)
      : summary_(summary), units_(read_units(summary)), parts_(list_water_parts(summary)) {}

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
    const auto dry = list_soils(summary_, [](const auto& soil, const json&) { return !soil.is_wet(); });
    const auto khalili = list_soils(summary_, [](const auto& soil, const json&) {
      return soil.is_wet() && soil.chi == input::BishopChi::khalili_khabbaz;
    });
    add("Soil and pore water are two phases on the same points; air stays at atmospheric pressure. Effective stress "
        "after Bishop{}. Retention curves have no hysteresis, and water that leaves does not run down the slope and "
        "seep in elsewhere.",
        khalili.empty() ? ", with χ equal to the degree of saturation"
                        : "; χ after Khalili and Khabbaz in " + join_words(khalili));
    if (!dry.empty())
      add("Without pore water: {}. There is neither seepage nor suction in it; wet soil beside it loses water to it as "
          "through a seepage face.",
          join_words(dry));
    const auto largest = find_largest_suction(summary_);
    const auto limp = list_soils(
        summary_, [&](const auto& soil, const json&) { return soil.retention == input::RetentionCurve::saturated; });
    if (largest && !limp.empty())
      add("{} above the water table too, with suctions up to {}: that is on the unsafe side.",
          join_words(limp) + (limp.size() == 1 ? " stays saturated" : " stay saturated"),
          show(*largest, units_.stress));
  }

  /// E_c of the soil [Pa]; nothing where it changes with the stress.
  static std::optional<double> find_oedometric(const json& material) {
    if (const auto given = find_si(material, "constrained_modulus")) return given;
    const auto young = find_si(material, "young_modulus");
    const double poisson = get_si(material, "poisson_ratio", 0);
    return young ? std::optional(*young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))) : std::nullopt;
  }

  /// How much of a load that is brought on undrained the water takes: 1/(1 + n E_c/K_w), in one dimension.
  static double find_share(const json& material, double oedometric, double modulus) {
    return 1 / (1 + find_porosity(material).value_or(0) * oedometric / modulus);
  }

  void add_modulus() {
    const double modulus = read_water(summary_).bulk_modulus;
    const double ratio = real_modulus / modulus;
    if (!(ratio > 1.1)) return;
    double lowest = 1, real = 1;
    list_soils(summary_, [&](const auto& soil, const json& material) {
      const auto oedometric = find_oedometric(material);
      if (!soil.is_wet() || !oedometric) return false;
      if (const double share = find_share(material, *oedometric, modulus); share < lowest) {
        lowest = share;
        real = find_share(material, *oedometric, real_modulus);
      }
      return true;
    });
    const std::string effect =
        lowest == 1 ? "Of a load that is brought on undrained, water carries less than it would, the less the stiffer "
                      "the soil is under its stress"
                    : fmt::format(
                          "Of a load that is brought on undrained, water carries {:.0f} % instead of {:.0f} % in "
                          "the stiffest of the wet soils",
                          100 * lowest, 100 * real);
    add("The bulk modulus of the water is {} MPa, {} times less than that of water (2200 MPa), for a longer time step. "
        "{}: pore pressures that shearing raises come out too small, and steady flow is the same.",
        show_number(modulus / 1e6, 4), show_number(ratio, ratio < 10 ? 2 : 3), effect);
  }

  void add_conductivity() {
    const auto constant = list_soils(summary_, [](const auto& soil, const json&) {
      return soil.is_wet() && soil.retention != input::RetentionCurve::saturated &&
             soil.relative_conductivity == input::ConductivityCurve::constant;
    });
    if (!constant.empty())
      add("The conductivity of {} does not fall with suction: above the water table the soil lets as much water "
          "through as "
          "below it, and rain enters and drains faster than in real soil.",
          join_words(constant));
    for (const WaterPart& part : parts_)
      if (part.flows && part.conductivity_factor != 1)
        add("Conductivities are multiplied by {:g} in {}: flow changes there {} times {} than in reality.",
            part.conductivity_factor, part.name,
            show_number(std::max(part.conductivity_factor, 1 / part.conductivity_factor)),
            part.conductivity_factor > 1 ? "faster" : "slower");
  }

  void add_trials() {
    const std::string frozen = find_water_of_trials(summary_, "frozen"),
                      curve = find_water_of_trials(summary_, "curve");
    if (frozen == "held")
      add("The factor at frozen geometry is drained: pore pressures and suctions stay as they were at the start, "
          "whatever "
          "the soil does. Pressures that shearing raises in loose soil, and those of a rapid drawdown, are not in it.");
    else if (frozen == "flows")
      add("The factor at frozen geometry is coupled: water flows in its trials, and shearing changes the pore "
          "pressures.");
    if (curve == "flows")
      add("The criteria on the displacement curve are coupled: in the {:g} s of a trial water flows, and shearing "
          "raises or lowers pore pressures that may have no time to even out.",
          get_si(summary_["input"]["strength_reduction"]["curve"], "window", 0));
    else if (curve == "held")
      add("The criteria on the displacement curve are drained: pore pressures are held.");
    if (!frozen.empty() && !curve.empty() && frozen != curve)
      add("The drained and the coupled factors answer different questions and need not agree.");
  }

  void add_steps() {
    if (const auto scaled = join_parts(parts_, [](const auto& p) { return p.flows && p.mass_scaling > 1; });
        !scaled.empty())
      add("Mass scaling in {} multiplies the inertia of the water too: a water hammer, where water is stopped, grows "
          "with "
          "its root.",
          scaled);
    if (const auto pressed = join_parts(parts_, [](const auto& p) { return p.flows && p.is_frozen_geometry; });
        !pressed.empty())
      add("Geometry is frozen while water flows in {}: pores keep their volume, and the water that straining would "
          "press "
          "out of them stays in them under a higher pressure.",
          pressed);
    if (const auto lowered =
            join_parts(parts_, [](const auto& p) { return p.flows && p.damping > 0 && p.damps_without_drag; });
        !lowered.empty())
      add("The damping of the water without drag in {} acts like a conductivity that is lower by the share of the "
          "damping.",
          lowered);
    const double gravity = read_water(summary_).drag_gravity;
    if (const json* weight = find(summary_, {"input", "gravity"});
        weight != nullptr && std::abs(get_si(*weight, "acceleration", gravity) / gravity - 1) > 1e-3)
      add("Conductivities hold at {:g} m/s² while gravity is {:g} m/s²: water flows in proportion to gravity.", gravity,
          get_si(*weight, "acceleration", gravity));
  }

  void add_surfaces() {
    add("Hydraulic conditions go with the soil: a surface that moves takes the condition of the nearest line, and a "
        "surface "
        "without any is a seepage face. Outer water and its weight act on the sides of the mesh beside the soil, so "
        "that a "
        "surface under water is known to about one element.");
    if (const double undecided = get_number(summary_, {"seepage", "undecided"}); undecided > 0)
      add("In the steady seepage {:.0f} {} a surface did not settle between taking and giving water.", undecided,
          undecided == 1 ? "node of" : "nodes of");
  }

  void add_budget() {
    const double stored = get_number(summary_, {"water", "stored"});
    if (!(stored > 0)) return;
    if (const double error = std::abs(get_number(summary_, {"water", "error"})); error > noticeable)
      add("The water budget does not close: {} of the water is not explained.", show_number(error, 2));
    if (const double between = std::abs(get_number(summary_, {"water", "lost_between"})) / stored; between > noticeable)
      add("Between elements that are integrated differently {} of the water came or went.", show_number(between, 2));
    if (const double gone = get_number(summary_, {"water", "left_grid"}); gone > 0)
      add("{} kg of water left the grid with its soil.", show_number(gone));
  }

  const json& summary_;
  ShownUnits units_;
  std::vector<WaterPart> parts_;
  std::vector<std::string> sentences_;
};

std::string tell_closure(double error) {
  const double size = std::abs(error);
  return size < 1e-12 ? "closes to round-off" : "closes to " + show_number(size, 1) + " of the water in the model";
}

}  // namespace

std::vector<std::string> tell_water(const json& summary) {
  std::vector<std::string> sentences;
  if (!is_wet(summary)) return sentences;
  const ShownUnits units = read_units(summary);
  const std::string per = get_dimension(summary) == 2 ? " m³/s per metre" : " m³/s";
  if (const json* seepage = find(summary, {"seepage"}))
    sentences.push_back(
        fmt::format("In the steady seepage of the start {}{} flow through the ground; the largest suction "
                    "is {}.",
                    show_number(get_number(*seepage, {"outflow"})), per,
                    show(get_number(*seepage, {"largest_suction"}), units.stress)));
  if (const json* water = find(summary, {"water"})) {
    const double suction = get_number(*water, {"largest_suction"}), runoff = get_number(*water, {"runoff"});
    const double density = get_number(*water, {"density"}, 1000);
    std::string text = fmt::format("At the end of the stages the largest pore pressure is {}",
                                   show(get_number(*water, {"largest_pressure"}), units.stress));
    text += suction > 0 ? " and the largest suction " + show(suction, units.stress) : ", and there is no suction";
    if (runoff > 0)
      text += fmt::format("; {} m³{} of rain ran off", show_number(runoff / density),
                          get_dimension(summary) == 2 ? " per metre" : "");
    sentences.push_back(text + "; the water budget " + tell_closure(get_number(*water, {"error"})) + ".");
  }
  return sentences;
}

std::vector<std::string> list_water_assumptions(const json& summary) {
  return is_wet(summary) ? WaterAssumptions(summary).collect() : std::vector<std::string>{};
}

}  // namespace talus::report
