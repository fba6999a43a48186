#include "analysis/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "analysis/conditions.hpp"
#include "base/error.hpp"
#include "mesh/column.hpp"
#include "mesh/points.hpp"
#include "mpm/observe.hpp"

namespace talus::analysis {
namespace {

int find_material(const std::vector<std::string>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw Error(ExitCode::wrong_input, fmt::format("there is no material '{}'", name));
  return static_cast<int>(at - names.begin());
}

/// Material number of each region of the mesh.
template <int D>
std::vector<int> assign_materials(const model::Case& data, const mesh::Mesh<D>& mesh,
                                  const std::vector<std::string>& names) {
  std::vector<int> material;
  for (const std::string& region : mesh.region_names) {
    const auto given = data.regions.find(region);
    if (given == data.regions.end()) {
      throw Error(ExitCode::wrong_input,
                  fmt::format("region '{}' of the mesh has no material; add it to [regions]", region));
    }
    material.push_back(find_material(names, given->second));
  }
  return material;
}

/// Vertical effective stress of the column of soil above, and K0 of it sideways.
template <int D>
void set_k0_stress(const model::Case& data, const mesh::Mesh<D>& mesh, const std::vector<int>& material_of_region,
                   const std::vector<std::string>& names, std::vector<mpm::InitialPoint<D>>& points) {
  std::vector<double> unit_weight(mesh.elements.size(), 0.0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const int region = mesh.element_region[e];
    if (region < 0) continue;
    unit_weight[e] = data.materials.at(names[material_of_region[region]]).density() * data.gravity.acceleration;
  }
  Vec<D> up = find_gravity<D>(data.gravity);
  const double g = norm(up);
  for (double& u : up) u /= -g;
  std::vector<mesh::LocalPoint<D>> places;
  for (const auto& p : points) places.push_back({p.element, p.xi});
  const std::vector<double> overburden = mesh::overburden_integral<D>(mesh, unit_weight, places, up);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const model::Material& m = data.materials.at(names[points[i].material]);
    const double k0 = data.initial.k0.value_or(m.poisson_ratio / (1 - m.poisson_ratio));
    const double vertical = -overburden[i], sideways = k0 * vertical;
    // σ = sideways·I + (vertical - sideways) up⊗up
    auto& s = points[i].stress;
    for (std::size_t d = 0; d < 3; ++d) s[d] = sideways;
    const double extra = vertical - sideways;
    for (std::size_t d = 0; d < D; ++d) s[d] += extra * up[d] * up[d];
    s[3] = extra * up[0] * up[1];
    if constexpr (D == 3) {
      s[4] = extra * up[1] * up[2];
      s[5] = extra * up[2] * up[0];
    }
  }
}

}  // namespace

std::vector<std::string> list_materials(const model::Case& data) {
  std::vector<std::string> names;
  for (const auto& [name, material] : data.materials) names.push_back(name);
  return names;
}

material::Law make_law(const model::Material& m, std::optional<double> cohesion, double factor) {
  const auto elastic = material::LinearElastic::from_young(m.young_modulus, m.poisson_ratio);
  if (m.model == model::MaterialModel::linear_elastic) return elastic;
  material::MohrCoulombStrength strength{m.cohesion, m.friction_angle, m.dilatancy_angle, m.tensile_strength};
  if (cohesion) strength.cohesion = *cohesion;
  return material::MohrCoulomb(elastic, factor == 1 ? strength : strength.reduced(factor));
}

template <int D>
void set_strength(mpm::Body<D>& body, const model::Case& data, std::optional<double> cohesion, double factor) {
  body.laws.clear();
  for (const std::string& name : body.material_names)
    body.laws.push_back(make_law(data.materials.at(name), cohesion, factor));
}

template <int D>
Vec<D> find_gravity(const model::Gravity& gravity) {
  Vec<D> g;
  for (std::size_t d = 0; d < D; ++d) g[d] = gravity.acceleration * gravity.direction[d];
  return g;
}

template <int D>
mpm::Body<D> prepare(const model::Case& data, mesh::Mesh<D> mesh, int chunks) {
  const std::vector<std::string> names = list_materials(data);
  if (names.size() > 32)
    throw Error(ExitCode::wrong_input, fmt::format("{} materials are too many; at most 32 are possible", names.size()));
  const std::vector<int> material_of_region = assign_materials(data, mesh, names);
  const auto positions = mesh::point_positions<D>(data.points_per_element);
  std::vector<mpm::InitialPoint<D>> points;
  std::vector<int> in_element(mesh.elements.size(), 0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const int region = mesh.element_region[e];
    if (region < 0) continue;
    const std::string& region_name = mesh.region_names[region];
    mpm::InitialPoint<D> point;
    point.element = e;
    point.material = material_of_region[region];
    point.volume = mesh.volumes[e] / data.points_per_element;
    point.mass = point.volume * data.materials.at(names[point.material]).density();
    if (const auto v = data.initial.velocity.find(region_name); v != data.initial.velocity.end()) {
      for (std::size_t d = 0; d < D; ++d) point.velocity[d] = v->second[d];
    }
    for (const auto& xi : positions) {
      point.xi = xi;
      points.push_back(point);
    }
    in_element[e] = data.points_per_element;
  }
  if (points.empty())
    throw Error(ExitCode::wrong_input, "no element of the mesh holds soil; check the polygons and the mesh size");
  if (data.initial.stress == model::InitialStress::k0) set_k0_stress<D>(data, mesh, material_of_region, names, points);

  std::vector<material::Law> laws;
  for (const std::string& name : names) laws.push_back(make_law(data.materials.at(name)));
  auto layout = mpm::make_layout<D>(std::move(mesh), in_element, chunks);
  mpm::Body<D> body = mpm::make_body<D>(std::move(layout), std::move(laws), names, points);
  resolve_conditions(body, data);
  return body;
}

template <int D>
double find_soil_height(const mpm::Body<D>& body, const model::Gravity& gravity) {
  // Corners of the elements that hold points, so that the height is the polygon's and not the points'.
  double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();
  for (int e = 0; e < body.mesh().element_count(); ++e) {
    if (body.points.count[e] == 0) continue;
    for (int i : body.mesh().elements[e]) {
      double height = 0;
      for (std::size_t d = 0; d < D; ++d) height -= gravity.direction[d] * body.mesh().nodes[i][d];
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
  }
  return highest - lowest;
}

#define TALUS_INSTANTIATE(D)                                                                       \
  template void set_strength<D>(mpm::Body<D>&, const model::Case&, std::optional<double>, double); \
  template Vec<D> find_gravity<D>(const model::Gravity&);                                          \
  template mpm::Body<D> prepare<D>(const model::Case&, mesh::Mesh<D>, int);                        \
  template double find_soil_height<D>(const mpm::Body<D>&, const model::Gravity&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::analysis
