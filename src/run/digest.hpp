// SPDX-License-Identifier: MIT
#pragma once
// Summary of a run in a few lines, for the terminal.

#include <string>

#include "results/run.hpp"

namespace talus::run {

std::string write_digest(const results::RunResult& run);

}  // namespace talus::run
