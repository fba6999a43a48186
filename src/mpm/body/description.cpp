// SPDX-License-Identifier: MIT
#include "mpm/body/description.hpp"

#include "base/ranks.hpp"
#include "mpm/body/build.hpp"
#include "mpm/step/softening.hpp"

namespace talus::input {

template <class Visit>
void visit_members(Visit&& visit, Like<TimeTable> auto& table) {
  visit(table.time, table.value);
}

}  // namespace talus::input

namespace talus::mpm {

template <class Visit>
void visit_members(Visit&& visit, Like<SurfaceCondition> auto& c) {
  visit(c.name, c.kind, c.value, c.vertical, c.suction_limit);
}
template <class Visit>
void visit_members(Visit&& visit, Like<RootUptake> auto& u) {
  visit(u.name, u.rate, u.reduction, u.weight);
}
template <class Visit, class L>
requires Like<L, Load<2>> || Like<L, Load<3>>
void visit_members(Visit&& visit, L& load) {
  visit(load.on_points, load.entries, load.factor);
}

namespace {

/// Which fields there are: those that only some bodies have.
struct Extent {
  int points = 0;
  bool softens_over_length = false, holds_saturation = false;
  bool has_pressure = false, has_change = false, has_own = false, has_ponded = false;
};

template <int D>
Extent find_extent(const Body<D>& body) {
  const DarcyWater<D>& darcy = body.water.darcy;
  return {body.points.size(),        body.softening_reach != nullptr, !body.elements.held_saturation.empty(),
          !darcy.pressure.empty(), !darcy.change.empty(),         !darcy.own.empty(),
          !darcy.ponded.empty()};
}

template <int D>
void allocate(Body<D>& body, const Extent& extent) {
  allocate_fields(body, extent.points);
  const std::size_t nodes = body.mesh().nodes.size(), lanes = body.elements.fill_limit.size();
  if (extent.softens_over_length)
    for (auto* field : {&body.elements.softened, &body.elements.softening_volume, &body.elements.lent})
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
  // List by list, as each is large.
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
