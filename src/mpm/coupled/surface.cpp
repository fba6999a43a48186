// SPDX-License-Identifier: MIT
// Where wet soil ends, and the pressure of the water outside.

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/shape_gradient.hpp"
#include "mpm/body/share.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/water_surface.hpp"

namespace talus::mpm {
namespace {

constexpr double closed_share = 1e-9;

/// What an element holds, as all ranks know it where the surface is looked for.
enum class Content : char { nothing, dry_soil, wet_soil };

template <int D>
std::vector<Content> find_contents_of_all(const Body<D>& body) {
  std::vector<Content> own;
  const auto [begin, end] = own_elements(body);
  for (int e = begin; e < end; ++e)
    own.push_back(body.water.volume[e] > 0   ? Content::wet_soil
                  : body.points.count[e] > 0 ? Content::dry_soil
                                             : Content::nothing);
  return join_lists(body, std::move(own));
}

/// Whether the water of node `i` may not move along the unit vector `n`.
template <int D>
bool is_held(const Water<D>& water, int i, const std::type_identity_t<Vec<D>>& n) {
  const int c = water.constraint_of_node[i];
  return c >= 0 && norm(remove_fixed<D>(water.constraints[c].fixed, water.constraints[c].fixed_count, n)) < 1e-9;
}

/// Whether the nodes of the side opposite node `k` of element `e` all hold the water along its normal.
template <int D>
bool is_closed(const Body<D>& body, int e, int k) {
  const auto& nodes = body.mesh().elements[e];
  Vec<D> normal = mesh::find_shape_gradient(body.mesh(), e, k);
  const double length = norm(normal);
  for (double& c : normal) c /= length;
  bool closed = true;
  for (int i = 0; i <= D; ++i) closed = closed && (i == k || is_held(body.water, nodes[i], normal));
  return closed;
}

/// Of each element without wet soil whether it is outside. Where shear parts the points of a thin band, elements inside
/// the soil are left without one: such a gap is no surface, and no water leaves there. A group of neighbours is outside
/// when one of them touches no wet soil, holds dry soil, or has a side of the mesh that lets water through.
template <int D>
std::vector<std::uint8_t> find_outside(const Body<D>& body, const std::vector<Content>& contents) {
  const mesh::Mesh<D>& mesh = body.mesh();
  const auto is_wet = [&](int e) { return contents[e] == Content::wet_soil; };
  std::vector<std::uint8_t> touches(mesh.nodes.size(), 0), outside(mesh.elements.size(), 0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!is_wet(e)) continue;
    for (int node : mesh.elements[e]) touches[node] = 1;
  }
  std::vector<int> found;
  const auto add = [&](int e) {
    if (e < 0 || outside[e] || is_wet(e)) return;
    outside[e] = 1;
    found.push_back(e);
  };
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (is_wet(e)) continue;
    bool is_far = true, lets_through = false;
    for (int k = 0; k <= D; ++k) {
      is_far = is_far && !touches[mesh.elements[e][k]];
      lets_through = lets_through || (mesh.neighbours[e][k] < 0 && !is_closed(body, e, k));
    }
    if (is_far || lets_through || contents[e] == Content::dry_soil) add(e);
  }
  while (!found.empty()) {
    const int e = found.back();
    found.pop_back();
    for (int neighbour : mesh.neighbours[e]) add(neighbour);
  }
  return outside;
}

/// A side of a wet element is open when the outside is behind it, unless its nodes all hold the water. Every rank looks
/// at the whole body, and keeps the sides that touch its nodes.
template <int D>
void find_open_sides(Body<D>& body) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  const std::vector<Content> contents = find_contents_of_all(body);
  const std::vector<std::uint8_t> outside = find_outside(body, contents);
  water.open_sides.clear();
  water.facing.assign(mesh.nodes.size(), Vec<D>{});
  std::vector<Vec<D>> touching(mesh.nodes.size(), Vec<D>{});
  std::vector<double> size(mesh.nodes.size(), 0.0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (contents[e] != Content::wet_soil) continue;
    for (int k = 0; k <= D; ++k) {
      const int behind = mesh.neighbours[e][k];
      if ((behind >= 0 && !outside[behind]) || is_closed(body, e, k)) continue;
      OpenSide<D> side{e, k, mesh::find_shape_gradient(mesh, e, k)};
      for (double& c : side.share) c *= -mesh.volumes[e];
      for (int i = 0; i <= D; ++i) {
        const int node = mesh.elements[e][i];
        for (int d = 0; d < D; ++d) {
          water.facing[node][d] += side.share[d];
          if (i != k) touching[node][d] += side.share[d];
        }
        size[node] += norm(side.share);
      }
      if (!body.share || body.share->is_near[e]) water.open_sides.push_back(side);
    }
  }
  // Where the open sides of a node's elements close round it, as those of a lone element do, their sum is round-off,
  // and the sides that touch the node say where outside is.
  for (std::size_t i = 0; i < size.size(); ++i) {
    if (norm(water.facing[i]) <= closed_share * size[i]) water.facing[i] = touching[i];
  }
  water.surface_is_stale = false;
}

