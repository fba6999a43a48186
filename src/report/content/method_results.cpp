// SPDX-License-Identifier: MIT
#include "report/content/method_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/user_file.hpp"
#include "report/words/numbers.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Returns null for 0, the value of rejected surfaces.
json write_factor(const std::optional<double>& factor) {
  return factor.value_or(0) > 0 ? json(*factor) : json();
}

json take_number(const std::optional<double>& number) {
  return number ? json(*number) : json();
}

json list_numbers(const std::vector<std::optional<double>>& numbers) {
  json list = json::array();
  for (const std::optional<double>& number : numbers) list.push_back(take_number(number));
  return list;
}

json take_surface(const results::CriticalSurface& found, const char* kind, bool governs) {
  const results::SlipSurface& surface = found.surface;
  const results::SurfaceChecks& checks = found.checks;
  json taken{{"kind", kind},
             {"name", surface.name.value_or("")},
             {"method", results::to_word(surface.method)},
             {"title", surface.title},
             {"factor", write_factor(surface.factor)},
             {"lambda", is_rigorous(surface.method) ? take_number(found.lambda) : json()},
             {"correction", found.correction},
             {"points", surface.points},
             {"area", found.area},
             {"depth", found.depth},
             {"yield_acceleration", take_number(found.yield_acceleration)},
             {"checks",
              {{"smallest_m_alpha", checks.smallest_m_alpha},
               {"tensile_share", keep_finite(checks.tensile_share)},
               {"thrust_outside", keep_finite(checks.thrust_outside)},
               {"refusal", checks.refusal}}},
             {"warnings", found.warnings},
             {"governs", governs}};
  if (const auto& drawn = found.drawdown)
    taken["drawdown"] = {{"factor_before", write_factor(drawn->factor_before)},
                         {"undrained_factor", write_factor(drawn->undrained_factor)},
                         {"normal", drawn->normal},
                         {"shear", drawn->shear},
                         {"strength", list_numbers(drawn->strength)}};
  if (surface.circle) taken["circle"] = results::to_json(*surface.circle);
  if (found.slices.size() > 0) taken["slices"] = results::to_json(found.slices);
  return taken;
}

json list_minima(const results::SliceResult& lem) {
  json list = json::array();
  for (const auto& [method, surfaces] : lem.minima)
    for (const results::SlipSurface& m : surfaces) {
      json taken{{"method", method}, {"factor", m.factor.value_or(0)}, {"points", m.points}};
      if (m.circle) taken["circle"] = results::to_json(*m.circle);
      list.push_back(std::move(taken));
    }
  return list;
}

json take_search(const results::SliceSearch& search) {
  json refused = json::array(), limit_hits = json::array();
  for (const auto& [method, reasons] : search.refused) {
    json list = json::array();
    for (const auto& [reason, count] : reasons) list.push_back({{"reason", reason}, {"count", count}});
    refused.push_back({{"method", method}, {"reasons", list}});
  }
  for (const results::LimitHit& hit : search.limit_hits)
    limit_hits.push_back(fmt::format("{}: {}", hit.method, hit.limit));
  json taken{{"kind", results::to_word(search.kind)},
             {"tried", search.tried},
             {"refused", refused},
             {"limit_hits", limit_hits},
             {"circles_per_second", search.circles_per_second}};
  const results::SearchRanges& ranges = search.ranges;
  if (ranges.exit) taken["exit"] = *ranges.exit;
  if (ranges.entry) taken["entry"] = *ranges.entry;
  if (ranges.grid) taken["grid"] = {ranges.grid->from, ranges.grid->to};
  return taken;
}

json pack_trials(const results::SliceTrials& file, Packer& packer) {
  const std::size_t methods = file.methods.size(), count = file.trials.size();
  if (count == 0 || methods == 0) return {};
  std::vector<double> circles, factors;
  for (const std::vector<double>& trial : file.trials) {
    if (trial.size() < 5 + methods) throw Error(ExitCode::wrong_input, "a trial is shorter than the others");
    circles.insert(circles.end(), trial.begin(), trial.begin() + 5);
    for (std::size_t k = 0; k < methods; ++k) factors.push_back(keep_finite(trial[5 + k]));
  }
  return {{"count", count},
          {"methods", file.methods},
          {"circles", packer.add_places("lem.circles", circles, {count, 5})},
          {"factors", packer.add_reals("lem.factors", factors, {count, methods})}};
}

