#include "input/case/result_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/units.hpp"
#include "input/case/declare_limit_equilibrium.hpp"
#include "input/case/method_names.hpp"
#include "input/checks/checks.hpp"

namespace talus::input {
namespace {

constexpr const char* trial_prefix = "curve.displacement[";
constexpr const char* runout_prefix = "runout[";
constexpr const char* test_prefix = "test[";
constexpr const char* per_cent = "%";

/// The number that stands in `text` between `prefix`, with which it begins, and the first `end`.
std::optional<double> read_number_between(const std::string& text, const std::string& prefix, const std::string& end) {
  const auto close = text.find(end);
  if (!text.starts_with(prefix) || close == std::string::npos) return std::nullopt;
  double number = 0;
  const char *first = text.data() + prefix.size(), *last = text.data() + close;
  const auto [stop, error] = std::from_chars(first, last, number);
  return error == std::errc() && stop == last ? std::optional(number) : std::nullopt;
}

ResultName name_trial(const std::string& name, double factor) {
  return {name, fmt::format("largest displacement at SRF {:g}", factor), "m", ResultKind::other, "displacement"};
}

/// Nothing when the case has no such test, or tests have no such quantity.
std::optional<ResultName> name_point_result(const Case& data, const std::string& name, const PointResultName& result) {
  const auto test =
      std::find_if(data.tests.begin(), data.tests.end(), [&](const PointTest& t) { return t.name == result.test; });
  if (test == data.tests.end()) return std::nullopt;
  if (result.quantity == "peak_q" && !result.strain)
    return ResultName{name, fmt::format("largest deviatoric stress, {}", result.test), "Pa", ResultKind::other,
                      result.quantity};
  for (const PointQuantity& q : list_point_quantities()) {
    if (result.quantity != q.name) continue;
    const std::string at =
        result.strain ? fmt::format(" at {} strain {:g}", test->get_strain_word(), *result.strain) : " at the end";
    return ResultName{name, fmt::format("{}{}, {}", q.title, at, result.test), std::string(q.unit) == "-" ? "" : q.unit,
                      ResultKind::other, result.quantity};
  }
  return std::nullopt;
}

void add_runout(std::vector<ResultName>& names, const Case& data, const std::string& path, const std::string& of) {
  const auto add = [&](const char* key, const char* title, const char* unit) {
    names.push_back({path + "." + key, title + of, unit, ResultKind::runout, key});
  };
  // A plane section is one metre thick.
  add("moved_volume", "moved volume", data.mesh.dimension == 2 ? "m3/m" : "m3");
  add("front_advance", "advance of the front", "m");
  add("toe_distance", "runout beyond the toe", "m");
  add("crest_retreat", "retreat of the crest", "m");
  add("centre_advance", "advance of the centre", "m");
  add("centre_drop", "drop of the centre", "m");
  add("largest_displacement", "largest displacement", "m");
  add("failure_time", "time of failure", "s");
  add("rest_time", "time to rest", "s");
}

void add_factors(std::vector<ResultName>& names, const Case& data) {
  const StrengthReduction& reduction = data.strength_reduction;
  if (reduction.frozen.enabled) {
    names.push_back({"factor_of_safety", "factor of safety", ""});
    names.push_back({"factor_of_safety.frozen", "factor of safety, rest or run-away at frozen geometry", ""});
  }
  if (!reduction.curve.enabled) return;
  names.push_back({"factor_of_safety.bilinear", "factor of safety, bilinear criterion", ""});
  names.push_back({"factor_of_safety.displacement", "factor of safety, displacement criterion", ""});
  names.push_back({"factor_of_safety.jump", "factor of safety, jump criterion", ""});
  for (const double f : reduction.curve.runout)
    add_runout(names, data, fmt::format("runout[{:g}]", f), fmt::format(", runout at SRF {:g}", f));
}

/// Of the monitored points of a run.
void add_motion(std::vector<ResultName>& names, const Case& data) {
  const Stage* from = find_clock_stage(data);
  if (from == nullptr) return;
  for (const Monitor& m : data.output.monitors) {
    names.push_back({fmt::format("onset[{}]", m.name),
                     fmt::format("onset of movement of '{}' after the start of '{}'", m.name, from->name), "s",
                     ResultKind::motion, "onset"});
    names.push_back({fmt::format("displacement[{}]", m.name), fmt::format("displacement of '{}' at the end", m.name),
                     "m", ResultKind::motion, "displacement"});
  }
}

/// Of soil with pore water: what came in and left by condition.
void add_water(std::vector<ResultName>& names, const Case& data) {
  const bool plane = data.mesh.dimension == 2;  // a plane section is one metre thick
  const std::string volume = plane ? "m3/m" : "m3";
  for (const Hydraulic& h : data.hydraulics) {
    if (h.condition == WaterCondition::no_flow) continue;
    names.push_back({fmt::format("water.inflow[{}]", h.on), fmt::format("water that came in through '{}'", h.on),
                     volume, ResultKind::water, "inflow"});
    names.push_back({fmt::format("water.outflow[{}]", h.on), fmt::format("water that left through '{}'", h.on), volume,
                     ResultKind::water, "outflow"});
    if (h.condition == WaterCondition::rain)
      names.push_back({fmt::format("water.runoff[{}]", h.on), fmt::format("rain that ran off '{}'", h.on), volume,
                       ResultKind::water, "runoff"});
  }
  names.push_back({"water.largest_suction", "largest suction at the end", "Pa", ResultKind::water, "largest_suction"});
  names.push_back(
      {"water.largest_pressure", "largest pore pressure at the end", "Pa", ResultKind::water, "largest_pressure"});
  names.push_back({"water.budget_error", "error of the water budget over the water in the model", "", ResultKind::water,
                   "budget_error"});
}

/// Of the steady seepage that soil with pore water starts from.
void add_seepage(std::vector<ResultName>& names, const Case& data) {
  const std::string flow = data.mesh.dimension == 2 ? "m3/s/m" : "m3/s";
  if (data.initial.water.pressure != InitialPressure::seepage) return;
  for (const Hydraulic& h : data.hydraulics) {
    if (h.condition != WaterCondition::no_flow)
      names.push_back({fmt::format("seepage.discharge[{}]", h.on), fmt::format("steady seepage out through '{}'", h.on),
                       flow, ResultKind::seepage, "discharge"});
  }
  names.push_back(
      {"seepage.largest_suction", "largest suction in steady seepage", "Pa", ResultKind::seepage, "largest_suction"});
}

}  // namespace

const Stage* find_clock_stage(const Case& data) {
  const Stage* found = data.stages.empty() ? nullptr : &data.stages.front();
  for (const Stage& stage : data.stages)
    if (data.output.count_from.empty() ? stage.reset_displacement : stage.name == data.output.count_from)
      found = &stage;
  return found;
}

std::vector<ResultName> list_result_names(const Case& data) {
  std::vector<ResultName> names;
  if (uses(data, Method::lem)) add_slice_results(names, data);
  if (uses(data, Method::fem)) add_element_results(names, data);
  if (data.partial_factors.set != DesignApproach::none)
    names.push_back({"partial_factors.over_design", "degree of over-design with partial factors", "",
                     ResultKind::over_design, "over_design"});
  if (!uses(data, Method::mpm)) {
    if (is_wet(data)) add_seepage(names, data);
    return names;
  }
  if (data.analysis == AnalysisKind::strength_reduction) {
    add_factors(names, data);
  } else {
    add_runout(names, data, "runout", "");
    add_motion(names, data);
  }
  for (const Stage& stage : data.stages) {
    names.push_back({fmt::format("stage[{}].displacement", stage.name),
                     fmt::format("largest displacement at the end of '{}'", stage.name), "m", ResultKind::stage,
                     "displacement"});
    names.push_back({fmt::format("stage[{}].time", stage.name),
                     fmt::format("simulated time at the end of '{}'", stage.name), "s", ResultKind::stage, "time"});
  }
  if (is_wet(data)) add_water(names, data);
  if (is_wet(data)) add_seepage(names, data);
  names.push_back(
      {"mesh.critical_time_step", "critical time step of the mesh", "s", ResultKind::mesh, "critical_time_step"});
  names.push_back({"mesh.points", "material points", "", ResultKind::mesh, "points"});
  names.push_back({"mesh.soil_elements", "elements with soil", "", ResultKind::mesh, "soil_elements"});
  return names;
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

std::optional<ResultName> find_result_name(const Case& data, const std::string& name) {
  if (const auto of_test = find_point_result_name(name)) return name_point_result(data, name, *of_test);
  const bool has_curve = data.analysis == AnalysisKind::strength_reduction && data.strength_reduction.curve.enabled;
  if (const auto factor = find_trial_factor(name); factor && has_curve) return name_trial(name, *factor);
  for (const ResultName& known : list_result_names(data))
    if (known.name == name) return known;
  return std::nullopt;
}

std::optional<ResultName> find_possible_name(const Case& data, const std::string& name) {
  Case asked = data;
  asked.methods = {Method::lem, Method::fem, Method::mpm};
  asked.lem.methods.clear();
  for (const auto& choice : choices<SliceMethod>) asked.lem.methods.push_back(choice.value);
  if (asked.lem.search == SurfaceSearch::none) asked.lem.search = SurfaceSearch::entry_exit;
  asked.lem.noncircular = asked.lem.yield_acceleration = true;
  asked.fem.flow = FlowRule::both;
  if (asked.partial_factors.set == DesignApproach::none) asked.partial_factors.set = DesignApproach::by_hand;
  asked.strength_reduction.curve.enabled = asked.strength_reduction.frozen.enabled = true;
  if (const auto factor = read_number_between(name, runout_prefix, "]."))
    asked.strength_reduction.curve.runout = {*factor};
  for (const AnalysisKind kind : {AnalysisKind::strength_reduction, AnalysisKind::run}) {
    asked.analysis = kind;
    if (const auto found = find_result_name(asked, name)) return found;
  }
  return std::nullopt;
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

}  // namespace talus::input
