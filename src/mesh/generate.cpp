// SPDX-License-Identifier: MIT
#include "mesh/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "mesh/gmsh_mesh.hpp"
#include "mesh/gmsh_module.hpp"
#include "mesh/plan.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {
namespace {

/// Returns the innermost polygon around a point: a lens replaces the polygon that contains it.
int find_region(const Plan& plan, const Point2& x) {
  int region = empty_region;
  double smallest = 0;
  for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
    const auto& corners = plan.polygons[i].points;
    const double area = std::abs(compute_area(corners));
    if (is_inside(x, corners) && (region == empty_region || area < smallest)) {
      region = static_cast<int>(i);
      smallest = area;
    }
  }
  return region;
}

template <int D>
std::vector<std::string> find_sides(const Plan& plan, const std::array<double, 3>& x) {
  const double near = get_tolerance(plan);
  std::vector<std::string> names;
  const auto add = [&](const char* name, double value, double wall) {
    if (std::abs(value - wall) <= near) names.emplace_back(name);
  };
  add("left", x[0], plan.box_min[0]);
  add("right", x[0], plan.box_max[0]);
  add("bottom", x[1], plan.box_min[1]);
  add("top", x[1], plan.box_max[1]);
  if constexpr (D == 3) {
    add("front", x[2], 0);
    add("back", x[2], plan.thickness);
  }
  for (const Line& l : plan.lines)
    if (compute_distance({x[0], x[1]}, l.points) <= near) names.push_back(l.name);
  return names;
}

/// Moves nodes at sides and corners exactly onto them, because the geometry kernel is accurate to 1e-7 m only.
template <int D>
void put_in_place(Mesh<D>& mesh, const Plan& plan) {
  const double near = get_tolerance(plan);
  Polyline corners;
  for (const Polygon& p : plan.polygons) corners.insert(corners.end(), p.points.begin(), p.points.end());
  for (const Line& l : plan.lines) corners.insert(corners.end(), l.points.begin(), l.points.end());
  for (auto& x : mesh.nodes) {
    for (const Point2& c : corners)
      if (std::hypot(x[0] - c[0], x[1] - c[1]) <= near) {
        x[0] = c[0];
        x[1] = c[1];
      }
    for (int d = 0; d < D; ++d)
      for (double wall : {d == 2 ? 0 : plan.box_min[d], d == 2 ? plan.thickness : plan.box_max[d]})
        if (std::abs(x[d] - wall) <= near) x[d] = wall;
  }
}

/// Rounds x to `digits` decimals.
double round_decimal(double x, int digits) {
  const double unit = std::pow(10.0, digits);
  return std::round(x * unit) / unit;
}

/// Returns the decimals for ten significant digits of a number as large as `size`.
int count_digits(double size) {
  return 9 - static_cast<int>(std::floor(std::log10(size)));
}

/// Returns the decimals to which the coordinates of a plan are rounded; the geometry kernel merges points within 1e-7
/// m.
int count_digits(const Plan& plan) {
  return std::max(7, count_digits(std::max(plan.box_max[0] - plan.box_min[0], plan.box_max[1] - plan.box_min[1])));
}

/// Returns the plan with the lower left corner of its box at the origin and rounded coordinates: the same section then
/// has the same mesh at any position and in any unit of length. Without rounding, differences of map coordinates, or
/// feet, differ in the last digits, and Gmsh makes another mesh.
Plan make_local(const Plan& given) {
  Plan plan = given;
  const Point2 origin = given.box_min;
  const int digits = count_digits(given);
  const auto shift = [&](Point2& x) {
    x = {round_decimal(x[0] - origin[0], digits), round_decimal(x[1] - origin[1], digits)};
  };
  const auto shift_all = [&](Polyline& points) { std::for_each(points.begin(), points.end(), shift); };
  const auto round_length = [](double& x) { x = round_decimal(x, count_digits(x)); };
  for (Polygon& p : plan.polygons) shift_all(p.points);
  for (Line& l : plan.lines) shift_all(l.points);
  round_length(plan.size);
  if (plan.dimension == 3) round_length(plan.thickness);
  for (Refinement& r : plan.refinements) {
    shift_all(r.near);
    round_length(r.size);
    round_length(r.distance);
  }
  shift(plan.box_max);
  plan.box_min = {0, 0};
  return plan;
}

/// Returns the plan in canonical order: counter-clockwise polygons from their leftmost corner, lines from left to
/// right, both sorted by these points. Gmsh's mesh depends on the order of its input.
Plan put_in_order(Plan plan) {
  for (Polygon& p : plan.polygons) {
    if (compute_area(p.points) < 0) std::reverse(p.points.begin(), p.points.end());
    std::rotate(p.points.begin(), std::min_element(p.points.begin(), p.points.end()), p.points.end());
  }
  for (Line& l : plan.lines)
    if (l.points.back() < l.points.front()) std::reverse(l.points.begin(), l.points.end());
  const auto by_points = [](const auto& a, const auto& b) { return a.points < b.points; };
  std::stable_sort(plan.polygons.begin(), plan.polygons.end(), by_points);
  std::stable_sort(plan.lines.begin(), plan.lines.end(), by_points);
  return plan;
}

