#pragma once
// The slope on which speed is stated: a jittered structured mesh of a box, filled up to a slope's profile, that really
// fails and runs out. The same case, number by number, as the throw-away yardstick that docs/performance.md compares
// with.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "mpm/build.hpp"

namespace talus::bench {

struct YardstickCase {
  std::array<int, 3> cells;  ///< squares or cubes per direction
  double size;               ///< their edge [m]
  int filled_elements;
  int points_per_element;
};

template <int D>
YardstickCase yardstick_case(const std::string& name) {
  static const std::map<std::string, YardstickCase> plane{{"small", {{73, 21, 0}, 1.0, 1792, 3}},
                                                          {"mid", {{292, 84, 0}, 0.25, 28672, 3}},
                                                          {"large", {{998, 287, 0}, 0.0731, 334300, 3}}};
  static const std::map<std::string, YardstickCase> space{{"small", {{24, 10, 4}, 1.0, 2600, 4}},
                                                          {"mid", {{60, 25, 10}, 0.4, 40000, 4}},
                                                          {"large", {{110, 46, 19}, 0.22, 250000, 4}}};
  return D == 2 ? plane.at(name) : space.at(name);
}

template <int D>
mesh::Mesh<D> make_yardstick_mesh(const YardstickCase& c) {
  mesh::Mesh<D> mesh;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.18, 0.18);
  const int nx = c.cells[0], ny = c.cells[1], nz = D == 3 ? c.cells[2] : 0;
  const double scale = D == 3 ? 0.6 : 1.0;
  const auto number = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        std::array<double, D> x;
        x[0] = (i + (i > 0 && i < nx ? jitter(random) * scale : 0)) * c.size;
        x[1] = (j + (j > 0 && j < ny ? jitter(random) * scale : 0)) * c.size;
        if constexpr (D == 3) x[2] = (k + (k > 0 && k < nz ? jitter(random) * scale : 0)) * c.size;
        mesh.nodes.push_back(x);
      }
    }
  }
  if constexpr (D == 2) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const int p = number(i, j, 0), q = number(i + 1, j, 0), r = number(i + 1, j + 1, 0), s = number(i, j + 1, 0);
        if (random() & 1) {
          mesh.elements.push_back({p, q, r});
          mesh.elements.push_back({p, r, s});
        } else {
          mesh.elements.push_back({p, q, s});
          mesh.elements.push_back({q, r, s});
        }
      }
    }
  } else {
    constexpr int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int k = 0; k < nz; ++k) {
      for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
          for (const auto& path : paths) {  // Kuhn's six tetrahedra of a cube
            int at[3] = {i, j, k};
            std::array<int, 4> t{number(i, j, k), 0, 0, 0};
            for (std::size_t s = 0; s < 3; ++s) {
              ++at[path[s]];
              t[s + 1] = number(at[0], at[1], at[2]);
            }
            mesh.elements.push_back(t);
          }
        }
      }
    }
  }
  mesh.element_region.assign(mesh.elements.size(), mesh::empty_region);
  mesh::finish(mesh);
  return mesh;
}

template <int D>
struct Yardstick {
  mpm::Body<D> body;
  mpm::StepOptions<D> options;
};

/// The case ready to step. `chunks` as in make_layout.
template <int D>
Yardstick<D> make_yardstick(const std::string& name, int chunks) {
  const YardstickCase c = yardstick_case<D>(name);
  mesh::Mesh<D> mesh = make_yardstick_mesh<D>(c);
  const double length = c.cells[0] * c.size, height = c.cells[1] * c.size;
  const auto ground = [&](double x) {
    const double x1 = 0.38 * length, x2 = 0.56 * length, h1 = 0.86 * height, h2 = 0.40 * height;
    return x < x1 ? h1 : (x > x2 ? h2 : h1 + (h2 - h1) * (x - x1) / (x2 - x1));
  };
  std::vector<std::pair<double, int>> depth(mesh.elements.size());
  for (int e = 0; e < mesh.element_count(); ++e) {
    std::array<double, D> centre{};
    for (int i : mesh.elements[e]) {
      for (int d = 0; d < D; ++d) centre[d] += mesh.nodes[i][d] / (D + 1);
    }
    depth[e] = {centre[1] - ground(centre[0]), e};
  }
  std::sort(depth.begin(), depth.end());
  const double offset = depth[static_cast<std::size_t>(c.filled_elements) - 1].first;

  constexpr double young = 1.0e7, poisson = 0.3, density = 1800, gravity = 9.81;
  const double k0 = poisson / (1 - poisson);
  std::vector<mpm::InitialPoint<D>> points;
  std::vector<int> in_element(mesh.elements.size(), 0);
  std::vector<int> filled;
  for (int i = 0; i < c.filled_elements; ++i) filled.push_back(depth[static_cast<std::size_t>(i)].second);
  std::sort(filled.begin(), filled.end());
  for (int e : filled) {
    in_element[e] = c.points_per_element;
    for (int p = 0; p < c.points_per_element; ++p) {
      mpm::InitialPoint<D> point;
      point.element = e;
      const double low = D == 2 ? 1.0 / 6 : 0.13819660112501, high = D == 2 ? 2.0 / 3 : 0.58541019662497;
      for (int d = 0; d < D; ++d) point.xi[d] = p == d + 1 ? high : low;
      const auto x = mesh::to_global(mesh, e, point.xi);
      const double vertical = -density * gravity * std::max(0.0, ground(x[0]) + offset - x[1]);
      point.stress[0] = point.stress[2] = k0 * vertical;
      point.stress[1] = vertical;
      point.volume = mesh.volumes[e] / c.points_per_element;
      point.mass = point.volume * density;
      points.push_back(point);
    }
  }
  const auto elastic = material::LinearElastic::from_young(young, poisson);
  const double degree = std::numbers::pi / 180;
  // σ_t at the apex, as in the yardstick
  const material::MohrCoulomb law(elastic, {1e3, 18 * degree, 0, 1e3 / std::tan(18 * degree)});
  Yardstick<D> y;
  const std::vector<Vec<D>> nodes = mesh.nodes;
  y.body = mpm::make_body<D>(mpm::make_layout<D>(std::move(mesh), in_element, chunks), {law}, {"soil"}, points);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mpm::Constraint<D> constraint;
    const auto add = [&](int d) {
      Vec<D> n{};
      n[d] = 1;
      constraint.fixed[constraint.fixed_count++] = n;
    };
    const double depth_z = D == 3 ? c.cells[2] * c.size : 0;
    const bool bottom = nodes[i][1] == 0;
    if (bottom || nodes[i][0] == 0 || nodes[i][0] == length) add(0);
    if (bottom || nodes[i][1] == height) add(1);
    if constexpr (D == 3) {
      if (bottom || nodes[i][2] == 0 || nodes[i][2] == depth_z) add(2);
    }
    if (constraint.fixed_count == 0) continue;
    y.body.conditions.constraint_of_node[i] = static_cast<int>(y.body.conditions.constraints.size());
    y.body.conditions.constraints.push_back(constraint);
  }
  const double size = c.size * (D == 3 ? 0.6 : 1);
  y.options.dt = 0.25 * size / std::sqrt(elastic.constrained_modulus() / density);
  y.options.gravity[1] = -gravity;
  y.options.damping = 0.05;
  y.options.objective = false;  // as in the yardstick
  mpm::gather_nodal_sums(y.body, y.options);
  return y;
}

}  // namespace talus::bench
