// SPDX-License-Identifier: MIT
// The search on meshes that are refined where the soil shears.

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/extrapolate.hpp"
#include "mesh/bisect.hpp"
#include "run/common/bedding_lines.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/fem/adapted_mesh.hpp"

namespace talus::run {

namespace {

/// Expected fall of the factor from the first mesh to the second, over the factor, and half the width of the first
/// bracket over the fall that is expected. They change the number of trials only.
constexpr double first_fall = 0.03, bracket_of_fall = 0.5;

/// Number of meshes from which the order of convergence is observed.
constexpr std::size_t fewest_meshes = 3;

/// Returns the options of the search on the next of these meshes. The difference is expected to halve with the size, so
/// that few trials suffice. The bracket is half as wide, since its width is part of the interval.
fem::ReductionOptions narrow_options(fem::ReductionOptions options,
                                     const std::vector<results::ElementMeshFactor>& meshes) {
  const results::ElementMeshFactor& last = meshes.back();
  double fall = first_fall * last.factor;
  if (meshes.size() > 1) fall = 0.5 * std::max(0.0, meshes[meshes.size() - 2].factor - last.factor);
  options.resolution *= 0.5;
  const double reach = std::max(options.resolution, bracket_of_fall * fall), guess = last.factor - fall;
  options.from = std::max(options.smallest, guess - reach);
  options.to = options.from + 2 * reach;
  return options;
}

}  // namespace

template <int D>
const char* ElementRun<D>::find_obstacle() const {
  if (D == 3) return "only plane sections are";
  if (!data().mesh.file.empty()) return "it is a ready file";
  if (softens_in_trials(data())) return "soil softens over a length that all elements have to resolve";
  if (data().fem.flow == input::FlowRule::both) return "both flow rules share one mesh";
  if (has_bedding(data())) return "it has lines along the bedding";
  if (data().initial.known_stress || !known_springs_.empty()) return "the stresses are those of an earlier calculation";
  const input::InitialWater& water = data().initial.water;
  if (water.pressure == input::InitialPressure::seepage || water.season > 0 || water.known)
    return "the pore pressure of seepage is computed on it";
  if (!data().supports.empty() && !list_walls(site_).empty()) return "it has walls";
  return nullptr;
}

template <int D>
void ElementRun<D>::adapt(const std::string& words, fem::ReductionResult<D>& found, results::ElementRun& run) {
  if constexpr (D == 2) {
    const double nominal = coarse_ratio * coarse_ratio * static_cast<double>(model_->mesh.elements.size());
    const auto most = static_cast<std::size_t>(most_elements * nominal);
    std::vector<double> work = compute_shear_work(model_->mesh, found.at_failure, found.mechanism);
    std::vector meshes{make_mesh_factor_result(found, compute_shear_size(*model_->solid.mesh, model_->mesh, work))};
    std::vector<double> by_displacement{found.by_displacement};
    const bool is_associated = run.flow == results::Flow::associated || run.davis || !has_less_dilatancy(data());
    const double safety = is_associated ? sequence_safety : mesh_safety;
    while (const auto marked = mark_shear(*model_->solid.mesh, model_->mesh, work, most)) {
      fem::ReductionResult<D> next;
      try {
        auto finer = std::make_shared<const mesh::Mesh<2>>(mesh::refine(*model_->solid.mesh, *marked));
        auto model = make_model_on(make_solid_on<2>(site_, std::move(finer)));
        set_trial_laws<2>(site_, model->solid, run.flow == results::Flow::associated);
        const fem::ReductionOptions options = narrow_options(make_options(data().fem, options_.threads), meshes);
        next = search(*model, fmt::format("{}, {} elements", words, model->mesh.elements.size()), options);
        model_ = std::move(model);
      } catch (const Error& error) {  // the meshes before remain
        if (error.code() != ExitCode::wrong_input) throw;
        run.warnings.push_back(fmt::format("the mesh is not refined further: {}", error.what()));
        break;
      }
      next.seconds += found.seconds;
      found = std::move(next);
      work = compute_shear_work(model_->mesh, found.at_failure, found.mechanism);
      const double size = compute_shear_size(*model_->solid.mesh, model_->mesh, work);
      if (!(size > 0)) break;
      // Meshes of about the same size at the mechanism, which has moved, count as one.
      if (meshes.back().size < least_ratio * size) meshes.pop_back(), by_displacement.pop_back();
      meshes.push_back(make_mesh_factor_result(found, size));
      by_displacement.push_back(found.by_displacement);
      if (meshes.size() < fewest_meshes) continue;
      run.interval = find_sequence_interval(meshes, {}, safety);
      if (run.interval && run.interval->upper - run.interval->lower <= widest_interval * found.factor) break;
    }
    describe_mesh();
    run.by_displacement.reset();
    if (meshes.size() < 2) {
      run.interval.reset();
      run.factor = found.factor;
      run.warnings.push_back("the mesh could not be refined where the soil shears, so that its error is not known");
      return;
    }
    const auto &fine = meshes.back(), &coarse = meshes[meshes.size() - 2];
    const auto to_zero = [&](double at_coarse, double at_fine) {
      return std::max(0.0, extrapolate_to_zero(coarse.size, at_coarse, fine.size, at_fine));
    };
    run.factor = to_zero(coarse.factor, fine.factor);
    const double before = by_displacement[by_displacement.size() - 2], last = by_displacement.back();
    if (before > 0 && last > 0) run.by_displacement = to_zero(before, last);
    run.interval = find_sequence_interval(meshes, find_least_error(found, run), safety);
    run.meshes = std::move(meshes);
  }
}

template const char* ElementRun<2>::find_obstacle() const;
template const char* ElementRun<3>::find_obstacle() const;
template void ElementRun<2>::adapt(const std::string&, fem::ReductionResult<2>&, results::ElementRun&);
template void ElementRun<3>::adapt(const std::string&, fem::ReductionResult<3>&, results::ElementRun&);

}  // namespace talus::run
