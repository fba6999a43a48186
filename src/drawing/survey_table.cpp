// SPDX-License-Identifier: MIT
#include "drawing/survey_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"
#include "drawing/ags.hpp"
#include "drawing/case_text.hpp"
#include "input/case/series_file.hpp"

namespace talus::drawing {
namespace {

constexpr std::size_t most_rows = 200'000;
constexpr std::uint64_t largest_table = 20 * largest_file::megabyte;
constexpr std::size_t most_columns = 200, most_depth_columns = 100;

/// Headings of a role, as their letters and digits in lower case; the first that a table has is taken.
struct Headings {
  Role role;
  std::initializer_list<const char*> names;
};

// AGS 4 (loca…, geol…) and 3 (hole…), drill-hole databases (holeid, from, to) and what surveyors write.
const std::array known{
    Headings{Role::hole, {"holeid",   "hole",      "boreholeid",   "borehole", "bhid",    "bh",      "boring",
                          "boringid", "drillhole", "drillholeid",  "dhid",     "locaid",  "pointid", "wellid",
                          "well",     "wellname",  "boreholename", "holename", "bohrung", "sondage", "boring no",
                          "punkt",    "boringno",  "boreholeno",   "holeno",   "no",      "id",      "name"}},
    Headings{Role::x,
             {"station",  "chainage", "ch",       "stationing",  "distance", "dist",    "distancealong", "offset",
              "position", "x",        "xcoord",   "xcoordinate", "along",    "localx",  "easting",       "abstand",
              "east",     "locanate", "holenate", "utme",        "xutm",     "xcollar", "xmga",          "locationx"}},
    Headings{Role::northing,
             {"northing", "north", "locanatn", "holenatn", "utmn", "yutm", "ycollar", "ymga", "locationy", "ycoord",
              "ycoordinate", "y"}},
    // The top of a borehole comes first: rows of layers may have elevations of their own.
    Headings{Role::elevation, {"collar",      "collarelevation",
                               "collarelev",  "collarlevel",
                               "collarz",     "zcollar",
                               "groundlevel", "groundelevation",
                               "groundelev",  "surfaceelevation",
                               "surfaceelev", "locagl",
                               "holegl",      "gl",
                               "altitude",    "alt",
                               "elevation",   "elev",
                               "level",       "z",
                               "rl",          "height",
                               "zcoord",      "zcoordinate",
                               "höhe",        "hoehe",
                               "cote",        "surface"}},
    Headings{Role::top,
             {"top", "from", "von", "topdepth", "depthtop", "depthfrom", "fromdepth", "geoltop", "start", "startdepth",
              "upper", "depthstart", "upperdepth"}},
    Headings{
        Role::bottom,
        {"bottom", "base", "to", "bis", "bottomdepth", "depthbottom", "depthbase", "basedepth", "depthto", "todepth",
         "geolbase", "lower", "depthend", "lowerdepth", "bot", "botdepth", "bottomoflayer", "md", "end"}},
    Headings{Role::bottom_level,
             {"bottomelevation", "bottomlevel", "baseelevation", "baselevel", "bottomelev", "baseelev", "bottomz"}},
    Headings{Role::thickness, {"thickness", "thick"}},
    Headings{Role::end,
             {"totaldepth", "enddepth", "finaldepth", "td", "eoh", "holedepth", "maxdepth", "locafdep", "holefdep",
              "length", "boreholedepth", "depthofhole"}},
    Headings{Role::soil, {"soil",     "soilname", "soiltype",    "stratum",   "strata",   "unit",    "formation",
                          "geolgeol", "geology",  "lithology",   "lith",      "litho",    "geolleg", "lithodesc",
                          "rocktype", "rock",     "layer",       "layername", "material", "surface", "component",
                          "line",     "boundary", "description", "geoldesc",  "schicht",  "bodenart"}},
    Headings{Role::order, {"pointorder", "order", "sequence"}},
};

/// Returns the unit of length that a word names; empty if it names none: "ft" for "feet", "m" for "mAOD".
std::string find_length_unit(std::string_view text) {
  std::string word = to_lower(text);
  word = word.substr(0, word.find_first_of(" +."));
  constexpr std::array<std::pair<const char*, const char*>, 25> units{
      {{"m", "m"},      {"meter", "m"},  {"meters", "m"},  {"metre", "m"},  {"metres", "m"},
       {"maod", "m"},   {"mod", "m"},    {"masl", "m"},    {"mamsl", "m"},  {"mbgl", "m"},
       {"mbgs", "m"},   {"mnap", "m"},   {"ft", "ft"},     {"foot", "ft"},  {"feet", "ft"},
       {"ftbgs", "ft"}, {"ftbgl", "ft"}, {"ftamsl", "ft"}, {"ftmsl", "ft"}, {"mm", "mm"},
       {"cm", "cm"},    {"dm", "dm"},    {"km", "km"},     {"in", "inch"},  {"yd", "yard"}}};
  for (const auto& [name, unit] : units)
    if (word == name) return unit;
  return "";
}

/// A heading without its unit.
struct Heading {
  std::string name, key, unit;
};

std::string find_key(std::string_view name) {
  std::string key;
  for (const char c : to_lower(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0) key += c;
  return key;
}

/// Splits "Elevation (ft)", "Depth_m" and "x [m]".
Heading read_heading(const input::TextTable::Heading& heading) {
  Heading read{heading.name, "", heading.unit};
  const std::size_t open = read.name.rfind('(');
  if (read.unit.empty() && open != std::string::npos && open > 0 && read.name.ends_with(')')) {
    read.unit = find_length_unit(std::string_view(read.name).substr(open + 1, read.name.size() - open - 2));
    read.name = read.name.substr(0, read.name.find_last_not_of(" _", open - 1) + 1);
  }
  const std::size_t last = read.name.find_last_of("_ ");
  if (read.unit.empty() && last != std::string::npos && last > 0) {
    read.unit = find_length_unit(std::string_view(read.name).substr(last + 1));
    if (!read.unit.empty()) read.name = read.name.substr(0, last);
  }
  if (const std::string plain = find_length_unit(read.unit); !plain.empty()) read.unit = plain;
  read.key = find_key(read.name);
  return read;
}

/// Returns true if headings have the names of a position and an elevation, or of a borehole and its depths.
bool are_known(const std::vector<input::TextTable::Heading>& headings) {
  std::array<bool, static_cast<std::size_t>(Role::count)> has{};
  for (const auto& heading : headings) {
    const std::string key = read_heading(heading).key;
    for (const Headings& of : known)
      for (const char* name : of.names)
        if (key == name) has[static_cast<std::size_t>(of.role)] = true;
  }
  const auto knows = [&](Role role) { return has[static_cast<std::size_t>(role)]; };
  return (knows(Role::x) && (knows(Role::elevation) || knows(Role::northing))) ||
         (knows(Role::hole) && (knows(Role::x) || knows(Role::bottom) || knows(Role::top) || knows(Role::thickness)));
}

/// The first line of a table, below its preamble.
struct Start {
  std::size_t at = 0;        ///< in the text
  int line = 1;              ///< its number
  std::size_t preamble = 0;  ///< number of lines with text above it
  std::string unit;          ///< unit of length that the preamble names
};

/// Returns the unit of length that a line such as "Unit: ft" names; empty if it names none.
std::string find_preamble_unit(std::string_view line) {
  const std::size_t mark = line.find_first_of(":=,;\t");
  if (mark == std::string_view::npos) return "";
  const std::string key = find_key(line.substr(0, mark));
  if (key != "unit" && key != "units" && key != "lengthunit" && key != "lengthunits") return "";
  const std::size_t begin = line.find_first_not_of(" \t:=,;", mark);
  if (begin == std::string_view::npos) return "";
  return find_length_unit(line.substr(begin, line.find_first_of(",;\t\r", begin) - begin));
}

/// Returns true for words between blanks above a line with another number of cells.
bool is_sentence(std::string_view line, std::string_view below) {
  if (line.find_first_of(",;\t") != std::string_view::npos) return false;
  below = below.substr(std::min(below.find_first_not_of(" \t\r\n"), below.size()));
  const std::string_view next = below.substr(0, below.find('\n'));
  const auto count = [](std::string_view words) { return input::TextTable("", std::string(words), 1).header().size(); };
  return !next.empty() && count(line) != count(next);
}

/// Searches the first lines for headings that are known. Without such a line, the table begins with the text.
Start find_start(std::string_view text) {
  constexpr std::size_t most_preamble = 60, longest = 10'000;
  Start start;
  std::size_t at = 0;
  for (int number = 1; at < text.size() && start.preamble < most_preamble; ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (line.size() > longest) break;
    if (const input::TextTable candidate("", std::string(line), 1); !candidate.header().empty()) {
      if (are_known(candidate.header()) && !is_sentence(line, text.substr(std::min(end + 1, text.size())))) {
        start.at = at, start.line = number;
        return start;
      }
      ++start.preamble;
      if (const std::string unit = find_preamble_unit(line); !unit.empty()) start.unit = unit;
    }
    at = end + 1;
  }
  return {};
}

/// Converts text that is not UTF-8, as programs of Windows write it, from Latin-1. Returns true if it was converted.
bool make_utf8(std::string& text) {
  if (!find_wrong_utf8(text)) return false;
  std::string converted;
  converted.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      converted += c;
    } else {
      converted += static_cast<char>(0xC0 | (byte >> 6));
      converted += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  text = std::move(converted);
  return true;
}

const char* name_form(TableForm form) {
  switch (form) {
    case TableForm::lines:
      return "lines";
    case TableForm::layers:
      return "boreholes, with a row for each layer";
    case TableForm::holes:
      return "boreholes, with a row for each and a column for each boundary";
    default:
      return "positions of boreholes";
  }
}

}  // namespace

SurveyTable::SurveyTable(const std::string& path, double unit) : text_(open(path, unit)) {
  read(unit);
}

SurveyTable::SurveyTable(input::TextTable text, const std::string& name, double unit)
    : part_(name), text_(std::move(text)) {
  read(unit);
}

input::TextTable SurveyTable::open(const std::string& path, double& unit) {
  std::string text;
  if (const auto fault = try_user_file(path, largest_table, text))
    fail_input("the table '{}' cannot be read: {}", path, fault->why);
  if (is_utf16(std::string_view(text).substr(0, text.find('\n'))))
    fail_input("'{}' is in UTF-16; save it as UTF-8", path);
  is_converted_ = make_utf8(text);
  const Start start = find_start(text);
  preamble_ = start.preamble;
  if (!start.unit.empty()) {
    unit = units::parse_as_si("1 " + start.unit, "m", "the unit of the table");
    preamble_unit_ = start.unit;
  }
  return {path, text.substr(start.at), start.line};
}

void SurveyTable::read(double unit) {
  const std::string& path = text_.file();
  if (text_.header().empty()) fail_input("the table '{}' is empty", path);
  if (text_.rows() > most_rows)
    fail_input("the table '{}' has {} rows; at most {} are read", path, text_.rows(), most_rows);
  if (text_.header().size() > most_columns)
    fail_input("the table '{}' has {} columns; a survey has at most {}", path, text_.header().size(), most_columns);
  select_columns(unit);
  find_form();
  read_units_row();
  if (first_row_ >= text_.rows()) fail_input("the table '{}' has a header and no rows", path);
}

void SurveyTable::select_columns(double unit) {
  const std::size_t count = text_.header().size();
  std::vector<Heading> headings;
  std::vector<char> is_used(count);
  for (const auto& heading : text_.header()) headings.push_back(read_heading(heading));
  const auto get_factor = [&](std::size_t i) {
    if (headings[i].unit.empty()) return unit;
    return units::parse_as_si("1 " + headings[i].unit, "m",
                              fmt::format("column '{}' of '{}'", headings[i].name, text_.file()));
  };
  const auto has_unit = [&](std::size_t i) { return !headings[i].unit.empty() || !preamble_unit_.empty(); };
  const bool is_headless = count >= 2 && headings[0].name == "1" && headings[1].name == "2";
  if (is_headless) {
    if (count > 3)
      fail_input("'{}' has {} columns without headings; name them in a first line, for example x, y, z", text_.file(),
                 count);
    columns_[static_cast<std::size_t>(Role::x)] = Column{0, unit, false};
    if (count == 3) columns_[static_cast<std::size_t>(Role::northing)] = Column{1, unit, false};
    columns_[static_cast<std::size_t>(Role::elevation)] = Column{count - 1, unit, false};
    return;
  }
  for (const Headings& of : known)
    for (const char* name : of.names) {
      const auto found =
          std::find_if(headings.begin(), headings.end(), [&](const Heading& h) { return h.key == name; });
      const auto i = static_cast<std::size_t>(found - headings.begin());
      if (i == count || is_used[i]) continue;
      const bool is_text = of.role == Role::hole || of.role == Role::soil;
      if (!is_text && !is_numeric(i)) continue;
      if (of.role == Role::soil && !has_text(i)) continue;
      is_used[i] = 1;
      const bool is_length = !is_text && of.role != Role::order;
      columns_[static_cast<std::size_t>(of.role)] = Column{i, is_length ? get_factor(i) : 0, has_unit(i)};
      break;
    }
  // In a table with x and y only, y is the elevation.
  auto &elevation = columns_[static_cast<std::size_t>(Role::elevation)],
       &northing = columns_[static_cast<std::size_t>(Role::northing)];
  if (!elevation && is_headed(Role::northing, {"y"})) std::swap(elevation, northing);
  for (std::size_t i = 0; i < count; ++i) {
    if (is_used[i]) continue;
    // "depth" is that of a layer where rows are layers, and of the borehole otherwise.
    if (headings[i].key == "depth" && is_numeric(i)) {
      const Role role = has(Role::soil) ? Role::bottom : Role::end;
      if (!has(role)) {
        columns_[static_cast<std::size_t>(role)] = Column{i, get_factor(i), has_unit(i)};
        continue;
      }
    }
    // A part of a file, such as a group of AGS, has one meaning for each column.
    const bool may_be_depth =
        part_.empty() && has(Role::hole) && !has(Role::soil) && is_numeric(i) && !headings[i].name.empty();
    if (may_be_depth && depths_.size() < most_depth_columns)
      depths_.push_back({headings[i].name, i, get_factor(i), has_unit(i)});
    else
      unused_.push_back(headings[i].name);
  }
}

bool SurveyTable::is_headed(Role role, const std::vector<std::string>& keys) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  return column && std::find(keys.begin(), keys.end(), read_heading(text_.header()[column->number]).key) != keys.end();
}

void SurveyTable::find_form() {
  // A column "no" or "id" may number the points of a line, whose further columns are no depths.
  const bool has_holes =
      has(Role::hole) &&
      (!has(Role::elevation) || !is_headed(Role::hole, {"id", "no", "nr", "name", "pointid", "punkt"}) ||
       !is_headed(Role::elevation, {"z", "y", "elevation", "elev", "height", "höhe", "hoehe", "cote"}));
  const bool has_depth = has(Role::bottom) || has(Role::bottom_level) || has(Role::thickness) || has(Role::top);
  if (has(Role::soil) && has(Role::hole) && has_depth) {
    form_ = TableForm::layers;
  } else if (has_holes && has(Role::x) && !has(Role::soil) && !depths_.empty()) {
    form_ = TableForm::holes;
  } else if (has(Role::hole) && has(Role::x) && !has(Role::soil) && (has(Role::end) || has(Role::northing))) {
    form_ = TableForm::collars;
  } else if (has(Role::x) && has(Role::elevation)) {
    form_ = TableForm::lines;
  } else {
    refuse_headings();
    std::string list;
    for (const auto& heading : text_.header()) list += fmt::format("{}'{}'", list.empty() ? "" : ", ", heading.name);
    if (list.size() > 200) list = list.substr(0, 200) + " …";
    fail_input(
        "the headings of '{}' are neither those of a line (x, station, chainage or distance, and y, z, elevation or "
        "level) nor those of boreholes (hole, x, elevation, and bottom and soil, or the depth of each boundary); it "
        "has {}",
        text_.file(), clean_text(list));
  }
  if (form_ != TableForm::holes) {
    for (const DepthColumn& column : depths_) unused_.push_back(column.soil);
    depths_.clear();
  }
}

void SurveyTable::refuse_headings() const {
  std::size_t numbers = 0;
  bool has_latitude = false, has_longitude = false;
  for (const auto& heading : text_.header()) {
    const char* const end = heading.name.data() + heading.name.size();
    double value = 0;
    if (!heading.name.empty() && parse_number(heading.name.data(), end, value) == end) ++numbers;
    const std::string key = read_heading(heading).key;
    has_latitude = has_latitude || key == "lat" || key == "latitude";
    has_longitude = has_longitude || key == "lon" || key == "long" || key == "lng" || key == "longitude";
  }
  if (has_latitude && has_longitude)
    fail_input("the positions of '{}' are latitudes and longitudes; give eastings and northings of a map projection",
               text_.file());
  if (numbers >= 2)
    fail_input(
        "'{}' has numbers and texts in its first line and no headings; name its columns in a first line, for "
        "example name, x, y, z, code",
        text_.file());
}

void SurveyTable::read_units_row() {
  if (text_.rows() == 0) return;
  bool is_row_of_units = false;
  const auto take = [&](std::size_t number, double& factor, bool& has_unit) {
    std::string cell = text_.cell(0, number);
    if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '(')) cell = cell.substr(1, cell.size() - 2);
    const std::string unit = find_length_unit(cell);
    if (unit.empty()) return;
    is_row_of_units = has_unit = true;
    factor = units::parse_as_si("1 " + unit, "m", "the unit of a column");
  };
  for (auto& column : columns_)
    if (column && column->factor > 0) take(column->number, column->factor, column->has_unit);
  for (DepthColumn& column : depths_) take(column.column, column.factor, column.has_unit);
  if (!is_row_of_units) return;
  // In AGS data a row of types, such as 2DP, follows.
  first_row_ = 1;
  const auto is_type = [&](const std::optional<Column>& column) {
    const std::string cell = column && text_.rows() > 1 ? text_.cell(1, column->number) : "";
    return cell.size() == 3 && (cell.ends_with("DP") || cell.ends_with("SF"));
  };
  if (std::any_of(columns_.begin(), columns_.end(), is_type)) first_row_ = 2;
}

