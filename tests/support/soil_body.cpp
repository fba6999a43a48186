// SPDX-License-Identifier: MIT
#include "support/soil_body.hpp"

namespace talus::support {

template <int D>
mpm::Body<D> fill_body(mesh::Mesh<D> mesh, const std::vector<Substance>& substances, int points_per_element,
                       const Filling<D>& filling, const Start<D>& start, int chunks) {
  std::vector<mpm::InitialPoint<D>> points;
  std::vector<int> in_element(mesh.elements.size(), 0);
  Vec<D> middle;
  middle.fill(1.0 / (D + 1));
  for (int e = 0; e < mesh.element_count(); ++e) {
    mpm::InitialPoint<D> p;
    p.element = e;
    p.material = filling(mesh::to_global(mesh, e, middle));
    if (p.material < 0) continue;
    const std::size_t at = static_cast<std::size_t>(e);
    p.volume = mesh.volumes[at] / points_per_element;
    p.mass = p.volume * substances[static_cast<std::size_t>(p.material)].density;
    for (const auto& xi : mesh::point_positions<D>(points_per_element)) {
      p.xi = xi;
      if (start) start(p, mesh::to_global(mesh, e, xi));
      points.push_back(p);
    }
    in_element[at] = points_per_element;
  }
  std::vector<material::Law> laws;
  std::vector<std::string> names;
  for (const Substance& s : substances) {
    laws.push_back(s.law);
    names.push_back("soil" + std::to_string(names.size()));
  }
  return mpm::make_body<D>(mpm::make_layout<D>(std::move(mesh), in_element, chunks), std::move(laws), std::move(names),
                           points);
}

template <int D>
void fix_nodes(mpm::Body<D>& body, int component,
               const std::type_identity_t<std::function<bool(const Vec<D>&)>>& chosen) {
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    if (!chosen(body.mesh().nodes[i])) continue;
    mpm::Constraint<D>& c = get_constraint(body, i);
    Vec<D> axis{};
    axis[static_cast<std::size_t>(component)] = 1;
    bool known = false;
    for (int k = 0; k < c.fixed_count; ++k) known = known || c.fixed[k] == axis;
    if (!known) c.fixed[c.fixed_count++] = axis;
  }
}

std::vector<Mode> all_modes() {
  using enum input::Smoothing;
  return {{"points", false, none},          {"mixed", true, none},
          {"points strain", false, strain}, {"mixed strain", true, strain},
          {"points stable", false, stable}, {"mixed stable", true, stable}};
}

template mpm::Body<2> fill_body<2>(mesh::Mesh<2> mesh, const std::vector<Substance>& substances, int points_per_element,
                                   const Filling<2>& filling, const Start<2>& start, int chunks);
template mpm::Body<3> fill_body<3>(mesh::Mesh<3> mesh, const std::vector<Substance>& substances, int points_per_element,
                                   const Filling<3>& filling, const Start<3>& start, int chunks);
template void fix_nodes<2>(mpm::Body<2>& body, int component,
                           const std::type_identity_t<std::function<bool(const Vec<2>&)>>& chosen);
template void fix_nodes<3>(mpm::Body<3>& body, int component,
                           const std::type_identity_t<std::function<bool(const Vec<3>&)>>& chosen);

}  // namespace talus::support
