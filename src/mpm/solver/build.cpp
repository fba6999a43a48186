// SPDX-License-Identifier: MIT
// Construction of layouts and bodies, nodal sums from scratch (P2G at the start of a stage), and messages that
// broadcast a body without its fields.
#include "mpm/solver/build.hpp"

#include <algorithm>

#include "base/ranks.hpp"
#include "material/every_law.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/laws.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/kernels/pore_state.hpp"
#include "mpm/kernels/softening.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/partition.hpp"
#include "mpm/state/slots.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {

namespace {

/// A chunk must be large enough to be worth starting a thread, and there must be enough chunks for many threads. In
/// large bodies chunks grow first, because nodes between chunks cost more; above points_per_large_chunk their number
/// grows, for many ranks.
constexpr int points_per_chunk = 8192, points_per_large_chunk = 65536;
constexpr int most_small_chunks = 64;

int choose_chunks(std::int64_t points) {
  const std::int64_t small = std::clamp<std::int64_t>(points / points_per_chunk, 1, most_small_chunks);
  return static_cast<int>(std::max(small, points / points_per_large_chunk));
}

std::vector<int> cut_into_chunks(const std::vector<int>& weight, int chunks) {
  const int blocks = static_cast<int>(weight.size());
  std::int64_t total = 0, sum = 0;
  for (int w : weight) total += w;
  std::vector<int> start{0};
  for (int b = 0; b < blocks; ++b) {
    sum += weight[b];
    if (static_cast<int>(start.size()) < chunks && sum * chunks >= total * static_cast<std::int64_t>(start.size()))
      start.push_back(b + 1);
  }
  start.push_back(blocks);
  start.erase(std::unique(start.begin(), start.end()), start.end());
  return start;
}

template <int D>
void number_rows(Layout<D>& layout) {
  const mesh::Mesh<D>& mesh = layout.mesh;
  const int elements = mesh.element_count(), nodes = mesh.node_count();
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(nodes));
  std::vector<int> seen(static_cast<std::size_t>(nodes), -1);
  std::vector<int> first_chunk(static_cast<std::size_t>(nodes), layout.chunks - 1);
  layout.connectivity.assign(static_cast<std::size_t>(layout.blocks) * (D + 1) * lane_width, 0);
  for (int c = 0; c < layout.chunks; ++c) {
    layout.chunk_row.push_back(layout.rows);
    const int begin = layout.chunk_start[c] * lane_width,
              end = std::min(elements, layout.chunk_start[c + 1] * lane_width);
    std::vector<int> mine;
    for (int e = begin; e < end; ++e) {
      for (int i : mesh.elements[e]) {
        if (seen[i] != c) {
          seen[i] = c;
          mine.push_back(i);
        }
      }
    }
    std::sort(mine.begin(), mine.end());
    for (int i : mine) {
      if (rows[i].empty()) first_chunk[i] = c;
      rows[i].push_back(layout.rows++);
    }
    for (int e = begin; e < layout.chunk_start[c + 1] * lane_width; ++e) {
      for (int k = 0; k <= D; ++k) {
        // Lanes after the last element refer to some row of the chunk and add zero to it.
        const int node = e < elements ? mesh.elements[e][k] : mesh.elements[begin][k];
        const std::size_t at =
            (static_cast<std::size_t>(e / lane_width) * (D + 1) + static_cast<std::size_t>(k)) * lane_width;
        layout.connectivity[at + static_cast<std::size_t>(e % lane_width)] = rows[node].back();
      }
    }
  }
  layout.chunk_row.push_back(layout.rows);
  layout.is_ordered = std::is_sorted(first_chunk.begin(), first_chunk.end());
  for (int c = 0; c <= layout.chunks; ++c)
    layout.node_start.push_back(
        layout.is_ordered
            ? static_cast<int>(std::lower_bound(first_chunk.begin(), first_chunk.end(), c) - first_chunk.begin())
            : static_cast<int>(static_cast<std::int64_t>(nodes) * c / layout.chunks));
  layout.row_start.assign(1, 0);
  for (std::vector<int>& r : rows) {
    if (r.empty()) r.push_back(layout.rows++);  // a node of no element: its row stays zero
    layout.node_rows.insert(layout.node_rows.end(), r.begin(), r.end());
    layout.row_start.push_back(static_cast<int>(layout.node_rows.size()));
  }
}