/// Returns the mirror image of a local plan about the middle of its box; the sides of the box keep their names.
Plan reflect(Plan plan) {
  const int digits = count_digits(plan);
  const auto turn = [&](Polyline& points) {
    for (Point2& x : points) x[0] = round_decimal(plan.box_max[0] - x[0], digits);
  };
  for (Polygon& p : plan.polygons) turn(p.points);
  for (Line& l : plan.lines) turn(l.points);
  for (Refinement& r : plan.refinements) turn(r.near);
  return plan;
}

/// Returns the first moment of the soil about the middle of the box, over that of one full half of the box [-]:
/// positive where the ground rises to the right.
double measure_lean(const Plan& plan) {
  const auto [width, height] = plan.box_max;
  double moment = 0;
  for (const Polygon& p : plan.polygons) {
    double own = 0;
    for (std::size_t i = 0; i < p.points.size(); ++i) {
      const Point2 &a = p.points[i], &b = p.points[(i + 1) % p.points.size()];
      own += (a[0] * b[1] - b[0] * a[1]) * ((a[0] + b[0]) / 3 - width / 2) / 2;
    }
    moment += compute_area(p.points) < 0 ? -own : own;
  }
  return moment / (width * width * height / 8);
}

/// Returns true if the mirror image of a local plan is meshed in its place, since Gmsh does not mirror its meshes: the
/// ground falls to the right in what is meshed. The coordinates decide where neither side has more soil.
bool is_reflected(const Plan& plan) {
  constexpr double least_lean = 1e-9;
  const double lean = measure_lean(plan);
  if (std::abs(lean) > least_lean) return lean > 0;
  const Plan here = put_in_order(plan), there = put_in_order(reflect(plan));
  const auto compare = [](const auto& a, const auto& b, const auto& get_points) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (get_points(a[i]) != get_points(b[i])) return get_points(a[i]) < get_points(b[i]) ? -1 : 1;
    return 0;
  };
  const auto get_points = [](const auto& item) -> const Polyline& { return item.points; };
  int order = compare(here.polygons, there.polygons, get_points);
  if (order == 0) order = compare(here.lines, there.lines, get_points);
  if (order == 0) order = compare(here.refinements, there.refinements, [](const Refinement& r) { return r.near; });
  return order > 0;
}

/// Returns a function of the module of Gmsh by its name. The library is loaded once in the process, and the children
/// have it.
template <class Function>
Function* load_gmsh(const std::string& name) {
  std::string why;
  void* function = load_module("libtalus_gmsh.so", name.c_str(), false, why);
  if (function == nullptr)
    throw Error(ExitCode::internal_error,
                "meshes are made by Gmsh in libtalus_gmsh.so, which is built with the program and is not beside it "
                "({})",
                why);
  return reinterpret_cast<Function*>(function);
}

template <int D>
using MeshPlan = void(const Plan&, const Naming&, Mesh<D>&, std::vector<Freedom<D>>&);
template <int D>
using ReadMesh = void(const std::string&, Mesh<D>&);

/// Meshes the plan, or its mirror image, whose mesh is mirrored and numbered; `reflected` says which.
template <int D>
Mesh<D> mesh_plan(MeshPlan<D>& mesh_by_gmsh, const Plan& checked, bool& reflected) {
  const Plan plan = make_local(checked);
  reflected = is_reflected(plan);
  const Plan meshed = reflected ? reflect(plan) : plan;
  const auto turn = [&](std::array<double, 3> x) {
    if (reflected) x[0] = plan.box_max[0] - x[0];
    return x;
  };
  Naming naming;
  naming.region = [&](int, const std::array<double, 3>& x) { return find_region(meshed, {x[0], x[1]}); };
  naming.sides = [&](int, const std::array<double, 3>& x) { return find_sides<D>(plan, turn(x)); };
  Mesh<D> mesh;
  std::vector<Freedom<D>> freedoms;
  mesh_by_gmsh(put_in_order(meshed), naming, mesh, freedoms);
  for (const Polygon& p : plan.polygons) mesh.region_names.push_back(p.name);
  raise_altitudes<D>(mesh, freedoms, [&](const auto& x) { return compute_size(meshed, {x[0], x[1]}); });
  if (reflected) {
    // The numbers are those of the mesh that Gmsh made, so that sums over nodes and elements run in the same order.
    finish(mesh);
    for (auto& x : mesh.nodes) x[0] = plan.box_max[0] - x[0];
  }
  for (auto& x : mesh.nodes)
    for (std::size_t d = 0; d < 2; ++d) x[d] += checked.box_min[d];
  put_in_place(mesh, checked);
  return mesh;
}

