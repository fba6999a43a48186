// SPDX-License-Identifier: MIT
#include "report/content/calibration.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "input/case/point_test.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// "loess.kappa = 0.02203 (± 0.05 %)".
std::string describe_parameter(const results::CalibratedParameter& p) {
  std::string text = fmt::format("{} = {:.4g}{}{}", p.key.substr(std::string("materials.").size()), p.value,
                                 p.unit.empty() ? "" : " ", p.unit);
  if (p.error && p.value != 0) text += fmt::format(" (± {:.2g} %)", 100 * *p.error / std::abs(p.value));
  return p.limit == results::AtLimit::no ? text : text + " (at its limit)";
}

const char* name_kind(const results::ShownQuantity& quantity) {
  using input::PointQuantityKind;
  const PointQuantityKind kind = input::find_point_quantity_kind(quantity.name);
  return kind == PointQuantityKind::strain ? "strain" : kind == PointQuantityKind::stress ? "stress" : "other";
}

}  // namespace

void add_calibration(const ResultFolder& folder, json& document) {
  const auto found = results::read_file<results::Calibration>(folder.path / "calibration" / "calibration.json");
  if (!found) return;
  json section = results::to_json(*found);
  for (std::size_t i = 0; i < found->curves.size(); ++i) {
    section["curves"][i]["x"]["kind"] = name_kind(found->curves[i].x);
    section["curves"][i]["y"]["kind"] = name_kind(found->curves[i].y);
  }
  document["calibration"] = std::move(section);
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

}  // namespace talus::report
