#include "report/content/calibration.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// "loess.kappa = 0.02203 (± 0.05 %)".
std::string describe_parameter(const json& p) {
  const std::string unit = get_text(p, {"unit"});
  const double value = get_number(p, {"value"});
  std::string text = fmt::format("{} = {:.4g}{}{}", get_text(p, {"key"}).substr(std::string("materials.").size()),
                                 value, unit.empty() ? "" : " ", unit);
  const json& error = p.at("error");
  if (!error.is_null() && value != 0) text += fmt::format(" (± {:.2g} %)", 100 * error.get<double>() / std::abs(value));
  return get_text(p, {"limit"}) == "no" ? text : text + " (at its limit)";
}

}  // namespace

void add_calibration(const ResultFolder& folder, json& document) {
  const json found = read_json(folder.path / "calibration" / "calibration.json");
  if (!found.is_object()) return;
  json section;
  for (const char* key : {"parameters", "correlation", "starts", "best", "values", "scatter", "evaluations", "tests"})
    section[key] = found.at(key);
  section["curves"] = found.at("curves");
  for (json& parameter : section["parameters"]) parameter.erase("text");
  document["calibration"] = std::move(section);
  json warnings = found.at("findings");
  for (const json& warning : document["warnings"]) warnings.push_back(warning);
  document["warnings"] = std::move(warnings);
  std::string list;
  for (const json& p : found.at("parameters")) list += (list.empty() ? "" : "; ") + describe_parameter(p);
  json sentences = json::array({fmt::format("Fitted to {} measured values: {}. In brackets: standard errors.",
                                            found.at("values").get<long>(), list)});
  for (const json& sentence : document["answer"]["sentences"]) sentences.push_back(sentence);
  document["answer"]["sentences"] = std::move(sentences);
  document["assumptions"].push_back(
      "Fitted parameters are those with the least sum of squares of the differences to the measured values, in parts "
      "of their stated errors. Standard errors come from the slopes of the curves there: they hold for small errors "
      "that are independent of each other, and say nothing of what the soil model itself lacks.");
}

}  // namespace talus::report
