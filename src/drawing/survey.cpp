// SPDX-License-Identifier: MIT
#include "drawing/survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/boreholes.hpp"
#include "drawing/case_text.hpp"
#include "drawing/chainage.hpp"
#include "drawing/lines.hpp"
#include "drawing/plan_line.hpp"
#include "drawing/survey_table.hpp"
#include "mesh/layers.hpp"

namespace talus::drawing {
namespace {

using mesh::Point2;
using mesh::Polyline;

constexpr std::size_t most_holes = 500;

/// A point of a line of a table.
struct SurveyPoint {
  PlanPlace place;
  double level = 0;
  std::size_t row = 0;
  double order = 0;
};

/// The points of one name in a table.
struct SurveyLine {
  std::string name, soil;
  const SurveyTable* table = nullptr;
  std::vector<SurveyPoint> points;
};

/// A borehole while its rows are collected.
struct HoleRows {
  Borehole hole;
  std::optional<PlanPlace> place;
  std::vector<std::array<std::optional<double>, 2>> depths;  ///< top and bottom of each layer [m]
  std::vector<std::string> soils;
  bool is_wrong = false;
};

class SurveyReader {
 public:
  SurveyReader(const std::vector<std::string>& files, const SurveyOptions& options) : options_(options) {
    for (const std::string& file : files)
      for (SurveyTable& table : read_survey_tables(file, options.unit)) tables_.push_back(std::move(table));
    const auto has_layers =
        std::any_of(tables_.begin(), tables_.end(), [](const SurveyTable& t) { return t.form() == TableForm::layers; });
    for (SurveyTable& table : tables_)
      if (table.form() == TableForm::collars && !has_layers) table.take_as_lines();
  }

  DrawnSection read() {
    for (const SurveyTable& table : tables_) {
      remark(table.describe());
      if (const std::string lengths = compare_chainage(table, options_.boreholes); !lengths.empty()) remark(lengths);
      switch (table.form()) {
        case TableForm::lines:
          read_lines(table);
          break;
        case TableForm::layers:
          read_layers(table);
          break;
        default:
          read_holes(table);
      }
    }
    check_wanted();
    project_places();
    finish_holes();
    set_ground();
    set_boundaries();
    set_drilled_layers();
    if (section_.layers.empty())
      fail_input(
          "the survey has a ground and nothing below it: add tables of lower boundaries or boreholes, or the level of "
          "the base with --base");
    if (!options_.is_unit_given &&
        !std::all_of(tables_.begin(), tables_.end(), [](const SurveyTable& t) { return t.has_units(); }))
      remark("lengths without a unit count as metres; --units gives another one");
    return std::move(section_);
  }

 private:
  void remark(const std::string& text) { section_.remarks.push_back(text); }

  /// Calls `read` for each row; a row with a fault is a remark. Returns false for it.
  bool try_row(const std::function<void()>& read) {
    try {
      read();
      return true;
    } catch (const Error& error) {
      ++faults_;
      constexpr int most_faults = 20;
      if (faults_ < most_faults) remark(fmt::format("{}; the row was not used", error.what()));
      if (faults_ == most_faults) remark("further rows were not understood and not used");
      return false;
    }
  }

  void read_lines(const SurveyTable& table) {
    std::vector<SurveyLine> lines;
    std::map<std::string, std::size_t> numbers;
    std::size_t without = 0;
    for (std::size_t row = table.first_row(); row < table.rows(); ++row)
      try_row([&] {
        const auto place = table.read_place(row);
        const auto level = table.read_length(row, Role::elevation);
        if (!place || !level) return void(++without);
        const std::string name = table.read_text(row, Role::soil);
        const auto [at, is_new] = numbers.try_emplace(name, lines.size());
        if (is_new) lines.push_back({fmt::format("'{}'", name), name, &table, {}});
        if (lines.size() > most_holes) fail_input("the table '{}' has more than {} lines", table.file(), most_holes);
        lines[at->second].points.push_back(
            {*place, *level, row, table.has(Role::order) ? table.read_order(row) : static_cast<double>(row)});
      });
    for (SurveyLine& line : lines)
      std::stable_sort(line.points.begin(), line.points.end(),
                       [](const SurveyPoint& a, const SurveyPoint& b) { return a.order < b.order; });
    if (without > 0)
      remark(fmt::format("{} row{} of {} without a position or an elevation {} not used", without,
                         without == 1 ? "" : "s", table.file(), without == 1 ? "was" : "were"));
    if (lines.size() > 1 && lines_.empty())
      // Lines with names have no order in their file; the uppermost is the ground.
      is_first_sorted_ = true;
    for (SurveyLine& line : lines) {
      if (line.points.size() < 2) {
        remark(fmt::format("a line {}of {} has one point, and was not used",
                           table.has(Role::soil) ? line.name + " " : "", table.file()));
        continue;
      }
      const std::string stem = std::filesystem::path(table.file()).stem().string();
      if (lines.size() == 1) line.soil = stem;
      line.name =
          lines.size() == 1 ? fmt::format("'{}'", table.file()) : fmt::format("{} of '{}'", line.name, table.file());
      lines_.push_back(std::move(line));
    }
  }

