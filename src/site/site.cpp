// SPDX-License-Identifier: MIT
#include "site/site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "site/initial_water.hpp"

namespace talus::site {

Site::Site(std::shared_ptr<const input::Case> data) : data_(std::move(data)) {
  if (data_->mesh.polygons.empty()) return;
  try {
    ground_ = find_ground(data_->mesh);
  } catch (const Error& fault) {
    fault_ = fault;
    return;
  }
  ponds_ = find_ponds(find_first_time(*data_));
}

const Polyline& Site::ground() const {
  if (fault_) throw Error(*fault_);
  return ground_;
}

const input::Material& Site::get_soil(const std::string& region) const {
  const auto given = data_->regions.find(region);
  const auto material = given == data_->regions.end() ? data_->materials.end() : data_->materials.find(given->second);
  if (material == data_->materials.end())
    throw Error(ExitCode::wrong_input, fmt::format("region '{}' has no material; add it to [regions]", region));
  return material->second;
}

double Site::water_weight() const {
  return find_water_weight(*data_);
}

const Polyline& Site::water_table() const {
  static const Polyline none;
  const input::InitialWater& water = data_->initial.water;
  // At a later time the water on the ground has the levels of [[hydraulic]] where there are any.
  if (water.known && gives_levels(*data_)) return none;
  return water.pressure == input::InitialPressure::water_table ? water.water_table : none;
}

std::vector<Pond> Site::find_ponds(double time) const {
  return has_ground() ? site::find_ponds(*data_, ground_, time) : std::vector<Pond>();
}

std::vector<std::string> Site::list_open_ends() const {
  return has_ground() ? find_open_ends(ponds_, ground_, data_->units().length) : std::vector<std::string>();
}

std::optional<double> Site::find_standing_level(double x) const {
  return has_ground() ? site::find_standing_level(ponds_, water_table(), ground_, x) : std::nullopt;
}

double Site::find_surcharge(double x) const {
  double sum = 0;
  for (const input::Surcharge& s : data_->surcharges) {
    for (std::size_t i = 1; i < s.x.size(); ++i) {
      if (x < s.x[i - 1] || x >= s.x[i]) continue;
      sum += s.load[i - 1] + (s.load[i] - s.load[i - 1]) * (x - s.x[i - 1]) / (s.x[i] - s.x[i - 1]);
    }
  }
  return sum;
}

double Site::find_slurry_pressure(double x, double y) const {
  double sum = 0;
  for (const input::Slurry& s : data_->slurries)
    if (x > s.x[0] && x < s.x[1]) sum += s.unit_weight * std::max(0.0, s.level - y);
  return sum;
}

double Site::find_standing_load(double x) const {
  const auto level = find_standing_level(x);
  return level ? water_weight() * std::max(0.0, *level - find_level(ground_, x)) : 0;
}

template <int D>
Vec<D> Site::find_earthquake() const {
  Vec<D> added{};
  const input::Earthquake& quake = data_->earthquake;
  if (quake.horizontal == 0 && quake.vertical == 0) return added;
  const bool falls_to_the_left = !ground().empty() && ground_.front()[1] < ground_.back()[1];
  const bool is_both = quake.direction == input::EarthquakeDirection::both;
  const bool pushes_left = is_both ? falls_to_the_left : quake.direction == input::EarthquakeDirection::left;
  const double amount = is_both ? std::abs(quake.horizontal) : quake.horizontal;
  added[0] = pushes_left ? -amount : amount;
  added[1] = -quake.vertical;
  return added;
}

template Vec<2> Site::find_earthquake<2>() const;
template Vec<3> Site::find_earthquake<3>() const;

PlaneStrength find_plane_strength(const input::Material& soil) {
  constexpr double unyielding = 1e9;  // [Pa]
  if (!soil.traits().serves_slices)
    throw Error(ExitCode::wrong_input, fmt::format("LEM and limit analysis need a cohesion and a friction angle: they "
                                                   "take the models {}",
                                                   material::list_sliceable()));
  if (soil.known_strength) {
    PlaneStrength known;
    known.law = soil.known_strength;
    return known;
  }
  if (const auto strength = material::find_slice_strength(soil.model, soil)) return {*strength, true};
  PlaneStrength none{{}, false};
  none.cohesion = unyielding;
  return none;
}

double find_water_weight(const input::Case& data) {
  return data.water.density * data.gravity.acceleration;
}

template <int D>
const input::Material* find_soil(const input::Case& data, const mesh::Mesh<D>& mesh, int e) {
  const int region = mesh.element_region[e];
  if (region < 0) return nullptr;
  const auto given = data.regions.find(mesh.region_names[region]);
  const auto material = given == data.regions.end() ? data.materials.end() : data.materials.find(given->second);
  if (material == data.materials.end()) {
    throw Error(ExitCode::wrong_input,
                fmt::format("region '{}' of the mesh has no material; add it to [regions]", mesh.region_names[region]));
  }
  return &material->second;
}

void check_upright(const input::Case& data, const char* what) {
  constexpr double upright = 1e-9;
  if (data.gravity.direction[1] > -1 + upright) {
    throw Error(ExitCode::wrong_input,
                fmt::format("{} is a level of y, so gravity must act along -y; its direction is ({:g}, {:g}, {:g})",
                            what, data.gravity.direction[0], data.gravity.direction[1], data.gravity.direction[2]));
  }
}

template const input::Material* find_soil<2>(const input::Case&, const mesh::Mesh<2>&, int);
template const input::Material* find_soil<3>(const input::Case&, const mesh::Mesh<3>&, int);

}  // namespace talus::site
