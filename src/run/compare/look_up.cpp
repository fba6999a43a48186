#include "run/compare/look_up.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace talus::run {

using nlohmann::json;

const json& get(const json& object, const char* key) {
  static const json nothing;
  return object.is_object() && object.contains(key) ? object.at(key) : nothing;
}

const json& list(const json& object, const char* key) {
  static const json empty = json::array();
  const json& found = get(object, key);
  return found.is_array() ? found : empty;
}

std::optional<double> get_number(const json& object, const char* key) {
  const json& found = get(object, key);
  return found.is_number() ? std::optional(found.get<double>()) : std::nullopt;
}

const json& find_critical(const json& summary, const char* kind, const std::string& method) {
  static const json nothing;
  for (const json& c : list(get(summary, "lem"), kind))
    if (c.at("method") == method) return c;
  return nothing;
}

std::optional<double> find_slices(const json& summary, const char* kind, const std::string& method) {
  return get_number(find_critical(summary, kind, method), "factor");
}

std::string describe_flow(const json& run) {
  if (run.at("flow") == "associated") return "ψ = φ";
  const double low = run.at("psi").at(0), high = run.at("psi").at(1), degrees = 180 / std::numbers::pi;
  return std::abs(high - low) < 1e-9 ? fmt::format("ψ = {:.3g}°", low * degrees) : "ψ as given";
}

double find_seconds(const json& summary, const char* method) {
  return get_number(get(summary, method), "seconds").value_or(0);
}

}  // namespace talus::run