  /// Returns false, and counts the borehole, if the options name boreholes and this row is of another one.
  bool is_wanted(const SurveyTable& table, std::size_t row) {
    const auto& wanted = options_.boreholes;
    const std::string name = table.read_text(row, Role::hole);
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end()) return true;
    unwanted_.insert(name);
    return false;
  }

  HoleRows& find_hole(const SurveyTable& table, std::size_t row) {
    const std::string name = table.read_text(row, Role::hole);
    if (name.empty()) fail_input("{}: the row has no name of a borehole", table.place(row));
    const auto [at, is_new] = hole_numbers_.try_emplace(name, holes_.size());
    if (is_new) {
      if (holes_.size() >= most_holes)
        fail_input("{}: this is one more than {} boreholes, the most that a section has", table.place(row), most_holes);
      holes_.emplace_back().hole.name = name;
      holes_.back().hole.place = table.place(row);
    }
    return holes_[at->second];
  }

  /// Reads what belongs to the borehole, not to a layer. Rows of one borehole must agree.
  void read_head(const SurveyTable& table, std::size_t row, HoleRows& rows) {
    const auto place = table.read_place(row);
    const auto collar = table.read_length(row, Role::elevation), end = table.read_length(row, Role::end);
    constexpr double same = 1e-3;  // [m]
    if (place && rows.place && !(std::abs(place->x - rows.place->x) <= same))
      fail_input("{}: borehole {} is at {:.6g} m here and at {:.6g} m before", table.place(row), rows.hole.name,
                 place->x, rows.place->x);
    if (collar && rows.hole.collar && !(std::abs(*collar - *rows.hole.collar) <= same))
      fail_input("{}: the top of borehole {} is {:.6g} m here and {:.6g} m before", table.place(row), rows.hole.name,
                 *collar, *rows.hole.collar);
    if (place) rows.place = place;
    if (collar) rows.hole.collar = collar;
    if (end) rows.hole.end = std::abs(*end);
  }

  void read_layers(const SurveyTable& table) {
    for (std::size_t row = table.first_row(); row < table.rows(); ++row) {
      if (!is_wanted(table, row)) continue;
      HoleRows* rows = nullptr;
      const bool is_good = try_row([&] {
        rows = &find_hole(table, row);
        read_head(table, row, *rows);
        auto top = table.read_length(row, Role::top), bottom = table.read_length(row, Role::bottom);
        if (const auto level = table.read_length(row, Role::bottom_level); level && !bottom && rows->hole.collar)
          bottom = *rows->hole.collar - *level;
        if (const auto thickness = table.read_length(row, Role::thickness); thickness && !bottom)
          bottom =
              top.value_or(rows->depths.empty() ? 0.0 : rows->depths.back()[1].value_or(std::nan(""))) + *thickness;
        const std::string soil = table.read_text(row, Role::soil);
        if (soil.empty()) fail_input("{}: the row has no soil", table.place(row));
        if (!top && !bottom) fail_input("{}: the row has no depth", table.place(row));
        if (bottom && std::isnan(*bottom)) fail_input("{}: the layer has no top for its thickness", table.place(row));
        rows->soils.push_back(soil);
        rows->depths.push_back({top, bottom});
      });
      if (!is_good && rows != nullptr) rows->is_wrong = true;
    }
  }

