// SPDX-License-Identifier: MIT
#pragma once
// Which frames and points of the results a report shows: a rule that needs no choice and can be said in one sentence.

#include <cstddef>
#include <string>
#include <vector>

namespace talus::report {

/// How much one sequence may show.
struct Budget {
  std::size_t frames = 48;
  std::size_t points = 20000;
  std::size_t point_frames = 0;  ///< points times frames
};

/// Points times frames in the whole report, by dimension: each takes about 17 bytes in a plane and 34 in space.
constexpr std::size_t find_most_point_frames(std::size_t dimension) {
  return dimension == 2 ? 450000 : 250000;
}

/// Shares of `total` among sequences that need so much: none gets more than it needs, and what one leaves is shared by
/// the others.
std::vector<std::size_t> share_out(const std::vector<std::size_t>& needs, std::size_t total);

/// Indices of at most `most` of `count` frames, evenly spread, the first and the last always among them (most >= 2).
std::vector<std::size_t> choose_frames(std::size_t count, std::size_t most);

/// Every how many-th point is shown: the smallest stride that keeps both limits.
std::size_t choose_stride(std::size_t points, std::size_t frames, const Budget& budget);

/// The rule as it was applied, for the reader.
std::string describe_thinning(std::size_t frames, std::size_t shown_frames, std::size_t points,
                              std::size_t shown_points, std::size_t stride);

}  // namespace talus::report
