// SPDX-License-Identifier: MIT
#include "run/fem/solid_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "input/case/support.hpp"
#include "material/every_law.hpp"
#include "mesh/generate.hpp"
#include "mesh/locate.hpp"
#include "run/common/bars_of_case.hpp"
#include "run/common/bedding_lines.hpp"
#include "run/common/soil_column.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/fem/element_run.hpp"
#include "site/ground_load.hpp"
#include "site/initial_water.hpp"
#include "site/known_state.hpp"
#include "site/mesh_sides.hpp"
#include "site/pore_water.hpp"
#include "site/roots.hpp"

namespace talus::run {

namespace {

/// Least component of a unit normal that counts as parallel to an axis.
constexpr double along_axis = 1 - 1e-9;

/// Material and model from which the law of a region is made.
struct RegionSoil {
  input::Material material;  ///< rooted if cohesion varies in space
  bool varies = false;       ///< cohesion is a state variable of the points
};

RegionSoil make_region_soil(const site::Site& site, const std::string& region) {
  RegionSoil soil{find_trial_soil(site.data(), site.get_soil(region))};
  if (!soil.material.traits().serves_slices || soil.material.traits().only_slices)
    throw Error(ExitCode::wrong_input,
                fmt::format("FEM cannot reduce the strength of material '{}': it takes the models {}",
                            site.data().regions.at(region),
                            material::list_words(
                                [](const material::Traits& t) { return t.serves_slices && !t.only_slices; }, " and ")));
  if (const auto local = material::find_local_model(soil.material.model, soil.material)) {
    soil.varies = true;
    soil.material.model = *local;
  }
  return soil;
}

template <int D>
std::vector<RegionSoil> list_soils(const site::Site& site, const mesh::Mesh<D>& mesh) {
  std::vector<RegionSoil> soils;
  for (const std::string& region : mesh.region_names) soils.push_back(make_region_soil(site, region));
  return soils;
}

/// Throws if FEM does not support this boundary.
void check_boundary(const input::Boundary& b) {
  if (b.fix == input::Fix::plane &&
      std::none_of(b.normal.begin(), b.normal.end(), [](double n) { return std::abs(n) > along_axis; }))
    throw Error(ExitCode::wrong_input,
                fmt::format("FEM can fix '{}' along x, y or z only, not along ({:g}, {:g}, {:g}); use fix = "
                            "\"normal\" on an inclined side",
                            b.on, b.normal[0], b.normal[1], b.normal[2]));
  if (b.fix != input::Fix::friction && b.fix != input::Fix::velocity) return;
  throw Error(ExitCode::wrong_input,
              fmt::format("FEM has no {}: take \"fem\" out of [analysis] methods, or let fix of the boundary "
                          "'{}' be full or normal",
                          b.fix == input::Fix::friction ? "wall with friction" : "boundary that moves", b.on));
}

template <int D>
fem::Support<D> make_support(const input::Boundary& b, const mesh::Mesh<D>& mesh) {
  check_boundary(b);
  fem::Support<D> support;
  support.name = b.on;
  support.sides = site::find_sides(mesh, b.on);
  support.along_normal = b.fix == input::Fix::normal;
  for (std::size_t d = 0; d < D; ++d)
    support.fixed[d] = b.fix == input::Fix::full || (b.fix == input::Fix::plane && std::abs(b.normal[d]) > along_axis);
  return support;
}

template <int D>
class SolidBuilder {
 public:
  SolidBuilder(const site::Site& site, SolidOfCase<D>& solid)
      : site_(site), data_(site_.data()), solid_(solid), mesh_(*solid.mesh), soils_(list_soils<D>(site_, mesh_)) {}

  void build() {
    fem::SolidModel<D>& model = solid_.model;
    model.mesh = &mesh_;
    model.units = data_.units();
    model.softening_length = data_.softening_length.value_or(0);
    // Throws for a section without a unique ground.
    if (!data_.mesh.polygons.empty() && site::needs_ground(site_)) site_.ground();
    model.direction = site_.find_body_force<D>();
    solid_.notes = site_.list_open_ends();
    for (const input::Boundary& b : data_.boundaries) model.supports.push_back(make_support<D>(b, mesh_));
    set_water();
    model.loads = site::make_surface_loads<D>(site_, mesh_);
    if constexpr (D == 2) add_bars();
    if (data_.initial.stress != input::InitialStress::none) set_k0_stress();
    if constexpr (D == 2) {
      if (data_.initial.known_stress) set_known_stress(*data_.initial.known_stress);
    }
    set_start();
  }