  /// Reads boreholes with a row each, with depths or without.
  void read_holes(const SurveyTable& table) {
    if (!table.depths().empty()) {
      if (!soils_.empty())
        fail_input("'{}' is a second table of boreholes with a row each; put them into one", table.file());
      std::set<std::string> names;
      for (const DepthColumn& column : table.depths()) {
        const std::string name = take_name(names, column.soil);
        soils_.push_back({name, name});
      }
    }
    for (std::size_t row = table.first_row(); row < table.rows(); ++row) {
      if (!is_wanted(table, row)) continue;
      HoleRows* rows = nullptr;
      const bool is_good = try_row([&] {
        rows = &find_hole(table, row);
        read_head(table, row, *rows);
        double above = 0;
        std::vector<std::optional<double>> bottoms;
        for (const DepthColumn& column : table.depths()) {
          const auto depth = table.read_length(row, column);
          if (depth && *depth < above)
            fail_input("{}: the depth of '{}', {:.6g} m, is less than the one above, {:.6g} m", table.place(row),
                       clean_text(column.soil), *depth, above);
          if (depth) above = *depth;
          bottoms.push_back(depth);
        }
        rows->hole.bottoms = bottoms;
        rows->hole.end = std::max(rows->hole.end, above);
      });
      if (!is_good && rows != nullptr) rows->is_wrong = true;
    }
  }

  /// Throws Error (wrong_input) if a borehole that the options name is in no table.
  void check_wanted() {
    for (const std::string& name : options_.boreholes)
      if (!hole_numbers_.contains(name)) {
        std::vector<std::string> known(unwanted_.begin(), unwanted_.end());
        for (const auto& [hole, number] : hole_numbers_) known.push_back(hole);
        if (known.empty()) fail_input("--boreholes names '{}', and the tables have no boreholes", name);
        constexpr std::size_t most_named = 12;
        if (known.size() > most_named && find_nearest(name, known).empty())
          known.resize(most_named), known.push_back("…");
        fail_input("--boreholes names '{}', which is in no table; {}", name, suggest(name, known));
      }
    if (!unwanted_.empty())
      remark(fmt::format("{} borehole{} that --boreholes does not name {} left out", unwanted_.size(),
                         unwanted_.size() == 1 ? "" : "s", unwanted_.size() == 1 ? "was" : "were"));
  }

  static bool has_layers(const HoleRows& rows) {
    return !rows.soils.empty() || std::any_of(rows.hole.bottoms.begin(), rows.hole.bottoms.end(),
                                              [](const auto& bottom) { return bottom.has_value(); });
  }

  /// Makes positions along the section of places in plan, with one line for all tables.
  void project_places() {
    std::vector<PlanPlace> places;
    std::size_t count = 0;
    const auto collect = [&](const PlanPlace& p) {
      ++count;
      if (!std::isnan(p.northing)) places.push_back(p);
    };
    for (const SurveyLine& line : lines_)
      for (const SurveyPoint& p : line.points) collect(p.place);
    for (const HoleRows& rows : holes_)
      if (rows.place && has_layers(rows)) collect(*rows.place);
    const bool is_plan = !places.empty();
    if (is_plan && places.size() < count)
      fail_input(
          "some of the tables have positions in plan, with a northing, and others along the section: bring them all to "
          "one of both");
    const bool is_straight = std::all_of(places.begin(), places.end(),
                                         [&](const PlanPlace& p) { return p.northing == places.front().northing; });
    if (!is_plan || is_straight) {
      for (HoleRows& rows : holes_)
        if (rows.place) rows.hole.x = rows.place->x;
      return;
    }
    const PlanLine line(places);
    for (SurveyLine& of : lines_)
      for (SurveyPoint& p : of.points) p.place.x = line.project(p.place);
    for (HoleRows& rows : holes_)
      if (rows.place) rows.hole.x = line.project(*rows.place);
    remark(
        fmt::format("positions are distances along the line of azimuth {:.1f}° that fits the places in plan best; the "
                    "farthest is {:.3g} m beside it",
                    line.compute_azimuth(), line.widest()));
  }

  /// Returns the points from left to right. Throws Error (wrong_input) if the line folds back.
  static Polyline make_line(const SurveyLine& from) {
    std::vector<SurveyPoint> points = from.points;
    if (points.front().place.x > points.back().place.x) std::reverse(points.begin(), points.end());
    Polyline line;
    for (std::size_t i = 0; i < points.size(); ++i) {
      line.push_back({points[i].place.x, points[i].level});
      if (i > 0 && points[i].place.x < points[i - 1].place.x)
        fail_input(
            "{}: the line folds back from x = {:.6g} m to x = {:.6g} m; its points must follow one another along the "
            "section",
            from.table->place(points[i].row), points[i - 1].place.x, points[i].place.x);
    }
    if (!(line.back()[0] > line.front()[0])) fail_input("the line {} has no width", from.name);
    return line;
  }

