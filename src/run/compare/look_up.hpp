#pragma once
// Reading what the methods have written into a summary. Internal to methods/.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace talus::run {

/// The member, or null.
const nlohmann::json& get(const nlohmann::json& object, const char* key);
/// The member as a list; empty where there is none.
const nlohmann::json& list(const nlohmann::json& object, const char* key);
std::optional<double> get_number(const nlohmann::json& object, const char* key);

/// Factor of the critical circle or polyline ("critical", "noncircular") of a method of slices.
std::optional<double> find_slices(const nlohmann::json& summary, const char* kind, const std::string& method);
/// The critical surface itself; null where there is none.
const nlohmann::json& find_critical(const nlohmann::json& summary, const char* kind, const std::string& method);

/// "ψ = φ", "ψ = 0°", "ψ as given" of a run of the finite elements.
std::string describe_flow(const nlohmann::json& run);

/// Seconds of "lem" or "fem"; 0 where it did not run.
double find_seconds(const nlohmann::json& summary, const char* method);

}  // namespace talus::run
