// SPDX-License-Identifier: MIT
#include "input/case/pressure_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "base/units.hpp"
#include "input/case/checks.hpp"
#include "input/case/text_table.hpp"

namespace talus::input {

namespace {

constexpr std::size_t most_rows = 100'000;

/// Returns the factor of the unit of a column to `si`; `si` empty: a number without unit.
double read_factor(const TextTable& table, std::size_t column, const char* si, bool needs_unit) {
  const TextTable::Heading& heading = table.header()[column];
  if (*si == '\0') {
    if (!heading.unit.empty() && heading.unit != "-" && heading.unit != "1")
      fail_input("the column '{}' of '{}' has the unit '{}'; it has none", heading.name, table.file(), heading.unit);
    return 1;
  }
  if (heading.unit.empty()) {
    if (needs_unit)
      fail_input("the column '{0}' of '{1}' has no unit; head it '{0} [kPa]'", heading.name, table.file());
    return 1;
  }
  return units::parse_as_si("1 " + heading.unit, si, fmt::format("column '{}' of '{}'", heading.name, table.file()));
}

std::vector<mesh::ScatteredValue> read_values(const PressureTable& source, const std::filesystem::path& folder,
                                              double water_weight) {
  const TextTable table((folder / source.file).lexically_normal());
  const bool is_pressure = source.quantity == GridQuantity::pressure, is_ratio = source.quantity == GridQuantity::ratio;
  const std::size_t x = table.find_column("x"), y = table.find_column("y"),
                    column = table.find_column(get_word(source.quantity));
  if (table.rows() > most_rows)
    fail_input("'{}' has {} rows; at most {} can be read", table.file(), table.rows(), most_rows);
  const double to_x = read_factor(table, x, "m", false), to_y = read_factor(table, y, "m", false),
               to_value = read_factor(table, column,
                                      is_ratio      ? ""
                                      : is_pressure ? "Pa"
                                                    : "m",
                                      is_pressure);
  std::vector<mesh::ScatteredValue> values;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    mesh::ScatteredValue value{{to_x * table.number(row, x), to_y * table.number(row, y)},
                               to_value * table.number(row, column)};
    if (is_pressure) value.value = value.at[1] + value.value / water_weight;
    if (is_ratio && !(value.value >= 0 && value.value < 1))
      fail_input("{}: r_u is {:.6g}; it must be at least 0 and less than 1", table.place(row), value.value);
    values.push_back(value);
  }
  return values;
}

/// Returns true if pore water flows in stages of construction in a soil with a piezometric line of its own.
bool flows_below_line(const Case& data) {
  const auto is_wet = [&](const std::string& name) {
    const auto soil = data.materials.find(name);
    return soil != data.materials.end() && soil->second.water.is_wet();
  };
  return !data.construction.empty() &&
         std::any_of(data.initial.water.lines.begin(), data.initial.water.lines.end(),
                     [&](const PiezometricLine& line) {
                       return std::any_of(line.materials.begin(), line.materials.end(), is_wet);
                     });
}

void check_lines(const Case& data, Findings& findings) {
  const InitialWater& water = data.initial.water;
  std::map<std::string, std::size_t> owners;
  for (std::size_t i = 0; i < water.lines.size(); ++i) {
    const PiezometricLine& line = water.lines[i];
    const std::string path = fmt::format("initial.piezometric_line.{}", i);
    check_water_table(line.points, path + ".points", data.units().length, findings);
    if (line.materials.empty() && findings.is_sound(path + ".materials"))
      findings.add(path + ".materials", "'materials' is empty; name those in which the line acts");
    for (std::size_t k = 0; k < line.materials.size(); ++k) {
      const std::string& name = line.materials[k];
      const std::string at = fmt::format("{}.materials.{}", path, k);
      if (!data.materials.contains(name) && findings.is_sound("materials"))
        findings.add(at, "there is no material '{}'", name);
      else if (const auto [owner, is_new] = owners.try_emplace(name, i); !is_new)
        findings.add(at, "material '{}' has a piezometric line already, number {} of the list; it can have one", name,
                     owner->second + 1);
    }
  }
  if (water.lines.empty()) return;
  const char* path = "initial.piezometric_line";
  if (water.pressure != InitialPressure::water_table && findings.is_sound("initial.pore_pressure"))
    findings.add(path, "piezometric lines belong to pore_pressure = \"water_table\", the line of all other soils");
  else if (water.season > 0 || data.timeline || flows_below_line(data))
    findings.add(
        path,
        "transient flow starts from one field of pressure, which jumps between soils with piezometric lines of "
        "their own; start from pore_pressure = \"seepage\" or from one water table");
  else if (uses(data, Method::mpm) && is_wet(data))
    findings.add(path,
                 "MPM moves the pore water of [materials.NAME.water], which would flow at once between soils with "
                 "piezometric lines of their own; take that block out (constant pressures), or let the pressures "
                 "follow from pore_pressure = \"seepage\"");
}

/// Names of the materials that fill a region at any time.
std::set<std::string> list_soils(const Case& data, const std::string& region) {
  std::set<std::string> soils;
  if (const auto first = data.regions.find(region); first != data.regions.end()) soils.insert(first->second);
  for (const ConstructionStage& stage : data.construction)
    if (const auto later = stage.soils.find(region); later != stage.soils.end()) soils.insert(later->second);
  return soils;
}

/// Returns the level of the given water at `x` [m].
double find_given_level(const InitialWater& water, const std::array<double, 2>& x) {
  if (water.pressure == InitialPressure::grid) return water.field->find(x);
  const auto& table = water.water_table;
  const auto after = std::find_if(table.begin(), table.end(), [&](const auto& p) { return p[0] >= x[0]; });
  if (after == table.begin() || after == table.end()) return (after == table.end() ? table.back() : *after)[1];
  const auto &a = *(after - 1), &b = *after;
  return a[1] + (b[1] - a[1]) * (x[0] - a[0]) / (b[0] - a[0]);
}

/// Returns true if the outline of a polygon lies below the given water somewhere.
bool lies_in_water(const InitialWater& water, const mesh::Polygon& polygon) {
  constexpr int parts = 32;
  constexpr double noticeable = 1e-6;  // of the length of a side
  for (std::size_t i = 0; i < polygon.points.size(); ++i) {
    const auto &a = polygon.points[i], &b = polygon.points[(i + 1) % polygon.points.size()];
    for (int k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      const std::array<double, 2> x{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
      if (find_given_level(water, x) - x[1] > noticeable * std::hypot(b[0] - a[0], b[1] - a[1])) return true;
    }
  }
  return false;
}

/// Reports soil without pore water of its own below the given water in MPM, which moves the pore water of the others.
void check_missing_water(const Case& data, Findings& findings) {
  const InitialWater& water = data.initial.water;
  const bool has_table = water.pressure == InitialPressure::water_table && !water.water_table.empty(),
             has_field = water.pressure == InitialPressure::grid && water.field && water.table &&
                         water.table->quantity != GridQuantity::ratio;
  if (!uses(data, Method::mpm) || !is_wet(data) || !water.lines.empty() || !(has_table || has_field)) return;
  if (!findings.is_sound("materials") || !findings.is_sound("initial.water_table")) return;
  std::set<std::string> reported;
  for (const mesh::Polygon& polygon : data.mesh.polygons)
    for (const std::string& name : list_soils(data, polygon.name)) {
      const auto soil = data.materials.find(name);
      if (soil == data.materials.end() || soil->second.water.is_wet() || !has_effective_strength(soil->second))
        continue;
      if (lies_in_water(water, polygon) && reported.insert(name).second)
        findings.add("materials." + name, "{}", describe_missing_water(name));
    }
}

/// Warns of soil outside the points, where values are extrapolated.
void warn_of_uncovered(const Case& data, Findings& findings) {
  const InitialWater& water = data.initial.water;
  if (!water.field) return;
  for (const mesh::Polygon& polygon : data.mesh.polygons)
    for (const auto& corner : polygon.points) {
      if (water.field->covers(corner)) continue;
      findings.warn("initial.pressure_grid.file",
                    "the soil at {} {} lies outside the points of '{}': {}. Add points around the section",
                    format_point(corner, data.units().length), data.units().length.name, water.table->file,
                    water.field->kind() == mesh::Scatter::linear ? "values at their edge are used there"
                                                                 : "the spline is extrapolated there");
      return;
    }
}

void check_grid(const Case& data, Findings& findings) {
  const InitialWater& water = data.initial.water;
  if (!findings.is_sound("initial.pore_pressure")) return;
  if (water.table && water.pressure != InitialPressure::grid)
    findings.add("initial.pressure_grid", "a grid of pressures needs pore_pressure = \"grid\"");
  if (water.pressure != InitialPressure::grid) return;
  if (!water.table) {
    findings.add("initial.pore_pressure", "pore_pressure = \"grid\" needs the block [initial.pressure_grid]");
    return;
  }
  if (data.mesh.dimension != 2)
    findings.add("initial.pore_pressure", "a grid of pressures describes a plane section, and 'dimension' is 3");
  warn_of_uncovered(data, findings);
  if (water.table->quantity != GridQuantity::ratio) return;
  const char* path = "initial.pressure_grid.quantity";
  const bool flows = data.timeline || (!data.construction.empty() && is_wet(data));
  if (flows) findings.add(path, "transient flow cannot start from r_u; give pressures or heads");
  if (uses(data, Method::mpm) && is_wet(data))
    findings.add(path,
                 "MPM moves the pore water of [materials.NAME.water], which r_u does not describe; give pressures "
                 "or heads");
  for (const auto& [name, material] : data.materials)
    if (material.slices.pore_pressure_ratio != 0)
      findings.add("materials." + name + ".pore_pressure_ratio",
                   "material '{}' has a pore pressure ratio, and the grid gives r_u for all soils; give one of them",
                   name);
}

}  // namespace

void load_pressure_table(Case& data, const std::string& file, Findings& findings) {
  InitialWater& water = data.initial.water;
  if (!water.table || !findings.is_sound("initial.pressure_grid") || !findings.is_sound("water.density") ||
      !findings.is_sound("gravity.acceleration"))
    return;
  const double weight = data.water.density * data.gravity.acceleration;
  if (!(weight > 0) && water.table->quantity == GridQuantity::pressure)
    return findings.add("gravity.acceleration", "'acceleration' is 0, but a grid of pressures needs a weight of water");
  try {
    water.field = std::make_shared<const mesh::ScatteredField>(
        read_values(*water.table, std::filesystem::path(file).parent_path(), weight), water.table->interpolation);
  } catch (const Error& error) {
    findings.add("initial.pressure_grid.file", "[initial.pressure_grid] '{}': {}", water.table->file, error.what());
  }
}

void check_given_pressures(const Case& data, Findings& findings) {
  check_lines(data, findings);
  check_grid(data, findings);
  check_missing_water(data, findings);
}

bool has_effective_strength(const Material& soil) {
  return soil.traits().strength != material::Strength::none && !material::is_total_stress(soil.model, soil);
}

std::string describe_missing_water(const std::string& material) {
  return fmt::format(
      "the water of [initial] acts in material '{0}', which has no [materials.{0}.water]: MPM moves the pore water of "
      "the other soils, and this one would be dry. Give it that block, or take those of the others out (constant "
      "pressures)",
      material);
}

}  // namespace talus::input
