// SPDX-License-Identifier: MIT
#include "ground/ground_load.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ground/pore_water.hpp"
#include "ground/side_normals.hpp"

namespace talus::ground {
namespace {

/// Parts of a side along which its load is summed up.
constexpr int side_parts = 64, triangle_parts = 8;

/// Places on a side by their shape functions, equal shares each.
template <int D>
std::vector<std::array<double, D>> list_places() {
  std::vector<std::array<double, D>> places;
  if constexpr (D == 2) {
    for (int i = 0; i < side_parts; ++i) {
      const double s = (i + 0.5) / side_parts;
      places.push_back({1 - s, s});
    }
  } else {
    const double n = triangle_parts;
    for (int i = 0; i < triangle_parts; ++i) {
      for (int j = 0; i + j < triangle_parts; ++j) {
        places.push_back({(i + 1.0 / 3) / n, (j + 1.0 / 3) / n, 1 - (i + j + 2.0 / 3) / n});
        if (i + j + 1 < triangle_parts)
          places.push_back({(i + 2.0 / 3) / n, (j + 2.0 / 3) / n, 1 - (i + j + 4.0 / 3) / n});
      }
    }
  }
  return places;
}

/// The traction, linear on the side, that has the forces and moments of `load` there; nothing when it is zero.
template <int D>
std::optional<std::array<Vec<D>, D>> fit_traction(const mesh::Mesh<D>& mesh, const std::array<int, D>& nodes,
                                                  const std::function<Vec<D>(const Vec<D>&)>& load) {
  static const auto places = list_places<D>();
  std::array<Vec<D>, D> moments{}, traction{};
  bool acts = false;
  for (const auto& n : places) {
    Vec<D> x{};
    for (std::size_t c = 0; c < D; ++c)
      for (std::size_t d = 0; d < D; ++d) x[d] += n[c] * mesh.nodes[nodes[c]][d];
    const Vec<D> t = load(x);
    for (std::size_t c = 0; c < D; ++c)
      for (std::size_t d = 0; d < D; ++d) moments[c][d] += n[c] * t[d] / static_cast<double>(places.size());
    acts = acts || norm(t) > 0;
  }
  if (!acts) return std::nullopt;
  // ∫ N_i N_j = (1 + δ_ij)/(D(D+1)) of the side's area.
  for (std::size_t d = 0; d < D; ++d) {
    double sum = 0;
    for (std::size_t c = 0; c < D; ++c) sum += moments[c][d];
    for (std::size_t c = 0; c < D; ++c) traction[c][d] = D * (D + 1) * (moments[c][d] - sum / (D + 1));
  }
  return traction;
}

}  // namespace

template <int D>
std::vector<GroundSide<D>> find_ground_sides(const mesh::Mesh<D>& mesh) {
  constexpr double steepest = 1e-6;
  std::vector<GroundSide<D>> ground;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    for (int k = 0; k <= D; ++k) {
      const int behind = mesh.neighbours[e][k];
      if (behind >= 0 && mesh.element_region[behind] != mesh::empty_region) continue;
      GroundSide<D> side;
      side.normal = find_outward_normal(mesh, e, k).first;
      if (side.normal[1] <= steepest) continue;
      std::size_t n = 0;
      for (int j = 0; j <= D; ++j)
        if (j != k) side.nodes[n++] = mesh.elements[e][j];
      ground.push_back(side);
    }
  }
  return ground;
}

double find_surcharge(const input::Case& data, double x) {
  double sum = 0;
  for (const input::Surcharge& s : data.surcharges) {
    for (std::size_t i = 1; i < s.x.size(); ++i) {
      if (x < s.x[i - 1] || x >= s.x[i]) continue;
      sum += s.load[i - 1] + (s.load[i] - s.load[i - 1]) * (x - s.x[i - 1]) / (s.x[i] - s.x[i - 1]);
    }
  }
  return sum;
}

template <int D>
std::vector<fem::SurfaceLoad<D>> make_surface_loads(const input::Case& data, const mesh::Mesh<D>& mesh,
                                                    const std::vector<Pond>& ponds, const Polyline& table,
                                                    const Polyline& ground) {
  std::vector<fem::SurfaceLoad<D>> loads;
  const std::vector<GroundSide<D>> sides = find_ground_sides(mesh);
  const auto add = [&](const char* name, const std::function<Vec<D>(const GroundSide<D>&, const Vec<D>&)>& find) {
    fem::SurfaceLoad<D> load;
    load.name = name;
    for (const GroundSide<D>& side : sides) {
      const auto t = fit_traction<D>(mesh, side.nodes, [&](const Vec<D>& x) { return find(side, x); });
      if (!t) continue;
      load.sides.push_back(side.nodes);
      load.traction.push_back(*t);
    }
    if (!load.sides.empty()) loads.push_back(std::move(load));
  };
  if (!data.surcharges.empty())
    add("surcharges", [&](const GroundSide<D>& side, const Vec<D>& x) {
      Vec<D> t{};
      t[1] = -find_surcharge(data, x[0]) * side.normal[1];
      return t;
    });
  if (!ponds.empty() || !table.empty()) {
    const double weight = find_water_weight(data);
    add("standing water", [&](const GroundSide<D>& side, const Vec<D>& x) {
      Vec<D> t{};
      const auto level = find_standing_level(ponds, table, ground, x[0]);
      const double pressure = level ? weight * std::max(0.0, *level - x[1]) : 0;
      for (std::size_t d = 0; d < D; ++d) t[d] = -pressure * side.normal[d];
      return t;
    });
  }
  for (const input::Traction& traction : data.tractions) {
    fem::SurfaceLoad<D> load;
    load.name = traction.on;
    Vec<D> t;
    for (std::size_t d = 0; d < D; ++d) t[d] = traction.traction[d] * traction.factor.at(0);
    for (const auto& side : find_sides(mesh, traction.on)) {
      load.sides.push_back(side);
      load.traction.emplace_back();
      load.traction.back().fill(t);
    }
    loads.push_back(std::move(load));
  }
  return loads;
}

#define TALUS_INSTANTIATE(D)                                                      \
  template std::vector<GroundSide<D>> find_ground_sides<D>(const mesh::Mesh<D>&); \
  template std::vector<fem::SurfaceLoad<D>> make_surface_loads<D>(                \
      const input::Case&, const mesh::Mesh<D>&, const std::vector<Pond>&, const Polyline&, const Polyline&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::ground