/// Sets the water laws; every surface is a seepage face.
template <int D>
void set_water_laws(Body<D>& body, const std::vector<WaterLaw>& laws) {
  Water<D>& water = body.water;
  for (const WaterLaw& law : laws) {
    if (law.wet) {
      water.density = law.density;
      water.bulk_modulus = law.bulk_modulus;
    }
    water.laws.push_back(finish(law));
  }
  water.first_field = body.points.fields;
  body.points.fields += WaterFields<D>::count;
  const std::size_t nodes = body.mesh().nodes.size();
  water.constraint_of_node.assign(nodes, -1);
  water.surfaces = {{}};
  water.surface_of_node.assign(nodes, 0);
  water.budgets.assign(1, {});
}

template <int D>
void allocate_water(Body<D>& body) {
  const Layout<D>& l = *body.layout;
  const std::size_t lanes = static_cast<std::size_t>(l.blocks) * lane_width, rows = static_cast<std::size_t>(l.rows);
  Water<D>& water = body.water;
  water.moments.resize(lanes * moment_size<D>);
  for (auto* field : {&water.volume, &water.stretch, &water.mean_saturation, &water.mean_pressure, &water.mean_bishop,
                      &water.mean_resistance, &water.surplus})
    field->resize(lanes);
  water.sums.resize(rows * wet_sums_stride<D>);
  water.motion.resize(rows * wet_motion_stride<D>);
  water.average.resize(rows * 4);
  water.smoothed.resize(rows * 4);
  water.still_flux.resize(l.mesh.nodes.size());
}

}  // namespace

template <int D>
std::shared_ptr<const Layout<D>> make_layout(mesh::Mesh<D> mesh, const std::vector<int>& points_in_element,
                                             int chunks) {
  const int elements = mesh.element_count();
  std::vector<int> weight(static_cast<std::size_t>((elements + lane_width - 1) / lane_width), 1);
  std::int64_t points = 0;
  for (int e = 0; e < elements; ++e) {
    weight[e / lane_width] += 2 * points_in_element[e];
    points += points_in_element[e];
  }
  if (chunks <= 0) chunks = choose_chunks(points);
  return lay_out(std::move(mesh), cut_into_chunks(weight, chunks));
}

template <int D>
// NOLINTNEXTLINE(performance-unnecessary-value-param): it does not see the move of a template
std::shared_ptr<const Layout<D>> lay_out(mesh::Mesh<D> mesh, std::vector<int> chunk_start) {
  auto layout = std::make_shared<Layout<D>>();
  layout->mesh = std::move(mesh);
  const int elements = layout->mesh.element_count();
  layout->blocks = (elements + lane_width - 1) / lane_width;
  layout->chunk_start = std::move(chunk_start);
  layout->chunks = static_cast<int>(layout->chunk_start.size()) - 1;
  number_rows(*layout);
  layout->gradients.assign(static_cast<std::size_t>(layout->blocks) * D * D * lane_width, 0.0);
  layout->volumes.assign(static_cast<std::size_t>(layout->blocks) * lane_width, 0.0);
  for (int e = 0; e < elements; ++e) {
    const std::size_t b = static_cast<std::size_t>(e / lane_width), lane = static_cast<std::size_t>(e % lane_width);
    for (std::size_t i = 0; i < D * D; ++i)
      layout->gradients[(b * D * D + i) * lane_width + lane] = layout->mesh.gradients[e][i];
    layout->volumes[b * lane_width + lane] = layout->mesh.volumes[e];
  }
  return layout;
}

