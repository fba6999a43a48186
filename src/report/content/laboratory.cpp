// SPDX-License-Identifier: MIT
#include "report/content/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/user_file.hpp"
#include "input/case/point_test.hpp"
#include "output/files/history.hpp"
#include "report/content/sequence.hpp"
#include "report/folder/numbers.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Returns a text such as "loess.kappa = 0.02203 (± 0.05 %)".
std::string describe_parameter(const results::CalibratedParameter& p) {
  std::string text = fmt::format("{} = {:.4g}{}{}", p.key.substr(std::string("materials.").size()), p.value,
                                 p.unit.empty() ? "" : " ", p.unit);
  if (p.error && p.value != 0) text += fmt::format(" (± {:.2g} %)", 100 * *p.error / std::abs(p.value));
  return p.limit == results::AtLimit::no ? text : text + " (at its limit)";
}

}  // namespace

void add_calibration(const ResultFolder& folder, json& document) {
  const auto& found = folder.calibration;
  if (!found) return;
  json warnings = found->findings;
  for (const json& warning : document["warnings"]) warnings.push_back(warning);
  document["warnings"] = std::move(warnings);
  std::string list;
  for (const results::CalibratedParameter& p : found->parameters)
    list += (list.empty() ? "" : "; ") + describe_parameter(p);
  json sentences = json::array(
      {fmt::format("Fitted to {} measured values: {}. In brackets: standard errors.", found->values, list)});
  for (const json& sentence : document["answer"]["sentences"]) sentences.push_back(sentence);
  document["answer"]["sentences"] = std::move(sentences);
  document["assumptions"].push_back(
      "Fitted parameters are those with the least sum of squares of the differences to the measured values, in parts "
      "of their stated errors. Standard errors come from the slopes of the curves there: they hold for small errors "
      "that are independent of each other, and do not include the error of the soil model.");
}

using nlohmann::json;

namespace {

constexpr std::size_t most_test_rows = 251;

/// Rounds to six digits, which exceed the resolution of a chart, to reduce the size of the report.
double round_off(double value) {
  if (value == 0 || !std::isfinite(value)) return 0;
  const double power = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * power) / power;
}

/// Returns the columns that the diagrams need, with fewer rows; strains in per cent.
json read_columns(const std::filesystem::path& table, const std::set<std::string>& wanted,
                  const std::vector<std::size_t>& turns) {
  const output::HistoryTable curve = output::read_history(table);
  const std::size_t rows = curve.values.empty() ? 0 : curve.values.front().size();
  std::set<std::size_t> shown;
  for (const std::size_t i : choose_frames(rows, most_test_rows)) shown.insert(i);
  for (const std::size_t turn : turns)
    if (turn < rows) shown.insert(turn);
  json columns = json::array();
  for (const input::PointQuantity& quantity : input::list_point_quantities()) {
    if (!wanted.contains(quantity.name)) continue;
    const bool is_strain = quantity.kind == input::PointQuantityKind::strain;
    for (std::size_t c = 0; c < curve.columns.size(); ++c) {
      if (curve.columns[c].name != quantity.name) continue;
      json values = json::array();
      for (const std::size_t i : shown) values.push_back(round_off(curve.values[c][i] * (is_strain ? 100 : 1)));
      columns.push_back({{"name", quantity.name},
                         {"title", std::string(quantity.title) + (*quantity.symbol ? " " : "") + quantity.symbol},
                         {"unit", is_strain ? "%" : curve.columns[c].unit},
                         {"values", values}});
    }
  }
  return columns;
}

}  // namespace

json read_point_columns(const ResultFolder& folder) {
  const std::vector<results::PointTest>& list = folder.tests->tests;
  std::vector<std::set<std::string>> wanted(list.size());
  for (const results::PointGroup& group : folder.tests->groups)
    for (const std::size_t test : group.tests)
      for (const results::PointPanel& panel : group.panels) wanted.at(test).insert({panel.x, panel.y});
  json columns = json::array();
  for (std::size_t i = 0; i < list.size(); ++i)
    columns.push_back(read_columns(join_name(folder.path / "point", list[i].file), wanted[i], list[i].turns));
  return columns;
}

std::vector<std::string> format_point_tests(const ResultFolder& folder) {
  const std::vector<results::PointTest>& list = folder.tests->tests;
  std::vector<std::string> kinds;
  for (const results::PointTest& test : list)
    if (std::find(kinds.begin(), kinds.end(), test.kind) == kinds.end()) kinds.push_back(test.kind);
  std::vector<std::string> sentences;
  sentences.push_back(fmt::format("{} element {} of one point of soil each: {}.", list.size(),
                                  list.size() == 1 ? "test" : "tests", join_words(kinds)));
  const ShownUnit stress = read_units(folder.run).stress;
  double low = INFINITY, high = 0;
  for (const results::PointTest& test : list) {
    const double q = std::abs(keep_finite(test.peak_q));
    if (q > 0) low = std::min(low, q);  // q is zero in isotropic tests
    high = std::max(high, q);
  }
  if (high > 0)
    sentences.push_back(low == high ? fmt::format("The largest deviatoric stress is {}.", show(low, stress, 4))
                                    : fmt::format("The largest deviatoric stress lies between {} and {}.",
                                                  show(low, stress, 4), show(high, stress, 4)));
  const std::vector<results::Comparison>& comparisons = folder.tests->comparisons;
  if (!comparisons.empty()) {
    const auto passed =
        std::count_if(comparisons.begin(), comparisons.end(), [](const results::Comparison& c) { return c.passes; });
    sentences.push_back(
        fmt::format("{} of {} compared values are met within their tolerances.", passed, comparisons.size()));
  }
  return sentences;
}

std::vector<std::string> list_point_assumptions() {
  return {
      "Each test is one point of soil: stress and strain are the same in the whole specimen, which has neither "
      "friction at its ends nor a shear band.",
      "Strains are sums of increments of the current length (logarithmic strains), as in the calculation of slopes; at "
      "25 % of axial strain a specimen is 22 % shorter.",
      "Drained tests are so slow that no excess pore pressure arises. In undrained tests the water is incompressible "
      "beside the skeleton, so that the volume is constant."};
}

}  // namespace talus::report
