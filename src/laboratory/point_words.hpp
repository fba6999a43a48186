#pragma once
// Element tests in words, for reports.

#include <string>

#include "input/case/point_test.hpp"

namespace talus::laboratory {

/// "drained triaxial compression", "oedometer".
std::string name_kind(const input::PointTest& test);

/// "from 100 kPa radial and 100 kPa axial stress to an axial strain of 25 %".
std::string describe_path(const input::PointTest& test);

/// "root_content = 0.44"; empty when the test sets nothing.
std::string describe_settings(const input::PointTest& test);

}  // namespace talus::laboratory