 private:
  const input::Material& get_soil(int e) const { return soils_[mesh_.element_region[e]].material; }
  bool is_soil(int e) const { return mesh_.element_region[e] != mesh::empty_region; }

  /// Sets unit weights, χp and saturation.
  void set_water() {
    site::HeldWater<D> water = has_impermeable_walls(data_)
                                   ? site::find_held_water<D>(data_, cut_at_walls(site_, mesh_), &solid_.water)
                                   : site::find_held_water<D>(data_, mesh_, &solid_.water);
    fem::SolidModel<D>& model = solid_.model;
    model.unit_weight = std::move(water.unit_weight);
    model.saturation.assign(mesh_.elements.size(), 1.0);
    pore_ = std::move(water.pore);
    if (water.acts) model.pore_stress = pore_;
  }

  void add_bars() {
    if (data_.supports.empty()) return;
    solid_.model.bars = make_bars(site_);
    solid_.model.walls = make_walls(site_, mesh_);
    solid_.notes.push_back(describe_bars(data_));
  }

  /// Sets the vertical effective stress of the overburden of soil and water, and K0 times it horizontally.
  void set_k0_stress() {
    std::vector<mesh::LocalPoint<D>> places;
    Vec<D> middle;
    middle.fill(1.0 / (D + 1));
    for (int e = 0; e < mesh_.element_count(); ++e)
      if (is_soil(e)) places.push_back({e, middle});
    Vec<D> up;
    for (std::size_t d = 0; d < D; ++d) up[d] = -data_.gravity.direction[d];
    const std::vector<double> overburden = mesh::overburden_integral<D>(mesh_, solid_.model.unit_weight, places, up);
    solid_.model.initial_stress.assign(mesh_.elements.size(), {});
    for (std::size_t i = 0; i < places.size(); ++i) {
      const int e = places[i].element;
      const input::Material& m = get_soil(e);
      const Vec<D> x = mesh::to_global(mesh_, e, middle);
      double above = overburden[i], pore = 0;
      if (site_.has_ground()) {
        above += site_.find_surcharge(x[0]);
        above += site_.find_standing_load(x[0]);
        above += site_.find_slurry_pressure(x[0], site::find_level(site_.ground(), x[0]));
      }
      for (const double p : pore_[e]) pore += p / (D + 1);
      const double k0 = data_.initial.k0.value_or(m.poisson_ratio / (1 - m.poisson_ratio)), vertical = -above - pore,
                   sideways = k0 * vertical, extra = vertical - sideways;
      auto& s = solid_.model.initial_stress[e];
      for (std::size_t d = 0; d < 3; ++d) s[d] = sideways;
      for (std::size_t d = 0; d < D; ++d) s[d] += extra * up[d] * up[d];
      s[3] = extra * up[0] * up[1];
      if constexpr (D == 3) {
        s[4] = extra * up[1] * up[2];
        s[5] = extra * up[2] * up[0];
      }
    }
  }

  /// Sets the stress of an earlier calculation, at the integration points, each nearest to a corner.
  void set_known_stress(const input::KnownStress& known) {
    constexpr double near = 2.0 / 3, far = 1.0 / 6;
    site::StressReader reader(known, mesh_);
    solid_.model.point_stress.assign(mesh_.elements.size() * input::KnownStress::points, {});
    for (int e = 0; e < mesh_.element_count(); ++e) {
      if (!is_soil(e)) continue;
      for (std::size_t q = 0; q < input::KnownStress::points; ++q)
        solid_.model.point_stress[static_cast<std::size_t>(e) * input::KnownStress::points + q] =
            reader.read(e, {q == 1 ? near : far, q == 2 ? near : far}).stress;
    }
  }

