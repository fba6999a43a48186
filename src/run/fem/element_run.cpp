// SPDX-License-Identifier: MIT
#include "run/fem/element_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/extrapolate.hpp"
#include "mesh/quality.hpp"
#include "run/common/bars_of_case.hpp"
#include "run/common/head.hpp"
#include "run/fem/fields_vtu.hpp"
#include "run/fem/softening_band.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/fem/start_stress.hpp"

namespace talus::run {

namespace {

/// Displacements and strains of the fields are rounded to this many parts of one: micrometres and 1e-6.
constexpr double field_digits = 1e6;

}  // namespace

double find_shear_strain(const std::array<double, 6>& e) {
  const double mean = (e[0] + e[1] + e[2]) / 3;
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) squares += (e[i] - mean) * (e[i] - mean);
  for (std::size_t i = 3; i < 6; ++i) squares += 0.5 * e[i] * e[i];
  return std::sqrt(2.0 / 3 * squares);
}

std::array<double, 2> find_dilatancy(const input::Case& data, bool associated) {
  double low = 1e9, high = -1e9;
  for (const auto& [region, name] : data.regions) {
    const input::Material m = find_trial_soil(data, data.materials.at(name));
    if (m.traits().strength == material::Strength::none) continue;
    // The angles of a curved envelope vary with the stress.
    if (material::needs<material::FlowRatio>(m.model)) continue;
    const double psi = associated ? m.friction_angle : m.dilatancy_angle;
    low = std::min(low, psi);
    high = std::max(high, psi);
  }
  return low <= high ? std::array{low, high} : std::array{0.0, 0.0};
}

results::ElementTrial make_trial_result(const fem::ReductionTrial& t) {
  return {t.factor, t.converged, t.iterations, t.force_residual, t.displacement_residual, t.displacement, t.seconds};
}

template <int D>
results::ElementMeshFactor make_mesh_factor_result(const fem::ReductionResult<D>& found, double size) {
  return {size, found.factor, found.stable, found.failed,
          found.flowing > 0 ? std::optional(found.flowing) : std::nullopt};
}

std::optional<results::ElementInterval> find_mesh_interval(const results::ElementMeshFactor& coarse,
                                                           const results::ElementMeshFactor& fine,
                                                           const LeastMeshError& least) {
  if (!coarse.flowing || !fine.flowing) return std::nullopt;
  // The difference between the meshes is uncertain by the brackets of both searches, weighted as in the extrapolation.
  const double rest = find_rest(coarse.size, fine.size), difference = std::max(0.0, coarse.factor - fine.factor),
               fall = rest * (*coarse.flowing - fine.stable + (mesh_safety - 1) * difference),
               rise = rest * (*fine.flowing - coarse.stable);
  // No factor is negative.
  return results::ElementInterval{std::max(0.0, fine.stable - std::max(fall, least.below * fine.factor)),
                                  *fine.flowing + std::max(rise, least.above * fine.factor)};
}

template <int D>
results::ElementMesh make_mesh_result(const fem::QuadraticMesh<D>& mesh) {
  results::ElementMesh result;
  for (const auto& x : mesh.nodes) {
    std::vector<double>& row = result.nodes.emplace_back();
    for (const double c : x) row.push_back(round_to(c, field_digits));
  }
  for (const auto& e : mesh.elements) result.elements.emplace_back(e.begin(), e.end());
  return result;
}

template <int D>
results::ElementFields make_fields_result(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state,
                                          results::Flow flow) {
  const std::size_t elements = mesh.elements.size(), per = elements > 0 ? mesh.points.size() / elements : 0;
  std::vector<double> strain(mesh.nodes.size(), 0.0), volume(mesh.nodes.size(), 0.0);
  results::ElementFields fields;
  fields.flow = flow;
  for (std::size_t e = 0; e < elements; ++e) {
    double sum = 0, weight = 0;
    std::size_t plastic = 0;
    for (std::size_t k = e * per; k < (e + 1) * per; ++k) {
      sum += mesh.weights[k] * find_shear_strain(state.strain[k]);
      weight += mesh.weights[k];
      plastic += state.yields[k] != 0 ? 1 : 0;
    }
    for (const int i : mesh.elements[e]) {
      strain[i] += sum;
      volume[i] += weight;
    }
    fields.yields.push_back(2 * plastic > per ? 1 : 0);
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    fields.shear_strain.push_back(volume[i] > 0 ? round_to(strain[i] / volume[i], field_digits) : 0);
    std::vector<double>& u = fields.displacement.emplace_back();
    for (const double c : state.displacement[i]) u.push_back(round_to(c, field_digits));
  }
  return fields;
}