bool SurveyTable::is_numeric(std::size_t column) const {
  constexpr std::size_t most_tries = 20;
  for (std::size_t row = 0; row < std::min(text_.rows(), most_tries); ++row) {
    if (input::is_missing(text_.cell(row, column), -99)) continue;
    try {
      text_.number(row, column);
      return true;
    } catch (const Error&) {
      continue;
    }
  }
  return text_.rows() == 0;
}

bool SurveyTable::has_text(std::size_t column) const {
  for (std::size_t row = 0; row < text_.rows(); ++row)
    if (const std::string cell = text_.cell(row, column); !cell.empty() && cell != "X" && cell != "PA") return true;
  return text_.rows() == 0;
}

std::optional<double> SurveyTable::read_length(std::size_t row, const DepthColumn& column) const {
  if (input::is_missing(text_.cell(row, column.column), -99)) return std::nullopt;
  const double value = text_.number(row, column.column) * column.factor;
  constexpr double farthest = 1e9;  // [m]
  if (!(std::abs(value) < farthest)) fail_input("{}: {:.6g} m is too far away", text_.place(row), value);
  return value;
}

std::optional<double> SurveyTable::read_length(std::size_t row, Role role) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  if (!column) return std::nullopt;
  return read_length(row, {"", column->number, column->factor, column->has_unit});
}

