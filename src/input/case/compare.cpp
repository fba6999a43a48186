// SPDX-License-Identifier: MIT
#include "input/case/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "input/case/checks.hpp"
#include "input/case/limit_equilibrium.hpp"
#include "input/case/result_names.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Compare& c) {
  v.key(
      "name", c.name, plain().required().example(R"("factor_of_safety")"),
      "The result: `factor_of_safety`, `factor_of_safety.bilinear` (or another criterion), `curve.displacement[1.45]` "
      "(of the trial at that factor), `runout[1.75].moved_volume`, `stage[gravity].displacement`, "
      "`mesh.critical_time_step` and so on; `results` in `summary.json` lists all. Of element tests "
      "`test[NAME].q[0.1]` (at axial strain 0.1), `test[NAME].void_ratio` (at the end), `test[NAME].peak_q`. Of LEM "
      "`lem.spencer` (critical circle), `lem.noncircular.spencer`, `lem.surface[NAME].bishop`, "
      "`lem.yield_acceleration.spencer`; of FEM `fem.factor`, `fem.by_displacement`, "
      "`fem.associated.factor`; of one on the surface of another `lem.handed[fem.band].spencer`.");
  v.key("value", c.value, plain().required().example("1.4"),
        "The published or measured value: a number in SI units, or a text with a unit.");
  v.key("tolerance", c.tolerance, plain().at_least(0).required().example(R"("5 %")"),
        "Largest difference that passes: in per cent of the value, or an amount; a plain number is in the unit of the "
        "value.");
  v.key("source", c.source, plain().required().example(R"("Bishop, hand calculation")"), "Where the value comes from.");
}

namespace {

constexpr const char* per_cent = "%";

/// A plain number is in SI units; a unit must be of the result's dimension.
bool fits(const Amount& amount, const std::string& unit) {
  if (amount.unit.empty()) return true;
  if (unit.empty()) return units::get_dimension_name(amount.unit) == units::get_dimension_name("");
  try {
    units::parse_as_si("1 " + amount.unit, unit, "value");
    return true;
  } catch (const Error&) {
    return false;
  }
}

void check_amount(const Amount& amount, const results::NamedValue& result, const std::string& path, const char* key,
                  Findings& findings) {
  if (!findings.is_sound(path) || fits(amount, result.unit)) return;
  findings.add(path, "'{}' is \"{}\"; '{}' is {}{}", key, amount.text, result.name,
               units::get_dimension_name(result.unit), result.unit.empty() ? "" : " such as \"1 " + result.unit + "\"");
}

}  // namespace

std::string suggest_result(const Case& data, const std::string& name) {
  std::vector<std::string> names;
  for (const results::NamedValue& known : list_result_names(data)) names.push_back(known.name);
  for (const PointTest& test : data.tests)
    for (const PointQuantity& q : list_point_quantities())
      names.push_back(fmt::format("test[{}].{}", test.name, q.name));
  const std::string near = find_nearest(name, names);
  if (!near.empty()) return fmt::format("did you mean '{}'?", near);
  if (uses(data, Method::mpm) && data.analysis == AnalysisKind::strength_reduction &&
      data.strength_reduction.curve.enabled)
    names.emplace_back("curve.displacement[SRF]");
  return fmt::format("it yields {}", fmt::join(names, ", "));
}

double to_si(const Amount& amount) {
  return amount.number * units::get_si_factor(amount.unit);
}

bool is_relative(const Amount& tolerance) {
  return tolerance.unit == per_cent;
}

double find_tolerance(const Compare& compare) {
  Amount tolerance = compare.tolerance;
  if (is_relative(tolerance)) return tolerance.number / 100 * std::abs(to_si(compare.value));
  if (tolerance.unit.empty()) tolerance.unit = compare.value.unit;
  return to_si(tolerance);
}

void check_compare(const Case& data, Findings& findings) {
  if (!findings.is_sound("analysis") || !findings.is_sound("stage") || !findings.is_sound("test")) return;
  for (std::size_t i = 0; i < data.compare.size(); ++i) {
    const Compare& compare = data.compare[i];
    const std::string path = fmt::format("compare.{}", i);
    if (!findings.is_sound(path + ".name")) continue;
    const std::optional<results::NamedValue> result = find_possible_name(data, compare.name);
    if (!result) {
      findings.add(path + ".name", "the case yields no result '{}'; {}", compare.name,
                   suggest_result(data, compare.name));
      continue;
    }
    check_amount(compare.value, *result, path + ".value", "value", findings);
    if (!is_relative(compare.tolerance))
      check_amount(compare.tolerance, *result, path + ".tolerance", "tolerance", findings);
  }
}

using results::NamedValue;
using results::ResultKind;