  void set_ground() {
    std::vector<Chain> chains;
    for (const SurveyLine& line : lines_) chains.push_back({line.soil, line.name, false, make_line(line)});
    if (is_first_sorted_) sort_down(chains);
    if (!chains.empty()) {
      const double extent = measure_extent(chains);
      for (Chain& chain : chains) drop_repeated(chain.points, 1e-9 * extent);
      thin_out(chains, meeting_distance * extent, "the survey", section_.remarks);
      section_.ground = chains.front().points;
      remark(fmt::format("{} is the ground", chains.front().handle));
      boundaries_.assign(chains.begin() + 1, chains.end());
      return;
    }
    if (drilled_.empty())
      fail_input("the tables have no line of two points; the last remark is: {}", section_.remarks.back());
    for (const Borehole& hole : drilled_) {
      if (!hole.collar)
        fail_input("{}: borehole {} has no elevation of its top, and there is no table of the ground", hole.place,
                   clean_text(hole.name));
      section_.ground.push_back({*hole.x, *hole.collar});
    }
    if (section_.ground.size() < 2)
      fail_input("the survey has one borehole{} and no ground: give a table of the ground (x and elevation) too{}",
                 holes_.size() > 1 ? fmt::format(" of {} that can be used", holes_.size()) : "",
                 left_out_.empty() ? "" : "; " + left_out_);
    remark(fmt::format("the ground is a line through the tops of {} boreholes", drilled_.size()));
  }

  void set_boundaries() {
    if (!boundaries_.empty() && !drilled_.empty())
      fail_input("the survey has both lower boundaries and boreholes; give the ground and one of them");
    for (const Chain& line : boundaries_) {
      section_.layers.push_back({take_name(names_, line.layer), line.points, "", false, {}});
      remark(fmt::format("{} is the lower boundary of '{}'", line.handle, section_.layers.back().name));
    }
    if (!options_.base || !drilled_.empty()) return;
    std::vector<mesh::Polyline> lines{section_.ground};
    for (const Chain& line : boundaries_) lines.push_back(line.points);
    check_base(*options_.base, lines);
    section_.layers.push_back(
        {take_name(names_, boundaries_.empty() ? "soil" : "base"), {}, "", false, *options_.base});
  }

  /// Converts the rows of a borehole of form `layers` to its layers.
  void make_layers(HoleRows& rows) {
    Borehole& hole = rows.hole;
    std::vector<std::size_t> order(rows.soils.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto& depths = rows.depths;
    const bool goes_down = std::all_of(depths.begin(), depths.end(),
                                       [](const auto& d) { return d[0].value_or(0) <= 0 && d[1].value_or(0) <= 0; });
    const double sign = goes_down ? -1 : 1;
    const auto get_middle = [&](std::size_t i) {
      return sign * (depths[i][0].value_or(*depths[i][1]) + depths[i][1].value_or(*depths[i][0]));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return get_middle(a) < get_middle(b); });
    double above = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::size_t i = order[k];
      const double top = depths[i][0] ? sign * *depths[i][0] : above;
      const auto& next_top = k + 1 < order.size() ? depths[order[k + 1]][0] : std::nullopt;
      const double bottom = depths[i][1] ? sign * *depths[i][1] : next_top ? sign * *next_top : std::max(top, hole.end);
      constexpr double same = 0.005;  // [m]
      if (top < above - same || bottom < top)
        fail_input("borehole {} ({}): '{}' goes from {:.6g} m to {:.6g} m depth, and the soil above it to {:.6g} m",
                   clean_text(hole.name), hole.place, clean_text(rows.soils[i]), top, bottom, above);
      if (top > above + same)
        remark(fmt::format("borehole {} has no soil from {:.6g} m to {:.6g} m depth; '{}' below was extended",
                           clean_text(hole.name), above, top, clean_text(rows.soils[i])));
      if (!hole.layers.empty() && hole.layers.back().soil == rows.soils[i])
        hole.layers.back().bottom = bottom;
      else if (bottom > above)
        hole.layers.push_back({rows.soils[i], bottom});
      above = bottom;
    }
  }