/// Mean pressure of the elements at the surface round each of its nodes: what limits evaporation.
template <int D>
void find_suctions(Body<D>& body) {
  Water<D>& water = body.water;
  water.suction.assign(body.mesh().nodes.size(), 0.0);
  std::vector<int> count(body.mesh().nodes.size(), 0);
  int last = -1;
  for (const OpenSide<D>& side : water.open_sides) {  // the sides of an element follow one another
    if (side.element == last) continue;
    last = side.element;
    for (int i : body.mesh().elements[side.element]) {
      water.suction[i] += water.mean_pressure[side.element];
      ++count[i];
    }
  }
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (count[i] > 0) water.suction[i] /= count[i];
  }
}

/// What the points of an element fill of it: Σ V N_i of wet points [m³], and whether it is integrated as a whole.
template <int D>
struct Filling : std::array<double, D + 2> {
  bool is_full() const { return this->back() != 0; }

  Filling() : std::array<double, D + 2>{} {}
  Filling(const Body<D>& body, int e, bool mixed) : Filling() {
    auto& moment = *this;
    using P = Points<D>;
    const P& points = body.points;
    const std::int64_t first = points.block_start[e / lane_width];
    double all = 0;
    int material = -1;
    bool uniform = true;
    for (int k = 0; k < static_cast<int>(points.count[e]); ++k) {
      const double* p = points.slot(first + k) + e % lane_width;
      const int m = points.material[points.id[static_cast<std::size_t>((first + k) * lane_width + e % lane_width)]];
      const double v = p[P::volume * lane_width];
      all += v;
      uniform = uniform && (k == 0 || m == material);
      material = m;
      if (!body.water.laws[m].wet) continue;
      double rest = 1;
      for (int d = 0; d < D; ++d) {
        const double xi = p[(P::xi + d) * lane_width];
        moment[d + 1] += v * xi;
        rest -= xi;
      }
      moment[0] += v * rest;
    }
    this->back() = mixed && uniform && all > body.elements.fill_limit[e] ? 1 : 0;
  }
};

/// Those of the elements with open sides. Several ranks exchange them before they are asked for.
template <int D>
class Fillings {
 public:
  Fillings(const Body<D>& body, bool mixed) : body_(body), mixed_(mixed) {
    if (!body.share) return;
    known_.resize(body.mesh().elements.size());
    const auto [begin, end] = own_elements(body);
    for (const OpenSide<D>& side : body.water.open_sides)
      if (side.element >= begin && side.element < end)
        known_[static_cast<std::size_t>(side.element)] = Filling<D>(body, side.element, mixed);
    update_elements(body, known_);
  }
  Filling<D> find(int e) const {
    return known_.empty() ? Filling<D>(body_, e, mixed_) : known_[static_cast<std::size_t>(e)];
  }

 private:
  const Body<D>& body_;
  bool mixed_;
  std::vector<Filling<D>> known_;
};