namespace {

constexpr const char* trial_prefix = "curve.displacement[";
constexpr const char* runout_prefix = "runout[";
constexpr const char* test_prefix = "test[";

/// Returns the number in `text` between `prefix`, with which it begins, and the first `end`.
std::optional<double> read_number_between(const std::string& text, const std::string& prefix, const std::string& end) {
  const auto close = text.find(end);
  if (!text.starts_with(prefix) || close == std::string::npos) return std::nullopt;
  double number = 0;
  const char *first = text.data() + prefix.size(), *last = text.data() + close;
  return parse_number(first, last, number) == last ? std::optional(number) : std::nullopt;
}

NamedValue name_trial(const std::string& name, double factor) {
  return {name, fmt::format("largest displacement at SRF {:g}", factor), "m", ResultKind::other, "displacement", {}};
}

/// Returns std::nullopt if the case has no such test, or tests have no such quantity.
std::optional<NamedValue> name_point_result(const Case& data, const std::string& name, const PointResultName& result) {
  const auto test =
      std::find_if(data.tests.begin(), data.tests.end(), [&](const PointTest& t) { return t.name == result.test; });
  if (test == data.tests.end()) return std::nullopt;
  if (result.quantity == "peak_q" && !result.strain)
    return NamedValue{
        name, fmt::format("largest deviatoric stress, {}", result.test), "Pa", ResultKind::other, result.quantity, {}};
  for (const PointQuantity& q : list_point_quantities()) {
    if (result.quantity != q.name) continue;
    const std::string at =
        result.strain ? fmt::format(" at {} strain {:g}", test->get_strain_word(), *result.strain) : " at the end";
    return NamedValue{name,
                      fmt::format("{}{}, {}", q.title, at, result.test),
                      std::string(q.unit) == "-" ? "" : q.unit,
                      ResultKind::other,
                      result.quantity,
                      {}};
  }
  return std::nullopt;
}

/// Returns the results that LEM always yields, with placeholders as values.
results::SliceResult outline_slices(const LimitEquilibrium& lem) {
  results::SliceResult slices;
  const auto add = [&](std::vector<results::CriticalSurface>& list, SliceMethod method) -> results::CriticalSurface& {
    results::CriticalSurface& c = list.emplace_back();
    c.surface.method = method;
    c.surface.factor = 1;
    if (lem.yield_acceleration && !lem.drawdown) c.yield_acceleration = 1;
    if (lem.drawdown) {
      c.drawdown.emplace().factor_before = 1;
      if (lem.drawdown->method == DrawdownMethod::three_stage) c.drawdown->undrained_factor = 1;
    }
    return c;
  };
  for (const SliceMethod m : lem.methods) {
    if (lem.search != SurfaceSearch::none) {
      add(slices.critical, m);
      if (lem.noncircular && suits_polylines(m)) add(slices.noncircular, m);
    }
  }
  for (const SlipSurface& surface : lem.surfaces)
    for (const SliceMethod m : lem.methods) add(slices.given, m).surface.name = surface.name;
  if (lem.referee) {
    results::Referee& referee = slices.referee.emplace();
    referee.lower = referee.upper = 1;
  }
  return slices;
}

/// Returns the slip surfaces of the other methods and their factors by LEM, with placeholders as values.
results::MethodComparison outline_methods(const Case& data) {
  results::MethodComparison methods;
  for (const auto& [method, line] :
       {std::pair{Method::fem, results::band_name}, std::pair{Method::fem, results::associated_band_name},
        std::pair{Method::bounds, results::mechanism_name}, std::pair{Method::mpm, results::slip_line_name}}) {
    if (!uses(data, Method::lem) || !uses(data, method)) continue;
    if (line == results::band_name && data.fem.flow == FlowRule::associated) continue;
    if (line == results::associated_band_name && data.fem.flow == FlowRule::as_given) continue;
    methods.surfaces.emplace_back().name = line;
    methods.surfaces.back().method = method;
    for (const SliceMethod m : list_polyline_methods(data.lem)) methods.handed.push_back({line, to_word(m), "", 1, ""});
    methods.handed.push_back({line, "spencer_optimised", "Spencer, optimised from another method's surface", 1, ""});
  }
  if (data.partial_factors.set != DesignApproach::none) methods.partial_factors.emplace().over_design = 1;
  return methods;
}

results::ElementResult outline_elements(FlowRule asked) {
  results::ElementResult elements;
  for (const auto& [other, flow] : {std::pair{FlowRule::associated, results::Flow::as_given},
                                    std::pair{FlowRule::as_given, results::Flow::associated}}) {
    if (asked == other) continue;
    elements.runs.emplace_back().flow = flow;
    elements.runs.back().by_displacement = 1;
  }
  return elements;
}

/// Returns the results for soil that moves to both sides.
std::vector<results::RunoutSide> outline_sides() {
  std::vector<results::RunoutSide> sides(2);
  sides[0].direction = -1;
  return sides;
}

void outline_reduction(const StrengthReduction& reduction, results::RunResult& run) {
  results::PointFactors& factors = run.factor_of_safety.emplace();
  if (reduction.frozen.enabled) {
    factors.value = 1;
    factors.frozen.emplace().factor = 1;
  }
  if (!reduction.curve.enabled) return;
  factors.criteria.emplace();
  using enum results::CriterionKind;
  for (const results::CriterionKind kind : {bilinear, displacement, jump})
    factors.criteria->push_back({kind, 1, {}, {}, ""});
  run.runouts.emplace();
  for (const double factor : reduction.curve.runout) {
    results::RunoutTrial& trial = run.runouts->emplace_back();
    trial.trial.factor = factor;
    trial.trial.end = results::StageEnd::rest;
    trial.runout.sides = outline_sides();
    trial.failure_time = 1;
  }
}

results::Motion outline_motion(const Case& data) {
  results::Motion motion;
  const Stage* from = find_clock_stage(data);
  if (from == nullptr) return motion;
  motion.stage = from->name;
  for (const Monitor& m : data.output.monitors) motion.monitors.push_back({m.name, 1, 1});
  return motion;
}

/// Returns the names of the sides with a water budget: those of [[hydraulic]], and moving supports.
std::vector<std::string> list_water_sides(const Case& data) {
  std::vector<std::string> sides;
  for (const Hydraulic& h : data.hydraulics) sides.push_back(h.on);
  for (const Boundary& b : data.boundaries)
    if (b.fix == Fix::velocity) sides.push_back(b.on);
  return sides;
}

results::WaterBudget outline_water(const Case& data) {
  results::WaterBudget water;
  for (const std::string& side : list_water_sides(data)) {
    water.surfaces.emplace_back().name = side;
    for (const Hydraulic& h : data.hydraulics)
      if (h.on == side && h.condition == WaterCondition::rain)
        water.surfaces.back().condition = results::SurfaceCondition::rain;
  }
  return water;
}

void outline_points(const Case& data, results::RunResult& run) {
  run.mesh.emplace();
  run.stages.emplace();
  for (const Stage& stage : data.stages) {
    run.stages->emplace_back().name = stage.name;
    run.stages->back().end = results::StageEnd::rest;
  }
  if (is_wet(data)) run.water = outline_water(data);
  if (data.analysis == AnalysisKind::strength_reduction) return outline_reduction(data.strength_reduction, run);
  run.runout.emplace().sides = outline_sides();
  run.failure_time = 1;
  run.motion = outline_motion(data);
}

results::Timeline outline_timeline(const Case& data) {
  const Timeline& asked = *data.timeline;
  results::Timeline timeline;
  if (uses(data, Method::fem)) timeline.elements.emplace_back().runs = outline_elements(data.fem.flow).runs;
  timeline.least = timeline.least_time = 1;
  timeline.failure.emplace().to = 1;
  timeline.chosen = asked.times.empty();
  const auto add = [&](double time) {
    timeline.factors.emplace_back().time = time;
    timeline.factors.back().factor = 1;
  };
  add(0);
  for (const double time : asked.times) add(time);
  return timeline;
}

results::Construction outline_construction(const Case& data) {
  results::Construction construction;
  construction.least = 1;
  for (const ConstructionStage& asked : data.construction) {
    results::ConstructionStage& stage = construction.stages.emplace_back();
    stage.name = asked.name;
    stage.converged = true;
    stage.steps.emplace_back().least_excess = 0;
    if (asked.factor)
      for (const Method method : data.methods)
        if (method != Method::mpm)
          for (const std::optional<bool> undrained : {std::optional<bool>{}, {true}})
            stage.factors.push_back({method, "", 1, {}, {}, {}, undrained});
    if (asked.release) stage.release.emplace();
  }
  for (const Monitor& asked : data.output.monitors) {
    results::ConstructionMonitor& monitor = construction.monitors.emplace_back();
    monitor.name = asked.name;
    for (const auto& [table, curve] :
         {std::pair{&asked.settlement, &monitor.measured_settlement},
          std::pair{&asked.lateral, &monitor.measured_lateral}, std::pair{&asked.pressure, &monitor.measured_pressure}})
      if (!table->time.empty()) *curve = results::MeasuredCurve{{}, {}, 1};
  }
  return construction;
}

results::FlowResult outline_flow(const Case& data) {
  results::FlowResult flow;
  results::FlowState& state = flow.states.emplace_back();
  for (const FlowSection& section : data.seepage.sections) state.sections.push_back({section.name, 1});
  for (const std::string& side : list_water_sides(data)) state.exits.push_back({side, 1, {}, 1, 1, false});
  state.uplift.emplace().factor = 1;
  for (const HeaveBlock& block : data.seepage.blocks) state.heaves.push_back({block.name, 1, 1, 1});
  return flow;
}

/// Returns a run with a placeholder for each number that a run of `data` may yield, which defines the result names.
results::RunResult outline_results(const Case& data) {
  results::RunResult run;
  if (!data.construction.empty()) {
    run.construction = outline_construction(data);
    return run;
  }
  if (uses(data, Method::lem)) run.slices = outline_slices(data.lem);
  if (uses(data, Method::fem)) run.elements = outline_elements(data.fem.flow);
  if (uses(data, Method::bounds)) {
    results::BoundsResult& bounds = run.bounds.emplace();
    bounds.lower = bounds.upper = 1;
  }
  if (data.timeline) run.timeline = outline_timeline(data);
  if (uses(data, Method::seepage)) run.flow = outline_flow(data);
  run.methods = outline_methods(data);
  if (uses(data, Method::mpm)) outline_points(data, run);
  if (is_wet(data) && data.initial.water.pressure == InitialPressure::seepage) {
    results::Seepage& seepage = run.seepage.emplace();
    for (const std::string& side : list_water_sides(data)) seepage.discharges.emplace_back().name = side;
  }
  return run;
}

}  // namespace