json pack_maps(const results::SliceTrials& file, Packer& packer) {
  json list = json::array();
  for (const auto& [method, map] : file.maps) {
    const auto columns = static_cast<std::size_t>(map.columns), rows = static_cast<std::size_t>(map.rows);
    if (columns * rows == 0 || map.factor.size() != columns * rows) continue;
    std::vector<double> factors;
    for (const std::optional<double>& v : map.factor) factors.push_back(v.value_or(0));
    list.push_back({{"method", method},
                    {"from", map.from},
                    {"to", map.to},
                    {"columns", columns},
                    {"rows", rows},
                    {"factor", packer.add_reals("lem.map." + method, factors, {rows, columns})}});
  }
  return list;
}

}  // namespace

json make_slices(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.slices) return {};
  const results::SliceResult& lem = *folder.run.slices;
  json surfaces = json::array(), methods = json::array();
  std::map<SliceMethod, std::string> titles;
  const auto governing = results::find_governing_surface(folder.run);
  static const std::vector<results::CriticalSurface> none;
  for (const auto& [kind, list] :
       {std::pair{"circle", &lem.critical}, std::pair{"polyline", &lem.noncircular}, std::pair{"given", &lem.given},
        std::pair{"optimised", folder.run.methods ? &folder.run.methods->optimised : &none}})
    for (const results::CriticalSurface& found : *list) {
      surfaces.push_back(take_surface(found, kind, governing && governing->found == &found));
      titles[found.surface.method] = found.surface.title;
    }
  for (const SliceMethod method : lem.methods) {
    const std::string name = results::to_word(method);
    methods.push_back({{"name", name}, {"title", titles.contains(method) ? titles[method] : name}});
  }
  json slices{{"methods", methods},   {"slice_count", lem.slices},  {"seconds", lem.seconds},
              {"surfaces", surfaces}, {"minima", list_minima(lem)}, {"maps", json::array()}};
  if (lem.drawdown) slices["drawdown"] = get_title(*lem.drawdown);
  if (lem.error) slices["error"] = *lem.error;
  if (lem.search) slices["search"] = take_search(*lem.search);
  try {
    const auto file =
        results::read_file<results::SliceFile>(join_name(folder.path, lem.trials_file.value_or("lem.json")));
    if (!file || !file->trials) return slices;
    if (json trials = pack_trials(*file->trials, packer); !trials.is_null()) slices["trials"] = std::move(trials);
    slices["maps"] = pack_maps(*file->trials, packer);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The trial surfaces are not shown: {}", error.what()));
  }
  return slices;
}

using nlohmann::json;

namespace {

/// Limit on the mesh in the report; a finer mesh would dominate the file size and could not be resolved on the page.
constexpr std::size_t most_field_elements = 60000;
constexpr std::size_t corners_per_element = 6;

json take_factor(double factor) {
  return factor > 0 ? json(factor) : json();
}

json take_trials(std::vector<results::ElementTrial> trials) {
  std::stable_sort(trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.factor < b.factor; });
  json list = json::array();
  for (const results::ElementTrial& trial : trials)
    list.push_back({{"factor", trial.factor},
                    {"converged", trial.converged},
                    {"iterations", trial.iterations},
                    {"force_residual", keep_finite(trial.force_residual)},
                    {"displacement_residual", keep_finite(trial.displacement_residual)},
                    {"displacement", keep_finite(trial.displacement)},
                    {"seconds", trial.seconds}});
  return list;
}

json take_run(const results::ElementRun& run) {
  json taken{{"flow", results::to_word(run.flow)},
             {"title", run.flow == results::Flow::associated ? "associated flow, ψ = φ" : "ψ as given"},
             {"psi", run.psi},
             {"trials", take_trials(run.trials)},
             {"slip_lines", json::array()},
             {"warnings", run.warnings},
             {"factor", take_factor(run.factor)},
             {"stable", take_factor(run.stable)},
             {"failed", take_factor(run.failed)},
             {"by_displacement", take_factor(run.by_displacement.value_or(0))},
             {"lower", run.interval ? json(results::show_lower(run.interval->lower)) : json()},
             {"upper", run.interval ? json(results::show_upper(run.interval->upper)) : json()}};
  if (run.sides)
    for (const results::SideLine& side : *run.sides) taken["slip_lines"].push_back(side.points);
  else if (!run.slip_line.empty())
    taken["slip_lines"].push_back(run.slip_line);
  return taken;
}

/// Returns the limits of the colour scale from 0 to the 99th percentile of the nodal shear strain.
std::vector<double> find_strain_scale(std::vector<double> strain) {
  if (strain.empty()) return {0, 1};
  const auto at = strain.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(strain.size() - 1));
  std::nth_element(strain.begin(), at, strain.end());
  return {0, *at > 0 ? *at : 1};
}

