#pragma once
// The echo of a case: every value that a calculation used, with its unit, and whether it was given or is a default.

#include <nlohmann/json.hpp>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// {"mesh": {"size": {"value": 0.75, "unit": "m", "given": true}, ...}, "stage": [{...}], ...}. Keys that have no
/// meaning in the case (a cohesion of an elastic material) are left out; an optional key without a value is null.
nlohmann::json echo(const Case& data, const Places& places);

}  // namespace talus::input