const Stage* find_clock_stage(const Case& data) {
  const Stage* found = data.stages.empty() ? nullptr : &data.stages.front();
  for (const Stage& stage : data.stages)
    if (data.output.count_from.empty() ? stage.reset_displacement : stage.name == data.output.count_from)
      found = &stage;
  return found;
}

std::vector<results::NamedValue> list_result_names(const Case& data) {
  return results::list_values(outline_results(data), data.mesh.dimension);
}

std::optional<double> find_trial_factor(const std::string& name) {
  return name.ends_with("]") ? read_number_between(name, trial_prefix, "]") : std::nullopt;
}

std::optional<PointResultName> find_point_result_name(const std::string& name) {
  const auto close = name.find("].");
  if (!name.starts_with(test_prefix) || close == std::string::npos) return std::nullopt;
  const std::size_t first = std::string(test_prefix).size();
  PointResultName result{name.substr(first, close - first), name.substr(close + 2), std::nullopt};
  const auto open = result.quantity.find('[');
  if (open == std::string::npos) return result;
  if (!result.quantity.ends_with("]")) return std::nullopt;
  result.strain = read_number_between(result.quantity, result.quantity.substr(0, open + 1), "]");
  if (!result.strain) return std::nullopt;
  result.quantity.resize(open);
  return result;
}

