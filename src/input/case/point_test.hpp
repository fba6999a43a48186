#pragma once
// [[test]] of the case: element tests, for `talus point` and `talus calibrate`.

#include <optional>
#include <string>
#include <vector>

namespace talus::input {

enum class PointTestKind {
  isotropic_compression,
  k0_compression,
  oedometer,
  drained_triaxial,
  undrained_triaxial,
  simple_shear,
  wetting
};
enum class PointControl { strain, stress };
enum class ShearDrainage { drained, constant_volume };

/// A key of the test's material with another value, as --set writes it.
struct PointSetting {
  std::string key;    ///< dotted path within the material
  std::string value;  ///< TOML text
};

/// Stresses are effective, and compression is positive as in a laboratory's report; of unsaturated soil they are net.
struct PointTest {
  std::string name;
  std::string material;
  PointTestKind kind = PointTestKind::drained_triaxial;
  PointControl control = PointControl::strain;
  ShearDrainage drainage = ShearDrainage::drained;  ///< of simple shear
  std::optional<double> confining_pressure;         ///< radial stress at the start [Pa]; or
  std::optional<double> vertical_stress;            ///< axial stress at the start [Pa]
  std::optional<double> k0;                         ///< radial over axial stress at the start [-]
  // Where the test goes: from turning point to turning point. One of the four.
  std::vector<double> axial_strain;  ///< ε_a [-], negative in extension
  std::vector<double> shear_strain;  ///< γ of simple shear [-]
  std::vector<double> axial_stress;  ///< effective, of undrained tests total [Pa]
  std::vector<double> shear_stress;  ///< of simple shear [Pa]
  std::vector<double> suction;       ///< of wetting: the first is the start; elsewhere one, which stays [Pa]
  int steps = 2000;                  ///< of the whole test, shared out among its legs by their length
  std::vector<PointSetting> set;

  /// What the test follows, by kind and control.
  const std::vector<double>& goals() const;
  bool is_triaxial() const;
  /// Whether the test starts from a confining pressure rather than a vertical stress.
  bool has_cell() const;
  /// What strains of its results are measured along: "axial" or "shear".
  const char* get_strain_word() const { return kind == PointTestKind::simple_shear ? "shear" : "axial"; }
};

enum class PointQuantityKind { strain, stress, other };

/// What a row of a test tells.
struct PointQuantity {
  const char* name;    ///< as in CSV files and [[compare]]: "axial_strain"
  const char* title;   ///< for people
  const char* symbol;  ///< for axes; empty where there is none
  const char* unit;    ///< SI: "Pa", or "-"
  PointQuantityKind kind = PointQuantityKind::other;
};
/// All of them, in the order of the tables.
const std::vector<PointQuantity>& list_point_quantities();
/// What the quantity called `name` is.
PointQuantityKind find_point_quantity_kind(const std::string& name);

}  // namespace talus::input