  /// Cohesion that varies in space is a state variable of the points.
  void set_start() {
    if (std::none_of(soils_.begin(), soils_.end(), [](const RegionSoil& s) { return s.varies; })) return;
    std::vector<material::Law> laws;
    for (const RegionSoil& soil : soils_) laws.push_back(input::make_law(soil.material));
    solid_.model.set_state = [site = site_, mesh = solid_.mesh, soils = soils_, laws = std::move(laws),
                              columns = SoilColumns(site_)](int region, const Vec<D>& x, double* state) {
      const RegionSoil& soil = soils[region];
      if (!soil.varies) return;
      const input::Material& given = site.get_soil(mesh->region_names[region]);
      material::StateStart start{
          .stress = nullptr,
          .root_cohesion = site::find_roots<D>(site.data(), *mesh, {x}, {&given}).front().cohesion,
          .level = x[1]};
      add_column<D>(columns, x, start);
      material::set_initial_state(laws[region], soil.material, start, state);
    };
  }

  const site::Site site_;
  const input::Case& data_;
  SolidOfCase<D>& solid_;
  const mesh::Mesh<D>& mesh_;
  std::vector<RegionSoil> soils_;
  std::vector<std::array<double, D + 1>> pore_;
};

void set_associated(input::Material& material) {
  material.dilatancy_angle = material.friction_angle;
  material.dilatancy_ratio = 1;
  material.bedding_dilatancy = material.bedding_friction;
  material.is_associated = true;
}

template <int D>
void set_laws(const site::Site& site, SolidOfCase<D>& solid, bool associated, input::DavisRule davis) {
  std::vector<RegionSoil> soils = list_soils<D>(site, *solid.mesh);
  std::vector<double> dilatancy;  // of the soils as given [rad]
  for (RegionSoil& soil : soils) {
    dilatancy.push_back(soil.material.dilatancy_angle);
    if (associated || davis != input::DavisRule::none) set_associated(soil.material);
  }
  solid.model.make_law = [soils = std::move(soils), dilatancy = std::move(dilatancy), davis](int region,
                                                                                             double factor) {
    const auto r = static_cast<std::size_t>(region);
    const input::Material& soil = soils[r].material;
    // Strengths times β that are divided by F are those divided by F/β; β acts in soil that is not reduced too.
    const double own = soil.reduced ? factor : 1;
    return material::make_law(soil.model, soil,
                              {own / compute_davis_share(davis, soil.friction_angle, dilatancy[r], own), {}});
  };
}

}  // namespace

input::Material find_trial_soil(const input::Case& data, const input::Material& soil) {
  return data.fem.softening == input::FemSoftening::progressive ? soil : input::find_limit_soil(soil);
}

bool softens_in_trials(const input::Case& data) {
  return data.fem.softening == input::FemSoftening::progressive &&
         std::any_of(data.regions.begin(), data.regions.end(), [&](const auto& region) {
           return material::needs<material::SofteningRange>(data.materials.at(region.second).model);
         });
}

double compute_davis_share(input::DavisRule rule, double friction_angle, double dilatancy_angle, double factor) {
  if (rule == input::DavisRule::none) return 1;
  double phi = friction_angle, psi = dilatancy_angle;
  if (rule != input::DavisRule::a) phi = std::atan(std::tan(phi) / factor);
  if (rule == input::DavisRule::b) psi = std::atan(std::tan(psi) / factor);
  if (psi >= phi) return 1;
  return std::cos(psi) * std::cos(phi) / (1 - std::sin(psi) * std::sin(phi));
}

mesh::Plan make_fem_plan(const site::Site& site, double share) {
  const input::Case& data = site.data();
  if (!data.mesh.file.empty()) return data.mesh;
  mesh::Plan plan = conform_to_walls(site, site::conform_to_loads(site, data.mesh));
  plan.algorithm = data.fem.algorithm;
  if (!data.fem.size && share == 1) return plan;
  const double size = share * data.fem.size.value_or(plan.size);
  return mesh::resize(std::move(plan), size);
}

void check_solid(const site::Site& site) {
  for (const auto& [region, material] : site.data().regions) make_region_soil(site, region);
  for (const input::Boundary& b : site.data().boundaries) check_boundary(b);
  if (!site.data().mesh.polygons.empty() && site::needs_ground(site)) site.ground();
}

template <int D>
SolidOfCase<D> make_solid(const site::Site& site, double share) {
  std::vector<std::string> notes;
  SolidOfCase<D> solid = make_solid_on<D>(site, std::make_shared<const mesh::Mesh<D>>(generate_along_bedding<D>(
                                                    site.data(), make_fem_plan(site, share), notes)));
  solid.notes.insert(solid.notes.end(), notes.begin(), notes.end());
  return solid;
}

template <int D>
SolidOfCase<D> make_solid_on(const site::Site& site, std::shared_ptr<const mesh::Mesh<D>> mesh) {
  SolidOfCase<D> solid;
  solid.mesh = std::move(mesh);
  set_laws<D>(site, solid, false, input::DavisRule::none);
  SolidBuilder<D>(site, solid).build();
  return solid;
}

template <int D>
void set_trial_laws(const site::Site& site, SolidOfCase<D>& solid, bool associated) {
  set_laws<D>(site, solid, associated, associated ? input::DavisRule::none : site.data().fem.davis);
}

#define TALUS_INSTANTIATE(D)                                                                         \
  template SolidOfCase<D> make_solid<D>(const site::Site&, double);                                  \
  template SolidOfCase<D> make_solid_on<D>(const site::Site&, std::shared_ptr<const mesh::Mesh<D>>); \
  template void set_trial_laws<D>(const site::Site&, SolidOfCase<D>&, bool);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

namespace {

/// Fraction of the elements that do not reach γ_c.
constexpr double below_band = 0.97;

/// Elements, area, outline and altitudes of a region, and its largest shear strain.
struct Layer {
  int elements = 0;
  double area = 0;       ///< [m²]
  double perimeter = 0;  ///< [m]
  double altitudes = 0;  ///< sum over `counted` [m]
  int counted = 0;       ///< elements of which the altitudes count
  double strain = 0;