/// The soil of an element that is not full ends inside it, and so does the pressure outside. On the sides where other
/// soil is behind, nothing changes: ∮ p̂ N_i n dA over the soil's surface differs from that over the element's by
/// ∫ div(p̂ N_i) dV over what the soil does not fill.
template <int D>
void load_inside(Body<D>& body, int e, const Filling<D>& filling, const double (&pressure)[D + 1]) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  Vec<D> gradient[D + 1];
  for (int k = 0; k <= D; ++k) gradient[k] = mesh::find_shape_gradient(mesh, e, k);
  const auto add = [&](std::vector<Vec<D>>& load, double most) {
    double missing = 0;  // ∫ p̂ dV over the points less that over the element
    Vec<D> slope{};
    for (int k = 0; k <= D; ++k) {
      const double p = std::min(most, pressure[k]);
      missing += p * (filling[k] - mesh.volumes[e] / (D + 1));
      for (int d = 0; d < D; ++d) slope[d] += p * gradient[k][d];
    }
    for (int k = 0; k <= D; ++k) {
      const double share = filling[k] - mesh.volumes[e] / (D + 1);
      for (int d = 0; d < D; ++d) load[mesh.elements[e][k]][d] += missing * gradient[k][d] + share * slope[d];
    }
  };
  add(water.load, std::numeric_limits<double>::infinity());
  add(water.mixture_load, 0.0);
}

/// Forces of the water outside, linear along a side between the pressures at its nodes, where all of them have such a
/// condition: on the water; on the mixture when it presses.
template <int D>
void load_open_sides(Body<D>& body, bool mixed, double unit_weight, const std::type_identity_t<Vec<D>>& up) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  water.load.assign(mesh.nodes.size(), Vec<D>{});
  water.mixture_load.assign(mesh.nodes.size(), Vec<D>{});
  const Fillings<D> fillings(body, mixed);
  int last = -1;
  for (const OpenSide<D>& side : water.open_sides) {  // the sides of an element follow one another
    double pressure[D + 1] = {}, sum = 0;
    bool loaded = true;
    int like = -1;  // the last node of the side
    for (int i = 0; i <= D && loaded; ++i) {
      if (i == side.opposite) continue;
      const int node = like = mesh.elements[side.element][i];
      const auto outer = find_outer_pressure(body, node, node, unit_weight, up);
      loaded = outer.has_value();
      pressure[i] = outer.value_or(0);
      sum += pressure[i];
    }
    if (!loaded) continue;
    if (side.element != last) {
      last = side.element;
      const Filling<D> filling = fillings.find(last);
      double everywhere[D + 1];
      for (int i = 0; i <= D; ++i)
        everywhere[i] = i == side.opposite ? *find_outer_pressure(body, mesh.elements[last][i], like, unit_weight, up)
                                           : pressure[i];
      if (!filling.is_full()) load_inside(body, last, filling, everywhere);
    }
    for (int i = 0; i <= D; ++i) {
      if (i == side.opposite) continue;
      const int node = mesh.elements[side.element][i];
      const double mean = (sum + pressure[i]) / (D + 1);
      for (int d = 0; d < D; ++d) {
        water.load[node][d] += mean * side.share[d];
        water.mixture_load[node][d] += std::min(0.0, mean) * side.share[d];
      }
    }
  }
}

}  // namespace

template <int D>
void load_surface(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  if (is_any(body, water.surface_is_stale)) find_open_sides(body);
  bool loads = false, evaporates = false;
  for (const SurfaceCondition& c : water.surfaces) {
    loads = loads || c.kind == SurfaceKind::head || c.kind == SurfaceKind::pressure;
    evaporates = evaporates || (c.kind == SurfaceKind::rain && !std::isinf(c.suction_limit));
  }
  if (loads) load_open_sides(body, o.mixed, water.density * norm(o.gravity), find_up<D>(o.gravity));
  if (!evaporates) return;
  update_elements(body, water.mean_pressure);
  find_suctions(body);
}

template <int D>
void add_budgets(Body<D>& body, std::vector<SurfaceBudget>& by_chunk) {
  std::vector<SurfaceBudget>& all = body.water.budgets;
  complete_chunks(body, by_chunk, all.size());
  for (std::size_t i = 0; i < by_chunk.size(); ++i) {
    SurfaceBudget& budget = all[i % all.size()];
    budget.entered += by_chunk[i].entered;
    budget.left += by_chunk[i].left;
    budget.supplied += by_chunk[i].supplied;
    budget.runoff += by_chunk[i].runoff;
  }
}

template void add_budgets<2>(Body<2>&, std::vector<SurfaceBudget>&);
template void add_budgets<3>(Body<3>&, std::vector<SurfaceBudget>&);
template void load_surface<2>(Body<2>&, const StepOptions<2>&);
template void load_surface<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
