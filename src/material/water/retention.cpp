// SPDX-License-Identifier: MIT
// Validation of the parameters of retention curves.
#include "material/water/retention.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace talus::material {

namespace {

using Fault = std::optional<std::string>;

Fault find_own_fault(const ConstantSaturation&) {
  return {};
}
Fault find_own_fault(const VanGenuchten& c) {
  if (!(c.reference > 0))
    return fmt::format("The reference pressure of van Genuchten's curve must be above 0, not {:g} Pa.", c.reference);
  if (!(c.lambda > 0 && c.lambda < 1))
    return fmt::format("λ of van Genuchten's curve must lie between 0 and 1, not at {:g}.", c.lambda);
  return {};
}
Fault find_own_fault(const LinearRetention& c) {
  if (!(c.slope >= 0 && std::isfinite(c.slope)))
    return fmt::format("The slope of a linear retention curve must be 0 or above, not {:g} 1/Pa.", c.slope);
  return {};
}
Fault find_own_fault(const ExponentialRetention& c) {
  if (!(c.alpha > 0 && std::isfinite(c.alpha)))
    return fmt::format("α of an exponential retention curve must be above 0, not {:g} 1/Pa.", c.alpha);
  return {};
}
Fault find_own_fault(const TableRetention& c) {
  if (c.table.size < 2) return "A retention table needs at least 2 pairs of suction and saturation.";
  return {};
}

}  // namespace

std::optional<std::string> find_fault(const Retention& retention) {
  return std::visit(
      [](const auto& c) -> Fault {
        if (!(c.minimum >= 0 && c.minimum <= c.maximum && c.maximum > 0 && c.maximum <= 1))
          return fmt::format(
              "The limits of saturation must obey 0 <= minimum <= maximum <= 1 with a maximum above 0, but are {:g} "
              "and {:g}.",
              c.minimum, c.maximum);
        return find_own_fault(c);
      },
      retention);
}

TableRetention make_retention_table(const std::vector<std::array<double, 2>>& pairs, Interpolation interpolation) {
  TableRetention r;
  r.table = make_table(pairs, interpolation, "The retention table");
  r.maximum = pairs.front()[1];
  r.minimum = pairs.back()[1];
  if (r.minimum > r.maximum) fail_input("The retention table must fall with suction, but rises.");
  if (pairs.front()[0] < 0)
    fail_input("The retention table must start at a suction of 0 or above, not at {:g} Pa.", pairs.front()[0]);
  if (const auto fault = find_fault(r)) fail_input(*fault);
  return r;
}

}  // namespace talus::material