template <int D>
void allocate_fields(Body<D>& body, int points) {
  using P = Points<D>;
  const Layout<D>& l = *body.layout;
  const std::size_t blocks = static_cast<std::size_t>(l.blocks), lanes = blocks * lane_width,
                    rows = static_cast<std::size_t>(l.rows), n = static_cast<std::size_t>(points);
  body.points.element.assign(n, -1);
  body.points.place.resize(n);
  body.points.material.resize(n);
  body.points.reference.resize(n);
  body.points.strain_offset.resize(n);
  allocate_slots(body.points, std::vector<int>(blocks, 0));
  body.elements.moments.resize(lanes * moment_size<D>);
  body.elements.strain.resize(lanes * P::stress_size);
  for (auto* field :
       {&body.elements.fill_limit, &body.elements.apart, &body.elements.plastic_dilation, &body.elements.rough})
    field->resize(lanes);
  body.nodes.sums.resize(rows * sums_stride);
  body.nodes.motion.resize(rows * motion_stride<D>);
  body.nodes.average.resize(rows * 2);
  body.nodes.smoothed.resize(rows);
  body.nodes.displacement.resize(l.mesh.nodes.size());
  if (body.water.is_wet()) allocate_water(body);
}

template <int D>
// The linter does not see the moves of a template that it has not instantiated.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
Body<D> make_body(std::shared_ptr<const Layout<D>> layout, std::vector<material::Law> laws,
                  // NOLINTNEXTLINE(performance-unnecessary-value-param)
                  std::vector<std::string> names, const std::vector<InitialPoint<D>>& initial,
                  const std::vector<WaterLaw>& water) {
  using P = Points<D>;
  Body<D> body;
  body.layout = std::move(layout);
  body.laws = std::move(laws);
  body.material_names = std::move(names);
  const Layout<D>& l = *body.layout;
  P& points = body.points;
  const int states = find_state_size(body.laws);
  points.fields = P::state + states;
  if (!water.empty()) set_water_laws(body, water);
  const std::size_t n = initial.size(), blocks = static_cast<std::size_t>(l.blocks);
  allocate_fields(body, static_cast<int>(n));
  body.water.stretch.assign(body.water.stretch.size(), 1.0);

  std::vector<int> in_element(blocks * lane_width, 0), used(blocks, 0);
  for (const InitialPoint<D>& p : initial) ++in_element[p.element];
  for (std::size_t e = 0; e < in_element.size(); ++e)
    used[e / lane_width] = std::max(used[e / lane_width], in_element[e]);
  allocate_slots(points, used);
  body.conditions.constraint_of_node.assign(l.mesh.nodes.size(), -1);

  body.smallest_mass = initial.empty() ? 0 : initial.front().mass;
  for (std::size_t i = 0; i < n; ++i) {
    const InitialPoint<D>& p = initial[i];
    Record<D> r;
    r.id = static_cast<int>(i);
    r.element = p.element;
    for (int d = 0; d < D; ++d) {
      r.fields[P::xi + d] = p.xi[d];
      r.fields[P::velocity + d] = p.velocity[d];
    }
    for (int s = 0; s < P::stress_size; ++s) r.fields[P::stress + s] = p.stress[s];
    r.fields[P::volume] = p.volume;
    r.fields[P::mass] = p.mass;
    for (int s = 0; s < states; ++s) r.fields[P::state + s] = p.state[static_cast<std::size_t>(s)];
    if (body.water.is_wet()) {
      using W = WaterFields<D>;
      double* w = r.fields + body.water.first_field;
      const WaterLaw& law = body.water.laws[p.material];
      for (int d = 0; d < D; ++d) w[W::velocity + d] = law.wet ? p.water_velocity[d] : 0.0;
      w[W::pressure] = law.wet ? p.pressure : 0.0;
      w[W::capacity] = law.wet ? find_state_at_pressure<double>(law, p.pressure).capacity : -1.0;
      w[W::mass] =
          law.wet ? find_content(law, p.pressure) * law.density * (p.volume - p.mass / law.grain_density) : 0.0;
    }
    points.material[i] = static_cast<std::uint8_t>(p.material);
    points.reference[i] = mesh::to_global(l.mesh, p.element, p.xi);
    insert_point(points, r);
    body.smallest_mass = std::min(body.smallest_mass, p.mass);
  }
  return body;
}