template results::ElementMeshFactor make_mesh_factor_result<2>(const fem::ReductionResult<2>&, double);
template results::ElementMeshFactor make_mesh_factor_result<3>(const fem::ReductionResult<3>&, double);
template results::ElementMesh make_mesh_result<2>(const fem::QuadraticMesh<2>&);
template results::ElementMesh make_mesh_result<3>(const fem::QuadraticMesh<3>&);
template results::ElementFields make_fields_result<2>(const fem::QuadraticMesh<2>&, const fem::SolidState<2>&,
                                                      results::Flow);
template results::ElementFields make_fields_result<3>(const fem::QuadraticMesh<3>&, const fem::SolidState<3>&,
                                                      results::Flow);

namespace {

constexpr const char* element_file = "fem.json";

std::vector<results::Flow> list_flows(input::FlowRule rule) {
  if (rule == input::FlowRule::as_given) return {results::Flow::as_given};
  if (rule == input::FlowRule::associated) return {results::Flow::associated};
  return {results::Flow::as_given, results::Flow::associated};
}

std::optional<results::Davis> find_davis(input::DavisRule rule) {
  switch (rule) {
    case input::DavisRule::none:
      break;
    case input::DavisRule::a:
      return results::Davis::a;
    case input::DavisRule::b:
      return results::Davis::b;
    case input::DavisRule::c:
      return results::Davis::c;
  }
  return std::nullopt;
}

bool has_run(const results::ElementResult& result, results::Flow flow) {
  return std::any_of(result.runs.begin(), result.runs.end(), [&](const auto& run) { return run.flow == flow; });
}

}  // namespace

bool has_less_dilatancy(const input::Case& data) {
  return std::any_of(data.regions.begin(), data.regions.end(), [&](const auto& region) {
    const input::Material m = find_trial_soil(data, data.materials.at(region.second));
    if (material::needs<material::FlowRatio>(m.model)) return m.dilatancy_ratio < 1;
    return m.traits().strength != material::Strength::none && m.dilatancy_angle < m.friction_angle;
  });
}

fem::ReductionOptions make_options(const input::FiniteElements& settings, int threads) {
  fem::ReductionOptions options;
  options.from = settings.from;
  options.to = settings.to;
  options.resolution = settings.resolution;
  options.solid = make_solid_options(settings, threads);
  return options;
}

template <int D>
ElementRun<D>::ElementRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash)
    : MethodRun("FEM", element_file, alone, options, std::move(input_hash)),
      site_(site),
      tries_both_directions_(data().earthquake.list_directions().size() > 1) {}

template <int D>
void ElementRun<D>::attempt_part(const std::function<void()>& part) {
  if (try_part(part)) return;
  model_.reset();
  is_told_ = true;
}

template <int D>
void ElementRun<D>::prepare() {
  attempt_part([&] {
    show("mesh");
    const char* obstacle = data().fem.adapt ? find_obstacle() : nullptr;
    adapts_ = data().fem.adapt && obstacle == nullptr;
    model_ = make_model(adapts_ ? coarse_ratio : 1);
    water_ = std::move(model_->solid.water);
    begin();
    if (obstacle != nullptr) file_.summary.warnings.push_back(fmt::format("the mesh is not adapted: {}", obstacle));
    if (data().fem.meshes > 1 && !data().mesh.file.empty())
      file_.summary.warnings.push_back(
          "the mesh is a ready file, which cannot be coarsened: the factor is that of one mesh and not extrapolated");
    clear_progress();
  });
}

template <int D>
auto ElementRun<D>::make_model(double share) const -> std::unique_ptr<Model> {
  return make_model_on(make_solid<D>(site_, share));
}

