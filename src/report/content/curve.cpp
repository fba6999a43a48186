#include "report/content/curve.hpp"

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

json make_point(const json& trial) {
  return {{"srf", get_number(trial, {"srf"})},
          {"displacement", get_number(trial, {"displacement"})},
          {"end", get_text(trial, {"end"}, "time")},
          {"force_ratio", get_number(trial, {"force_ratio"})},
          {"nodal_speed", get_number(trial, {"nodal_speed"})}};
}

json make_branch(const json& branch) {
  return {{"slope", get_number(branch, {"slope"})},
          {"intercept", get_number(branch, {"intercept"})},
          {"factors", find_list(branch, {"points"})}};
}

}  // namespace

json make_curve(const json& summary) {
  const json* curve = find(summary, {"curve"});
  if (curve == nullptr) return {};
  json points = json::array(), criteria = json::array();
  for (const json& p : find_list(*curve, {"points"})) points.push_back(make_point(p));
  for (const json& c : find_list(*curve, {"criteria"})) {
    const auto number = [&](const char* key) {
      const auto value = find_number(c, {key});
      return value ? json(*value) : json();
    };
    criteria.push_back({{"name", get_text(c, {"name"})},
                        {"factor", number("factor")},
                        {"lower", number("lower")},
                        {"upper", number("upper")},
                        {"note", get_text(c, {"note"})}});
  }
  json result{{"points", points}, {"criteria", criteria}};
  if (const json* bilinear = find(*curve, {"bilinear"})) {
    const auto factor = find_number(*bilinear, {"factor"});
    result["bilinear"] = {{"first", make_branch(bilinear->at("first"))},
                          {"last", make_branch(bilinear->at("second"))},
                          {"factor", factor ? json(*factor) : json()}};
  }
  return result;
}

json make_curve(const ResultFolder& folder) {
  json curve = make_curve(folder.summary);
  if (!curve.is_null()) return curve;
  json points = json::array();
  for (const TrialFolder& trial : folder.trials)
    if (!trial.result.is_null()) points.push_back(make_point(trial.result));
  if (points.empty()) return {};
  return {{"points", points}, {"criteria", json::array()}};
}

}  // namespace talus::report
