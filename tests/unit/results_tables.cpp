// SPDX-License-Identifier: MIT
// Results as tables: columns and units follow from the descriptions, lists within rows become tables that name their
// row.

#include "results/tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "results/run.hpp"
#include "results/study.hpp"
#include "results/table_visitor.hpp"

namespace talus::results {

/// Structs with every kind of member.
struct Leaf {
  std::string word;
  std::vector<Point> points;
  std::optional<double> stress;
};
void describe(Visitor& v, Leaf& r) {
  v.key("word", r.word, {"", "word"});
  v.key("points", r.points, {"m", "its points"});
  v.key("stress", r.stress, {"Pa", "stress"});
}

struct Pair {
  std::vector<double> x, angle;
};
void describe(Visitor& v, Pair& r) {
  v.key("x", r.x, {"m", "x"});
  v.key("angle", r.angle, {"rad", "angle"});
}
const TableRules rules{.left_out = {}, .columns = {&type<Pair>}, .own_columns = {}, .in_head = {}};

struct Branching {
  int count = 0;
  double mean = 0;
  Point centre{};
  std::vector<Leaf> leaves;
  Pair pair;
  std::vector<std::string> notes;
  std::map<std::string, std::vector<Leaf>> named;
  std::vector<std::vector<Point>> lines;
};
void describe(Visitor& v, Branching& r) {
  v.key("count", r.count, {"", "count"});
  v.key("mean", r.mean, {"N/m", "mean force"});
  v.key("centre", r.centre, {"m", "centre"});
  v.key("leaves", r.leaves, {"", "leaves"});
  v.key("pair", r.pair, {"", "two lists"});
  v.key("notes", r.notes, {"", "notes"});
  v.key("named", r.named, {"", "by name"});
  v.key("lines", r.lines, {"m", "lines"});
}

namespace {

using Cells = std::vector<Cell>;

const Table& find_table(const std::deque<Table>& tables, const std::string& name) {
  for (const Table& table : tables)
    if (table.name == name) return table;
  static const Table none;
  ADD_FAILURE() << "there is no table " << name;
  return none;
}

const Column& find_column(const Table& table, const std::string& key) {
  for (const Column& column : table.columns)
    if (column.key == key) return column;
  static const Column none;
  ADD_FAILURE() << "there is no column " << key << " in " << table.name;
  return none;
}

std::vector<std::string> list_keys(const Table& table) {
  std::vector<std::string> keys;
  for (const Column& column : table.columns) keys.push_back(column.key);
  return keys;
}

Branching make_example() {
  Branching b;
  b.count = 3;
  b.mean = 2500;
  b.centre = {1, 2};
  b.leaves = {{"first", {{0, 1}, {2, 3}}, std::nullopt}, {"second", {{4, 5}}, 2000.0}};
  b.pair.x = {1, 2, 3};
  b.pair.angle = {0, std::numbers::pi / 4, std::nan("")};
  b.notes = {"a", "b"};
  b.named = {{"one", {{"deep", {}, 1000.0}}}};
  b.lines = {{{0, 0}, {1, 1}}, {{5, 5}}};
  return b;
}

TEST(ResultsTables, AStructIsARowInUnitsOfDisplay) {
  const auto tables = visit_tables(make_value(make_example()), rules, ShownUnits{}, 2);
  const Table& own = find_table(tables, "");
  EXPECT_TRUE(own.is_single);
  EXPECT_EQ(list_keys(own), (std::vector<std::string>{"count", "mean", "centre.x", "centre.y", "notes"}));
  EXPECT_TRUE(find_column(own, "count").counts);
  EXPECT_EQ(find_column(own, "mean").unit, "kN/m");
  EXPECT_EQ(find_column(own, "mean").cells, Cells{2.5});
  EXPECT_EQ(find_column(own, "centre.y").title, "centre y");
  EXPECT_EQ(find_column(own, "notes").cells, Cells{"a; b"});
}

TEST(ResultsTables, AListHasARowForEachEntry) {
  const auto tables = visit_tables(make_value(make_example()), rules, ShownUnits{}, 2);
  const Table& leaves = find_table(tables, "leaves");
  EXPECT_EQ(leaves.rows, 2u);
  EXPECT_EQ(find_column(leaves, "word").cells, (Cells{"first", "second"}));
  EXPECT_EQ(find_column(leaves, "stress").cells, (Cells{std::monostate{}, 2.0}));
  EXPECT_EQ(find_column(leaves, "stress").unit, "kPa");
}

TEST(ResultsTables, AListWithinRowsNamesItsRow) {
  const auto tables = visit_tables(make_value(make_example()), rules, ShownUnits{}, 2);
  const Table& points = find_table(tables, "leaves.points");
  EXPECT_EQ(list_keys(points), (std::vector<std::string>{"leaves.no", "leaves.word", "points.x", "points.y"}));
  EXPECT_EQ(points.columns[0].cells, (Cells{1.0, 1.0, 2.0}));
  EXPECT_EQ(points.columns[1].cells, (Cells{"first", "first", "second"}));
  EXPECT_EQ(points.columns[3].cells, (Cells{1.0, 3.0, 5.0}));
  EXPECT_EQ(points.columns[3].title, "its points y");
}

TEST(ResultsTables, ListsOfOneStructAreColumns) {
  const auto tables = visit_tables(make_value(make_example()), rules, ShownUnits{}, 2);
  const Table& pair = find_table(tables, "pair");
  EXPECT_EQ(list_keys(pair), (std::vector<std::string>{"x", "angle"}));
  EXPECT_EQ(find_column(pair, "x").cells, (Cells{1.0, 2.0, 3.0}));
  EXPECT_EQ(find_column(pair, "angle").unit, "deg");
  EXPECT_DOUBLE_EQ(std::get<double>(find_column(pair, "angle").cells[1]), 45);
  EXPECT_EQ(find_column(pair, "angle").cells[2], Cell());
}

TEST(ResultsTables, MapsAndNestedListsHaveTheirNamesAndNumbers) {
  const auto tables = visit_tables(make_value(make_example()), rules, ShownUnits{}, 2);
  EXPECT_EQ(list_keys(find_table(tables, "named")), (std::vector<std::string>{"name", "word", "stress"}));
  const Table& lines = find_table(tables, "lines");
  EXPECT_EQ(find_column(lines, "no").cells, (Cells{1.0, 1.0, 2.0}));
  EXPECT_EQ(find_column(lines, "lines.x").cells, (Cells{0.0, 1.0, 5.0}));
}

TEST(ResultsTables, EverySliceHasARow) {
  RunResult run;
  CriticalSurface& c = run.slices.emplace().critical.emplace_back();
  c.surface.factor = 1.25;
  c.slices.left = {0, 1};
  c.slices.soil = {"clay", "=sand"};
  c.slices.weight = {1e3, 2e3};
  c.slices.base_left = {{0, 5}, {1, 4}};
  run.units.length = "ft";
  const auto tables = make_tables(make_value(run), read_units(run), 2);
  const Table& slices = find_table(tables, "lem.critical.slices");
  EXPECT_EQ(slices.rows, 2u);
  EXPECT_EQ(find_column(slices, "critical.method").cells, (Cells{"spencer", "spencer"}));
  EXPECT_EQ(find_column(slices, "soil").cells, (Cells{"clay", "=sand"}));
  EXPECT_EQ(find_column(slices, "weight").cells, (Cells{1.0, 2.0}));
  EXPECT_EQ(find_column(slices, "base_left.y").unit, "ft");
  EXPECT_NEAR(std::get<double>(find_column(slices, "base_left.y").cells[0]), 5 / 0.3048, 1e-12);
}

TEST(ResultsTables, TheTableOfAStudyHasNumbersAndWords) {
  StudyResult study;
  study.variants.resize(2);
  study.columns.push_back({"size", "size", "m", {{"0.5", "0.5"}, {"", ""}}, ColumnKind::other, ""});
  study.columns.push_back({"word", "word", "", {{"1e3x", ""}, {"nan", ""}}, ColumnKind::other, ""});
  const Table table = make_study_table(study);
  EXPECT_EQ(table.rows, 2u);
  EXPECT_EQ(table.columns[0].cells, (Cells{0.5, Cell()}));
  EXPECT_EQ(table.columns[1].cells, (Cells{"1e3x", "nan"}));
}

TEST(ResultsTables, CurvesOfASupportAreTheColumnsOfOneTable) {
  RunResult run;
  ElementResult fem;
  ElementRun& one = fem.runs.emplace_back();
  one.supports.emplace();
  ElementBar wall;
  wall.support = "sheet";
  wall.place = {0.5, 1.5};
  wall.force = {-1e3, -2e3};
  wall.moments = {10e3, 20e3};
  wall.deflection = ElementDeflection{{0, 1, 2}, {0.01, 0.02, 0.03}};
  ElementBar nail;
  nail.support = "nail";
  nail.place = {0.1, 0.2, 0.3};
  nail.force = {5e3, 6e3, 7e3};
  one.supports = {wall, nail};
  run.elements = fem;
  const auto tables = make_tables(make_value(run), ShownUnits{}, 2);
  const Table& along = find_table(tables, "fem.runs.supports.along");
  EXPECT_EQ(along.rows, 5u) << "two places of the wall, three of the nail";
  EXPECT_EQ(find_column(along, "place").cells, (Cells{0.5, 1.5, 0.1, 0.2, 0.3})) << "two distances are no point";
  EXPECT_EQ(find_column(along, "force").cells, (Cells{-1.0, -2.0, 5.0, 6.0, 7.0}));
  EXPECT_EQ(find_column(along, "force").unit, "kN/m");
  EXPECT_EQ(find_column(along, "moments").cells,
            (Cells{10e3, 20e3, std::monostate{}, std::monostate{}, std::monostate{}}));
  EXPECT_EQ(find_column(along, "supports.support").cells, (Cells{"sheet", "sheet", "nail", "nail", "nail"}));
  EXPECT_EQ(find_column(find_table(tables, "fem.runs.supports.deflection"), "value").cells, (Cells{0.01, 0.02, 0.03}));
}

}  // namespace
}  // namespace talus::results
