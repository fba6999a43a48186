// SPDX-License-Identifier: MIT
// Validation of the parameters of conductivity laws.
#include "material/water/conductivity.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace talus::material {

namespace {

using Fault = std::optional<std::string>;

Fault find_own_fault(const ConstantConductivity&) {
  return {};
}
Fault find_own_fault(const Mualem& c) {
  if (!(c.lambda > 0 && c.lambda < 1))
    return fmt::format("λ of Mualem's conductivity must lie between 0 and 1, not at {:g}.", c.lambda);
  return {};
}
Fault find_own_fault(const Hillel& c) {
  if (!(c.exponent >= 0 && std::isfinite(c.exponent)))
    return fmt::format("The exponent of Hillel's conductivity must be 0 or above, not {:g}.", c.exponent);
  return {};
}
Fault find_own_fault(const ExponentialConductivity& c) {
  if (!(c.alpha >= 0 && std::isfinite(c.alpha)))
    return fmt::format("α of an exponential conductivity must be 0 or above, not {:g} 1/Pa.", c.alpha);
  return {};
}
Fault find_own_fault(const TableConductivity& c) {
  if (c.table.size < 2) return "A conductivity table needs at least 2 pairs of suction and relative conductivity.";
  return {};
}

}  // namespace

std::optional<std::string> find_fault(const Conductivity& law) {
  return std::visit([](const auto& l) { return find_own_fault(l); }, law);
}

TableConductivity make_conductivity_table(const std::vector<std::array<double, 2>>& pairs, Interpolation interpolation,
                                          bool logarithmic) {
  TableConductivity r;
  r.logarithmic = logarithmic;
  std::vector<std::array<double, 2>> points = pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i][1] > 0 && points[i][1] <= 1))
      fail_input("The conductivity table needs relative conductivities above 0 and up to 1, not {:g}.", points[i][1]);
    if (i > 0 && pairs[i][1] > pairs[i - 1][1]) fail_input("The conductivity table must fall with suction, but rises.");
    if (logarithmic) points[i][1] = std::log(points[i][1]);
  }
  r.table = make_table(points, interpolation, "The conductivity table");
  return r;
}

}  // namespace talus::material
