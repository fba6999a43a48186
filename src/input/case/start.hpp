// SPDX-License-Identifier: MIT
#pragma once
// [gravity] and [initial]: gravity and the initial state of the soil.

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"
#include "mesh/mesh.hpp"
#include "mesh/scattered_field.hpp"

namespace talus::input {

struct Gravity {
  double acceleration = 9.81;                 ///< [m/s²]
  std::array<double, 3> direction{0, -1, 0};  ///< unit vector after reading
};

enum class InitialPressure { zero, water_table, seepage, grid };

/// Pore water of a plane section from a preceding calculation.
struct KnownWater {
  mesh::Mesh<2> mesh;                          ///< finished
  std::vector<double> pressure;                ///< nodal values, positive in tension [Pa]
  std::vector<std::array<double, 2>> seepage;  ///< Darcy velocity per element [m/s]
};

/// A piezometric line, which replaces the water table in some soils.
struct PiezometricLine {
  std::vector<std::string> materials;
  std::vector<std::array<double, 2>> points;  ///< [m]; horizontal beyond its ends
};

/// Quantity of a grid of pore pressures.
enum class GridQuantity { pressure, head, ratio };

/// Pore pressures measured or computed at scattered points, from a table.
struct PressureTable {
  std::string file;
  GridQuantity quantity = GridQuantity::pressure;
  mesh::Scatter interpolation = mesh::Scatter::linear;
};

/// Initial pore pressure; part of [initial].
struct InitialWater {
  InitialPressure pressure = InitialPressure::zero;
  std::vector<std::array<double, 2>> water_table;  ///< polyline of zero pressure [m]; horizontal beyond its ends
  double largest_suction = std::numeric_limits<double>::infinity();  ///< limit above the water table [Pa]
  std::vector<PiezometricLine> lines;
  std::optional<PressureTable> table;
  /// Total head [m], or r_u [-], of `table`; not a key.
  std::shared_ptr<const mesh::ScatteredField> field{};
  /// Duration of preceding weather [s]: transient seepage in rigid soil from time -season, with initial condition
  /// `pressure`, to time 0.
  double season = 0;
  std::shared_ptr<const KnownWater> known{};  ///< from a time of a timeline; replaces the other members; not a key
};

enum class InitialStress { none, k0, elements };

/// Effective stress of a plane section by FEM, at the integration points of its triangles.
struct KnownStress {
  static constexpr std::size_t points = 3;  ///< per triangle, each nearest to the corner with its index
  mesh::Mesh<2> mesh;                       ///< finished
  struct Element {
    std::array<std::array<double, 6>, points> stress{};  ///< positive in tension [Pa]
    std::array<double, points> plastic_strain{};         ///< accumulated, deviatoric [-]
  };
  std::vector<Element> elements;  ///< in the order of the mesh
};

struct Initial {
  std::optional<Date> date;  ///< of time 0
  InitialStress stress = InitialStress::none;
  std::optional<double> k0;                           ///< K0 [-]; default: ν/(1-ν) of each material
  std::shared_ptr<const KnownStress> known_stress{};  ///< for stress = `elements`, after the FEM calculation; not a key
  std::map<std::string, std::array<double, 3>> velocity;  ///< by region [m/s]
  InitialWater water;
  std::string equilibrium;    ///< stage at the end of which preconsolidation_ratio is applied; empty: the first
  std::string result;         ///< folder of a result whose end is the initial state, as given; empty: none
  std::string result_folder;  ///< the resolved path of `result`
};

template <>
inline constexpr auto choices<InitialPressure> = std::array{
    Choice{InitialPressure::zero, "zero", "no pore pressure"},
    Choice{InitialPressure::water_table, "water_table", "hydrostatic below a water table, suction above it"},
    Choice{InitialPressure::seepage, "seepage", "the steady flow that belongs to the hydraulic conditions at time 0"},
    Choice{InitialPressure::grid, "grid", "values at points, from the table of [initial.pressure_grid]"},
};

template <>
inline constexpr auto choices<GridQuantity> = std::array{
    Choice{GridQuantity::pressure, "pressure", "pore pressure, compression positive"},
    Choice{GridQuantity::head, "head", "total head, a level"},
    Choice{GridQuantity::ratio, "r_u", "pore pressure over the weight of the soil above"},
};

template <>
inline constexpr auto choices<mesh::Scatter> = std::array{
    Choice{mesh::Scatter::linear, "linear", "linear on the Delaunay triangles of the points"},
    Choice{mesh::Scatter::thin_plate, "thin_plate", "a thin plate spline through the points"},
};

template <>
inline constexpr auto choices<InitialStress> = std::array{
    Choice{InitialStress::none, "none", "no stress: the first stage brings the weight on"},
    Choice{InitialStress::k0, "k0", "the weight of the column above, and K0 times it to the sides"},
    Choice{InitialStress::elements, "elements", "equilibrium by FEM, which starts from the stress of \"k0\""},
};

void describe(Visitor& v, Gravity& g);

void describe(Visitor& v, PiezometricLine& l);

void describe(Visitor& v, PressureTable& t);

void describe(Visitor& v, Initial& i);

}  // namespace talus::input
