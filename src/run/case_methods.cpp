// SPDX-License-Identifier: MIT
#include "run/case_methods.hpp"

#include <fmt/format.h>

#include "run/check_case.hpp"
#include "run/common/head.hpp"
#include "run/common/mesh_estimate.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/fem/start_stress.hpp"
#include "run/lem/run_lem.hpp"
#include "run/mpm/stage/stepper.hpp"
#include "site/ground_load.hpp"
#include "site/initial_water.hpp"
#include "site/pore_water.hpp"
#include "site/site.hpp"

namespace talus::run {
namespace {

/// MPM needs one direction of the earthquake: that in which circles have the smaller factor. Returns the sentence
/// that states it.
std::string choose_direction(const RunOptions& options, input::Earthquake& quake, const input::Case& data) {
  if (options.progress) options.progress->show("earthquake: weaker direction by circles");
  const auto weaker = find_weaker_direction(data, options.threads);
  if (options.progress) options.progress->clear();
  if (!weaker)
    return "MPM takes the earthquake towards the lower end of the ground, or towards larger x where "
           "both ends are equally high: no circle shows the weaker direction. Run the other one with 'direction' "
           "under "
           "[earthquake].";
  quake.direction = *weaker;
  quake.horizontal = std::abs(quake.horizontal);
  return fmt::format(
      "MPM takes the earthquake towards {} x, where Bishop's circles have the smaller factor. Run the "
      "other one with 'direction' under [earthquake].",
      *weaker == input::EarthquakeDirection::left ? "smaller" : "larger");
}

/// MPM runs released later are prepared at their time; their faults are found here, at time 0.
template <int D>
void check_points(const CaseContext& context) {
  RunOptions fresh = context.options;
  fresh.resume = false;
  results::RunResult none;
  PointRun<D>(context.loaded, context.design.data, fresh, context.hash).prepare(none);
}

}  // namespace

bool is_released(const input::Case& data) {
  return input::uses(data, Method::mpm) && data.timeline && data.timeline->release;
}

template <int D>
std::unique_ptr<const input::Case> make_point_case(const input::Case& data, const RunOptions& options,
                                                   results::RunResult& run, std::vector<std::string>& notes) {
  auto own = std::make_unique<input::Case>(data);
  if (data.earthquake.list_directions().size() > 1) notes.push_back(choose_direction(options, own->earthquake, data));
  if constexpr (D == 2) {
    if (data.initial.stress == input::InitialStress::elements) {
      if (options.progress) options.progress->show("FEM: initial stress");
      own->initial.known_stress = find_start_stress(*own, options.threads, run.stress_start.emplace());
    }
  }
  return own;
}

template <int D>
void prepare_mpm(const CaseContext& context, const input::Case& data, CaseMethods<D>& methods,
                 results::RunResult& run) {
  methods.point_case = make_point_case<D>(data, context.options, run, methods.point_notes);
  methods.points.emplace(context.loaded, *methods.point_case, context.options, context.hash).prepare(run);
}

/// Warns of soil that floats at the start. Without LEM among the methods its section is made for this alone, unless its
/// water would take long; sections that LEM does not accept are not examined.
void warn_of_uplift(const site::Site& site, const std::optional<SliceRun>& slices, results::RunResult& run) {
  const input::Case& data = site.data();
  const bool has_water = site::has_water(data) || !site.water_table().empty();
  if (data.mesh.dimension != 2 || !site.has_ground() || !has_water) return;
  const bool takes_long =
      site::needs_seepage(data) && (data.initial.water.season > 0 || !is_meshed_in_a_moment(data.mesh));
  if (!slices && takes_long) return;
  std::shared_ptr<const lem::Slope> slope;
  try {
    slope = slices ? slices->prepared().slope : prepare_slope(site).slope;
  } catch (const Error&) {
    return;  // its faults are those of another method
  }
  if (std::string sentence = describe_uplift(*slope); !sentence.empty()) run.warnings.push_back(std::move(sentence));
}

template <int D>
void prepare_methods(const CaseContext& context, CaseMethods<D>& methods, results::RunResult& run) {
  const auto& [loaded, design, options, hash] = context;
  const site::Site site(design.data);
  const input::Case& data = design.data;
  const bool alone = data.methods.size() == 1;
  const bool has_points = input::uses(data, Method::mpm), has_elements = input::uses(data, Method::fem),
             has_bounds = input::uses(data, Method::bounds);
  if (!data.construction.empty()) {
    if constexpr (D == 2) methods.construction.emplace(loaded, data, options, hash).prepare();
    run = begin_result(loaded, hash, options.threads);
    return;
  }
  // Faults of FEM and limit analysis are reported before MPM, which may take hours.
  if (has_points && (has_elements || asks_for_elements(data))) check_solid(site);
  if (has_points && has_bounds) check_bounds(data);
  if (input::uses(data, Method::lem)) methods.slices.emplace(site, alone, options, hash);
  run = begin_result(loaded, hash, options.threads);
  run.provenance.device = describe_device();
  warn_of_uplift(site, methods.slices, run);
  if (is_released(data)) {
    check_points<D>(context);
  } else if (has_points) {
    prepare_mpm(context, data, methods, run);
  } else if (data.mesh.dimension == 2 && !data.mesh.polygons.empty() && site::needs_ground(site)) {
    run.slope_height = site.find_slope_height();
  }
  if (has_elements) methods.elements.emplace(site, alone, options, hash).prepare();
  if (has_bounds) methods.bounds.emplace(site, alone, options, hash).prepare();
  if (input::uses(data, Method::seepage)) methods.seepage.emplace(site, alone, options, hash).prepare();
  if (data.timeline) methods.timeline.emplace(data, options, hash);
}

#define TALUS_INSTANTIATE(D)                                                                                      \
  template std::unique_ptr<const input::Case> make_point_case<D>(const input::Case&, const RunOptions&,           \
                                                                 results::RunResult&, std::vector<std::string>&); \
  template void prepare_mpm<D>(const CaseContext&, const input::Case&, CaseMethods<D>&, results::RunResult&);     \
  template void prepare_methods<D>(const CaseContext&, CaseMethods<D>&, results::RunResult&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
