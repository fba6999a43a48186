// SPDX-License-Identifier: MIT
#include "base/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace talus {
namespace {

std::string join(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) {
    if (!text.empty()) text += '\n';
    text += to_string(d);
  }
  return text;
}

}  // namespace

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : Error(ExitCode::wrong_input, join(diagnostics)), diagnostics_(std::move(diagnostics)) {}

std::string to_string(const Diagnostic& d) {
  if (d.line > 0) return fmt::format("{}:{}:{}: error: {}", d.file, d.line, d.column, d.sentence);
  if (!d.file.empty()) return fmt::format("{}: error: {}", d.file, d.sentence);
  return fmt::format("error: {}", d.sentence);
}

}  // namespace talus