/// Concatenates `rows`; throws Error (wrong_input) if a row has not the length `width`.
template <class T, class To>
std::vector<To> join_rows(const std::vector<std::vector<T>>& rows, std::size_t width) {
  std::vector<To> values;
  values.reserve(rows.size() * width);
  for (const std::vector<T>& row : rows) {
    if (row.size() != width)
      throw Error(ExitCode::wrong_input, fmt::format("a row has {} numbers instead of {}", row.size(), width));
    for (const T& value : row) values.push_back(static_cast<To>(value));
  }
  return values;
}

/// Packs the mesh; returns null if it cannot be drawn.
json pack_mesh(const results::ElementMesh& file, Packer& packer) {
  const std::size_t nodes = file.nodes.size(), elements = file.elements.size();
  if (nodes == 0 || elements == 0 || elements > most_field_elements || file.nodes[0].size() != 2 ||
      file.elements[0].size() != corners_per_element)
    return {};
  const auto cells = join_rows<int, std::uint32_t>(file.elements, corners_per_element);
  for (const std::uint32_t node : cells)
    if (node >= nodes)
      throw Error(ExitCode::wrong_input, fmt::format("an element names the node {} of {}", node, nodes));
  return {{"nodes", packer.add_places("fem.nodes", join_rows<double, double>(file.nodes, 2), {nodes, 2})},
          {"elements", packer.add_numbers("fem.elements", cells, {elements, corners_per_element}, true)}};
}

/// Packs the fields of one strength reduction; returns null if the file has none for this mesh.
json pack_fields(const results::ElementMesh& file, results::Flow flow, Packer& packer) {
  const std::size_t nodes = file.nodes.size(), elements = file.elements.size();
  for (const results::ElementFields& fields : file.runs) {
    if (fields.flow != flow || fields.displacement.size() != nodes || fields.shear_strain.size() != nodes ||
        fields.yields.size() != elements)
      continue;
    const std::string id = fmt::format("fem.{}", results::to_word(flow));
    const auto displacement = join_rows<double, double>(fields.displacement, 2);
    const std::vector<std::uint8_t> yields(fields.yields.begin(), fields.yields.end());
    return {{"displacement", packer.add_values(id + ".displacement", displacement, {nodes, 2}, false)},
            {"shear_strain", packer.add_values(id + ".shear_strain", fields.shear_strain, {nodes}, false)},
            {"strain_scale", find_strain_scale(fields.shear_strain)},
            {"yields", packer.add_bytes(id + ".yields", yields, {elements})}};
  }
  return {};
}

}  // namespace

json make_finite_elements(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.elements) return {};
  const results::ElementResult& fem = *folder.run.elements;
  json block{{"element", fem.element.empty() ? "T6" : fem.element},
             {"elements", fem.elements},
             {"nodes", fem.nodes},
             {"unknowns", fem.unknowns},
             {"size", fem.size},
             {"seconds", fem.seconds.value_or(0)},
             {"runs", json::array()}};
  if (fem.error) block["error"] = *fem.error;
  for (const results::ElementRun& run : fem.runs) block["runs"].push_back(take_run(run));
  try {
    const auto file = results::read_file<results::ElementFile>(
        join_name(folder.path, fem.fields_file.empty() ? "fem.json" : fem.fields_file));
    json mesh = file ? pack_mesh(file->mesh, packer) : json();
    if (mesh.is_null()) return block;
    block["mesh"] = std::move(mesh);
    for (std::size_t i = 0; i < fem.runs.size(); ++i)
      if (json fields = pack_fields(file->mesh, fem.runs[i].flow, packer); !fields.is_null())
        block["runs"][i]["fields"] = std::move(fields);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The finite elements are not drawn: {}", error.what()));
  }
  return block;
}

using nlohmann::json;