std::optional<NamedValue> find_result_name(const Case& data, const std::string& name) {
  if (const auto of_test = find_point_result_name(name)) return name_point_result(data, name, *of_test);
  const bool has_curve = data.analysis == AnalysisKind::strength_reduction && data.strength_reduction.curve.enabled;
  if (const auto factor = find_trial_factor(name); factor && has_curve) return name_trial(name, *factor);
  for (const NamedValue& known : list_result_names(data))
    if (results::is_same_result(known.name, name)) return known;
  return std::nullopt;
}

std::optional<NamedValue> find_possible_name(const Case& data, const std::string& name) {
  Case asked = data;
  asked.methods = {Method::lem, Method::fem, Method::bounds, Method::mpm, Method::seepage};
  asked.lem.methods.clear();
  for (const auto& choice : choices<SliceMethod>) asked.lem.methods.push_back(choice.value);
  if (asked.lem.search == SurfaceSearch::none) asked.lem.search = SurfaceSearch::entry_exit;
  asked.lem.noncircular = asked.lem.yield_acceleration = true;
  if (name.starts_with("lem.drawdown.")) asked.lem.drawdown.emplace();
  asked.fem.flow = FlowRule::both;
  if (asked.partial_factors.set == DesignApproach::none) asked.partial_factors.set = DesignApproach::by_hand;
  asked.strength_reduction.curve.enabled = asked.strength_reduction.frozen.enabled = true;
  if (const auto factor = read_number_between(name, runout_prefix, "]."))
    asked.strength_reduction.curve.runout = {*factor};
  for (const AnalysisKind kind : {AnalysisKind::strength_reduction, AnalysisKind::run}) {
    asked.analysis = kind;
    if (auto found = find_result_name(asked, name)) return found;
  }
  return std::nullopt;
}

}  // namespace talus::input
