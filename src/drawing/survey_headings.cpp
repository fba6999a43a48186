// SPDX-License-Identifier: MIT
#include "drawing/survey_headings.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"

namespace talus::drawing {
namespace {

// AGS 4 (loca…, geol…) and 3 (hole…), drill-hole databases (holeid, from, to) and what surveyors write.
const std::array known_headings{
    Headings{Role::hole, {"holeid",   "hole",      "boreholeid",   "borehole", "bhid",    "bh",      "boring",
                          "boringid", "drillhole", "drillholeid",  "dhid",     "locaid",  "pointid", "wellid",
                          "well",     "wellname",  "boreholename", "holename", "bohrung", "sondage", "boring no",
                          "punkt",    "boringno",  "boreholeno",   "holeno",   "no",      "id",      "name"}},
    Headings{Role::x,
             {"x", "xcoord", "xcoordinate", "localx", "easting", "east", "locanate", "holenate", "utme", "xutm",
              "xcollar", "xmga", "locationx", "rechtswert", "ostwert"}},
    Headings{Role::northing,
             {"northing", "north", "locanatn", "holenatn", "utmn", "yutm", "ycollar", "ymga", "locationy", "ycoord",
              "ycoordinate", "hochwert", "nordwert", "y"}},
    Headings{Role::chainage,
             {"station", "chainage", "ch", "stationing", "distance", "dist", "distancealong", "along", "abstand",
              "position", "offset"}},
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

// Eastings and northings of one kind; x and y count last, since y may be the elevation.
const std::array<std::pair<const char*, const char*>, 13> coordinate_pairs{{{"easting", "northing"},
                                                                            {"east", "north"},
                                                                            {"locanate", "locanatn"},
                                                                            {"holenate", "holenatn"},
                                                                            {"utme", "utmn"},
                                                                            {"xutm", "yutm"},
                                                                            {"xcollar", "ycollar"},
                                                                            {"xmga", "ymga"},
                                                                            {"locationx", "locationy"},
                                                                            {"rechtswert", "hochwert"},
                                                                            {"ostwert", "nordwert"},
                                                                            {"xcoord", "ycoord"},
                                                                            {"xcoordinate", "ycoordinate"}}};

}  // namespace

std::span<const Headings> get_known_headings() {
  return known_headings;
}

std::span<const std::pair<const char*, const char*>> get_coordinate_pairs() {
  return coordinate_pairs;
}

std::string find_length_unit(std::string_view text) {
  std::string word = to_lower(text);
  word = word.substr(0, word.find_first_of(" +."));
  constexpr std::array<std::pair<const char*, const char*>, 29> units{
      {{"m", "m"},     {"meter", "m"},  {"meters", "m"}, {"metre", "m"},   {"metres", "m"}, {"maod", "m"},
       {"mod", "m"},   {"masl", "m"},   {"mamsl", "m"},  {"mbgl", "m"},    {"mbgs", "m"},   {"mnap", "m"},
       {"mahd", "m"},  {"mnhn", "m"},   {"mnn", "m"},    {"mtaw", "m"},    {"ft", "ft"},    {"foot", "ft"},
       {"feet", "ft"}, {"ftbgs", "ft"}, {"ftbgl", "ft"}, {"ftamsl", "ft"}, {"ftmsl", "ft"}, {"mm", "mm"},
       {"cm", "cm"},   {"dm", "dm"},    {"km", "km"},    {"in", "inch"},   {"yd", "yard"}}};
  for (const auto& [name, unit] : units)
    if (word == name) return unit;
  return "";
}

std::string find_key(std::string_view name) {
  std::string key;
  for (const char c : to_lower(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0) key += c;
  return key;
}

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

bool are_known(const std::vector<input::TextTable::Heading>& headings) {
  std::array<bool, static_cast<std::size_t>(Role::count)> has{};
  for (const auto& heading : headings) {
    const std::string key = read_heading(heading).key;
    for (const Headings& of : known_headings)
      for (const char* name : of.names)
        if (key == name) has[static_cast<std::size_t>(of.role)] = true;
  }
  const auto knows = [&](Role role) { return has[static_cast<std::size_t>(role)]; };
  const bool has_position = knows(Role::x) || knows(Role::chainage);
  return (has_position && (knows(Role::elevation) || knows(Role::northing))) ||
         (knows(Role::hole) && (has_position || knows(Role::bottom) || knows(Role::top) || knows(Role::thickness)));
}

bool is_latitude(const std::string& key) {
  return key == "lat" || key == "latitude";
}

bool is_longitude(const std::string& key) {
  return key == "lon" || key == "long" || key == "lng" || key == "longitude";
}

}  // namespace talus::drawing
