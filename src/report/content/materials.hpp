// SPDX-License-Identifier: MIT
#pragma once
// The soils of a case with their values: as given, divided by the stage's strength factor, and at failure.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/report.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

// The rows of one soil in the table of materials: values as given, divided by the stage's strength factor, and at
// failure.

/// n [-]; nothing where a unit weight stands for grains and pores.
std::optional<double> find_porosity(const input::Material& soil);

/// Rows of one material (`properties` of MaterialRow in web/src/contract/).
class Properties {
 public:
  /// `design`, `failure`: what the strength is divided by in the last stage, and at failure.
  Properties(ShownUnits units, std::optional<double> design, std::optional<double> failure)
      : units_(std::move(units)), design_(design), failure_(failure) {}

  void add(const std::string& key, const std::string& title, const std::string& symbol, const ShownUnit& unit,
           std::optional<double> value, std::optional<double> design = {}, std::optional<double> at_failure = {});
  void add(const material::Properties& list);
  /// The effect of roots in this soil; `blocks`: of the whole case.
  void add_roots(const std::vector<input::Roots>& blocks, const input::Material& soil);
  /// With all fillable pores full of water, and as light as the driest soil of the model.
  void add_wet_weights(const ResultFolder& folder, const input::Material& soil);

  nlohmann::json list() const;

 private:
  /// Values in the unit shown.
  struct Row {
    std::string key, title, symbol, unit;
    std::optional<double> characteristic, design, at_failure;
  };

  ShownUnit find_unit(material::ShownAs shown_as) const;

  ShownUnits units_;
  std::optional<double> design_, failure_;
  std::vector<Row> rows_;
};

/// MaterialRow of web/src/contract/. `factor_of_safety`: what the strength is divided by "at failure".
nlohmann::json list_materials(const ResultFolder& folder, std::optional<double> factor_of_safety);

// Sentences about [[roots]] and rooted soils.

/// The assumptions on rooted soils; nothing for a case without.
std::vector<std::string> list_root_assumptions(const ResultFolder& folder);

}  // namespace talus::report
