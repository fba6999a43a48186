// SPDX-License-Identifier: MIT
// Mesh preview of the picture of a case.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/numbers.hpp"
#include "mesh/generate.hpp"
#include "run/common/mesh_estimate.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/picture_parts.hpp"
#include "site/site.hpp"

namespace talus::run {
namespace {

using Point = results::Point;
using Polyline = std::vector<Point>;
using Picture = output::CasePicture;

/// Largest mesh that is drawn, and largest file of a ready mesh that is read.
constexpr double most_elements = 15000;
constexpr std::uintmax_t most_mesh_bytes = 20'000'000;

/// Joins sides of elements to lines.
std::vector<Polyline> join(const mesh::Mesh<2>& mesh, const std::vector<std::array<int, 2>>& sides) {
  std::multimap<int, std::size_t> at;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (const int node : sides[i]) at.emplace(node, i);
  std::vector<bool> used(sides.size());
  const auto find_next = [&](int node) {
    for (auto [it, end] = at.equal_range(node); it != end; ++it)
      if (!used[it->second]) return it->second;
    return sides.size();
  };
  std::vector<Polyline> lines;
  const auto walk = [&](std::size_t start, int first) {
    Polyline line{mesh.nodes[static_cast<std::size_t>(first)]};
    int node = first;
    for (std::size_t side = start; side < sides.size(); side = find_next(node)) {
      used[side] = true;
      node = sides[side][0] == node ? sides[side][1] : sides[side][0];
      line.push_back(mesh.nodes[static_cast<std::size_t>(node)]);
    }
    lines.push_back(std::move(line));
  };
  for (std::size_t i = 0; i < sides.size(); ++i)  // ends of open lines first
    for (const int node : sides[i])
      if (!used[i] && at.count(node) == 1) walk(i, node);
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (!used[i]) walk(i, sides[i][0]);
  return lines;
}

void draw_mesh(const mesh::Mesh<2>& mesh, Picture& picture) {
  std::map<std::array<int, 2>, bool> sides;  // → soil on either side
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.elements[e][k], b = mesh.elements[e][(k + 1) % 3];
      bool& has_soil = sides[{std::min(a, b), std::max(a, b)}];
      has_soil = has_soil || mesh.element_region[e] != mesh::empty_region;
    }
  for (const auto& [nodes, has_soil] : sides)
    (has_soil ? picture.soil_sides : picture.empty_sides)
        .push_back({mesh.nodes[static_cast<std::size_t>(nodes[0])], mesh.nodes[static_cast<std::size_t>(nodes[1])]});
}

/// Returns the number of elements with soil.
std::size_t count_soil(const mesh::Mesh<2>& mesh) {
  return static_cast<std::size_t>(
      std::ranges::count_if(mesh.element_region, [](int region) { return region != mesh::empty_region; }));
}

std::string write_points(const input::Case& data, std::size_t soil) {
  if (!input::uses(data, input::Method::mpm)) return "";
  return fmt::format(", {} material points", soil * static_cast<std::size_t>(data.points_per_element));
}

void add_ready_mesh(PictureSource& source, Picture& picture) {
  const mesh::Mesh<2> mesh = mesh::generate<2>(source.data.mesh);
  const double longest_list = most_elements * 4;
  for (const auto& [name, sides] : mesh.sides) {
    const std::vector<Polyline> lines = join(mesh, sides);
    for (const Polyline& line : lines)
      if (line.size() > source.mesh_sides[name].size()) source.mesh_sides[name] = line;
  }
  for (std::size_t r = 0; r < mesh.region_names.size(); ++r) {
    std::map<std::array<int, 2>, int> count;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      if (mesh.element_region[e] != static_cast<int>(r)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = mesh.elements[e][k], b = mesh.elements[e][(k + 1) % 3];
        ++count[{std::min(a, b), std::max(a, b)}];
      }
    }
    std::vector<std::array<int, 2>> outer;
    for (const auto& [side, n] : count)
      if (n == 1) outer.push_back(side);
    const auto material = source.data.regions.find(mesh.region_names[r]);
    for (const Polyline& outline : join(mesh, outer))
      picture.soils.push_back(
          {mesh.region_names[r], material == source.data.regions.end() ? "" : material->second, outline});
  }
  picture.notes.push_back(fmt::format("Mesh '{}': {} elements, {} of them with soil{}.", source.data.mesh.file,
                                      mesh.elements.size(), count_soil(mesh),
                                      write_points(source.data, count_soil(mesh))));
  if (static_cast<double>(mesh.elements.size()) <= longest_list) draw_mesh(mesh, picture);
}

