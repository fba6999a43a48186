// SPDX-License-Identifier: MIT
#pragma once
// When a slope failed: read off the history of its largest displacement.

#include <filesystem>
#include <optional>

namespace talus::run {

/// The time [s] at which the largest displacement in `history` (a history.csv) reached `displacement` [m] for the last
/// time, by linear interpolation between rows: displacements may be set to zero between stages, and what happened
/// before does not count. Nothing when it ended below, was never below, or there is no such file.
std::optional<double> find_failure_time(const std::filesystem::path& history, double displacement);

}  // namespace talus::run
