#pragma once
// The sections of a case and what its monitors did, as the report shows them.

#include <filesystem>
#include <nlohmann/json.hpp>

namespace talus::report {

/// `Section[]` of web/src/contract/ from sections/*.csv in `folder`, at the times that are shown; empty when there
/// are none. A table that cannot be read adds a warning.
nlohmann::json make_sections(const std::filesystem::path& folder, const nlohmann::json& summary,
                             nlohmann::json& warnings);

/// `Motion` from that of summary.json.
nlohmann::json take_motion(const nlohmann::json& motion);

/// `MonitorPaths`: the displacement of the monitors from the start of the clock on; null when there are none.
nlohmann::json make_paths(const std::filesystem::path& folder, const nlohmann::json& summary, nlohmann::json& warnings);

}  // namespace talus::report
