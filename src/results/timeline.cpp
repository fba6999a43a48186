// SPDX-License-Identifier: MIT
#include "results/timeline.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace talus::results {

std::string say_failure(const Timeline& t) {
  if (!t.least) return "No slip surface was admissible at any time.";
  const std::string least = fmt::format("{:.3f} at {}", *t.least, units::say_time(*t.least_time));
  if (t.failure)
    return fmt::format("The factor of safety falls below {:g} between {} and {} ({:.4f} and {:.4f}); it is least, {}.",
                       t.target, units::say_time(t.failure->from), units::say_time(t.failure->to),
                       t.failure->factor_from, t.failure->factor_to, least);
  if (t.fails_from_start)
    return fmt::format("The factor of safety is below {:g} from the start; it is least, {}.", t.target, least);
  return fmt::format("The factor of safety stays at or above {:g} at all {} times that were tried; it is least, {}.",
                     t.target, t.factors.size(), least);
}

}  // namespace talus::results
