#pragma once
// The displacement curve of a run (`Curve` in web/src/contract/).

#include <nlohmann/json.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// The curve of a finished run's summary; null when it has none.
nlohmann::json make_curve(const nlohmann::json& summary);

/// The same from what finished trials left in the folder, when the summary has none.
nlohmann::json make_curve(const ResultFolder& folder);

}  // namespace talus::report