template <int D>
void write_mesh(const Mesh<D>& mesh, Message& message) {
  message.put_list(mesh.nodes);
  message.put_list(mesh.elements);
  message.put_list(mesh.element_region);
  message.put(mesh.region_names.size());
  for (const std::string& name : mesh.region_names) message.put_text(name);
  message.put(mesh.sides.size());
  for (const auto& [name, sides] : mesh.sides) {
    message.put_text(name);
    message.put_list(sides);
  }
}

/// Reads the output of write_mesh(). The output of the child process is validated; finish() checks the node numbers.
template <int D>
Mesh<D> read_mesh(Message& message) {
  Mesh<D> mesh;
  mesh.nodes = message.get_list<typename Mesh<D>::Point>();
  mesh.elements = message.get_list<typename Mesh<D>::Element>();
  mesh.element_region = message.get_list<int>();
  for (auto left = message.get<std::size_t>(); left > 0; --left) mesh.region_names.push_back(message.get_text());
  for (auto left = message.get<std::size_t>(); left > 0; --left) {
    const std::string name = message.get_text();
    mesh.sides[name] = message.get_list<typename Mesh<D>::Side>();
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (!std::ranges::all_of(mesh.nodes[i], [](double x) { return std::isfinite(x); }))
      fail_input("node {} of the mesh has no finite coordinates", i + 1);
  return mesh;
}

/// Checks that the whole box was meshed, because Gmsh does not always report a part that it leaves out.
template <int D>
void check_whole(const Mesh<D>& mesh, const Plan& plan) {
  const double box =
      (plan.box_max[0] - plan.box_min[0]) * (plan.box_max[1] - plan.box_min[1]) * (D == 3 ? plan.thickness : 1);
  const double meshed = std::accumulate(mesh.volumes.begin(), mesh.volumes.end(), 0.0);
  if (!(std::abs(meshed - box) < 1e-6 * box))
    fail_input(
        "Gmsh meshed {:.6g} of the box's {:.6g} {}: look for edges or lines that nearly touch, or ask for smaller "
        "elements",
        meshed, box, D == 2 ? "m²" : "m³");
}

/// Limits memory and time in proportion to the file size, because Gmsh allocates by the counts in a binary file's
/// header.
void limit_reading(const std::string& file) {
  constexpr double least_memory = 1e8, memory_per_byte = 40, least_seconds = 10, seconds_per_byte = 1e-6;
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  limit_memory(least_memory + memory_per_byte * size);
  limit_processor_time(least_seconds + seconds_per_byte * size);
}

}  // namespace

template <int D>
Mesh<D> generate(const Plan& plan) {
  if (plan.dimension != D)
    throw Error(ExitCode::internal_error, "a {}D plan was given to the {}D mesher", plan.dimension, D);
  const bool is_made = plan.file.empty();
  const Plan checked = is_made ? check_plan(plan) : plan;
  if (!is_made) check_mesh_file(plan.file);
  if (load_gmsh<decltype(talus_gmsh_layout)>("talus_gmsh_layout")() != gmsh_layout)
    throw Error(ExitCode::internal_error, "libtalus_gmsh.so is of another build than the program");
  auto& mesh_by_gmsh = *load_gmsh<MeshPlan<D>>("talus_mesh_plan_" + std::to_string(D));
  auto& read_by_gmsh = *load_gmsh<ReadMesh<D>>("talus_read_mesh_" + std::to_string(D));
  Message message;
  try {
    message = do_in_child("the mesh was made", [&](Message& answer) {
      Mesh<D> mesh;
      bool is_numbered = false;
      if (is_made) {
        mesh = mesh_plan<D>(mesh_by_gmsh, checked, is_numbered);
      } else {
        limit_reading(plan.file);
        read_by_gmsh(plan.file, mesh);
      }
      write_mesh(mesh, answer);
      answer.put(is_numbered);
    });
  } catch (const ChildCrash& crash) {
    fail_input(is_made ? fmt::format("Gmsh cannot mesh the plan: {}; look for corners, edges or lines that nearly "
                                     "touch, or ask for larger elements",
                                     crash.what())
                       : fmt::format("mesh file '{}' cannot be read by Gmsh: {}", plan.file, crash.what()));
  }
  Mesh<D> mesh = read_mesh<D>(message);
  finish(mesh, message.get<bool>() ? Order::as_given : Order::space_filling);
  if (is_made) check_whole(mesh, plan);
  return mesh;
}

template Mesh<2> generate<2>(const Plan&);
template Mesh<3> generate<3>(const Plan&);

}  // namespace talus::mesh
