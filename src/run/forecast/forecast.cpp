// SPDX-License-Identifier: MIT
#include "run/forecast/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "mesh/generate.hpp"
#include "mesh/gmsh_mesh.hpp"
#include "run/common/mesh_estimate.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/mpm/reduction/frozen_factor.hpp"
#include "run/mpm/reduction/leg.hpp"
#include "run/mpm/stage/stage.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {

namespace {

using Clock = std::chrono::steady_clock;

/// Elements with soil of the coarse mesh: enough to fill the lanes of a step, at negligible meshing time.
constexpr double coarse_elements = 800;
constexpr double probe_seconds = 0.1, most_seconds = 1;  ///< of a stage, and of all together

/// Exception that ends the timed stage.
struct Enough {};

bool can_be_probed(const input::Case& data) {
  const bool has_library = std::any_of(data.materials.begin(), data.materials.end(), [](const auto& named) {
    return named.second.model == material::model_of<material::External>;
  });
  return input::uses(data, input::Method::mpm) && data.mesh.file.empty() && is_meshed_in_a_moment(data.mesh) &&
         data.initial.result.empty() && data.initial.water.season == 0 && !data.stages.empty() && !has_library;
}

/// Returns the point steps per second of a stage, measured over `seconds`.
template <int D>
double measure(mpm::Body<D>& body, StagePlan<D> plan, double seconds) {
  plan.duration = 1e9;
  plan.until_rest = false;
  StageState state;
  StageHooks<D> hooks;
  const auto start = Clock::now();
  std::int64_t steps = 0;
  double taken = 0;
  hooks.look = [&](const mpm::Body<D>&, const StageState& now) {
    steps = now.steps;
    taken = std::chrono::duration<double>(Clock::now() - start).count();
    if (taken > seconds) throw Enough{};
  };
  try {
    run_stage(body, plan, state, hooks);
  } catch (const Enough&) {
  }
  return static_cast<double>(steps) * body.points.size() / taken;
}

template <int D>
Pace probe_in(const input::Case& data) {
  input::Case coarse = data;
  const double elements = count_elements(data.mesh).soil;
  const double ratio = std::max(1.0, std::pow(elements / coarse_elements, 1.0 / D));
  const double smallest = find_smallest_size(data.mesh);
  coarse.mesh.refinements.clear();
  coarse.mesh.size = ratio * data.mesh.size;
  mpm::Body<D> body = prepare<D>(coarse, mesh::generate<D>(coarse.mesh));
  const double height = find_soil_height(body, data.gravity);
  const auto find_step = [&](const StagePlan<D>& plan) {
    const double size = plan.equalises_mass ? data.mesh.size : smallest;
    return find_critical_step(body, plan).dt * plan.step.courant * size / coarse.mesh.size;
  };
  Pace pace;
  const input::Stage& first = data.stages.front();
  set_strength(body, coarse, first.cohesion, first.strength_factor.value_or(1));
  const double each = std::min(probe_seconds, most_seconds / static_cast<double>(data.stages.size()));
  for (const input::Stage& stage : data.stages) {
    const StagePlan<D> plan = make_plan<D>(coarse, stage, height, 1);
    StagePace& here = pace.stages.emplace_back(StagePace{find_step(plan), 0});
    // A later stage starts from the state after the short runs of the earlier ones, not from their ends.
    here.point_steps = measure(body, plan, each);
  }
  StagePlan<D> plan = make_plan<D>(coarse, first, height, 1);
  plan.step = data.strength_reduction.curve.step_settings;
  pace.curve = {find_step(plan), pace.stages.back().point_steps};
  pace.frozen = {find_step(make_frozen_plan<D>(coarse, data.strength_reduction.frozen, height, 1)),
                 pace.stages.front().point_steps};  // its pore pressures are fixed
  return pace;
}

}  // namespace

std::optional<Pace> probe(const input::Case& data) {
  if (!can_be_probed(data)) return std::nullopt;
  try {
    return data.mesh.dimension == 2 ? probe_in<2>(data) : probe_in<3>(data);
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    return std::nullopt;
  }
}

