// SPDX-License-Identifier: MIT
// Search of the open sides of wet soil, and the forces of outside water on them (T14.12).
#include "mpm/pore_water/surface.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/kernels/surface_kernels.hpp"
#include "mpm/state/partition.hpp"

namespace talus::mpm {

namespace {

constexpr double closed_share = 1e-9;

template <int D>
std::vector<Content> find_contents_of_all(const Body<D>& body) {
  std::vector<Content> own;
  const auto [begin, end] = own_elements(body);
  for (int e = begin; e < end; ++e) own.push_back(find_content(body, e));
  return join_lists(body, std::move(own));
}

/// By element without wet soil: whether it is outside, regardless of its neighbours or through them.
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
    if (is_outside_by_itself(body, e, contents[e], touches)) add(e);
  }
  while (!found.empty()) {
    const int e = found.back();
    found.pop_back();
    for (int neighbour : mesh.neighbours[e]) add(neighbour);
  }
  return outside;
}

/// Finds the open sides: the outside is behind them, and their nodes do not all fix the water along the normal. Every
/// rank examines the whole body and stores the sides that touch its nodes.
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
      if (!is_open(body, e, k, outside)) continue;
      const OpenSide<D> side{e, k, find_side_share(mesh, e, k)};
      for (int i = 0; i <= D; ++i) {
        const int node = mesh.elements[e][i];
        for (int d = 0; d < D; ++d) {
          water.facing[node][d] += side.share[d];
          if (i != k) touching[node][d] += side.share[d];
        }
        size[node] += norm(side.share);
      }
      if (!body.partition || body.partition->is_near[e]) water.open_sides.push_back(side);
    }
  }
  // If the open sides of a node's elements close around it, as those of an isolated element do, the sum of their area
  // vectors is round-off, and the sum over the sides that touch the node defines the outward direction.
  for (std::size_t i = 0; i < size.size(); ++i) {
    if (norm(water.facing[i]) <= closed_share * size[i]) water.facing[i] = touching[i];
  }
  water.surface_is_stale = false;
}

/// By surface node: mean pressure of its elements with an open side, which limits evaporation.
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

/// Filled parts of the elements with open sides, after the halo exchange.
template <int D>
class Fillings {
 public:
  Fillings(const Body<D>& body, bool mixed) : body_(body), mixed_(mixed) {
    if (!body.partition) return;
    known_.resize(body.mesh().elements.size());
    const auto [begin, end] = own_elements(body);
    for (const OpenSide<D>& side : body.water.open_sides)
      if (side.element >= begin && side.element < end)
        known_[static_cast<std::size_t>(side.element)] = find_filling(body, side.element, mixed);
    update_elements(body, known_);
  }
  Filling<D> find(int e) const {
    return known_.empty() ? find_filling(body_, e, mixed_) : known_[static_cast<std::size_t>(e)];
  }

 private:
  const Body<D>& body_;
  bool mixed_;
  std::vector<Filling<D>> known_;
};

/// Forces of outside water on open sides with pressure at all their nodes, linear between the nodes: on the water, and
/// on the mixture where the pressure is compressive.
template <int D>
void load_open_sides(Body<D>& body, bool mixed, const OuterWater<D>& outer) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  water.load.assign(mesh.nodes.size(), Vec<D>{});
  water.darcy_load.assign(mesh.nodes.size(), Vec<D>{});
  const Fillings<D> fillings(body, mixed);
  int last = -1;
  for (const OpenSide<D>& side : water.open_sides) {  // the sides of an element follow one another
    const auto add = [&](int k, const Vec<D>& on_water, const Vec<D>& on_darcy) {
      const int node = mesh.elements[side.element][k];
      for (int d = 0; d < D; ++d) {
        water.load[node][d] += on_water[d];
        water.darcy_load[node][d] += on_darcy[d];
      }
    };
    const PressedSide<D> pressed = find_pressed_side(body, side.element, side.opposite, outer);
    if (pressed.like < 0) continue;
    if (side.element != last) {
      last = side.element;
      const Filling<D> filling = fillings.find(last);
      if (!filling.is_full()) load_inside(body, pressed, filling, outer, add);
    }
    load_side(pressed, side.share, add);
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
  if (loads) load_open_sides(body, o.mixed, OuterWater<D>(water.density, o.gravity));
  if (!evaporates) return;
  update_elements(body, water.mean_pressure);
  find_suctions(body);
}

template <int D>
void add_budgets(Body<D>& body, std::vector<SurfaceBudget>& by_chunk) {
  std::vector<SurfaceBudget>& all = body.water.budgets;
  complete_chunks(body, by_chunk, all.size());
  for (std::size_t i = 0; i < by_chunk.size(); ++i) all[i % all.size()].add(by_chunk[i]);
}

template void add_budgets<2>(Body<2>&, std::vector<SurfaceBudget>&);
template void add_budgets<3>(Body<3>&, std::vector<SurfaceBudget>&);
template void load_surface<2>(Body<2>&, const StepOptions<2>&);
template void load_surface<3>(Body<3>&, const StepOptions<3>&);

// Root uptake of water from elements (T16.4), by the same surplus as the exchange between elements.

namespace {

/// Calls take(e, volume) with the root uptake [m³] of each wet element in `dt` seconds, and adds it to the budget.
/// `water_in(e)`: water of the element [m³].
template <int D, class WaterIn, class Take>
void draw(Body<D>& body, int threads, double dt, WaterIn&& water_in, Take&& take) {
  Water<D>& water = body.water;
  const Layout<D>& layout = *body.layout;
  std::vector<double> rates;
  for (const RootUptake& uptake : water.uptakes) rates.push_back(uptake.rate.at(body.time + 0.5 * dt));
  std::vector<double> drawn(static_cast<std::size_t>(layout.chunks), 0.0);
  for_chunks(body, threads, [&](int c) {
    const int end = std::min(layout.chunk_start[c + 1] * lane_width, body.mesh().element_count());
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e) {
      const double volume = find_draw(body, water.uptakes, rates, dt, e, [&] { return water_in(e); });
      if (volume == 0) continue;
      take(e, volume);
      drawn[static_cast<std::size_t>(c)] += water.density * volume;
    }
  });
  complete_chunks(body, drawn);
  for (const double mass : drawn) water.transpired += mass;
}

}  // namespace

template <int D>
void draw_root_water(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  if (!o.smooth_pressure && !o.exchange_water) std::fill(water.surplus.begin(), water.surplus.end(), 0.0);
  if (!o.moving) return;
  draw(
      body, o.threads, exchange_interval * o.dt,
      [&](int e) {
        const std::size_t block = static_cast<std::size_t>(e / lane_width) * moment_size<D>;
        return water.moments[block * lane_width + static_cast<std::size_t>(e % lane_width)] / water.density;
      },
      [&](int e, double volume) { water.surplus[e] += volume / water.volume[e]; });
}

template <int D>
void find_root_draw(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  if (water.uptakes.empty()) return;
  DarcyWater<D>& m = water.darcy;
  std::fill(m.drawn.begin(), m.drawn.end(), 0.0);
  if (!o.moving) return;
  draw(
      body, o.threads, o.dt, [&](int e) { return m.water[e]; }, [&](int e, double volume) { m.drawn[e] = volume; });
}

template void find_root_draw<2>(Body<2>&, const StepOptions<2>&);
template void find_root_draw<3>(Body<3>&, const StepOptions<3>&);
template void draw_root_water<2>(Body<2>&, const StepOptions<2>&);
template void draw_root_water<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
