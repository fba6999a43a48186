#pragma once
// Element tests in words, for reports.

#include <string>

#include "model/point_test.hpp"

namespace talus::laboratory {

/// "drained triaxial compression", "oedometer".
std::string name_kind(const model::PointTest& test);

/// "from 100 kPa radial and 100 kPa axial stress to an axial strain of 25 %".
std::string describe_path(const model::PointTest& test);

/// "root_content = 0.44"; empty when the test sets nothing.
std::string describe_settings(const model::PointTest& test);

}  // namespace talus::laboratory