template <int D>
auto ElementRun<D>::make_model_on(SolidOfCase<D> solid) const -> std::unique_ptr<Model> {
  if (!known_springs_.empty()) {
    solid.model.known_springs = known_springs_;
    for (fem::Bar& bar : solid.model.bars) bar.prestress = 0;
    for (fem::Wall& wall : solid.model.walls)
      for (fem::Strut& strut : wall.struts) strut.prestress = 0;
  }
  fem::QuadraticMesh<D> mesh = fem::make_quadratic<D>(*solid.mesh, fem::list_cuts(solid.model));
  return std::make_unique<Model>(Model{std::move(solid), std::move(mesh)});
}

/// Reads the state of an interrupted run, or sets the one before the first trial.
template <int D>
void ElementRun<D>::begin() {
  if (read_kept()) {
    spent_ = std::chrono::duration<double>(file_.summary.seconds.value_or(0));
    return;
  }
  file_.input_hash = hash_;
  describe_mesh();
  results::ElementResult& result = file_.summary;
  result.element = D == 2 ? "T6" : "T10";
  result.warnings = model_->solid.notes;
  result.fields_file = element_file;
  result.seepage = water_.seepage;
}

template <int D>
void ElementRun<D>::describe_mesh() {
  file_.mesh = make_mesh_result<D>(model_->mesh);
  file_.summary.elements = model_->mesh.elements.size();
  file_.summary.nodes = model_->mesh.nodes.size();
  file_.summary.size = mesh::measure_quality(*model_->solid.mesh).mean_size;
}

template <int D>
void ElementRun<D>::calculate() {
  if (!model_) return;
  for (const results::Flow flow : list_flows(data().fem.flow)) {
    if (!model_ || has_run(file_.summary, flow)) continue;
    attempt_part([&] {
      throw_if_interrupted();
      set_trial_laws<D>(site_, model_->solid, flow == results::Flow::associated);
      reduce(flow);
    });
    if (!model_) return;
    file_.summary.seconds = spent_.count();
    keep();
  }
  is_told_ = true;
  model_.reset();
  clear_progress();
}

template <int D>
void ElementRun<D>::keep_present(const Model& model, const fem::ReductionTrial& trial,
                                 const fem::SolidState<D>& state) {
  if (!options_.keeps_present) return;
  present_.trials.push_back(make_trial_result(trial));
  clock_.update([&] {
    present_.mesh.runs = {make_fields_result<D>(model.mesh, state, results::Flow::as_given)};
    results::write_file(options_.folder / results::present_reduction_file, present_, -1);
  });
}

template <int D>
fem::ReductionResult<D> ElementRun<D>::search(const Model& model, const std::string& words) {
  return search(model, words, make_options(data().fem, options_.threads));
}

template <int D>
fem::ReductionResult<D> ElementRun<D>::search(const Model& model, const std::string& words,
                                              const fem::ReductionOptions& options) {
  show(fmt::format("{}, equilibrium at full strength", words));
  std::optional<double> lower, upper;
  present_ = {};
  if (options_.keeps_present) present_.title = words, present_.mesh = make_mesh_result<D>(model.mesh);
  return fem::reduce_strength<D>(model.solid.model, options,
                                 [&](const fem::ReductionTrial& t, const fem::SolidState<D>& state) {
                                   if (t.converged)
                                     lower = std::max(lower.value_or(t.factor), t.factor);
                                   else
                                     upper = std::min(upper.value_or(t.factor), t.factor);
                                   show(fmt::format("{}, strength divided by {:.4g}: {} after {} iterations", words,
                                                    t.factor, t.converged ? "converges" : "fails", t.iterations),
                                        {.method = "fem",
                                         .series = words,
                                         .lower = lower,
                                         .upper = upper,
                                         .factor = t.factor,
                                         .holds = t.converged,
                                         .displacement = t.displacement});
                                   present_.stable = lower, present_.failed = upper;
                                   keep_present(model, t, state);
                                 });
}

