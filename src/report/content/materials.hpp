// SPDX-License-Identifier: MIT
#pragma once
// Soil parameters in a report: characteristic values, values divided by the strength factor of the last stage, and
// values at failure; and the assumptions on roots.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/folder/numbers.hpp"
#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns the porosity [-]; nullopt if a given unit weight replaces density and porosity.
std::optional<double> find_porosity(const input::Material& soil);

/// Rows of one material (`properties` of MaterialRow in web/src/contract/).
class Properties {
 public:
  /// `design` and `failure` are the strength reduction factors of the last stage and at failure.
  Properties(ShownUnits units, std::optional<double> design, std::optional<double> failure)
      : units_(std::move(units)), design_(design), failure_(failure) {}

  void add(const std::string& key, const std::string& title, const std::string& symbol, const ShownUnit& unit,
           std::optional<double> value, std::optional<double> design = {}, std::optional<double> at_failure = {});
  void add(const material::Properties& list);
  /// Adds the effect of roots on this soil; `blocks` are those of the whole case.
  void add_roots(const std::vector<input::Roots>& blocks, const input::Material& soil);
  /// Adds the unit weight at full saturation and, if it differs, at the largest suction of the model.
  void add_wet_weights(const ResultFolder& folder, const input::Material& soil);

  nlohmann::json list() const;

 private:
  /// One row; values are in the unit of display.
  struct Row {
    std::string key, title, symbol, unit;
    std::optional<double> characteristic, design, at_failure;
  };

  ShownUnit find_unit(material::ShownAs shown_as) const;

  ShownUnits units_;
  std::optional<double> design_, failure_;
  std::vector<Row> rows_;
};

/// Returns `MaterialRow[]` of web/src/contract/. The strength "at failure" is divided by `factor_of_safety`.
nlohmann::json list_materials(const ResultFolder& folder, std::optional<double> factor_of_safety);

/// Returns the assumptions on [[roots]] and rooted soils; empty for a case without.
std::vector<std::string> list_root_assumptions(const ResultFolder& folder);

}  // namespace talus::report
