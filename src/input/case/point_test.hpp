// SPDX-License-Identifier: MIT
#pragma once
// [[test]]: element tests for `talus point` and `talus calibrate`.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

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

/// An element test. Stresses are effective (net stresses in unsaturated soil) and positive in compression, as in
/// laboratory reports.
struct PointTest {
  std::string name;
  std::string material;
  PointTestKind kind = PointTestKind::drained_triaxial;
  PointControl control = PointControl::strain;
  ShearDrainage drainage = ShearDrainage::drained;  ///< for simple shear
  std::optional<double> confining_pressure;         ///< initial radial stress [Pa]; or
  std::optional<double> vertical_stress;            ///< initial axial stress [Pa]
  std::optional<double> k0;                         ///< initial ratio of radial to axial stress [-]
  // Path of the test through its turning points; exactly one of the following four.
  std::vector<double> axial_strain;  ///< ε_a [-], negative in extension
  std::vector<double> shear_strain;  ///< γ of simple shear [-]
  std::vector<double> axial_stress;  ///< effective; total in undrained tests [Pa]
  std::vector<double> shear_stress;  ///< in simple shear [Pa]
  std::vector<double> suction;       ///< wetting: path from the initial suction; other tests: one constant value [Pa]
  int steps = 2000;                  ///< of the whole test, distributed among its legs by length
  std::vector<PointSetting> set;

  /// Returns the turning points of the controlled quantity.
  const std::vector<double>& goals() const;
  bool is_triaxial() const;
  /// Returns true if the initial stress is a confining pressure, not a vertical stress.
  bool has_cell() const;
  /// Returns "axial" or "shear", the strain component against which results are given.
  const char* get_strain_word() const { return kind == PointTestKind::simple_shear ? "shear" : "axial"; }
};

enum class PointQuantityKind { strain, stress, other };

/// A quantity of a test, one column of its table.
struct PointQuantity {
  const char* name;    ///< column in CSV files and [[compare]]: "axial_strain"
  const char* title;   ///< for reports
  const char* symbol;  ///< for axes; may be empty
  const char* unit;    ///< SI: "Pa", or "-"
  PointQuantityKind kind = PointQuantityKind::other;
};
/// Returns all quantities in the order of the tables.
const std::vector<PointQuantity>& list_point_quantities();
/// Returns the kind of the quantity `name`.
PointQuantityKind find_point_quantity_kind(const std::string& name);

template <>
inline constexpr auto choices<PointTestKind> = std::array{
    Choice{PointTestKind::isotropic_compression, "isotropic_compression", "the same stress from all sides"},
    Choice{PointTestKind::k0_compression, "k0_compression", "axial and radial stress keep their ratio k0"},
    Choice{PointTestKind::oedometer, "oedometer", "no lateral strain"},
    Choice{PointTestKind::drained_triaxial, "drained_triaxial",
           "axial compression or extension at constant radial stress"},
    Choice{PointTestKind::undrained_triaxial, "undrained_triaxial",
           "axial compression or extension at constant volume and constant total radial stress"},
    Choice{PointTestKind::simple_shear, "simple_shear", "shear without lateral strain"},
    Choice{PointTestKind::wetting, "wetting", "suction changes at constant net stress"},
};

template <>
inline constexpr auto choices<PointControl> = std::array{
    Choice{PointControl::strain, "strain", "axial or shear strain is prescribed"},
    Choice{PointControl::stress, "stress", "axial or shear stress is prescribed, as far as the soil carries it"},
};

template <>
inline constexpr auto choices<ShearDrainage> = std::array{
    Choice{ShearDrainage::drained, "drained", "vertical stress stays constant"},
    Choice{ShearDrainage::constant_volume, "constant_volume", "the height stays constant"},
};

void describe(Visitor& v, PointTest& t);

}  // namespace talus::input
