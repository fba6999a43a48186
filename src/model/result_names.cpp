#include "model/result_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/units.hpp"

namespace talus::model {
namespace {

constexpr const char* trial_prefix = "curve.displacement[";
constexpr const char* per_cent = "%";

ResultName name_trial(const std::string& name, double factor) {
  return {name, fmt::format("largest displacement at SRF {:g}", factor), "m"};
}

void add_runout(std::vector<ResultName>& names, const Case& data, const std::string& path, const std::string& of) {
  const auto add = [&](const char* key, const char* title, const char* unit) {
    names.push_back({path + "." + key, title + of, unit});
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

}  // namespace

std::vector<ResultName> list_result_names(const Case& data) {
  std::vector<ResultName> names;
  if (data.analysis == AnalysisKind::strength_reduction)
    add_factors(names, data);
  else
    add_runout(names, data, "runout", "");
  for (const Stage& stage : data.stages) {
    names.push_back({fmt::format("stage[{}].displacement", stage.name),
                     fmt::format("largest displacement at the end of '{}'", stage.name), "m"});
    names.push_back(
        {fmt::format("stage[{}].time", stage.name), fmt::format("simulated time at the end of '{}'", stage.name), "s"});
  }
  names.push_back({"mesh.critical_time_step", "critical time step of the mesh", "s"});
  names.push_back({"mesh.points", "material points", ""});
  names.push_back({"mesh.soil_elements", "elements with soil", ""});
  return names;
}

std::optional<double> find_trial_factor(const std::string& name) {
  const std::string prefix = trial_prefix;
  if (!name.starts_with(prefix) || !name.ends_with("]")) return std::nullopt;
  double factor = 0;
  const char *first = name.data() + prefix.size(), *last = name.data() + name.size() - 1;
  const auto [end, error] = std::from_chars(first, last, factor);
  return error == std::errc() && end == last ? std::optional(factor) : std::nullopt;
}

std::optional<ResultName> find_result_name(const Case& data, const std::string& name) {
  const bool has_curve = data.analysis == AnalysisKind::strength_reduction && data.strength_reduction.curve.enabled;
  if (const auto factor = find_trial_factor(name); factor && has_curve) return name_trial(name, *factor);
  for (const ResultName& known : list_result_names(data))
    if (known.name == name) return known;
  return std::nullopt;
}

double to_si(const Amount& amount) {
  return amount.number * units::get_si_factor(amount.unit);
}

double find_tolerance(const Compare& compare) {
  if (compare.tolerance.unit == per_cent) return compare.tolerance.number / 100 * std::abs(to_si(compare.value));
  return to_si(compare.tolerance);
}

}  // namespace talus::model
