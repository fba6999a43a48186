#include "report/content/point_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "input/case/point_test.hpp"
#include "output/files/history.hpp"
#include "report/content/thinning.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

constexpr std::size_t most_rows = 251;

/// Six digits are more than a chart shows, and a report is to be small.
double round_off(double value) {
  if (value == 0 || !std::isfinite(value)) return 0;
  const double power = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * power) / power;
}

bool is_strain(const std::string& name) {
  return name.ends_with("strain");
}

/// The columns that the diagrams show, thinned; strains in per cent.
json read_columns(const std::filesystem::path& table, const std::set<std::string>& wanted, const json& turns) {
  const output::HistoryTable curve = output::read_history(table);
  const std::size_t rows = curve.values.empty() ? 0 : curve.values.front().size();
  std::set<std::size_t> shown;
  for (const std::size_t i : choose_frames(rows, most_rows)) shown.insert(i);
  for (const json& turn : turns)
    if (turn.get<std::size_t>() < rows) shown.insert(turn.get<std::size_t>());
  json columns = json::array();
  for (const input::PointQuantity& quantity : input::list_point_quantities()) {
    if (!wanted.contains(quantity.name)) continue;
    for (std::size_t c = 0; c < curve.columns.size(); ++c) {
      if (curve.columns[c].name != quantity.name) continue;
      json values = json::array();
      for (const std::size_t i : shown)
        values.push_back(round_off(curve.values[c][i] * (is_strain(quantity.name) ? 100 : 1)));
      columns.push_back({{"name", quantity.name},
                         {"title", std::string(quantity.title) + (*quantity.symbol ? " " : "") + quantity.symbol},
                         {"unit", is_strain(quantity.name) ? "%" : curve.columns[c].unit},
                         {"values", values}});
    }
  }
  return columns;
}

}  // namespace

json make_point_tests(const ResultFolder& folder) {
  if (!folder.point.is_object()) return {};
  const json &list = find_list(folder.point, {"tests"}), &groups = find_list(folder.point, {"groups"});
  std::vector<std::set<std::string>> wanted(list.size());
  for (const json& group : groups)
    for (const json& test : find_list(group, {"tests"}))
      for (const json& panel : find_list(group, {"panels"}))
        wanted.at(test.get<std::size_t>()).insert({get_text(panel, {"x"}), get_text(panel, {"y"})});
  json tests = json::array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const json& test = list[i];
    json entry;
    for (const char* key : {"name", "material", "kind", "path", "set", "stopped"}) entry[key] = get_text(test, {key});
    for (const char* key : {"peak_q", "peak_q_strain"}) entry[key] = get_number(test, {key});
    for (const char* key : {"q", "p", "volumetric_strain", "void_ratio", "preconsolidation"})
      entry["end"][key] = get_number(test, {"end", key});
    entry["columns"] =
        read_columns(folder.path / "point" / get_text(test, {"file"}), wanted[i], find_list(test, {"turns"}));
    tests.push_back(std::move(entry));
  }
  json shown = json::array();
  for (const json& group : groups) {
    json entry;
    for (const char* key : {"id", "title", "panels", "tests", "colour", "dash"}) entry[key] = group.at(key);
    shown.push_back(std::move(entry));
  }
  return {{"tests", tests}, {"groups", shown}};
}

json make_point_answer(const ResultFolder& folder) {
  const json& list = find_list(folder.point, {"tests"});
  std::vector<std::string> kinds;
  for (const json& test : list)
    if (const std::string kind = get_text(test, {"kind"}); std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      kinds.push_back(kind);
  json sentences = json::array();
  sentences.push_back(fmt::format("{} element {} of one point of soil each: {}.", list.size(),
                                  list.size() == 1 ? "test" : "tests", join_words(kinds)));
  const ShownUnit stress = read_units(folder.summary).stress;
  double low = INFINITY, high = 0;
  for (const json& test : list) {
    const double q = std::abs(get_number(test, {"peak_q"}));
    if (q > 0) low = std::min(low, q);  // isotropic tests have none
    high = std::max(high, q);
  }
  if (high > 0)
    sentences.push_back(low == high ? fmt::format("The largest deviatoric stress is {}.", show(low, stress, 4))
                                    : fmt::format("The largest deviatoric stress lies between {} and {}.",
                                                  show(low, stress, 4), show(high, stress, 4)));
  const json& comparisons = find_list(folder.point, {"comparisons"});
  if (!comparisons.empty()) {
    const auto passed =
        std::count_if(comparisons.begin(), comparisons.end(), [](const json& c) { return c.value("passes", false); });
    sentences.push_back(
        fmt::format("{} of {} compared values are met within their tolerances.", passed, comparisons.size()));
  }
  return {{"sentences", sentences}, {"factors", json::array()}, {"results", json::array()}};
}

json list_point_assumptions() {
  return {
      "Each test is one point of soil: stress and strain are the same in the whole specimen, which has neither "
      "friction at its ends nor a shear band.",
      "Strains are sums of increments of the current length (logarithmic strains), as in the calculation of slopes; at "
      "25 % of axial strain a specimen is 22 % shorter.",
      "Drained tests are so slow that no excess pore pressure arises. In undrained tests the water is incompressible "
      "beside the skeleton, so that the volume is constant."};
}

}  // namespace talus::report
