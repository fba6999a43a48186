#include "run/lem/lem_json.hpp"

#include <cmath>
#include <functional>

namespace talus::run {
namespace {

using nlohmann::json;

json to_json(const lem::Point& x) {
  return {x[0], x[1]};
}

json to_json(const std::vector<lem::Point>& line) {
  json list = json::array();
  for (const lem::Point& x : line) list.push_back(to_json(x));
  return list;
}

/// Numbers that files need not keep to the last digit.
double round_to(double value, double digits) {
  return std::round(value * digits) / digits;
}

json list_slices(const lem::Slope& slope, const lem::CutSurface& cut) {
  json j;
  const auto add = [&](const char* name, const std::function<json(const lem::Slice&)>& get) {
    json list = json::array();
    for (const lem::Slice& s : cut.slices) list.push_back(get(s));
    j[name] = std::move(list);
  };
  add("left", [](const auto& s) { return json(s.left); });
  add("right", [](const auto& s) { return json(s.right); });
  add("base_left", [](const auto& s) { return to_json(s.base_left); });
  add("base_right", [](const auto& s) { return to_json(s.base_right); });
  add("top_left", [](const auto& s) { return json(s.top_left); });
  add("top_right", [](const auto& s) { return json(s.top_right); });
  add("soil", [&](const auto& s) { return json(slope.section().soils.at(static_cast<std::size_t>(s.soil)).name); });
  const std::pair<const char*, double lem::Slice::*> numbers[] = {
      {"alpha", &lem::Slice::alpha},
      {"length", &lem::Slice::length},
      {"weight", &lem::Slice::weight},
      {"surface_load", &lem::Slice::surface_load},
      {"surface_thrust", &lem::Slice::surface_thrust},
      {"earthquake", &lem::Slice::earthquake},
      {"pore_pressure", &lem::Slice::pore_pressure},
      {"cohesion", &lem::Slice::cohesion},
      {"root_cohesion", &lem::Slice::root_cohesion},
      {"suction_strength", &lem::Slice::suction_strength},
      {"tan_friction", &lem::Slice::tan_friction},
      {"normal", &lem::Slice::normal},
      {"shear", &lem::Slice::shear},
      {"m_alpha", &lem::Slice::m_alpha},
      {"normal_right", &lem::Slice::normal_right},
      {"shear_right", &lem::Slice::shear_right},
      {"thrust_right", &lem::Slice::thrust_right},
  };
  for (const auto& [name, member] : numbers)
    add(name, [member = member](const lem::Slice& s) { return json(s.*member); });
  return j;
}

json describe_circle(const lem::Surface& surface) {
  if (!surface.circle) return nullptr;
  return {{"centre", to_json(surface.circle->centre)}, {"radius", surface.circle->radius}};
}

}  // namespace

std::vector<lem::Point> list_points(const lem::CutSurface& cut) {
  std::vector<lem::Point> points;
  for (const lem::Slice& s : cut.slices) {
    if (points.empty()) points.push_back(s.base_left);
    points.push_back(s.base_right);
  }
  return points.empty() ? cut.surface.line : points;
}

json to_short_json(const lem::Critical& c) {
  json j{{"method", lem::name_method(c.method)},
         {"title", lem::title_method(c.method)},
         {"circular", c.surface.circle.has_value()},
         {"factor", c.solution.factor > 0 ? json(c.solution.factor) : json(nullptr)},
         {"circle", describe_circle(c.surface)},
         {"points", to_json(list_points(c.cut))}};
  if (!c.surface.name.empty()) j["name"] = c.surface.name;
  return j;
}

json to_json(const lem::Slope& slope, const lem::Critical& c) {
  json j = to_short_json(c);
  const bool has_lambda = c.method == lem::Method::spencer || c.method == lem::Method::morgenstern_price ||
                          c.method == lem::Method::morgenstern_price_constant;
  j["lambda"] = has_lambda ? json(c.solution.lambda) : json(nullptr);
  j["correction"] = c.solution.correction;
  j["area"] = c.cut.area;
  j["depth"] = c.cut.depth;
  j["volume_note"] = "m³ per metre of slope";
  j["slides_left"] = c.cut.slides_left;
  j["yield_acceleration"] = c.yield_acceleration ? json(*c.yield_acceleration) : json(nullptr);
  const lem::Refusal refusal = c.cut.refusal != lem::Refusal::none ? c.cut.refusal : c.solution.refusal;
  j["checks"] = {{"smallest_m_alpha", c.solution.smallest_m_alpha},
                 {"tensile_share", c.solution.tensile_share},
                 {"thrust_outside", c.solution.thrust_outside},
                 {"refusal", refusal == lem::Refusal::none ? "" : lem::name_refusal(refusal)}};
  j["slices"] = list_slices(slope, c.cut);
  j["warnings"] = c.warnings;
  return j;
}

json describe_search(const lem::SearchOptions& options, const lem::SearchResult& result) {
  json refused = json::object(), ranges = json::object();
  for (std::size_t m = 0; m < result.refused.size(); ++m) {
    json counts = json::object();
    for (const auto& [why, count] : result.refused[m]) counts[lem::name_refusal(why)] = count;
    refused[lem::name_method(options.methods[m])] = std::move(counts);
  }
  if (const auto& e = result.entry_exit; e && options.kind == lem::SearchKind::entry_exit) {
    ranges["exit"] = {e->exit[0], e->exit[1]};
    ranges["entry"] = {e->entry[0], e->entry[1]};
    ranges["exits"] = e->exits;
    ranges["entries"] = e->entries;
    ranges["depths"] = e->depths;
  }
  if (const auto& g = result.grid; g && options.kind == lem::SearchKind::grid) {
    ranges["grid"] = {{"from", to_json(g->from)}, {"to", to_json(g->to)}, {"columns", g->columns},
                      {"rows", g->rows},          {"radii", g->radii},    {"levels", nullptr}};
    if (g->lowest && g->highest) ranges["grid"]["levels"] = {*g->lowest, *g->highest};
  }
  return {{"kind", options.kind == lem::SearchKind::grid ? "grid" : "entry_exit"},
          {"tried", result.tried},
          {"refused", refused},
          {"limit_hits", result.limit_hits},
          {"ranges", ranges},
          {"seconds", result.seconds},
          {"circles_per_second", result.seconds > 0 ? static_cast<double>(result.tried) / result.seconds : 0}};
}

json describe_trials(const lem::SearchOptions& options, const lem::SearchResult& result) {
  json names = json::array(), trials = json::array(), maps = json::object();
  for (const lem::Method m : options.methods) names.push_back(lem::name_method(m));
  for (const lem::Trial& t : result.trials) {
    if (!t.surface.circle) continue;
    json row{round_to(t.surface.circle->centre[0], 1e4), round_to(t.surface.circle->centre[1], 1e4),
             round_to(t.surface.circle->radius, 1e4), round_to(t.surface.from, 1e4), round_to(t.surface.to, 1e4)};
    for (const float f : t.factors) row.push_back(round_to(f, 1e4));
    trials.push_back(std::move(row));
  }
  for (std::size_t m = 0; m < result.maps.size(); ++m) {
    const auto& map = result.maps[m];
    json factors = json::array();
    for (const float f : map.factor) factors.push_back(std::isfinite(f) ? json(round_to(f, 1e4)) : json(nullptr));
    maps[lem::name_method(options.methods[m])] = {{"from", to_json(map.from)},
                                                  {"to", to_json(map.to)},
                                                  {"columns", map.columns},
                                                  {"rows", map.rows},
                                                  {"factor", std::move(factors)}};
  }
  return {{"methods", std::move(names)}, {"trials", std::move(trials)}, {"maps", std::move(maps)}};
}

}  // namespace talus::run
