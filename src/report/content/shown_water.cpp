// SPDX-License-Identifier: MIT
#include "report/content/shown_water.hpp"

#include <algorithm>
#include <limits>

namespace talus::report {

void show_water(output::Frame& frame) {
  const auto find = [&](const char* name) {
    const auto found = std::find_if(frame.point_fields.begin(), frame.point_fields.end(),
                                    [&](const output::Field& f) { return f.name == name; });
    return found == frame.point_fields.end() ? nullptr : &*found;
  };
  output::Field *water = find("water_velocity"), *pressure = find("pore_pressure"), *saturation = find("saturation");
  const output::Field *velocity = find("velocity"), *porosity = find("porosity");
  if (!water || !pressure || !saturation || !velocity || !porosity) return;
  const auto n = static_cast<std::size_t>(water->components);
  for (std::size_t i = 0; i < water->values.size(); ++i)
    water->values[i] = porosity->values[i / n] * saturation->values[i / n] * (water->values[i] - velocity->values[i]);
  water->name = "darcy_velocity";
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < saturation->values.size(); ++i) {
    if (saturation->values[i] > 0) continue;
    saturation->values[i] = pressure->values[i] = none;
    std::fill_n(water->values.begin() + static_cast<std::ptrdiff_t>(i * n), n, none);
  }
}

}  // namespace talus::report
