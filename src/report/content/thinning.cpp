// SPDX-License-Identifier: MIT
#include "report/content/thinning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace talus::report {

std::vector<std::size_t> choose_frames(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(i);
    return chosen;
  }
  // Rounded to the nearest frame; with fewer places than frames no two fall on the same one.
  const std::size_t gaps = most - 1;
  for (std::size_t k = 0; k < most; ++k) chosen.push_back((k * (count - 1) + gaps / 2) / gaps);
  return chosen;
}

std::vector<std::size_t> share_out(const std::vector<std::size_t>& needs, std::size_t total) {
  std::vector<std::size_t> order(needs.size()), shares(needs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return needs[a] < needs[b]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    shares[order[k]] = std::min(needs[order[k]], total / (order.size() - k));
    total -= shares[order[k]];
  }
  return shares;
}

std::size_t choose_stride(std::size_t points, std::size_t frames, const Budget& budget) {
  const std::size_t most =
      std::max<std::size_t>(1, std::min(budget.points, budget.point_frames / std::max<std::size_t>(1, frames)));
  return std::max<std::size_t>(1, (points + most - 1) / most);
}

std::string describe_thinning(std::size_t frames, std::size_t shown_frames, std::size_t points,
                              std::size_t shown_points, std::size_t stride) {
  const auto count = [](std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  std::string text = frames == shown_frames
                         ? (frames == 1 ? "The one frame" : fmt::format("All {}", count(frames, "frame")))
                         : fmt::format("{} of {} (evenly spread, the first and the last among them)", shown_frames,
                                       count(frames, "frame"));
  text += stride == 1 ? fmt::format(" with all {}", count(points, "point"))
                      : fmt::format(" with {} of {} (those whose number is a multiple of {})", shown_points,
                                    count(points, "point"), stride);
  return text + (frames == shown_frames && stride == 1 ? "." : "; the results file holds the rest.");
}

}  // namespace talus::report
