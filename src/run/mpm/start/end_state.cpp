// SPDX-License-Identifier: MIT
#include "run/mpm/start/end_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "input/echo.hpp"
#include "mpm/kernels/pore_state.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/start/body_archive.hpp"
#include "site/roots.hpp"

namespace talus::run {
namespace {

/// Samples the water storage of a soil, so that equal laws have equal samples: density, and water content at pressures
/// from compression to the suction of dry clay [Pa].
std::vector<double> sample_storage(const mpm::WaterLaw& law) {
  std::vector<double> sample{law.wet ? 1.0 : 0.0, law.density, mpm::find_content(law, -1e6)};
  for (int i = -4; i <= 28; ++i) sample.push_back(mpm::find_content(law, std::pow(10, 0.25 * i)));
  return sample;
}

std::vector<double> sample_storage(const std::vector<mpm::WaterLaw>& laws) {
  std::vector<double> all;
  for (const mpm::WaterLaw& law : laws) {
    const std::vector<double> one = sample_storage(law);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

/// Returns for each old material the set of new materials of its soil.
std::vector<std::set<int>> map_materials(const std::vector<int>& old, std::span<const std::uint8_t> now) {
  std::vector<std::set<int>> map;
  for (std::size_t id = 0; id < old.size() && id < now.size(); ++id) {
    const std::size_t m = static_cast<std::size_t>(old[id]);
    if (m >= map.size()) map.resize(m + 1);
    map[m].insert(now[id]);
  }
  return map;
}

/// Returns the pairs of old and new material numbers that store water differently.
std::set<std::pair<int, int>> find_refilled(const output::ArchiveReader& archive,
                                            const std::vector<std::set<int>>& materials,
                                            const std::vector<mpm::WaterLaw>& laws) {
  std::set<std::pair<int, int>> refilled;
  if (laws.empty()) return refilled;
  const std::vector<double>& before = archive.reals("water/retention_samples");
  for (std::size_t old = 0; old < materials.size(); ++old) {
    for (const int now : materials[old]) {
      const mpm::WaterLaw& law = laws[static_cast<std::size_t>(now)];
      const std::vector<double> sample = sample_storage(law);
      const std::size_t at = old * sample.size();
      const bool same = at + sample.size() <= before.size() &&
                        std::equal(sample.begin(), sample.end(), before.begin() + static_cast<std::ptrdiff_t>(at));
      if (law.wet && !same) refilled.insert({static_cast<int>(old), now});
    }
  }
  return refilled;
}

/// Converts slots with the state variables of the old materials to those of the new ones.
template <int D>
void adapt_fields(mpm::Points<D>& points, int fields, int water_fields) {
  const std::size_t slots = points.id.size() / lane_width;
  if (slots == 0) return;
  const int old = static_cast<int>(points.data.size() / (slots * lane_width));
  points.fields = fields;
  if (old == fields) return;
  const int kept = std::min(old, fields) - water_fields;
  AlignedVector<double> data(slots * static_cast<std::size_t>(fields * lane_width), 0.0);
  for (std::size_t s = 0; s < slots; ++s) {
    const double* from = &points.data[s * static_cast<std::size_t>(old * lane_width)];
    double* to = &data[s * static_cast<std::size_t>(fields * lane_width)];
    std::copy_n(from, kept * lane_width, to);
    std::copy_n(from + (old - water_fields) * lane_width, water_fields * lane_width,
                to + (fields - water_fields) * lane_width);
  }
  points.data = std::move(data);
}

/// Sets the water content of points in such materials to that of their pressure.
template <int D>
void refill(mpm::Body<D>& body, const std::vector<int>& old_materials, const std::set<std::pair<int, int>>& refilled) {
  using P = mpm::Points<D>;
  using W = mpm::WaterFields<D>;
  for (int id = 0; id < body.points.size(); ++id) {
    const int material = body.points.material[id];
    if (!mpm::is_present(body, id) || !refilled.contains({old_materials[id], material})) continue;
    const std::int64_t place = body.points.place[id];
    double* p = body.points.slot(place / lane_width) + place % lane_width;
    double* w = p + body.water.first_field * lane_width;
    const mpm::WaterLaw& law = body.water.laws[material];
    const double pressure = w[W::pressure * lane_width],
                 pores = p[P::volume * lane_width] - p[P::mass * lane_width] / law.grain_density;
    w[W::mass * lane_width] = mpm::find_content(law, pressure) * law.density * pores;
    w[W::capacity * lane_width] = mpm::find_state_at_pressure<double>(law, pressure).capacity;
  }
}

template <class Values>
std::string hash_values(const Values& values) {
  return hash_text({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])});
}

}  // namespace

EndState::EndState(const input::Initial& initial)
    : result_(initial.result), archive_(std::filesystem::path(initial.result_folder) / end_state_file) {
  check_lane_width(archive_, fmt::format("the result '{}'", initial.result), "start from it");
  input_ = JsonTree::parse(archive_.text("input"));
}

results::Origin EndState::tell() const {
  return {result_, hash(), input::read_echo(input_).title, archive_.text("input_hash"),
          archive_.reals("scalars").front()};
}

bool EndState::is_on_another_mesh(const JsonTree& echo) const {
  return !input::has_same_mesh_input(echo, input_);
}

int EndState::points_per_element() const {
  return input::read_echo(input_).points_per_element;
}

std::vector<input::MaterialModel> EndState::list_models() const {
  const std::vector<input::MaterialModel> by_number = input::list_material_models(input_, result_);
  std::vector<input::MaterialModel> models;
  for (const int number : archive_.integers("points/material"))
    models.push_back(by_number[static_cast<std::size_t>(number)]);
  return models;
}

bool EndState::has_roots_of(const input::Case& data) const {
  return archive_.has("roots") && archive_.text("roots") == site::write_root_input(data);
}

template <int D>
mesh::Mesh<D> EndState::get_mesh() const {
  return run::get_mesh<D>(archive_);
}

template <int D>
void EndState::take_over(mpm::Body<D>& body) const {
  const bool wet = body.water.is_wet();
  if (archive_.has("water/moments") != wet) {
    throw Error(ExitCode::wrong_input, fmt::format("the result '{}' is one of {} soil, and this case has {} pore water",
                                                   result_, wet ? "dry" : "wet", wet ? "some" : "no"));
  }
  const mpm::Body<D> fresh = body;
  get_body(archive_, body);
  body.points.material = fresh.points.material;
  const std::vector<int>& old_materials = archive_.integers("points/material");
  const auto materials = map_materials(old_materials, fresh.points.material);
  for (std::uint32_t& bits : body.points.block_materials) {
    std::uint32_t now = 0;
    for (std::size_t m = 0; m < materials.size(); ++m) {
      if ((bits >> m & 1u) == 0) continue;
      for (const int n : materials[m]) now |= 1u << n;
    }
    bits = now;
  }
  adapt_fields(body.points, fresh.points.fields, wet ? mpm::WaterFields<D>::count : 0);
  const auto refilled = find_refilled(archive_, materials, body.water.laws);
  refill(body, old_materials, refilled);
  if (!refilled.empty())
    body.water.darcy.own.clear();  // the pressures are unchanged; the water stored at nodes for them is not
  // Nodal values follow from the points and are gathered at the start of the stage; another version may number the
  // rows differently.
  if (body.nodes.sums.size() != fresh.nodes.sums.size()) {
    body.nodes = fresh.nodes;
    body.water.sums = fresh.water.sums;
    body.water.motion = fresh.water.motion;
  }
  body.nodes.load = fresh.nodes.load;
  body.water.budgets = fresh.water.budgets;
  body.water.lost_between = body.water.left_grid = body.water.pressed_in = 0;
  body.lost.clear();
  body.time = 0;
  body.step_count = 0;
  mpm::reset_displacements(body);
  for (int id = 0; id < body.points.size(); ++id)
    if (mpm::is_present(body, id)) return;
  throw Error(ExitCode::wrong_input, fmt::format("in the result '{}' all soil has left the grid", result_));
}

template <int D>
std::vector<std::string> EndState::list_refilled(const mpm::Body<D>& body) const {
  std::vector<std::string> names;
  const auto materials = map_materials(archive_.integers("points/material"), body.points.material);
  for (const auto& [old, now] : find_refilled(archive_, materials, body.water.laws)) {
    const std::string& name = body.material_names[static_cast<std::size_t>(now)];
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

template <int D>
void save_end_state(const std::filesystem::path& folder, const JsonTree& echo, const JsonTree& mesh_input,
                    const std::string& input_hash, const mpm::Body<D>& body, const std::string& roots) {
  output::ArchiveWriter archive;
  archive.put("input", input::replace_mesh_input(echo, mesh_input).write());
  archive.put("input_hash", input_hash);
  archive.put("roots", roots);
  archive.put("state_hash",
              hash_text(hash_values(body.mesh().nodes) + hash_values(body.points.data) + hash_values(body.points.id)));
  if (body.water.is_wet()) archive.put("water/retention_samples", sample_storage(body.water.laws));
  put_mesh(archive, body.mesh());
  put_body(archive, body);
  archive.write(folder / end_state_file);
}

#define TALUS_INSTANTIATE(D)                                                                                          \
  template mesh::Mesh<D> EndState::get_mesh<D>() const;                                                               \
  template void EndState::take_over<D>(mpm::Body<D>&) const;                                                          \
  template std::vector<std::string> EndState::list_refilled<D>(const mpm::Body<D>&) const;                            \
  template void save_end_state<D>(const std::filesystem::path&, const JsonTree&, const JsonTree&, const std::string&, \
                                  const mpm::Body<D>&, const std::string&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
