// SPDX-License-Identifier: MIT
#include "report/content/strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/numbers.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

constexpr int samples = 40;
/// Range of a diagram where the section does not give one: a ready mesh [Pa].
constexpr double usual_stress = 2e5;
constexpr double usual_weight = 2e4;  ///< [N/m³]

struct Extent {
  double low = 0, high = 0;  ///< elevations [m]
};

Extent find_extent(const input::Case& data) {
  Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const mesh::Polygon& polygon : data.mesh.polygons)
    for (const auto& x : polygon.points)
      extent.low = std::min(extent.low, x[1]), extent.high = std::max(extent.high, x[1]);
  return extent.high > extent.low ? extent : Extent{};
}

}  // namespace

json sample_strength(const input::Case& data, const input::Material& soil) {
  const auto strength = material::find_slice_strength(soil.model, soil);
  if (!strength) return {};
  const Extent extent = find_extent(data);
  const double height = extent.high - extent.low,
               weight = soil.slices.unit_weight.value_or(soil.density() > 0 ? soil.density() * data.gravity.acceleration
                                                                            : usual_weight),
               most = height > 0 ? 0.5 * weight * height : usual_stress;
  const double digits = std::pow(10, std::floor(std::log10(most))), end = std::ceil(most / digits) * digits;
  json normal = json::array(), lines = json::array();
  for (int i = 0; i <= samples; ++i) normal.push_back(end * i / samples);
  const auto add_strength = [&](const std::string& name, const material::SliceStrength& own, StrengthPlane plane) {
    json shear = json::array();
    for (int i = 0; i <= samples; ++i) {
      plane.normal = plane.vertical = end * i / samples;
      const StrengthTangent t =
          own.law
              ? own.law->find_tangent(plane)
              : StrengthTangent{own.cohesion + own.cohesion_gradient * std::max(0.0, own.cohesion_level - plane.at[1]),
                                std::tan(own.friction_angle)};
      shear.push_back(round_to_digits(t.cohesion + plane.normal * t.tan_friction, 6));
    }
    lines.push_back({{"name", name}, {"shear", std::move(shear)}});
  };
  const auto add = [&](const std::string& name, const StrengthPlane& plane) { add_strength(name, *strength, plane); };
  const auto add_direction = [&](const std::string& name, double angle) {
    add(name, {{0, extent.high}, 0, 0, angle, angle, 0});
  };
  const bool by_depth =
      strength->cohesion_gradient != 0 || (material::needs<material::StrengthProfile>(soil.model) && soil.is_given());
  if (material::needs<material::BeddingInput>(soil.model)) {
    add_direction("along the bedding", soil.bedding_angle);
    add_direction("across the bedding", soil.bedding_angle + 0.5 * std::numbers::pi);
  } else if (strength->law && strength->law->is_directed) {
    for (const double angle : {45.0, 0.0, -45.0})
      add_direction(fmt::format("plane at {:g}°", angle), angle * std::numbers::pi / 180);
  } else if (material::needs<material::SofteningRange>(soil.model)) {
    input::Material either = soil;
    for (const material::LimitStrength limit : {material::LimitStrength::peak, material::LimitStrength::residual}) {
      either.limit_strength = limit;
      add_strength(limit == material::LimitStrength::peak ? "peak" : "residual",
                   *material::find_slice_strength(either.model, either), {{0, extent.high}, 0, 0, 0, 0, 0});
    }
  } else if (by_depth && height > 0) {
    add("at the highest point", {{0, extent.high}, 0, 0, 0, 0, 0});
    add("at the lowest point", {{0, extent.low}, height, 0, 0, 0, 0});
  } else {
    add("", {{0, extent.high}, 0, 0, 0, 0, 0});
  }
  // The strength of SHANSEP follows σ'_v, not σ'_n.
  const bool by_vertical = soil.model == material::model_of<material::Shansep>;
  return {{"stress", by_vertical ? "Vertical effective stress σ'v" : "Normal stress σ'"},
          {"normal", std::move(normal)},
          {"lines", std::move(lines)}};
}

}  // namespace talus::report
