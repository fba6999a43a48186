// SPDX-License-Identifier: MIT
#include "base/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace talus {

#ifdef __cpp_lib_to_chars

const char* parse_number(const char* first, const char* last, double& value) {
  const auto [end, failure] = std::from_chars(first, last, value);
  return failure == std::errc{} ? end : nullptr;
}

std::string write_shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

#else  // the C++ library of WebAssembly compilers; its C library knows one locale, with a decimal point

const char* parse_number(const char* first, const char* last, double& value) {
  if (first == last || *first == '+' || *first == ' ' || *first == '\t') return nullptr;
  const std::string text(first, last);
  char* end = nullptr;
  errno = 0;
  const double number = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || errno == ERANGE) return nullptr;
  value = number;
  return first + (end - text.c_str());
}

std::string write_shortest(double value) {
  return fmt::format("{}", value);
}

#endif

double read_number(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  double value = std::numeric_limits<double>::quiet_NaN();
  parse_number(text.data(), text.data() + text.size(), value);
  return value;
}

double round_to_digits(double value, int digits) {
  return std::isfinite(value) ? read_number(format_significant(value, digits)) : value;
}

std::string format_significant(double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

std::string format_coordinate(double x) {
  return fmt::format("{:.15g}", std::round(x * 1e5) / 1e5 + 0.0);
}

std::string format_uncertain(double value, std::optional<double> uncertainty) {
  constexpr double least = 1e-9;
  const auto round_at = [](double x, double last) {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(last) + 1e-9)));
    return fmt::format("{:.{}f}", std::round(x / last) * last + 0.0, decimals);
  };
  const auto find_first = [](double x) { return std::pow(10, std::floor(std::log10(std::abs(x)))); };
  if (!std::isfinite(value) || (uncertainty && !std::isfinite(*uncertainty))) return "–";
  const bool is_zero = std::abs(value) < least, is_exact = uncertainty && *uncertainty < least;
  if (is_zero && (!uncertainty || is_exact)) return "0";
  if (!uncertainty) return round_at(value, 0.1 * find_first(value));
  if (is_exact || *uncertainty < 1e-3 * std::abs(value)) return round_at(value, 0.01 * find_first(value));
  double last = find_first(*uncertainty);
  if (*uncertainty < 1.95 * last) last /= 10;
  return round_at(value, last) + " ± " + round_at(*uncertainty, last);
}

}  // namespace talus
