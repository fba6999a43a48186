// SPDX-License-Identifier: MIT
#pragma once
// A method beside others: what it cannot do becomes a part of the results.

#include <optional>
#include <string>

#include "base/error.hpp"
#include "run/options.hpp"

namespace talus::run {

/// Runs `part`. Returns the sentence of the Error that it throws, where the case has other methods as well. Throws it
/// on where it was an interruption, or the method is `alone`.
template <class Part>
std::optional<std::string> attempt(const RunOptions& options, bool alone, Part part) {
  try {
    part();
  } catch (const Error& error) {
    if (options.progress) options.progress->clear();
    if (alone || error.code() == ExitCode::interrupted) throw;
    return error.what();
  }
  return std::nullopt;
}

}  // namespace talus::run