/// Writes a large number with two significant digits: "21000".
std::string write_rounded(double number) {
  constexpr double most = 1e15;
  return number < most ? fmt::format("{:.0f}", round_to_digits(number, 2)) : format_significant(number, 2);
}

std::string describe_estimate(const PictureSource& source, const mesh::Plan& plan, const char* method) {
  const ElementCount count = count_elements(plan);
  if (!(count.soil > 0) || !std::isfinite(count.soil)) return "";
  std::string text = fmt::format("{}: elements of {}, about {} with soil", method,
                                 format_value(plan.size, source.data.units().length, 3), write_rounded(count.soil));
  if (std::string_view(method) == "MPM")
    text += fmt::format(", about {} material points", write_rounded(count.soil * source.data.points_per_element));
  return text + " (estimated).";
}

}  // namespace

/// Adds the mesh of MPM, or else that of FEM, if it is made in a moment; describes the others.
void add_meshes(PictureSource& source, Picture& picture) {
  if (!source.data.mesh.file.empty()) {
    std::error_code fault;
    const auto bytes = std::filesystem::file_size(source.data.mesh.file, fault);
    if (fault || bytes > most_mesh_bytes) return;
    try {
      add_ready_mesh(source, picture);
    } catch (const Error&) {  // `talus check` reports the fault of the file
    }
    return;
  }
  const bool has_points = input::uses(source.data, input::Method::mpm),
             has_elements = input::uses(source.data, input::Method::fem);
  const auto add = [&](const mesh::Plan& plan, const char* method, bool is_drawn) {
    if (is_drawn && !source.is_faulty && is_meshed_in_a_moment(plan) && count_elements(plan).all <= most_elements) {
      try {
        const mesh::Mesh<2> mesh = mesh::generate<2>(plan);
        const std::size_t soil = count_soil(mesh);
        const bool is_background = std::string_view(method) == "MPM";  // FEM has no elements without soil
        draw_mesh(mesh, picture);
        if (!is_background) picture.empty_sides.clear();
        picture.notes.push_back(fmt::format(
            "{}: elements of {}, {} with soil{}.", method, format_value(plan.size, source.data.units().length, 3), soil,
            is_background ? fmt::format(" of {} in the box{}", mesh.elements.size(), write_points(source.data, soil))
                          : ""));
        return;
      } catch (const Error&) {  // the run reports what the mesh generator refuses; the estimate remains
      }
    }
    if (const std::string text = describe_estimate(source, plan, method); !text.empty()) picture.notes.push_back(text);
  };
  if (has_points && source.data.mesh.size > 0) add(source.data.mesh, "MPM", true);
  if (has_elements && (source.data.mesh.size > 0 || source.data.fem.size)) {
    mesh::Plan plan = mesh::resize(source.data.mesh, source.data.fem.size.value_or(source.data.mesh.size));
    try {
      if (!source.is_faulty && !source.ground.empty()) plan = make_fem_plan(site::Site(source.data));
    } catch (const Error&) {  // the plan without corners at loads has nearly as many elements
    }
    add(plan, "FEM", !has_points);
  }
  if (input::uses(source.data, input::Method::bounds))
    picture.notes.push_back(fmt::format("Limit analysis: at most {} triangles, refined during the calculation.",
                                        source.data.bounds.triangles));
}

}  // namespace talus::run
