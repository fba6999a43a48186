#pragma once
// Which methods a case asks for: slices, finite elements, material points.

#include <nlohmann/json.hpp>
#include <string>

namespace talus::report {

/// `method` is "lem", "fem" or "mpm". A summary that names none is one of material points.
bool asks_for(const nlohmann::json& summary, const std::string& method);

}  // namespace talus::report
