// SPDX-License-Identifier: MIT
#pragma once
// Dates of the calendar, without time zones or summer time: every day has 86,400 s.

#include <optional>
#include <string>

namespace talus {

/// Seconds from the start of 1970 to "2023-07-01", "2023-07-01 06:00" or "2023-07-01T06:00:30"; nothing where the text
/// is no date.
std::optional<double> parse_date(const std::string& text);

/// "2023-07-01", with " 06:00" where it is not midnight, to the nearest minute.
std::string format_date(double seconds);

}  // namespace talus
