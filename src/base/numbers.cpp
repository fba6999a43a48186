// SPDX-License-Identifier: MIT
#include "base/numbers.hpp"

#include <cerrno>
#include <charconv>
#include <cstdlib>

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

}  // namespace talus
