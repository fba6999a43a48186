// SPDX-License-Identifier: MIT
#include "laboratory/calibration_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::laboratory {
namespace {

using results::AtLimit;

constexpr double strong_correlation = 0.95;
constexpr double share_of_direction = 0.2;  ///< smaller components of a direction are not named
constexpr double alike = 0.01;              ///< of the misfit: searches that end nearer together found the same
constexpr double apart = 0.01;              ///< of the range of a parameter

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

void add_limits(const input::Calibration& calibration, const results::Calibration& result,
                std::vector<std::string>& list) {
  for (std::size_t i = 0; i < result.parameters.size(); ++i)
    if (const results::CalibratedParameter& p = result.parameters[i]; p.limit != AtLimit::no)
      list.push_back(fmt::format(
          "'{}' ended at its {} value, {:.5g}{}{}: the curves require {}. Widen the range, or check the model. It has "
          "no standard error; those of the others treat it as known.",
          p.key, p.limit == AtLimit::low ? "smallest" : "largest", p.value / calibration.parameters[i].factor,
          p.unit.empty() ? "" : " ", p.unit, p.limit == AtLimit::low ? "less" : "more"));
}

void add_unfixed(const results::Calibration& result, const std::vector<std::vector<double>>& unfixed,
                 std::vector<std::string>& list) {
  for (const std::vector<double>& direction : unfixed) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < direction.size(); ++i)
      if (std::abs(direction[i]) > share_of_direction) names.push_back("'" + result.parameters[i].key + "'");
    list.push_back(
        names.size() == 1
            ? fmt::format("The curves do not depend on {}: its value is that of the start. Leave it out, or "
                          "add a test that depends on it; there are no standard errors.",
                          names[0])
            : fmt::format(
                  "The curves determine only a combination of {}. Fix one of them, or add a test that separates them; "
                  "there are no standard errors.",
                  join(names)));
  }
}

void add_correlations(const results::Calibration& result, std::vector<std::string>& list) {
  for (std::size_t i = 0; i < result.parameters.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const auto c = result.correlation[i][j]; c && std::abs(*c) > strong_correlation)
        list.push_back(
            fmt::format("These curves hardly separate '{}' and '{}' (correlation {:.3f}): a {} of one compensates for "
                        "a {} of the other.",
                        result.parameters[j].key, result.parameters[i].key, *c, "larger value",
                        *c > 0 ? "larger value" : "smaller value"));
}

/// Searches that came nearly as far with other values.
void add_rivals(const results::Calibration& result, std::vector<std::string>& list) {
  const results::CalibrationSearch& best = result.starts[result.best];
  std::size_t rivals = 0, agree = 0;
  for (const results::CalibrationSearch& start : result.starts) {
    // A misfit of nothing but rounding is the same as another.
    const double slack = std::max(alike * best.misfit, 1e-6 * static_cast<double>(result.values));
    if (start.misfit > best.misfit + slack) continue;
    double distance = 0;
    for (std::size_t i = 0; i < result.parameters.size(); ++i) {
      const results::CalibratedParameter& p = result.parameters[i];
      distance = std::max(distance, std::abs(start.to[i] - best.to[i]) / (p.high - p.low));
    }
    ++(distance > apart ? rivals : agree);
  }
  if (rivals > 0)
    list.push_back(fmt::format("{} of {} searches reached the same misfit with other values: the fit is not unique.",
                               rivals, result.starts.size()));
  if (result.starts.size() > 2 && agree == 1 && rivals == 0)
    list.push_back("Only one search reached this misfit, so a better fit may exist. Use more 'starts'.");
}

}  // namespace

std::vector<std::string> list_findings(const input::Calibration& calibration, const results::Calibration& result,
                                       const std::vector<std::vector<double>>& unfixed, double freedom) {
  std::vector<std::string> list;
  if (!result.starts[result.best].converged)
    list.push_back(fmt::format("The best search did not converge: {} Raise 'iterations', or begin nearer.",
                               result.starts[result.best].message));
  add_limits(calibration, result, list);
  add_unfixed(result, unfixed, list);
  add_correlations(result, list);
  for (const results::CalibratedCurve& c : result.curves)
    if (c.missing > 1e-6)
      list.push_back(
          fmt::format("The test '{}' does not reach all abscissae of its {} curve: {:.3g} % of them are missing "
                      "on average; each such point counts as missed by 100 standard errors and more.",
                      c.test, c.y.name, 100 * c.missing));
  add_rivals(result, list);
  if (freedom <= 0)
    list.push_back(
        "There are no more measured values than parameters: the fit is exact for any errors, so no standard errors can "
        "be given.");
  if (static_cast<int>(result.starts.size()) < calibration.starts)
    list.push_back(fmt::format("Only {} of {} searches could begin: the case refuses most values within the limits.",
                               result.starts.size(), calibration.starts));
  return list;
}

}  // namespace talus::laboratory
