// SPDX-License-Identifier: MIT
#include "input/case/support_warnings.hpp"

#include <utility>
#include <vector>

#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/case/support.hpp"
#include "input/case/support_places.hpp"

namespace talus::input {

namespace {

/// Warns of bars that cross: in the section they share a place, which bars side by side may do.
void warn_of_crossings(const Case& data, Findings& findings) {
  std::vector<std::pair<const std::string*, BarLine>> bars;
  for (const auto& [name, support] : data.supports)
    for (const BarLine& bar : lay_bars(data, name).bars) bars.emplace_back(&name, bar);
  for (std::size_t i = 0; i < bars.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [name, bar] = bars[i];
      const auto& [other_name, other] = bars[j];
      const auto is_beam = [](SupportKind kind) { return kind == SupportKind::pile || kind == SupportKind::wall; };
      if (is_beam(data.supports.at(*name).kind) || is_beam(data.supports.at(*other_name).kind)) continue;
      if (!do_cross(bar, other)) continue;
      return findings.warn(
          "support." + *name,
          "the bar of support '{}' in row {} crosses that of '{}' in row {} in the section. Both count "
          "with their full resistance, as bars that stand side by side along the slope",
          *name, bar.row, *other_name, other.row);
    }
}

}  // namespace

void warn_of_supports(const Case& data, Findings& findings) {
  if (findings.is_sound("support") && findings.is_sound("geometry") && data.mesh.dimension == 2 &&
      !data.mesh.polygons.empty())
    warn_of_crossings(data, findings);
}

}  // namespace talus::input