template <int D>
LeastMeshError ElementRun<D>::find_least_error(const fem::ReductionResult<D>& found, results::ElementRun& run) const {
  LeastMeshError least;
  if (run.flow != results::Flow::associated && !run.davis && has_less_dilatancy(data())) least.above = known_scatter;
  if constexpr (D == 2) {
    const auto thin = list_thin_layers(*model_->solid.mesh, model_->mesh, found.mechanism, adapts_);
    if (thin.empty()) return least;
    least.below = thin_layer_error;
    run.warnings.push_back(
        fmt::format("'{}' {} fewer than {:g} rows of elements over {} thickness, so that two meshes do not show the "
                    "error: the interval allows {:g} % for it; refine by [[mesh.refine]]",
                    fmt::join(thin, "', '"), thin.size() == 1 ? "shears and has" : "shear and have",
                    fewest_element_rows, thin.size() == 1 ? "its" : "their", 100 * thin_layer_error));
  }
  return least;
}

template <int D>
void ElementRun<D>::add_softening_warning(const Model& model, const fem::ReductionResult<D>& found,
                                          results::ElementRun& run) const {
  if (!softens_in_trials(data())) return;
  if (const auto warning = describe_soft_band<D>(data(), *model.solid.mesh, model.mesh, found.mechanism))
    run.warnings.push_back(*warning);
}

/// Searches on the coarser mesh, and extrapolates both factors to h = 0 with the interval.
template <int D>
void ElementRun<D>::extrapolate(const std::string& words, const fem::ReductionResult<D>& fine_search,
                                results::ElementRun& run) {
  const std::unique_ptr<Model> model = make_model(coarse_ratio);
  set_trial_laws<D>(site_, model->solid, run.flow == results::Flow::associated);
  const auto found = search(*model, words + ", coarse mesh");
  const results::ElementMeshFactor fine = make_mesh_factor_result(fine_search, file_.summary.size),
                                   coarse = make_mesh_factor_result(
                                       found, mesh::measure_quality(*model->solid.mesh).mean_size);
  run.seconds += found.seconds;
  if (coarse.size < least_ratio * fine.size)
    throw Error(ExitCode::wrong_input,
                fmt::format("its elements have a mean size of {}, hardly more than the {} of the finer one",
                            format_value(coarse.size, data().units().length, 3),
                            format_value(fine.size, data().units().length, 3)));
  run.meshes = std::vector<results::ElementMeshFactor>{coarse, fine};
  add_softening_warning(*model, found, run);
  run.factor = std::max(0.0, extrapolate_to_zero(coarse.size, coarse.factor, fine.size, fine.factor));
  if (const double fraction = 1 - run.factor / fine.factor; fraction > most_extrapolated)
    run.warnings.push_back(fmt::format(
        "the factor falls from {:.3f} to {:.3f} between elements of {} and {}, and is extrapolated by {:.0f} "
        "% to size zero; above {:.0f} % two meshes do not show the error, and the interval is the result: "
        "refine [fem] size",
        coarse.factor, fine.factor, format_value(coarse.size, data().units().length, 3),
        format_value(fine.size, data().units().length, 3), 100 * fraction, 100 * most_extrapolated));
  run.interval = find_mesh_interval(coarse, fine, find_least_error(fine_search, run));
  if (!run.interval)
    run.warnings.push_back(
        "every trial that failed on one of the meshes ran out of iterations: the factor has no upper end; give more "
        "`iterations` under [fem]");
  if (run.by_displacement && found.by_displacement > 0)
    run.by_displacement = extrapolate_to_zero(coarse.size, found.by_displacement, fine.size, *run.by_displacement);
  else
    run.by_displacement.reset();
}

template <int D>
results::EarthquakeSide ElementRun<D>::compare_directions(results::Flow flow, const std::string& words,
                                                          fem::ReductionResult<D>& found) {
  using Direction = input::EarthquakeDirection;
  const bool pushes_left = model_->solid.model.direction[0] < data().gravity.direction[0];
  const auto point = [&](bool left) {
    input::Case pointed = data();
    pointed.earthquake.direction = left == (pointed.earthquake.horizontal >= 0) ? Direction::left : Direction::right;
    site_ = site::Site(pointed);
  };
  point(!pushes_left);
  std::unique_ptr<Model> other = make_model(adapts_ ? coarse_ratio : 1);
  set_trial_laws<D>(site_, other->solid, flow == results::Flow::associated);
  const fem::ReductionOptions options = make_options(data().fem, options_.threads);
  show(fmt::format("{}, earthquake towards the other side", words));
  results::EarthquakeSide side{pushes_left ? -1 : 1, found.failed};
  if (!fem::is_stable<D>(other->solid.model, options, found.failed)) {
    fem::ReductionResult<D> beside = search(*other, words + ", earthquake towards the other side");
    side.other_stable = beside.stable;
    if (beside.factor < found.factor) {
      side.other_stable = found.stable;
      side.direction = -side.direction;
      std::swap(found, beside);
      std::swap(model_, other);
    }
    found.seconds += beside.seconds;
  }
  point(side.direction < 0);
  return side;
}

