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

void describe(auto& v, Gravity& g) {
  v.key("acceleration", g.acceleration, quantity("m/s2").at_least(0), "Acceleration of gravity.");
  v.key("direction", g.direction, plain(), "Direction in which it acts, of any length but zero.");
}

void describe(auto& v, PiezometricLine& l) {
  v.key("materials", l.materials, plain().required().example(R"(["sand"])"), "Materials in which the line acts.");
  v.key("points", l.points, quantity("m").required().example("[[0, 12], [32, 9]]"),
        "The line to which water would rise in a standpipe, from left to right; level beyond its ends. It may lie "
        "above the ground (artesian) or below the soil (drained, with suction).");
}

void describe(auto& v, PressureTable& t) {
  v.key("file", t.file, plain().required().example(R"("piezometers.csv")"),
        "A table (relative to the case file) with the columns x, y and that of `quantity`, with their units: "
        "`x [m], y [m], pressure [kPa]`.");
  v.key("quantity", t.quantity, plain(), "Which quantity the table has; its column has the same name.");
  v.key("interpolation", t.interpolation, plain(),
        "How values between the points are found. Pressures are interpolated as total heads, so that hydrostatic water "
        "is exact. Beyond the points the head of the nearest one holds for linear interpolation.");
}

void describe(auto& v, Initial& i) {
  v.key("result", i.result, plain().example(R"("gravity_results")"),
        "A folder of results (relative to the case file) whose state at the end of its stages is the start: mesh, "
        "points, stress, pore water, velocities and plastic strain are those of the result. Time, displacements and "
        "budgets begin anew.");
  const bool has_result = !i.result.empty();
  v.key("stress", i.stress, plain().allowed_without("result", has_result), "Stress at the start.");
  v.key(
      "k0", i.k0,
      plain().at_least(0).allowed_with("stress", i.stress, {InitialStress::k0, InitialStress::elements}).example("0.5"),
      "Ratio of horizontal to vertical stress; if not given, ν/(1-ν) of each material.");
  v.key("pore_pressure", i.water.pressure, plain().allowed_without("result", has_result),
        "Pore pressure at the start.");
  v.key("water_table", i.water.water_table,
        quantity("m")
            .needed_with("pore_pressure", i.water.pressure, InitialPressure::water_table)
            .example("[[0, 10], [32, 5]]"),
        "The line of zero pore pressure, from left to right; level beyond its ends.");
  v.key("largest_suction", i.water.largest_suction,
        quantity("kPa").at_least(0).or_infinite().allowed_with("pore_pressure", i.water.pressure,
                                                               {InitialPressure::water_table, InitialPressure::grid}),
        "Suction grows with the height above the water table up to this value.");
  v.key("season", i.water.season,
        quantity("day")
            .at_least(0)
            .allowed_with("pore_pressure", i.water.pressure, {InitialPressure::water_table, InitialPressure::seepage})
            .example("90"),
        "Weather before the run: seepage is calculated in soil at rest from this long before time 0, where the pore "
        "pressure named above holds, with the [[hydraulic]] series at negative times and the roots' transpiration.");
  v.key("date", i.date, plain().example("2023-07-01"),
        "The date of time 0: tables of dates begin there, and the times of [timeline] are printed as dates as well.");
  v.key("equilibrium", i.equilibrium, plain().example(R"("gravity")"),
        "The stage at whose end `preconsolidation_ratio` of Cam-clay soils is applied; if not given, the first one.");
  v.entries("velocity", i.velocity, "soil", 0, quantity("m/s").example("[1, 0]"),
            "Velocity of a region at the start; not with 'result'.");
  v.tables("piezometric_line", i.water.lines, 0,
           "A piezometric line of its own for some soils, beside the water table: perched or artesian water, or water "
           "held back by a cut-off. Water stands on the ground under the water table only.");
  v.optional_table("pressure_grid", i.water.table, "Pore pressures at points, for pore_pressure = \"grid\".");
}

}  // namespace talus::input