double SurveyTable::read_order(std::size_t row) const {
  return text_.number(row, columns_[static_cast<std::size_t>(Role::order)]->number);
}

std::string SurveyTable::read_text(std::size_t row, Role role) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  return column ? text_.cell(row, column->number) : "";
}

bool SurveyTable::has_units() const {
  return std::all_of(columns_.begin(), columns_.end(),
                     [](const auto& c) { return !c || c->factor == 0 || c->has_unit; }) &&
         std::all_of(depths_.begin(), depths_.end(), [](const DepthColumn& d) { return d.has_unit; });
}

std::string SurveyTable::describe() const {
  const auto name = [&](Role role) {
    const auto& column = columns_[static_cast<std::size_t>(role)];
    return column ? text_.header()[column->number].name : "";
  };
  std::string columns;
  for (const Role role : {Role::hole, Role::x, Role::northing, Role::elevation, Role::top, Role::bottom,
                          Role::bottom_level, Role::thickness, Role::end, Role::soil, Role::order})
    if (has(role)) columns += fmt::format("{}'{}'", columns.empty() ? "" : ", ", name(role));
  if (text_.header().front().name == "1" && text_.header().size() == 3) columns += " as x, y and z";
  std::string sentence = fmt::format("{}{} has {}; columns used: {}", std::filesystem::path(file()).filename().string(),
                                     part_.empty() ? "" : ", group " + part_, name_form(form_), columns);
  if (!depths_.empty()) sentence += fmt::format(" and {} depths", depths_.size());
  if (!unused_.empty()) {
    constexpr std::size_t most_named = 8;
    sentence += "; not used: ";
    for (std::size_t i = 0; i < std::min(unused_.size(), most_named); ++i)
      sentence += fmt::format("{}'{}'", i == 0 ? "" : ", ", unused_[i]);
    if (unused_.size() > most_named) sentence += fmt::format(" and {} more", unused_.size() - most_named);
  }
  if (preamble_ > 0)
    sentence += fmt::format("; {} line{} above the headings{}", preamble_, preamble_ == 1 ? "" : "s",
                            preamble_unit_.empty() ? " not used" : ", of which the unit is used: " + preamble_unit_);
  if (is_converted_) sentence += "; it is not UTF-8 and was read as Latin-1";
  return sentence + (has_units() ? "" : "; lengths without a unit");
}

std::vector<SurveyTable> read_survey_tables(const std::string& path, double unit) {
  std::vector<SurveyTable> tables;
  if (!is_ags(path)) {
    tables.emplace_back(path, unit);
    return tables;
  }
  for (AgsGroup& group : read_ags(path)) {
    make_utf8(group.text);
    tables.emplace_back(input::TextTable(path, std::move(group.text), group.first_line), group.name, unit);
  }
  return tables;
}

}  // namespace talus::drawing
