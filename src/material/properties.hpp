// SPDX-License-Identifier: MIT
#pragma once
// The numbers of a soil as a report shows them.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace talus::material {

// What the house asks of a soil beside its equations. Each law answers in its header, as `L::traits`.

/// The constitutive model of a material: the place of its law in `Law` (law.hpp).
enum class Model : int;

enum class Strength {
  none,   ///< elastic
  known,  ///< it can be divided by a factor
  hidden  ///< the law has one, but not as numbers that a factor could divide
};

/// What roots bring to the points of a soil, from [[roots]] or from the material itself.
enum class RootEffect { none, content, cohesion };

struct Traits {
  const char* word;     ///< `model` in the case file
  const char* meaning;  ///< in the manual
  const char* title;    ///< in reports
  Strength strength = Strength::known;
  bool serves_slices =
      false;  ///< has a cohesion and a friction angle: slices, finite elements and partial factors take it
  bool has_friction = false;       ///< has cohesion, friction, dilatancy and tensile strength of Mohr and Coulomb
  bool takes_water = true;         ///< false: its stresses are total ones
  bool changes_stiffness = false;  ///< with stress and state, so that the critical step must be looked at often
  bool stores_always = false;      ///< its state changes in elastic steps too
  bool softens = false;            ///< with its plastic volume: over mesh.softening_length
  bool is_opaque = false;          ///< its inside is not known: tangents are differences
  RootEffect roots = RootEffect::none;
  /// Laws of one family keep this many state variables where one follows the other.
  const char* family = "";
  int family_states = 1;
  /// Paragraphs of the report's methods that explain it.
  std::array<const char*, 2> paragraphs{};
  /// A sentence of the report's assumptions, {} being the materials; and what a reduction divides.
  const char* assumption = nullptr;
  const char* reduction = nullptr;
};

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
