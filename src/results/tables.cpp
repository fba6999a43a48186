// SPDX-License-Identifier: MIT
#include "results/tables.hpp"

#include <numbers>

#include "base/numbers.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"
#include "results/study.hpp"
#include "results/table_visitor.hpp"

namespace talus::results {

namespace {

const TableRules rules{
    // Ranges of a search are pairs of limits of x and not points; named results are shown in units of their own;
    // make_study_table() has the cells of a study.
    .left_out = {&type<JsonTree>, &type<SearchRanges>, &type<NamedResult>, &type<StudyColumn>},
    .columns = {&type<SliceTable>, &type<DrawnSurface>, &type<Profile>, &type<HistogramCounts>, &type<ElementFace>,
                &type<ElementDeflection>},
    .own_columns = {&type<ElementBar>, &type<PointBar>},
    .in_head = {&type<Project>, &type<Provenance>, &type<DisplayUnits>, &type<MethodRow>}};

}  // namespace

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

std::deque<Table> make_tables(Value result, const ShownUnits& units, std::size_t dimension) {
  return visit_tables(result, rules, units, dimension);
}

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
