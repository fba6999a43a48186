// SPDX-License-Identifier: MIT
#include "run/bounds/case_fields.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/locate.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/initial_water.hpp"
#include "site/roots.hpp"
#include "site/weights.hpp"

namespace talus::run {

namespace {

/// Relative difference of the polygons inside and outside a curved envelope.
constexpr double tolerance_of_envelopes = 0.01;

/// Returns true if find_nodal_pressure() has the pressures of a flow calculation, or of an earlier result.
bool has_flow(const input::Case& data) {
  const input::InitialWater& water = data.initial.water;
  return site::needs_seepage(data) && (water.known || water.pressure == input::InitialPressure::seepage ||
                                       (water.season > 0 && data.initial.result.empty()));
}

bool has_level(const input::Case& data) {
  const input::InitialWater& water = data.initial.water;
  return site::has_pressure_field(data) ||
         (water.pressure == input::InitialPressure::water_table && !water.water_table.empty());
}

bool has_ratio(const input::Case& data, const input::Material& soil) {
  const bool is_grid = data.initial.water.pressure == input::InitialPressure::grid;
  if (is_grid && material::is_total_stress(soil.model, soil)) return false;
  return site::has_pressure_ratio(data) && (is_grid || soil.slices.pore_pressure_ratio != 0);
}

}  // namespace

CaseFields::CaseFields(const site::Site& site, const mesh::Mesh<2>& mesh, site::WaterResult& water)
    : site_(site), data_(site_.data()), columns_(site_), mesh_(mesh) {
  cut_ = has_impermeable_walls(data_) ? cut_at_walls(site_, mesh_) : mesh_;
  nodal_ = site::find_nodal_pressure<2>(data_, cut_, &water);
  water_ = site::hold_water<2>(data_, cut_, nodal_);
  has_pressure_ = water_.acts || has_flow(data_) || has_level(data_) || site::has_pressure_ratio(data_);
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
    if (mesh_.element_region[e] != mesh::empty_region) elements_.push_back(e);
  for (const std::string& region : mesh_.region_names) {
    Soil soil{input::find_limit_soil(site_.get_soil(region)), {}, {}, false};
    soil.strength = site::find_plane_strength(soil.material);
    const bool has_roots = !data_.roots.empty() && soil.material.traits().roots == material::RootEffect::cohesion;
    const StrengthLaw* law = soil.get_law();
    soil.is_variable = has_roots || soil.strength.cohesion_gradient != 0 || (law && !law->is_curved);
    soils_.push_back(std::move(soil));
  }
}

const CaseFields::Soil& CaseFields::get_soil(std::size_t triangle) const {
  return soils_[static_cast<std::size_t>(mesh_.element_region[elements_[triangle]])];
}

std::vector<std::size_t> CaseFields::find_origins(const bounds::Problem& problem) const {
  std::vector<std::size_t> number(mesh_.elements.size(), 0), origins;
  for (std::size_t t = 0; t < elements_.size(); ++t) number[elements_[t]] = t;
  int element = 0;
  for (const bounds::Triangle& triangle : problem.triangles) {
    Vec<2> centre{};
    for (const int node : triangle)
      for (std::size_t d = 0; d < 2; ++d) centre[d] += problem.nodes[static_cast<std::size_t>(node)][d] / 3;
    element = mesh::find_element(mesh_, centre, element);
    if (element < 0) throw Error(ExitCode::internal_error, "a refined triangle lies outside the first mesh");
    origins.push_back(number[static_cast<std::size_t>(element)]);
  }
  return origins;
}

bool CaseFields::has_variable_strength(std::size_t triangle) const {
  return get_soil(triangle).is_variable;
}

void CaseFields::enclose_envelopes(double usual) {
  for (Soil& soil : soils_) {
    const StrengthLaw* law = soil.get_law();
    if (!law || !law->is_curved) continue;
    const auto find_tangent = [&](double normal) {
      StrengthPlane plane;
      plane.normal = normal;
      return law->find_tangent(plane);
    };
    soil.envelope = bounds::enclose_envelope(find_tangent, {law->straight_below, usual, tolerance_of_envelopes});
  }
}

bool CaseFields::has_envelopes() const {
  return std::any_of(soils_.begin(), soils_.end(), [](const Soil& soil) { return soil.envelope.has_value(); });
}

std::vector<double> CaseFields::find_root_cohesions(const std::vector<SoilPlace>& places) const {
  std::vector<Vec<2>> points;
  std::vector<const input::Material*> soils;
  for (const SoilPlace& place : places) {
    points.push_back(place.x);
    soils.push_back(&get_soil(place.triangle).material);
  }
  std::vector<double> cohesions;
  for (const site::RootsAt& roots : site::find_roots<2>(data_, mesh_, points, soils))
    cohesions.push_back(roots.cohesion);
  return cohesions;
}

bounds::Strength CaseFields::find_lines(const Soil& soil, const Vec<2>& x, double root_cohesion,
                                        bounds::Bound bound) const {
  const site::PlaneStrength& given = soil.strength;
  if (!given.yields) return {given.cohesion, 0, {}};
  bounds::Strength lines;
  lines.cohesion =
      given.cohesion + root_cohesion + given.cohesion_gradient * std::max(0.0, given.cohesion_level - x[1]);
  lines.tan_friction = std::tan(given.friction_angle);
  if (soil.envelope) {
    lines = bound == bounds::Bound::lower ? soil.envelope->inner : soil.envelope->outer;
    lines.cohesion += root_cohesion;
  } else if (const StrengthLaw* law = soil.get_law()) {
    lines.cohesion = root_cohesion + law->find_tangent(columns_.find(x)).cohesion;
  }
  lines.is_reduced = soil.material.reduced;
  if (data_.bounds.flow == input::BoundsFlow::davis) {
    const double phi = given.friction_angle, psi = soil.material.dilatancy_angle,
                 fraction = std::cos(psi) * std::cos(phi) / (1 - std::sin(psi) * std::sin(phi));
    lines.cohesion *= fraction, lines.tan_friction *= fraction;
  }
  return lines;
}

bounds::Strength CaseFields::find_strength(const Soil& soil, const Vec<2>& x, double root_cohesion,
                                           bounds::Bound bound) const {
  bounds::Strength strength = find_lines(soil, x, root_cohesion, bound);
  const site::PlaneStrength& given = soil.strength;
  if (!given.yields) return strength;
  if (const auto& planes = given.planes)
    strength.planes = std::make_shared<const bounds::WeakPlanes>(
        bounds::WeakPlanes{planes->angle, planes->cohesion, std::tan(planes->friction_angle)});
  const bool is_limited = data_.bounds.tension == input::BoundsTension::as_given &&
                          (soil.envelope || (soil.material.traits().has_friction && !soil.material.known_strength));
  const double tension = soil.envelope ? given.law->tensile_strength : soil.material.tensile_strength;
  if (is_limited && tension * strength.tan_friction < strength.cohesion) strength.tension = tension;
  return strength;
}

std::vector<std::array<bounds::Strength, 3>> CaseFields::find_strengths(bounds::Bound bound) const {
  std::vector<SoilPlace> places;
  for (std::size_t t = 0; t < elements_.size(); ++t)
    for (const int node : mesh_.elements[elements_[t]])
      places.push_back({t, mesh_.nodes[static_cast<std::size_t>(node)]});
  const std::vector<double> roots = find_root_cohesions(places);
  std::vector<std::array<bounds::Strength, 3>> strengths(elements_.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    strengths[i / 3][i % 3] = find_strength(get_soil(i / 3), places[i].x, roots[i], bound);
  // A tensile strength above the apex of the weakest corner limits the others; one above their own apex limits nothing.
  for (auto& corners : strengths) {
    const auto limited =
        std::find_if(corners.begin(), corners.end(), [](const auto& s) { return s.tension.has_value(); });
    if (limited == corners.end()) continue;
    const std::optional<double> tension = limited->tension;
    for (bounds::Strength& s : corners) s.tension = tension;
  }
  return strengths;
}

std::vector<double> CaseFields::find_cohesions(const std::vector<SoilPlace>& places, bounds::Bound bound) const {
  std::vector<double> cohesions;
  const std::vector<double> roots = find_root_cohesions(places);
  for (std::size_t i = 0; i < places.size(); ++i)
    cohesions.push_back(find_lines(get_soil(places[i].triangle), places[i].x, roots[i], bound).cohesion);
  return cohesions;
}

double CaseFields::find_nodal(std::size_t element, const Vec<2>& x) const {
  const auto xi = mesh::to_local(cut_, static_cast<int>(element), x);
  const auto& corners = cut_.elements[element];
  const auto at = [&](std::size_t c) { return nodal_[static_cast<std::size_t>(corners[c])]; };
  return (1 - xi[0] - xi[1]) * at(0) + xi[0] * at(1) + xi[1] * at(2);
}

/// Returns the pressure of an earlier result in the triangle of its own mesh.
double CaseFields::find_known(std::size_t element, const Vec<2>& x) const {
  const input::KnownWater& known = *data_.initial.water.known;
  const int e = mesh::find_element(known.mesh, x, last_known_);
  if (e < 0) return find_nodal(element, x);
  last_known_ = e;
  const auto xi = mesh::to_local(known.mesh, e, x);
  const auto& corners = known.mesh.elements[static_cast<std::size_t>(e)];
  const auto at = [&](std::size_t c) { return known.pressure[static_cast<std::size_t>(corners[c])]; };
  return (1 - xi[0] - xi[1]) * at(0) + xi[0] * at(1) + xi[1] * at(2);
}

/// Returns the pressure without r_u, as site::hold_water() has it at the corners.
double CaseFields::find_pressure(const SoilPlace& place) const {
  const std::size_t element = elements_[place.triangle];
  const input::Material& soil = *site::find_soil(data_, mesh_, static_cast<int>(element));
  const site::PressureSource source = site::find_pressure_source(data_, soil);
  if (source == site::PressureSource::none || material::is_total_stress(soil.model, soil)) return 0;
  double p = 0;
  if (source == site::PressureSource::given)
    p = site::find_given_pressure<2>(data_, soil, place.x);
  else
    p = data_.initial.water.known ? find_known(element, place.x) : find_nodal(element, place.x);
  return -(p > 0 ? site::find_suction_stress(soil, p) : p);
}

std::vector<double> CaseFields::find_pressures(const std::vector<SoilPlace>& places) const {
  std::vector<double> pressures(places.size(), 0);
  std::vector<mesh::LocalPoint<2>> loaded;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto element = static_cast<int>(elements_[places[i].triangle]);
    pressures[i] = find_pressure(places[i]);
    if (!has_ratio(data_, *site::find_soil(data_, mesh_, element))) continue;
    loaded.push_back({element, mesh::to_local(cut_, element, places[i].x)});
    numbers.push_back(i);
  }
  if (loaded.empty()) return pressures;
  const Vec<2> up{-data_.gravity.direction[0], -data_.gravity.direction[1]};
  const std::vector<double> overburden = mesh::overburden_integral<2>(cut_, water_.unit_weight, loaded, up);
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    const input::Material& soil = *site::find_soil(data_, mesh_, loaded[k].element);
    pressures[numbers[k]] = site::find_pressure_ratio<2>(data_, soil, places[numbers[k]].x) * overburden[k];
  }
  return pressures;
}

}  // namespace talus::run
