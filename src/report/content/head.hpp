#pragma once
// The title block, where the numbers come from, and what they cost.

#include <filesystem>
#include <nlohmann/json.hpp>

namespace talus::report {

/// Project, Provenance and Timing of web/src/contract/.
nlohmann::json make_project(const nlohmann::json& summary);
nlohmann::json make_provenance(const nlohmann::json& summary, const std::filesystem::path& folder);
nlohmann::json make_timing(const nlohmann::json& summary);

}  // namespace talus::report
