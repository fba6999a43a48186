// SPDX-License-Identifier: MIT
#include "report/content/curve.hpp"

#include <nlohmann/json.hpp>

#include "report/words/numbers.hpp"
#include "results/bounds.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

json make_point(const results::Trial& trial) {
  return {{"srf", trial.factor},
          {"displacement", keep_finite(trial.displacement)},
          {"end", results::to_word(trial.end)},
          {"force_ratio", keep_finite(trial.force_ratio)},
          {"nodal_speed", keep_finite(trial.speed)}};
}

json make_branch(const results::Branch& branch) {
  return {{"slope", branch.slope}, {"intercept", branch.intercept}, {"factors", branch.factors}};
}

/// As they are shown: the ends of an interval outward, as in the answer and in its table.
std::vector<results::Criterion> list_criteria(std::vector<results::Criterion> criteria) {
  for (results::Criterion& c : criteria) {
    if (c.kind != results::CriterionKind::frozen) continue;
    if (c.lower) c.lower = results::show_lower(*c.lower);
    if (c.upper) c.upper = results::show_upper(*c.upper);
  }
  return criteria;
}

}  // namespace

json make_curve(const ResultFolder& folder) {
  const auto& curve = folder.run.curve;
  json points = json::array();
  if (curve)
    for (const results::Trial& trial : curve->points) points.push_back(make_point(trial));
  else
    for (const TrialFolder& trial : folder.trials)
      if (trial.result) points.push_back(make_point(*trial.result));
  if (!curve && points.empty()) return {};
  json result{
      {"points", points},
      {"criteria", results::to_json(list_criteria(curve ? curve->criteria : std::vector<results::Criterion>{}))}};
  if (curve && curve->bilinear)
    result["bilinear"] = {{"first", make_branch(curve->bilinear->first)},
                          {"last", make_branch(curve->bilinear->second)},
                          {"factor", curve->bilinear->factor}};
  return result;
}

}  // namespace talus::report
