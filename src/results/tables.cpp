// SPDX-License-Identifier: MIT
#include "results/tables.hpp"

#include <numbers>

#include "base/numbers.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"
#include "results/study.hpp"
#include "results/table_visitor.hpp"

namespace talus::results {

// The ranges of a search are pairs of limits of x and not points.
template <>
inline constexpr bool is_left_out<SearchRanges> = true;
// Their values are shown in units of display of their own.
template <>
inline constexpr bool is_left_out<NamedResult> = true;
// make_study_table() has its cells.
template <>
inline constexpr bool is_left_out<StudyColumn> = true;

template <>
inline constexpr bool has_columns<SliceTable> = true;
template <>
inline constexpr bool has_columns<DrawnSurface> = true;
template <>
inline constexpr bool has_columns<Profile> = true;
template <>
inline constexpr bool has_columns<HistogramCounts> = true;
template <>
inline constexpr bool has_columns<ElementFace> = true;
template <>
inline constexpr bool has_columns<ElementDeflection> = true;

template <>
inline constexpr bool has_own_columns<ElementBar> = true;
template <>
inline constexpr bool has_own_columns<PointBar> = true;

template <>
inline constexpr bool is_in_head<Project> = true;
template <>
inline constexpr bool is_in_head<Provenance> = true;
template <>
inline constexpr bool is_in_head<DisplayUnits> = true;
template <>
inline constexpr bool is_in_head<MethodRow> = true;

ShownUnit find_shown_unit(const std::string& stored, const ShownUnits& units, std::size_t dimension) {
  constexpr double degree = std::numbers::pi / 180;
  if (stored == "m") return units.length;
  if (stored == "m2") return units.area();
  if (stored == "m3") return units.volume(dimension);
  if (stored == "m3/s") return units.flow(dimension);
  if (stored == "m/s") return units.speed();
  if (stored == "Pa") return units.stress;
  if (stored == "N/m") return units.line_force;
  if (stored == "N/m3") return units.unit_weight;
  if (stored == "rad") return {"deg", degree};
  return {stored, 1};
}

template <class T>
std::deque<Table> make_tables(const T& result, const ShownUnits& units, std::size_t dimension) {
  return visit_tables(result, units, dimension);
}
template std::deque<Table> make_tables(const RunResult&, const ShownUnits&, std::size_t);
template std::deque<Table> make_tables(const StudyResult&, const ShownUnits&, std::size_t);
template std::deque<Table> make_tables(const PointTests&, const ShownUnits&, std::size_t);
template std::deque<Table> make_tables(const Calibration&, const ShownUnits&, std::size_t);

namespace {

/// Returns a number, a text, or nothing.
Cell read_cell(const std::string& text) {
  if (text.empty()) return {};
  double number = 0;
  const char *first = text.data(), *last = first + text.size();
  if (parse_number(first, last, number) == last && std::isfinite(number)) return number;
  return text;
}

}  // namespace

Table make_study_table(const StudyResult& study) {
  Table table;
  table.name = "study";
  table.title = study.title;
  table.rows = study.variants.size();
  for (const StudyColumn& column : study.columns) table.rows = std::max(table.rows, column.cells.size());
  for (const StudyColumn& column : study.columns) {
    Column made{column.name, column.title, column.unit, false, false, {}};
    for (const StudyCell& cell : column.cells) made.cells.push_back(read_cell(cell.full));
    made.cells.resize(table.rows);
    table.columns.push_back(std::move(made));
  }
  return table;
}

}  // namespace talus::results
