// SPDX-License-Identifier: MIT
#pragma once
// Traits of a constitutive law and the properties of a soil for reports, partial factors and LEM.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/strength_law.hpp"

namespace talus::material {

// Properties of a law beside its equations. Each law defines them in its header as `L::traits`.

/// The constitutive model of a material: the index of its law in `Law` (law.hpp).
enum class Model : int;

enum class Strength {
  none,   ///< elastic
  known,  ///< can be divided by a factor
  hidden  ///< the law has a strength, but no parameters that a factor can divide
};

/// Quantity that roots add to the points of a soil, from [[roots]] or from the material itself.
enum class RootEffect { none, content, cohesion };

struct Traits {
  const char* word;     ///< `model` in the case file
  const char* meaning;  ///< in the manual's list of models
  const char* title;    ///< name in reports
  Strength strength = Strength::known;
  bool serves_slices = false;  ///< has a cohesion and a friction angle: LEM, FEM and partial factors accept it
  bool only_slices = false;    ///< LEM alone has this strength; stresses are those of LinearElastic, its base
  bool has_friction = false;   ///< has c, φ, ψ and σ_t of Mohr–Coulomb
  bool takes_water = true;     ///< false: law in total stresses
  bool changes_stiffness =
      false;  ///< stiffness depends on stress and state, so the critical time step must be updated often
  bool stores_always = false;  ///< state changes in elastic steps too
  bool softens = false;        ///< softens with plastic volumetric strain, averaged over mesh.softening_length
  bool is_opaque = false;      ///< called point by point; tangents by finite differences or update_point()
  RootEffect roots = RootEffect::none;
  /// Laws of one family share this number of leading state variables, which are kept when one law replaces the other.
  const char* family = "";
  int family_states = 1;
  /// Names of the paragraphs on the law in the report's chapter on methods.
  std::array<const char*, 2> paragraphs{};
  /// A sentence for the report's assumptions, where {} stands for the materials, and the quantities that a strength
  /// reduction divides.
  const char* assumption = nullptr;
  const char* reduction = nullptr;
};

/// The unit in which a property is shown; reports choose the unit of stresses.
enum class ShownAs { number, angle, stress, stiffness, per_cent, per_per_cent, stress_per_length, si };

struct Property {
  std::string key, title, symbol;
  ShownAs shown_as = ShownAs::number;
  std::optional<double> value;  ///< SI; the property is not shown without a value
  /// Returns the value after strength reduction by a factor; empty if the factor does not change it.
  std::function<double(double factor)> reduce;
};
using Properties = std::vector<Property>;

inline Property make_divided(const char* key, std::string title, const char* symbol, ShownAs shown_as, double value) {
  return {key, std::move(title), symbol, shown_as, value, [value](double factor) { return value / factor; }};
}

/// Interface to divide the parameters of a soil by partial factors and to record each change.
class PartialDivision {
 public:
  virtual ~PartialDivision() = default;
  double cohesion = 1, friction = 1, undrained = 1;  ///< γ_c', γ_φ', γ_cu

  virtual void divide(double& value, double factor, const char* quantity, const char* symbol, const char* unit,
                      double unit_si) = 0;
  /// Divides the tangent of the angle, not the angle.
  virtual void divide_angle(double& angle, double factor, const char* quantity, const char* symbol) = 0;
};

/// Strength of the planes of one direction.
struct PlanesStrength {
  double angle = 0;           ///< to the horizontal, positive where they rise with x [rad]
  double cohesion = 0;        ///< [Pa]
  double friction_angle = 0;  ///< [rad]
};

/// Strength of a soil for LEM and limit analysis.
struct SliceStrength {
  double cohesion = 0;                     ///< [Pa]
  double friction_angle = 0;               ///< [rad]
  double cohesion_gradient = 0;            ///< growth of c per metre below `cohesion_level` [Pa/m]
  double cohesion_level = 0;               ///< [m]
  std::shared_ptr<const StrengthLaw> law;  ///< replaces all of these; in limit analysis not with `planes`
  std::optional<PlanesStrength> planes{};  ///< weak planes, for limit analysis: LEM has them in `law`
};

}  // namespace talus::material