namespace {

/// Limit on the mesh in the report; a finer mesh would dominate the file size and could not be resolved on the page.
constexpr std::size_t most_field_triangles = 60000;
constexpr std::size_t components = 3;  ///< xx, yy, xy

json write_lower(std::optional<double> value) {
  return value ? json(results::show_lower(*value)) : json();
}
json write_upper(std::optional<double> value) {
  return value ? json(results::show_upper(*value)) : json();
}

std::vector<double> join_places(const std::vector<results::Point>& places) {
  std::vector<double> values;
  values.reserve(2 * places.size());
  for (const results::Point& x : places) values.insert(values.end(), {x[0], x[1]});
  return values;
}

/// Concatenates `width` node numbers of each triangle; throws Error (wrong_input) for an invalid node number.
std::vector<std::uint32_t> join_triangles(const std::vector<std::vector<int>>& triangles, std::size_t width,
                                          std::size_t nodes) {
  std::vector<std::uint32_t> values;
  values.reserve(width * triangles.size());
  for (const std::vector<int>& triangle : triangles) {
    if (triangle.size() != width)
      throw Error(ExitCode::wrong_input, fmt::format("a triangle has {} nodes instead of {}", triangle.size(), width));
    for (const int node : triangle) {
      if (node < 0 || static_cast<std::size_t>(node) >= nodes)
        throw Error(ExitCode::wrong_input, fmt::format("a triangle names the node {} of {}", node, nodes));
      values.push_back(static_cast<std::uint32_t>(node));
    }
  }
  return values;
}

bool can_be_drawn(std::size_t triangles, std::size_t values) {
  return triangles > 0 && triangles <= most_field_triangles && values == triangles;
}

/// Packs the stress field of the lower bound, averaged over each triangle.
json pack_holding(const results::HoldingField& field, Packer& packer) {
  const std::size_t triangles = field.triangles.size();
  if (!can_be_drawn(triangles, field.utilisation.size()) || field.stress.size() != triangles) return {};
  std::vector<double> stress;
  for (const std::vector<double>& corners : field.stress) {
    if (corners.size() != 3 * components)
      throw Error(ExitCode::wrong_input, fmt::format("the stresses of a triangle have {} numbers", corners.size()));
    for (std::size_t d = 0; d < components; ++d)
      stress.push_back((corners[d] + corners[components + d] + corners[2 * components + d]) / 3);
  }
  return {
      {"nodes", packer.add_places("bounds.holds.nodes", join_places(field.nodes), {field.nodes.size(), 2})},
      {"triangles", packer.add_numbers("bounds.holds.triangles", join_triangles(field.triangles, 3, field.nodes.size()),
                                       {triangles, 3}, true)},
      {"stress", packer.add_values("bounds.holds.stress", stress, {triangles, components}, false)},
      {"utilisation", packer.add_values("bounds.holds.utilisation", field.utilisation, {triangles}, false)}};
}

/// Packs the velocity field of the upper bound.
json pack_moving(const results::MovingField& field, Packer& packer) {
  constexpr std::size_t nodes_of_triangle = 6;
  const std::size_t triangles = field.triangles.size(), nodes = field.nodes.size();
  if (!can_be_drawn(triangles, field.shear_rate.size()) || field.velocity.size() != nodes) return {};
  return {{"nodes", packer.add_places("bounds.moves.nodes", join_places(field.nodes), {nodes, 2})},
          {"triangles",
           packer.add_numbers("bounds.moves.triangles", join_triangles(field.triangles, nodes_of_triangle, nodes),
                              {triangles, nodes_of_triangle}, true)},
          {"velocity", packer.add_values("bounds.moves.velocity", join_places(field.velocity), {nodes, 2}, false)},
          {"shear_rate", packer.add_values("bounds.moves.shear_rate", field.shear_rate, {triangles}, false)}};
}

}  // namespace

json make_proven_bounds(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.bounds) return {};
  const results::BoundsResult& bounds = *folder.run.bounds;
  json block{{"lower", write_lower(bounds.lower)},
             {"upper", write_upper(bounds.upper)},
             {"no_lower", bounds.no_lower},
             {"no_upper", bounds.no_upper},
             {"asked_gap", bounds.asked_gap},
             {"is_davis", bounds.is_davis},
             {"takes_tension", bounds.takes_tension},
             {"seconds", bounds.seconds.value_or(0)},
             {"meshes", json::array()},
             {"slip_lines", json::array()}};
  if (bounds.error) block["error"] = *bounds.error;
  for (const results::BoundsMesh& mesh : bounds.meshes)
    block["meshes"].push_back({{"triangles", mesh.triangles},
                               {"lower", write_lower(mesh.lower)},
                               {"upper", write_upper(mesh.upper)},
                               {"programs", mesh.programs},
                               {"iterations", mesh.iterations},
                               {"seconds", mesh.seconds}});
  if (bounds.sides)
    for (const results::SideLine& side : *bounds.sides) block["slip_lines"].push_back(side.points);
  if (bounds.fields_file.empty()) return block;
  try {
    const auto file = results::read_file<results::BoundsFile>(join_name(folder.path, bounds.fields_file));
    if (!file) return block;
    if (json field = pack_holding(file->holds, packer); !field.is_null()) block["holds"] = std::move(field);
    if (json field = pack_moving(file->moves, packer); !field.is_null()) block["moves"] = std::move(field);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The fields of the proven bounds are not drawn: {}", error.what()));
  }
  return block;
}

}  // namespace talus::report
