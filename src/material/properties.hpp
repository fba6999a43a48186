// SPDX-License-Identifier: MIT
#pragma once
// The numbers of a soil as a report shows them.

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace talus::material {

/// The unit in which a property is shown; reports choose that of stresses.
enum class ShownAs { number, angle, stress, stiffness, per_cent, per_per_cent, stress_per_length, si };

struct Property {
  std::string key, title, symbol;
  ShownAs shown_as = ShownAs::number;
  std::optional<double> value;  ///< SI; not shown without one
  /// The value with the strength divided by a factor; empty: a factor does not change it.
  std::function<double(double factor)> reduce;
};
using Properties = std::vector<Property>;

/// `value / factor`.
inline Property make_divided(const char* key, std::string title, const char* symbol, ShownAs shown_as, double value) {
  return {key, std::move(title), symbol, shown_as, value, [value](double factor) { return value / factor; }};
}

/// Divides numbers of a soil by partial factors, and records each change.
class PartialDivision {
 public:
  virtual ~PartialDivision() = default;
  double cohesion = 1, friction = 1, undrained = 1;  ///< γ_c', γ_φ', γ_cu

  virtual void divide(double& value, double factor, const char* quantity, const char* symbol, const char* unit,
                      double unit_si) = 0;
  /// The tangent is divided, not the angle.
  virtual void divide_angle(double& angle, double factor, const char* quantity, const char* symbol) = 0;
};

/// What methods of slices take of a soil.
struct SliceStrength {
  double cohesion = 0;           ///< [Pa]
  double friction_angle = 0;     ///< [rad]
  double cohesion_gradient = 0;  ///< per metre below `cohesion_level` [Pa/m]
  double cohesion_level = 0;     ///< [m]
};

}  // namespace talus::material