template <int D>
void gather_nodal_sums(Body<D>& body, const StepOptions<D>& o) {
  const auto clear = [](AlignedVector<double>& field) { field = AlignedVector<double>(field.size()); };
  clear(body.nodes.sums);
  clear(body.elements.moments);
  const auto [begin, end] = own_elements(body);
  const bool darcy = body.water.is_wet() && o.darcy;
  update_counts(body);
  for (int e = begin; e < end; ++e) update_fill_limit(body, e);
  for (int e = begin; e < end; ++e) note_gaps(body, o, e);
  for (int e = begin; e < end; ++e) {
    gather_points(body, o, e, darcy ? body.water.first_field + WaterFields<D>::mass : -1);
  }
  body.water.darcy.is_used = darcy;
  if (darcy) {
    body.water.surface_is_stale = true;
  } else if (body.water.is_wet()) {  // with the forces of the water, in rows of their own
    clear(body.water.sums);
    clear(body.water.volume);
    body.water.darcy.pressure.clear();  // they are not updated in this formulation
    body.water.darcy.ponded.clear();
    body.water.darcy.own.clear();
    body.water.darcy.change.clear();
    find_held_axes(body);
    for (int e = begin; e < end; ++e) {
      average_wet_element(body, e, o);
      if (body.points.count[e] > 0) add_wet_element(body, e, o, 1);
    }
    body.water.surface_is_stale = true;
  }
  gather_loads(body);
}

template std::shared_ptr<const Layout<2>> make_layout<2>(mesh::Mesh<2>, const std::vector<int>&, int);
template std::shared_ptr<const Layout<3>> make_layout<3>(mesh::Mesh<3>, const std::vector<int>&, int);
template std::shared_ptr<const Layout<2>> lay_out<2>(mesh::Mesh<2>, std::vector<int>);
template std::shared_ptr<const Layout<3>> lay_out<3>(mesh::Mesh<3>, std::vector<int>);
template void allocate_fields<2>(Body<2>&, int);
template void allocate_fields<3>(Body<3>&, int);
template Body<2> make_body<2>(std::shared_ptr<const Layout<2>>, std::vector<material::Law>, std::vector<std::string>,
                              const std::vector<InitialPoint<2>>&, const std::vector<WaterLaw>&);
template Body<3> make_body<3>(std::shared_ptr<const Layout<3>>, std::vector<material::Law>, std::vector<std::string>,
                              const std::vector<InitialPoint<3>>&, const std::vector<WaterLaw>&);
template void gather_nodal_sums<2>(Body<2>&, const StepOptions<2>&);
template void gather_nodal_sums<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm

namespace talus::input {

void visit_members(auto&& visit, Like<TimeTable> auto& table) {
  visit(table.time, table.value);
}

}  // namespace talus::input

