// SPDX-License-Identifier: MIT
#include "run/check_case.hpp"

#include <cmath>
#include <filesystem>
#include <set>

#include "mesh/generate.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/common/mesh_estimate.hpp"
#include "run/common/section_of_case.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/construction/stage_model.hpp"
#include "run/construction/stage_record.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/lem/run_lem.hpp"
#include "site/design_values.hpp"
#include "site/flow_measures.hpp"
#include "site/ground_load.hpp"
#include "site/initial_water.hpp"
#include "site/season.hpp"
#include "site/seepage_model.hpp"
#include "site/site.hpp"

namespace talus::run {

bool asks_for_elements(const input::Case& data) {
  if (!input::uses(data, Method::mpm)) return false;
  return data.initial.stress == input::InitialStress::elements ||
         (data.timeline && data.timeline->release &&
          data.timeline->release->criterion == input::ReleaseCriterion::equilibrium);
}

std::vector<std::string> list_warnings(const input::LoadedCase& loaded) {
  std::vector<std::string> lines;
  for (const Diagnostic& warning : loaded.warnings) lines.push_back(input::write_warning(warning));
  if (!loaded.is_whole) return lines;
  const site::DesignValues design = site::apply_partial_factors(loaded.data);
  for (const std::string& sentence : list_ground_warnings(design.data)) lines.push_back("warning: " + sentence);
  return lines;
}

namespace {

/// Checks that no water stands on a mesh without a ground of polygons. MPM applies heads and pressures itself.
template <int D>
void check_water_on(const input::Case& data, const mesh::Mesh<D>& mesh) {
  const bool has_elements = input::uses(data, Method::fem) || asks_for_elements(data);
  if (has_elements || input::uses(data, Method::mpm))
    site::check_standing_water<D>(data, mesh, {.hydraulics = has_elements});
}

/// Checks the ground of a case for MPM, which needs one with a slurry, an earthquake or standing water.
void check_ground(const site::Site& site) {
  const input::Case& data = site.data();
  if (data.mesh.polygons.empty() || site.has_ground()) return;
  if (!data.slurries.empty() || data.earthquake.horizontal != 0 || data.earthquake.vertical != 0) site.ground();
  if (site.water_table().empty() || !is_meshed_in_a_moment(data.mesh)) return;
  if (data.mesh.dimension == 2)
    check_water_on(data, mesh::generate<2>(data.mesh));
  else
    check_water_on(data, mesh::generate<3>(data.mesh));
}

}  // namespace

void check_ready_mesh(const input::LoadedCase& loaded) {
  constexpr std::uintmax_t most_bytes = 20'000'000;
  const mesh::Plan& plan = loaded.data.mesh;
  if (plan.file.empty() || std::filesystem::file_size(plan.file) > most_bytes) return;
  const auto check = [&](const auto& mesh) {
    std::set<std::string> sides, regions(mesh.region_names.begin(), mesh.region_names.end());
    for (const auto& [name, list] : mesh.sides) sides.insert(name);
    input::check_against_mesh(loaded, sides, regions);
    check_water_on(loaded.data, mesh);
  };
  if (plan.dimension == 2)
    check(mesh::generate<2>(plan));
  else
    check(mesh::generate<3>(plan));
}

namespace {

/// Returns the element size for which a section has about `most_checked` elements, `size` if it has fewer [m]. Faults
/// of a section show on a coarse mesh, which takes a moment.
double find_checked_size(const mesh::Plan& plan, double size) {
  constexpr double most_checked = 4000;
  const double count = count_elements(mesh::resize(plan, size)).soil;
  return count > most_checked ? size * std::sqrt(count / most_checked) : size;
}

/// Checks the section of every stage and the places of monitors, and that something bears the section.
void check_stages(input::Case data) {
  data.fem.size = find_checked_size(data.mesh, data.fem.size.value_or(data.mesh.size));
  std::vector<std::string> notes;
  const auto mesh = make_whole_mesh(data, notes);
  const StageRecord record(data, mesh);
  for (int k = before_stages; k < static_cast<int>(data.construction.size()); ++k)
    make_stage_model(data, k, mesh, nullptr);
}

/// Checks the sections and blocks of a seepage analysis on a coarse mesh.
void check_flow(input::Case data) {
  const bool is_plane = data.mesh.dimension == 2 && data.mesh.file.empty();
  if (!is_plane || (data.seepage.sections.empty() && data.seepage.blocks.empty())) return;
  data.mesh = mesh::resize(data.mesh, find_checked_size(data.mesh, data.mesh.size));
  const site::Site site(site::close_sides(data));
  const mesh::Mesh<2> mesh = generate_for_seepage<2>(site);
  mesh::Mesh<2> wet_mesh;
  const fem::SeepageModel<2> model = site::make_seepage_model<2>(site.data(), mesh, wet_mesh);
  const site::FlowMeasures<2> measures(site, mesh, model);
}

}  // namespace

void check_methods(const input::Case& data) {
  if (!data.construction.empty()) {
    if (is_meshed_in_a_moment(data.mesh)) check_stages(data);
    return;
  }
  // Levels before and after a drawdown are compared in the section; its steady seepage takes seconds.
  const bool is_meshed = is_meshed_in_a_moment(data.mesh);
  const bool compares_levels = is_meshed && data.lem.drawdown && data.initial.water.season == 0;
  const site::Site site(data);
  if (input::uses(data, Method::lem) && (compares_levels || !site::needs_seepage(data))) prepare_slope(site);
  if (input::uses(data, Method::fem) || asks_for_elements(data)) {
    check_solid(site);
    if (site.has_ground()) list_walls(site);  // which check_walls() judges
  }
  if (input::uses(data, Method::seepage) && is_meshed) check_flow(data);
  if (input::uses(data, Method::mpm)) check_ground(site);
  if (!input::uses(data, Method::bounds)) return;
  check_bounds(data);
  // This makes a coarse mesh and checks its loads.
  if (is_meshed && !site::needs_seepage(data)) make_bounds_problem(site);
}

}  // namespace talus::run