  /// Rows of elements over the thickness, which for a long layer is twice the area over the perimeter.
  double count_rows() const { return perimeter > 0 && counted > 0 ? 2 * area / perimeter / (altitudes / counted) : 0; }
};

/// Length of the sides of element `e` at another region or at the boundary [m].
double find_outline(const mesh::Mesh<2>& mesh, int e) {
  double length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int other = mesh.neighbours[e][k];
    if (other >= 0 && mesh.element_region[other] == mesh.element_region[e]) continue;
    const auto &a = mesh.nodes[mesh.elements[e][(k + 1) % 3]], &b = mesh.nodes[mesh.elements[e][(k + 2) % 3]];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

}  // namespace

template <int D>
std::vector<double> compute_element_strains(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& motion) {
  std::vector<double> strains;
  const std::size_t elements = mesh.elements.size(), per = elements > 0 ? mesh.points.size() / elements : 0;
  for (std::size_t e = 0; e < elements; ++e) {
    double sum = 0;
    for (std::size_t k = e * per; k < (e + 1) * per; ++k) sum += find_shear_strain(motion.strain[k]);
    strains.push_back(sum / static_cast<double>(per));
  }
  return strains;
}
template std::vector<double> compute_element_strains<2>(const fem::QuadraticMesh<2>&, const fem::SolidState<2>&);
template std::vector<double> compute_element_strains<3>(const fem::QuadraticMesh<3>&, const fem::SolidState<3>&);

double compute_band_strain(std::vector<double> strains) {
  const auto at = strains.begin() + static_cast<std::ptrdiff_t>(below_band * static_cast<double>(strains.size() - 1));
  std::nth_element(strains.begin(), at, strains.end());
  return *at;
}

std::vector<std::string> list_thin_layers(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                                          const fem::SolidState<2>& motion, bool is_adapted) {
  const std::vector<double> strains = compute_element_strains<2>(quadratic, motion);
  if (strains.empty()) return {};
  const double band = compute_band_strain(strains);
  std::vector<Layer> layers(mesh.region_names.size());
  for (std::size_t i = 0; i < strains.size(); ++i) {
    const int e = quadratic.linear_element[i];
    Layer& layer = layers[static_cast<std::size_t>(mesh.element_region[e])];
    ++layer.elements;
    layer.area += mesh.volumes[e];
    layer.perimeter += find_outline(mesh, e);
    if (!is_adapted || strains[i] >= band) layer.altitudes += mesh.altitudes[e], ++layer.counted;
    layer.strain = std::max(layer.strain, strains[i]);
  }
  std::vector<std::string> thin;
  for (std::size_t r = 0; r < layers.size(); ++r)
    if (layers[r].elements > 0 && layers[r].strain >= band && layers[r].count_rows() < fewest_element_rows)
      thin.push_back(mesh.region_names[r]);
  return thin;
}

}  // namespace talus::run