namespace {

// Peak memory of the dry slope with 2,000 to 690,000 elements (docs/verification_data/speed.md); a mesh takes most
// memory while Gmsh generates it.
constexpr double program_bytes = 65e6;
constexpr double mesh_bytes[] = {1600, 2500};  ///< of a triangle, a tetrahedron
constexpr double point_bytes[] = {560, 800};   ///< including the copies for a retry
constexpr double coupled_point_bytes[] = {800, 1000};
/// Meshing time of an element on one core [s].
constexpr double element_seconds[] = {6e-5, 1e-4};
/// Time of a strength reduction with n unknowns, c n^1.3 [s]: with ψ < φ, and with ψ = φ.
constexpr double reduction_seconds = 6e-5, associated_seconds = 2e-5, reduction_power = 1.3, unknowns_per_element = 4;
/// Bytes of the matrices and factors of n unknowns, c n^k, in 2D and 3D.
constexpr double matrix_bytes[] = {1600, 640}, matrix_power[] = {1.1, 1.25};
/// Time of limit analysis up to a last mesh of n triangles, c n^1.5 [s], and bytes per triangle.
constexpr double bounds_seconds = 7e-5, bounds_power = 1.5, bounds_bytes = 4e4;
/// Usual final number of triangles of the referee, and the usual fraction of the allowed triangles of a search for
/// bounds.
constexpr double referee_triangles = 900, usual_fraction = 0.3;
/// Time of seepage from one stored time to the next, per element [s].
constexpr double flow_seconds = 4e-5;
/// Usual number of selected times of a timeline, and of stored times in addition to the corners of its series.
constexpr double chosen_times = 20, kept_times = 128;
/// Fractions of their time after which stages come to rest, trials rest or fail, and slides come to rest.
constexpr double until_rest = 0.2, until_decided = 0.2, until_deposited = 0.6;
/// Time of a trial circle by one method with 50 slices [s].
constexpr double circle_seconds = 3e-6;
constexpr double polyline_seconds = 0.3;

std::size_t get_rank(int dimension) {
  return dimension == 2 ? 0 : 1;
}

/// Adds seepage up to every stored time, a search at the selected times, and the referee at a few of them.
void add_timeline(const input::Case& data, double referee, MethodForecast& f) {
  constexpr double most_judged = 6, read_pressures = 4;
  const input::Timeline& timeline = *data.timeline;
  f.times = timeline.times.empty() ? chosen_times : static_cast<double>(timeline.times.size());
  double kept = timeline.times.empty() ? kept_times : f.times;
  for (const input::Hydraulic& h : data.hydraulics) kept += static_cast<double>(h.values().time.size());
  f.seconds += kept * flow_seconds * count_elements(data.mesh).soil + f.times * read_pressures * (f.seconds - referee) +
               std::min(most_judged, f.times + 1) * referee;
}

MethodForecast forecast_slices(const input::Case& data, int threads) {
  const input::LimitEquilibrium& lem = data.lem;
  MethodForecast f;
  f.method = input::Method::lem;
  if (lem.search == input::SurfaceSearch::entry_exit) {
    const input::EntryExit& e = lem.entry_exit;
    const double ends = e.exits + e.entries;
    // Without ranges, surfaces pass through any two points of the ground.
    f.surfaces = (e.exit.empty() && e.entry.empty() ? ends * (ends - 1) / 2 : 1.0 * e.exits * e.entries) * e.depths;
  } else if (lem.search == input::SurfaceSearch::grid) {
    f.surfaces = 1.0 * lem.grid.columns * lem.grid.rows * lem.grid.radii;
  } else if (lem.search == input::SurfaceSearch::block) {
    f.surfaces = lem.block.surfaces;
  }
  const double methods = static_cast<double>(lem.methods.size());
  f.seconds = f.surfaces * methods * circle_seconds * lem.slices / 50 / threads;
  if (lem.noncircular) f.seconds += polyline_seconds * methods;
  const double referee = lem.referee && data.mesh.dimension == 2
                             ? static_cast<double>(data.earthquake.list_directions().size()) * bounds_seconds *
                                   std::pow(referee_triangles, bounds_power)
                             : 0;
  f.seconds += referee;
  if (data.timeline) add_timeline(data, referee, f);
  f.most_seconds = f.seconds;
  return f;
}

MethodForecast forecast_elements(const input::Case& data) {
  const mesh::Plan plan = make_fem_plan(data);
  MethodForecast f;
  f.method = input::Method::fem;
  f.dimension = plan.dimension;
  f.size = plan.size;
  const ElementCount count = count_elements(plan);
  f.elements = count.soil;
  const double unknowns = unknowns_per_element * count.soil;
  const input::FlowRule flow = data.fem.flow;
  const double each = (flow == input::FlowRule::associated ? 0 : reduction_seconds) +
                      (flow == input::FlowRule::as_given ? 0 : associated_seconds);
  if (plan.dimension == 2) f.seconds = each * std::pow(unknowns, reduction_power);
  if (data.fem.meshes > 1 && plan.file.empty())  // a second mesh, of twice the element size
    f.seconds *= 1 + std::pow(0.25, reduction_power);
  f.most_seconds = f.seconds;
  const std::size_t rank = get_rank(plan.dimension);
  f.bytes = program_bytes + mesh_bytes[rank] * count.all + matrix_bytes[rank] * std::pow(unknowns, matrix_power[rank]);
  return f;
}

/// Returns the forecast for the largest allowed mesh, regardless of the interval.
MethodForecast forecast_bounds(const input::ProvenBounds& bounds) {
  MethodForecast f;
  f.method = input::Method::bounds;
  f.elements = bounds.triangles;
  f.most_seconds = bounds_seconds * std::pow(bounds.triangles, bounds_power);
  f.seconds = bounds_seconds * std::pow(usual_fraction * bounds.triangles, bounds_power);
  f.bytes = program_bytes + bounds_bytes * bounds.triangles;
  return f;
}

/// The matrix of seepage is smaller than that of FEM, which bounds its memory.
MethodForecast forecast_flow(const input::Case& data) {
  MethodForecast f;
  f.method = input::Method::seepage;
  f.dimension = data.mesh.dimension;
  f.size = data.mesh.size;
  const ElementCount count = count_elements(data.mesh);
  f.elements = count.soil;
  f.times = static_cast<double>(data.seepage.times.size());
  const std::size_t rank = get_rank(f.dimension);
  f.bytes =
      program_bytes + mesh_bytes[rank] * count.all + matrix_bytes[rank] * std::pow(count.soil, matrix_power[rank]);
  return f;
}

/// Adds the largest number of steps of all stages and trials, and their time.
void add_time(const input::Case& data, const Pace& pace, MethodForecast& f, double coarse_points) {
  // Each run is repeated on elements twice as large.
  const double twin = data.output.runout_meshes < 2 ? 1 : 1 + std::pow(0.5, f.dimension + 1);
  const auto add = [&](double time, double fraction, const StagePace& here, double points, double runs) {
    f.steps += time / here.step;
    const double seconds = runs * time / here.step * points / here.point_steps;
    f.seconds += fraction * seconds;
    f.most_seconds += seconds;
  };
  const bool reduces = data.analysis == input::AnalysisKind::strength_reduction;
  for (std::size_t i = 0; i < data.stages.size(); ++i)
    add(data.stages[i].duration, data.stages[i].until == input::Until::rest ? until_rest : 1, pace.stages[i],
        coarse_points, reduces ? 1 : twin);
  const auto count_side_by_side = [&](double points) {
    return points < 1e9 ? count_parallel_trials(static_cast<int>(points), default_threads()) : 1;
  };
  if (reduces) {
    const input::DisplacementCurve& c = data.strength_reduction.curve;
    if (c.enabled) {
      const double trials = std::floor((c.to - c.from) / c.step + 1) + (c.refine ? 8 : 0);
      add(trials * c.window, 1, pace.curve, coarse_points, 1.0 / count_side_by_side(coarse_points));
      add(static_cast<double>(c.runout.size()) * c.runout_time, until_deposited, pace.curve, coarse_points, twin);
    }
    const input::FrozenFactor& z = data.strength_reduction.frozen;
    const double trials = 2 + std::ceil(std::log2(std::max(2.0, (z.to - z.from) / z.resolution)));
    for (int m = 0; z.enabled && m < z.meshes; ++m) {
      const double points = count_elements(plan_frozen_mesh(data.mesh, z, m)).soil * data.points_per_element;
      const StagePace finer{pace.frozen.step / std::pow(2.0, m), pace.frozen.point_steps};
      add(trials * z.window, until_decided, finer, points, 1.0 / count_side_by_side(points));
      add(static_cast<double>(data.stages.size()) * z.window, until_rest, finer, points, 1);
    }
  }
  // A release from a timeline is repeated at an earlier and a later time.
  const auto* release = data.timeline && data.timeline->release ? &*data.timeline->release : nullptr;
  const double runs = release != nullptr && release->apart != 0.0 ? 3 : 1;
  f.steps *= runs;
  for (double* seconds : {&f.seconds, &f.most_seconds})
    *seconds = runs * (*seconds + element_seconds[get_rank(f.dimension)] * f.elements);
}

MethodForecast forecast_points(const input::Case& data, bool with_time) {
  MethodForecast f;
  f.method = input::Method::mpm;
  f.dimension = data.mesh.dimension;
  f.size = data.mesh.size;
  if (!data.mesh.file.empty() || !data.initial.result.empty()) return f;
  const std::size_t rank = get_rank(f.dimension);
  const input::FrozenFactor& frozen = data.strength_reduction.frozen;
  const bool has_frozen = data.analysis == input::AnalysisKind::strength_reduction && frozen.enabled;
  const ElementCount own = count_elements(data.mesh);
  const ElementCount finest = has_frozen ? count_elements(plan_frozen_mesh(data.mesh, frozen, frozen.meshes - 1)) : own;
  f.elements = std::max(own.all, finest.all);
  f.points = std::max(own.soil, finest.soil) * data.points_per_element;
  const bool is_wet = std::any_of(data.materials.begin(), data.materials.end(),
                                  [](const auto& named) { return named.second.water.is_wet(); });
  const double copies = data.analysis == input::AnalysisKind::strength_reduction && f.points < 1e9
                            ? 1 + count_parallel_trials(static_cast<int>(f.points), default_threads())
                            : 1;
  const double of_point = (is_wet ? coupled_point_bytes : point_bytes)[rank];
  const double first = mesh_bytes[rank] * f.elements + copies * of_point * f.points;
  // The run on elements twice as large begins while the body of the first one is still in memory.
  const double coarse = data.output.runout_meshes < 2 ? 0 : std::pow(0.5, f.dimension);
  const double second =
      (1 + coarse) * mesh_bytes[rank] * own.all + (1 + copies * coarse) * of_point * own.soil * data.points_per_element;
  f.bytes = program_bytes + std::max(first, second);
  // Larger bodies exceed the memory, so timing is of no use.
  if (!with_time || f.points > 1e9) return f;
  if (const auto pace = probe(data)) add_time(data, *pace, f, own.soil * data.points_per_element);
  return f;
}

/// 1,234,000 with three digits.
std::string write_count(double n) {
  if (n >= 1e7) return fmt::format("{:.1e}", n);
  const double scale = n < 1000 ? 1 : std::pow(10, std::floor(std::log10(n)) - 2);
  std::string digits = fmt::format("{:.0f}", std::round(n / scale) * scale);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

/// "about 34 TB of memory (8e9 elements, 2e10 points)".
std::string write_need(const MethodForecast& f) {
  constexpr double countable = 1e20;
  if (!(f.bytes < countable)) return "more memory than any machine has";
  return fmt::format("about {} of memory ({} elements{})", write_bytes(f.bytes), write_count(f.elements),
                     f.points > 0 ? fmt::format(", {} points", write_count(f.points)) : "");
}

}  // namespace

std::vector<MethodForecast> forecast(const input::Case& data, bool with_time) {
  std::vector<MethodForecast> all;
  if (input::uses(data, input::Method::lem)) all.push_back(forecast_slices(data, default_threads()));
  if (input::uses(data, input::Method::fem)) all.push_back(forecast_elements(data));
  if (input::uses(data, input::Method::bounds)) all.push_back(forecast_bounds(data.bounds));
  if (input::uses(data, input::Method::mpm)) all.push_back(forecast_points(data, with_time));
  if (input::uses(data, input::Method::seepage)) all.push_back(forecast_flow(data));
  return all;
}

std::string write_time(double seconds) {
  if (seconds < 1.5) return "a second";
  if (seconds < 90) return fmt::format("{:.0f} seconds", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} minutes", seconds / 60);
  if (seconds < 2 * 86400) return fmt::format("{:.1f} hours", seconds / 3600);
  return fmt::format("{:.0f} days", seconds / 86400);
}

double find_sample_seconds(const input::LimitEquilibrium& lem) {
  constexpr double kept_surfaces = 200;
  return kept_surfaces * static_cast<double>(lem.methods.size()) * circle_seconds * lem.slices / 50;
}

std::string describe(const MethodForecast& f) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (f.surfaces > 0) add("about " + write_count(f.surfaces) + " slip surfaces");
  if (f.elements > 0)
    add((f.method == input::Method::bounds ? "up to " : "about ") + write_count(f.elements) + " elements");
  if (f.points > 0) add(write_count(f.points) + " points");
  if (f.bytes > 0 && f.elements > 0) add(write_bytes(f.bytes) + " of memory");
  if (f.steps > 0) add("up to " + write_count(f.steps) + " steps");
  if (f.times > 0) add(write_count(f.times) + " times");
  if (!(f.seconds > 0)) return text;
  const std::string usual = write_time(f.seconds), most = write_time(f.most_seconds);
  constexpr double apart = 1.5;  // "about" covers smaller ratios
  const bool says_most = f.most_seconds > apart * f.seconds && usual != most;
  add(says_most ? fmt::format("{}, at most {}", usual, most) : usual);
  return text;
}

