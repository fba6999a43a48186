// SPDX-License-Identifier: MIT
#include "base/shown_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/units.hpp"

namespace talus {
namespace {

/// Customary units that accompany a unit of stress.
struct Companions {
  const char *stress, *stiffness, *unit_weight, *unit_weight_title, *line_force;
};

const Companions& find_companions(const std::string& stress) {
  static constexpr std::array all{
      Companions{"kPa", "MPa", "kN/m3", "kN/m³", "kN/m"}, Companions{"Pa", "MPa", "kN/m3", "kN/m³", "N/m"},
      Companions{"MPa", "MPa", "kN/m3", "kN/m³", "MN/m"}, Companions{"psf", "ksf", "pcf", "pcf", "plf"},
      Companions{"psi", "ksf", "pcf", "pcf", "plf"},      Companions{"ksf", "ksf", "pcf", "pcf", "klf"},
      Companions{"tsf", "tsf", "pcf", "pcf", "klf"}};
  const auto found = std::find_if(all.begin(), all.end(), [&](const Companions& c) { return stress == c.stress; });
  return found == all.end() ? all.front() : *found;
}

}  // namespace

ShownUnit ShownUnits::volume(std::size_t dimension) const {
  const double cube = span.si * span.si * span.si;
  if (dimension == 3) return {span.name + "³", cube};
  return {span.name + "³/" + span.name, cube / span.si};
}

ShownUnit ShownUnits::flow(std::size_t dimension) const {
  const ShownUnit whole = volume(dimension);
  return {span.name + "³/s" + whole.name.substr(span.name.size() + std::string("³").size()), whole.si};
}

ShownUnit ShownUnits::rain() const {
  constexpr double hour = 3600;
  return span.name == "ft" ? ShownUnit{"in/h", units::get_si_factor("in") / hour} : ShownUnit{"mm/h", 1e-3 / hour};
}

ShownUnits make_shown_units(const std::string& length, const std::string& displacement, const std::string& stress) {
  const auto read = [](const std::string& name) { return ShownUnit{name, units::get_si_factor(name)}; };
  const Companions& others = find_companions(stress);
  const ShownUnit weight{others.unit_weight_title, units::get_si_factor(others.unit_weight)};
  const bool in_feet = length == "ft" || length == "in";
  return {read(length),
          read(displacement),
          read(stress),
          read(others.stiffness),
          weight,
          read(others.line_force),
          read(in_feet ? "ft" : "m")};
}

std::string format_value(double si, const ShownUnit& unit, int digits) {
  return fmt::format("{:.{}g} {}", si / unit.si, digits, unit.name);
}

std::string format_uncertain(double si, std::optional<double> uncertainty, const ShownUnit& unit) {
  if (uncertainty) *uncertainty /= unit.si;
  return format_uncertain(si / unit.si, uncertainty) + (unit.name.empty() ? "" : " " + unit.name);
}

}  // namespace talus
