// SPDX-License-Identifier: MIT
#include "base/dates.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <regex>

namespace talus {

std::optional<double> parse_date(const std::string& text) {
  static const std::regex form(R"((\d{4})-(\d{2})-(\d{2})(?:[T ](\d{2}):(\d{2})(?::(\d{2})(?:\.0*)?)?Z?)?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) return std::nullopt;
  const auto get = [&](int i) {
    return parts[static_cast<std::size_t>(i)].matched ? std::stoi(parts[static_cast<std::size_t>(i)]) : 0;
  };
  const std::chrono::year_month_day day{std::chrono::year(get(1)), std::chrono::month(static_cast<unsigned>(get(2))),
                                        std::chrono::day(static_cast<unsigned>(get(3)))};
  const int hour = get(4), minute = get(5), second = get(6);
  if (!day.ok() || hour > 24 || minute > 59 || second > 59) return std::nullopt;
  const auto days = std::chrono::sys_days(day).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + second;
}

std::string format_date(double seconds) {
  const auto minutes = static_cast<long long>(std::llround(seconds / 60));
  const long long days = minutes >= 0 ? minutes / 1440 : -((1439 - minutes) / 1440);
  const int rest = static_cast<int>(minutes - 1440 * days);
  const std::chrono::year_month_day day{std::chrono::sys_days(std::chrono::days(days))};
  std::string text = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                                 static_cast<unsigned>(day.day()));
  if (rest != 0) text += fmt::format(" {:02}:{:02}", rest / 60, rest % 60);
  return text;
}

}  // namespace talus