std::optional<double> find_size_that_fits(const input::Case& data, input::Method method, double free) {
  input::Case coarser = data;
  double& size = method == input::Method::fem && coarser.fem.size ? *coarser.fem.size : coarser.mesh.size;
  const double largest = data.mesh.box_max[0] - data.mesh.box_min[0];
  constexpr double growth = 1.05, smallest = 1e-7;  // of the section: no memory holds 1e14 elements
  size = std::max(size, smallest * largest);
  while (size < largest) {
    const std::vector<MethodForecast> all = forecast(coarser, false);
    if (std::any_of(all.begin(), all.end(), [&](const auto& f) { return f.method == method && f.bytes > free; })) {
      size *= growth;
      continue;
    }
    const double si = data.units().length.si, scale = std::pow(10, std::floor(std::log10(size / si)) - 1);
    return std::ceil(size / si / scale - 1e-9) * scale * si;
  }
  return std::nullopt;  // refinements alone need more
}

void refuse_above_memory(const input::LoadedCase& loaded) {
  const auto free = find_free_memory();
  if (!free || !loaded.is_whole) return;
  std::vector<Diagnostic> faults;
  for (const MethodForecast& f : forecast(loaded.data, false)) {
    if (f.bytes <= *free) continue;
    if (f.method == input::Method::bounds) {
      const input::Place place = loaded.places.find("bounds.triangles");
      faults.push_back(
          {place.file, place.line, place.column,
           fmt::format("limit analysis with {} triangles needs {}, and {} are free: give fewer 'triangles'",
                       loaded.data.bounds.triangles, write_need(f), write_bytes(*free))});
      continue;
    }
    const ShownUnit& length = loaded.data.units().length;
    const bool has_own = f.method == input::Method::fem && loaded.data.fem.size;
    const std::string key = has_own ? "fem.size" : "mesh.size";
    const input::Place place = loaded.places.find(key);
    const auto fitting = find_size_that_fits(loaded.data, f.method, *free);
    faults.push_back({place.file, place.line, place.column,
                      fmt::format("{} with elements of {} needs {}, and {} are free: {}", get_title(f.method),
                                  format_value(f.size, length), write_need(f), write_bytes(*free),
                                  fitting ? fmt::format("'{}' of {} would fit", key, format_value(*fitting, length, 2))
                                          : std::string("make [[mesh.refine]] coarser"))});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace talus::run
