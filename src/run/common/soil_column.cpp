// SPDX-License-Identifier: MIT
#include "run/common/soil_column.hpp"

#include <algorithm>
#include <cmath>

#include "lem/section/strips.hpp"
#include "run/common/section_of_case.hpp"

namespace talus::run {

SoilColumns::SoilColumns(const site::Site& site) {
  const auto& regions = site.data().regions;
  const bool needs = std::any_of(regions.begin(), regions.end(), [&](const auto& entry) {
    return material::needs<material::StrengthProfile>(site.get_soil(entry.first).model) &&
           material::find_local_model(site.get_soil(entry.first).model, site.get_soil(entry.first));
  });
  if (needs && site.has_ground()) slope_ = std::make_shared<const lem::Slope>(make_section(site).section);
}

StrengthPlane SoilColumns::find(const Vec<2>& x) const {
  if (!slope_) return {.at = x};
  const lem::Slope::Strips& strips = slope_->strips();
  const lem::Strip& strip = strips.strip(strips.find(x[0]));
  const double dx = x[0] - strip.left, ground = strip.ground.at(dx);
  int soil = -1;
  const double weight = slope_->weight_above(x[0], x[1], soil),
               water = strip.ponded ? std::max(0.0, strip.water.at(dx) - ground) : 0,
               above = weight + (strips.loads ? strip.load.at(dx) - strip.variable_load.at(dx) : 0) +
                       strips.section.water_unit_weight * water;
  const lem::Point p{x[0], x[1]};
  const double u = soil < 0 ? slope_->pore_pressure(p)
                            : slope_->pore_pressure(p, strips.section.soils[static_cast<std::size_t>(soil)], weight);
  StrengthPlane plane;
  plane.at = {x[0], x[1]};
  plane.depth = std::max(0.0, ground - x[1]);
  plane.vertical = std::max(0.0, above - std::max(0.0, u));
  return plane;
}

std::vector<double> SoilColumns::list_breaks() const {
  std::vector<double> breaks;
  if (!slope_) return breaks;
  for (const lem::Strip& strip : slope_->strips().strips) breaks.push_back(strip.left);
  return breaks;
}

std::vector<mesh::Polyline> SoilColumns::list_water_lines() const {
  std::vector<mesh::Polyline> lines;
  if (!slope_) return lines;
  for (const lem::Strip& strip : slope_->strips().strips) {
    const auto add = [&, width = strip.right - strip.left](const lem::StripLine& line) {
      if (std::isfinite(line.y)) lines.push_back({{strip.left, line.y}, {strip.right, line.at(width)}});
    };
    add(strip.water);
    for (const lem::StripLine& line : strip.piezometric) add(line);
  }
  return lines;
}

}  // namespace talus::run