  void finish_holes() {
    const bool has_ground = !lines_.empty();
    bool has_rows = false, has_columns = false;
    for (HoleRows& rows : holes_) {
      Borehole& hole = rows.hole;
      if (rows.is_wrong) {
        left_out_ =
            fmt::format("borehole {} was left out, because of a row that is not understood", clean_text(hole.name));
        remark(left_out_);
        continue;
      }
      const bool has_depths = has_layers(rows);
      if (!has_depths || !hole.x || (!has_ground && !hole.collar)) {
        left_out_ = fmt::format("borehole {} ({}) has no {}, and was left out", clean_text(hole.name), hole.place,
                                !has_depths ? "layers"
                                : !hole.x   ? "position"
                                            : "elevation of its top");
        remark(left_out_);
        continue;
      }
      if (!try_row([&] { make_layers(rows); })) {
        left_out_ = section_.remarks.back();
        continue;
      }
      (rows.soils.empty() ? has_columns : has_rows) = true;
      drilled_.push_back(std::move(hole));
    }
    if (has_rows && has_columns)
      fail_input("some boreholes have a row for each layer and others a column for each; bring them to one form");
    if (drilled_.empty() && !holes_.empty())
      fail_input("none of the {} boreholes can be used; the last remark is: {}", holes_.size(),
                 section_.remarks.back());
    std::stable_sort(drilled_.begin(), drilled_.end(),
                     [](const Borehole& a, const Borehole& b) { return *a.x < *b.x; });
    for (std::size_t i = 1; i < drilled_.size(); ++i)
      if (!(*drilled_[i].x - *drilled_[i - 1].x > 1e-6))
        fail_input("the boreholes {} ({}) and {} ({}) are both at x = {:.6g} m; leave one of them out",
                   clean_text(drilled_[i - 1].name), drilled_[i - 1].place, clean_text(drilled_[i].name),
                   drilled_[i].place, *drilled_[i].x);
    if (has_rows) soils_ = order_soils(drilled_);
  }

  /// Measures depths from the ground of a table, and leaves boreholes outside it out.
  void lower_to_ground() {
    double largest = 0;
    std::vector<Borehole> inside;
    for (Borehole& hole : drilled_) {
      if (*hole.x < section_.ground.front()[0] || *hole.x > section_.ground.back()[0]) {
        remark(fmt::format("borehole {} at x = {:.6g} m is outside the ground, and was left out", clean_text(hole.name),
                           *hole.x));
        continue;
      }
      const double move = hole.collar ? mesh::find_level(section_.ground, *hole.x) - *hole.collar : 0;
      largest = std::max(largest, std::abs(move));
      // A soil without thickness at the top stays so where the ground is lower than the top of the borehole.
      for (auto& bottom : hole.bottoms)
        if (bottom) *bottom = std::max(*bottom + move, 0.0);
      hole.end = std::max(hole.end + move, 0.0);
      inside.push_back(std::move(hole));
    }
    drilled_ = std::move(inside);
    if (largest > 0.01)
      remark(fmt::format(
          "the tops of boreholes are up to {:.3g} m from the ground; their boundaries keep their elevations", largest));
    if (drilled_.empty()) fail_input("all boreholes are outside the ground");
  }

  void set_drilled_layers() {
    if (drilled_.empty()) return;
    if (!lines_.empty()) lower_to_ground();
    section_.layers = make_drilled_layers(drilled_, soils_, section_.ground, options_.base, section_.remarks);
  }

  const SurveyOptions& options_;
  std::vector<SurveyTable> tables_;
  std::vector<SurveyLine> lines_;
  std::vector<HoleRows> holes_;
  std::map<std::string, std::size_t> hole_numbers_;
  std::vector<DrilledSoil> soils_;
  std::vector<Borehole> drilled_;
  std::vector<Chain> boundaries_;
  std::set<std::string> names_, unwanted_;
  std::string left_out_;  ///< remark on the last borehole that was left out
  DrawnSection section_;
  bool is_first_sorted_ = false;
  int faults_ = 0;
};

}  // namespace

DrawnSection read_survey(const std::vector<std::string>& files, const SurveyOptions& options) {
  constexpr std::size_t most_files = 20;
  if (files.size() > most_files) fail_input("{} tables are given; at most {} are read", files.size(), most_files);
  return SurveyReader(files, options).read();
}

}  // namespace talus::drawing