template <int D>
void ElementRun<D>::reduce(results::Flow flow) {
  const bool associated = flow == results::Flow::associated;
  results::ElementRun run;
  run.flow = flow;
  if (!associated) run.davis = find_davis(data().fem.davis);
  const std::string words = results::name_flow(run);
  auto found = search(*model_, words);
  if (tries_both_directions_) run.earthquake = compare_directions(flow, words, found);
  run.psi = find_dilatancy(data(), associated);
  run.factor = found.factor;
  if (found.by_displacement > 0) run.by_displacement = found.by_displacement;
  if (adapts_) adapt(words, found, run);
  run.stable = found.stable;
  run.failed = found.failed;
  run.seconds = found.seconds;
  for (const fem::ReductionTrial& t : found.trials) run.trials.push_back(make_trial_result(t));
  if constexpr (D == 2) {
    if (!data().supports.empty()) run.supports = make_bar_results(site_, model_->solid.model, found);
    std::vector<results::SideLine> lines;
    for (fem::SlipLine& line : fem::find_slip_lines(model_->solid.model, model_->mesh, found.mechanism))
      lines.push_back({line.direction, std::move(line.points)});
    if (!lines.empty()) run.slip_line = lines[0].points;
    if (lines.size() > 1) {
      if (lines[0].direction > lines[1].direction) std::swap(lines[0], lines[1]);
      run.sides = std::move(lines);
    }
    if (run.slip_line.empty()) run.warnings.push_back("the shear strain shows no band from the ground to the ground");
  }
  for (const fem::ReductionTrial& t : found.trials)
    if (t.factor == found.failed && !t.flows)
      run.warnings.push_back(
          fmt::format("the trial at {:.4g} ran out of iterations ({}) and is undecided: with more `iterations` under "
                      "[fem] the factor may be higher{}",
                      t.factor, t.iterations,
                      found.flowing > 0 ? fmt::format(", up to {:.4g}, where the soil flows", found.flowing) : ""));
  add_softening_warning(*model_, found, run);
  if (found.stable < 1)
    run.warnings.push_back("the slope does not stand with its full strength: the factor is below 1");
  if (!adapts_ && has_two_meshes()) {
    try {
      extrapolate(words, found, run);
    } catch (const Error& error) {  // the factor on the mesh of the [fem] size remains
      if (error.code() != ExitCode::wrong_input) throw;
      run.warnings.push_back(fmt::format(
          "no second mesh of twice the size, so that the factor is that of one mesh and its error is not known: {}",
          error.what()));
    }
  }
  file_.summary.unknowns = found.unknowns;
  show(fmt::format("{}, factor {:.4g}", words, run.factor),
       {.method = "fem", .series = words, .factor = run.factor, .surface = run.slip_line});
  file_.summary.runs.push_back(std::move(run));
  file_.mesh.runs.push_back(make_fields_result<D>(model_->mesh, found.at_failure, flow));
}

template <int D>
void ElementRun<D>::write_result(results::RunResult& run) const {
  if (!is_told_) return;
  const results::ElementResult& result = file_.summary;
  run.elements = result;
  add_warnings(run);
  for (const results::ElementRun& r : result.runs)
    for (const std::string& warning : r.warnings)
      run.warnings.push_back(fmt::format("{}, {}: {}", title_, results::name_flow(r), warning));
  site::give(water_, run);
}

template <int D>
void ElementRun<D>::keep() const {
  write_atomically(options_.folder / "fem.vtu", write_vtu(file_.mesh));
  write_kept();  // last: a resumed run takes it as complete
}

template class ElementRun<2>;
template class ElementRun<3>;

}  // namespace talus::run
