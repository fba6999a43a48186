#pragma once
// The rows of one soil in the table of materials: values as given, divided by the stage's strength factor, and at
// failure.

#include <nlohmann/json.hpp>
#include <optional>

#include "input/case/water.hpp"
#include "report/look_up.hpp"

namespace talus::report {

/// The kind of a material of the echo, bare or rooted.
bool is_mohr_coulomb(const nlohmann::json& soil);
bool is_cam_clay(const nlohmann::json& soil);
/// n and e₀ of a material of the echo, whichever of them the case gives [-].
std::optional<double> find_porosity(const nlohmann::json& soil);
std::optional<double> find_void_ratio(const nlohmann::json& soil);

/// M of a critical state whose tan φ is divided by a factor [-].
double reduce_slope(double slope, double factor);

/// Rows of one material (`properties` of MaterialRow in web/src/contract/).
class Properties {
 public:
  /// `design`, `failure`: what the strength is divided by in the last stage, and at failure.
  Properties(const ShownUnit& stress, std::optional<double> design, std::optional<double> failure)
      : stress_(stress), design_(design), failure_(failure) {}

  void add(const std::string& key, const std::string& title, const std::string& symbol, const ShownUnit& unit,
           std::optional<double> value, std::optional<double> design = {}, std::optional<double> at_failure = {});
  void add_mohr_coulomb(const nlohmann::json& soil);
  void add_cam_clay(const nlohmann::json& soil);
  /// What roots are worth in this soil, with those of [[roots]] of the whole case.
  void add_roots(const nlohmann::json& summary, const nlohmann::json& soil);
  /// What a UMAT is given. Its constants have no names and no units that anybody but the UMAT knows.
  void add_external(const nlohmann::json& soil);
  /// With all pores that fill full of water, and as light as the driest soil of the model.
  void add_wet_weights(const nlohmann::json& summary, const input::PoreWater& soil, double density, double porosity,
                       double gravity);

  nlohmann::json rows = nlohmann::json::array();

 private:
  void add_slope(const std::string& key, const std::string& title, const std::string& symbol, double slope);
  void add_cohesion(const std::string& key, const std::string& title, std::optional<double> cohesion);

  ShownUnit stress_;
  std::optional<double> design_, failure_;
};

}  // namespace talus::report