namespace talus::mpm {

void visit_members(auto&& visit, Like<SurfaceCondition> auto& c) {
  visit(c.name, c.kind, c.value, c.vertical, c.suction_limit);
}
void visit_members(auto&& visit, Like<RootUptake> auto& u) {
  visit(u.name, u.rate, u.reduction, u.weight);
}
template <class Visit, class L>
requires Like<L, Load<2>> || Like<L, Load<3>>
void visit_members(Visit&& visit, L& load) {
  visit(load.on_points, load.entries, load.factor);
}

namespace {

/// Optional fields that a body has.
struct Extent {
  int points = 0;
  bool softens_over_length = false, holds_saturation = false;
  bool has_pressure = false, has_change = false, has_own = false, has_ponded = false;
};

template <int D>
Extent find_extent(const Body<D>& body) {
  const DarcyWater<D>& darcy = body.water.darcy;
  return {body.points.size(),      body.softening_reach != nullptr, !body.elements.held_saturation.empty(),
          !darcy.pressure.empty(), !darcy.change.empty(),           !darcy.own.empty(),
          !darcy.ponded.empty()};
}

template <int D>
void allocate(Body<D>& body, const Extent& extent) {
  allocate_fields(body, extent.points);
  const std::size_t nodes = body.mesh().nodes.size(), lanes = body.elements.fill_limit.size();
  if (extent.softens_over_length)
    for (auto* field : {&body.elements.softened, &body.elements.softening_volume, &body.elements.nonlocal_correction})
      field->resize(lanes);
  if (extent.holds_saturation) body.elements.held_saturation.resize(lanes);
  DarcyWater<D>& darcy = body.water.darcy;
  if (extent.has_pressure) darcy.pressure.resize(nodes);
  if (extent.has_change) darcy.change.resize(nodes);
  if (extent.has_own) darcy.own.resize(nodes);
  if (extent.has_ponded) darcy.ponded.resize(nodes);
}

template <int D, class Visit>
void visit_description(Visit&& visit, Like<Body<D>> auto& body) {
  visit(body.material_names, body.points.fields);
  auto& c = body.conditions;
  visit(c.constraint_of_node, c.constraints, c.pressed, c.factors, c.loads);
  auto& w = body.water;
  visit(w.laws, w.density, w.bulk_modulus, w.first_field);
  visit(w.constraint_of_node, w.constraints, w.axes, w.axes_of_node);
  visit(w.surfaces, w.surface_of_node, w.darcy.is_used, w.uptakes);
  visit(w.budgets, w.transpired, w.lost_between, w.left_grid, w.pressed_in);
  visit(body.nodes.motion_step, body.lost, body.work, body.monitor, body.timing);
  visit(body.time, body.step_count, body.smallest_mass);
}

}  // namespace

template <int D>
void put_description(const Body<D>& body, Message& message) {
  message.put(find_extent(body));
  visit_description<D>(Putting(message), body);
}

template <int D>
Body<D> get_description(Message& message, std::shared_ptr<const Layout<D>> layout) {
  Body<D> body;
  body.layout = std::move(layout);
  const auto extent = message.get<Extent>();
  visit_description<D>(Taking(message), body);
  allocate(body, extent);
  return body;
}

template <int D>
Body<D> copy_description(const Body<D>& body) {
  Message message;
  put_description(body, message);
  Body<D> copy = get_description(message, body.layout);
  copy.laws = body.laws;
  copy.water.darcy.graph = body.water.darcy.graph;
  return copy;
}

template <int D>
std::shared_ptr<const Layout<D>> broadcast_layout(std::shared_ptr<const Layout<D>> layout) {
  // List by list, because each is large.
  mesh::Mesh<D> mesh;
  std::vector<int> chunks;
  if (layout) mesh = layout->mesh, chunks = layout->chunk_start;
  broadcast(mesh.nodes);
  broadcast(mesh.elements);
  broadcast(mesh.element_region);
  broadcast(mesh.neighbours);
  broadcast(mesh.volumes);
  broadcast(mesh.gradients);
  broadcast(mesh.altitudes);
  broadcast(chunks);
  return layout ? layout : lay_out(std::move(mesh), std::move(chunks));
}

#define TALUS_INSTANTIATE(D)                                                       \
  template Body<D> copy_description<D>(const Body<D>&);                            \
  template void put_description<D>(const Body<D>&, Message&);                      \
  template Body<D> get_description<D>(Message&, std::shared_ptr<const Layout<D>>); \
  template std::shared_ptr<const Layout<D>> broadcast_layout<D>(std::shared_ptr<const Layout<D>>);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
