// SPDX-License-Identifier: MIT
#include "run/construction/construction_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/progress.hpp"
#include "base/ranks.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"
#include "fem/consolidation/undrained_factor.hpp"
#include "input/echo.hpp"
#include "output/files/history.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"
#include "run/common/method_run.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/construction/stage_factors.hpp"
#include "run/construction/stage_supports.hpp"
#include "run/fem/start_stress.hpp"
#include "run/mpm/point_run.hpp"
#include "site/supports.hpp"

namespace talus::run {
namespace {

constexpr std::size_t points = input::KnownStress::points;

fem::QuadraticMesh<2> make_quadratic(const StageModel& stage) {
  return fem::make_quadratic<2>(*stage.solid.mesh, fem::list_cuts(stage.solid.model));
}

std::shared_ptr<const input::KnownWater> make_known_water(const mesh::Mesh<2>& mesh, std::vector<double> pressure) {
  return std::make_shared<const input::KnownWater>(
      input::KnownWater{mesh, std::move(pressure), std::vector<std::array<double, 2>>(mesh.elements.size())});
}

/// Lists the components of all entries one after the other.
template <class Entry>
std::vector<double> flatten(const std::vector<Entry>& entries) {
  std::vector<double> numbers;
  for (const Entry& entry : entries) numbers.insert(numbers.end(), entry.begin(), entry.end());
  return numbers;
}

/// The reverse of flatten(); false if the numbers do not fill the entries.
template <class Entry>
bool unflatten(const std::vector<double>& numbers, std::vector<Entry>& entries) {
  const std::size_t size = std::tuple_size_v<Entry>;
  if (numbers.size() % size != 0) return false;
  entries.resize(numbers.size() / size);
  for (std::size_t i = 0; i < numbers.size(); ++i) entries[i / size][i % size] = numbers[i];
  return true;
}

}  // namespace

ConstructionRun::ConstructionRun(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options,
                                 std::string input_hash)
    : loaded_(loaded), data_(data), options_(options), hash_(std::move(input_hash)) {}

void ConstructionRun::show(const std::string& what) const {
  if (options_.progress) options_.progress->show("construction: " + what);
}

void ConstructionRun::prepare() {
  if (get_ranks().size() > 1) fail_input("stages of construction run on one rank; start the program without MPI");
  show("mesh");
  mesh_ = make_whole_mesh(data_, warnings_);
  for (int k = before_stages; k < static_cast<int>(data_.construction.size()); ++k)
    make_stage_model(data_, k, mesh_, nullptr);
  summary_.elements = mesh_->element_count();
  record_.emplace(data_, mesh_);
  if (options_.progress) options_.progress->clear();
}

/// Computes the equilibrium before the stages, whose displacements do not count.
void ConstructionRun::find_start() {
  show("equilibrium at the start");
  stage_ = make_stage_model(data_, before_stages, mesh_, nullptr);
  steady_head_ = stage_->model.steady_head;
  fem::SolidModel<2> solid = stage_->solid.model;
  solid.pore_stress = fem::find_corner_stress<2>(stage_->model, steady_head_);
  const fem::SolidResult<2> found = fem::find_equilibrium<2>(solid, make_solid_options(data_.fem, options_.threads));
  if (!found.converged)
    throw Error(ExitCode::wrong_input,
                "the section has no equilibrium at the start of its stages of construction: check strengths, pore "
                "pressures and [[boundary]]");
  state_ = {found.at, steady_head_};
  record_->set_steady(steady_head_);
  std::fill(state_.solid.displacement.begin(), state_.solid.displacement.end(), Vec<2>{});
  std::fill(state_.solid.strain.begin(), state_.solid.strain.end(), std::array<double, 6>{});
  std::fill(state_.solid.yields.begin(), state_.solid.yields.end(), 0);
}

/// Takes the stages that an interrupted run has computed; false if there are none.
bool ConstructionRun::restore() {
  if (!options_.resume) return false;
  auto known = results::find_file<results::ConstructionRestart>(options_.folder / restart_file);
  if (!known || known->input_hash != hash_ || known->summary.stages.empty()) return false;
  const int last = static_cast<int>(known->summary.stages.size()) - 1;
  // The mesh of the stage before, which the water of its start is read on.
  const auto before = make_stage_model(data_, last - 1, mesh_, nullptr);
  if (known->start_pressure.size() != before->elevation.size()) return false;
  auto stage = make_stage_model(data_, last, mesh_, make_known_water(*before->water_mesh, known->start_pressure));
  if (known->head.size() != stage->elevation.size()) return false;
  fem::SolidState<2> solid;
  if (!unflatten(known->displacement, solid.displacement) || !unflatten(known->stress, solid.stress) ||
      !unflatten(known->strain, solid.strain))
    return false;
  solid.state = std::move(known->state);
  solid.bars = std::move(known->bars);
  solid.yields.assign(known->yields.begin(), known->yields.end());
  stage_ = std::move(stage);
  state_ = {std::move(solid), std::move(known->head)};
  steady_head_ = known->steady_head;
  start_pressure_ = std::move(known->start_pressure);
  summary_ = std::move(known->summary);
  warnings_ = std::move(known->warnings);
  for (std::vector<std::string>& entry : known->stage_warnings)
    if (!entry.empty()) stage_warnings_[entry.front()] = {entry.begin() + 1, entry.end()};
  record_->restore(*known);
  return true;
}

void ConstructionRun::keep_state() const {
  results::ConstructionRestart restart;
  restart.input_hash = hash_;
  restart.summary = summary_;
  restart.start_pressure = start_pressure_;
  restart.head = state_.head;
  restart.displacement = flatten(state_.solid.displacement);
  restart.stress = flatten(state_.solid.stress);
  restart.strain = flatten(state_.solid.strain);
  restart.state = state_.solid.state;
  restart.bars = state_.solid.bars;
  restart.yields.assign(state_.solid.yields.begin(), state_.solid.yields.end());
  restart.warnings = warnings_;
  for (const auto& [warning, stages] : stage_warnings_) {
    std::vector<std::string>& entry = restart.stage_warnings.emplace_back(std::vector{warning});
    entry.insert(entry.end(), stages.begin(), stages.end());
  }
  record_->keep(restart);
  results::write_file(options_.folder / restart_file, restart, -1);
}

void ConstructionRun::forget() const {
  remove_file(options_.folder / restart_file);
}

void ConstructionRun::calculate() {
  const auto start = std::chrono::steady_clock::now();
  std::chrono::duration<double> factors{0};
  if (!restore()) find_start();
  for (int k = static_cast<int>(summary_.stages.size()); k < static_cast<int>(data_.construction.size()); ++k) {
    const bool ended = run_stage(k);
    const input::ConstructionStage& asked = data_.construction[static_cast<std::size_t>(k)];
    const auto before = std::chrono::steady_clock::now();
    if (ended && asked.factor) add_factors(k, summary_.stages.back());
    if (asked.release) release(k, summary_.stages.back());
    factors += std::chrono::steady_clock::now() - before;
    if (!ended) break;
    keep_state();
    options_.store();
  }
  find_least();
  summary_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start - factors).count();
  keep();
  if (options_.progress) options_.progress->clear();
}

results::Construction ConstructionRun::follow() {
  find_start();
  for (int k = 0; k < static_cast<int>(data_.construction.size()); ++k)
    if (!run_stage(k)) break;
  summary_.monitors = record_->make_monitors();
  return summary_;
}

fem::ConsolidationSchedule ConstructionRun::make_schedule(int number) const {
  const input::ConstructionStage& asked = data_.construction[static_cast<std::size_t>(number)];
  fem::ConsolidationSchedule schedule;
  schedule.start = find_stage_start(data_, number);
  schedule.duration = asked.duration;
  schedule.tolerance = data_.consolidation.tolerance;
  schedule.first_step = data_.consolidation.first_step.value_or(0);
  schedule.most_iterations = data_.consolidation.most_iterations;
  schedule.load_steps = data_.fem.load_steps;
  schedule.threads = options_.threads;
  schedule.most_displacement = find_most_displacement();
  return schedule;
}

bool ConstructionRun::run_stage(int number) {
  const input::ConstructionStage& asked = data_.construction[static_cast<std::size_t>(number)];
  results::ConstructionStage& result = summary_.stages.emplace_back();
  result.name = asked.name;
  result.from = find_stage_start(data_, number);
  result.to = find_stage_end(data_, number);
  result.added = asked.add;
  result.removed = asked.remove;
  show(fmt::format("stage '{}'", asked.name));
  start_pressure_ = find_pressures(*stage_, state_.head);
  std::unique_ptr<StageModel> next =
      make_stage_model(data_, number, mesh_, make_known_water(*stage_->water_mesh, start_pressure_));
  SteadyWater steady(*next, map_nodes(*stage_, steady_head_, *next), result.from, result.to);
  if (next->is_wet && asked.drainage == input::StageDrainage::undrained)
    next->model.drainage = fem::StageDrainage::undrained;
  if (next->is_wet && asked.drainage == input::StageDrainage::drained) {
    next->model.drainage = fem::StageDrainage::drained;
    next->model.steady_head = steady.find_drained_head();
  }
  fem::ConsolidationState<2> start = fem::carry_state<2>(stage_->model, state_, next->model, next->elevation);
  if (asked.reset_displacement) std::fill(start.solid.displacement.begin(), start.solid.displacement.end(), Vec<2>{});
  const std::vector<fem::BarForces> supports_before = list_bar_forces(*next, start.solid);
  const fem::ConsolidationResult<2> found = fem::run_stage<2>(
      next->model, start, make_schedule(number),
      [&](const fem::ConsolidationStep& step, const fem::SolidState<2>& solid, const std::vector<double>& head) {
        // A table that jumps at the end of a step has its old value up to there.
        steady_head_ = steady.find_head(step.time - 1e-9 * step.length);
        add_step(*next, step, solid, head, result);
        show(fmt::format("stage '{}', {}", asked.name, units::format_time(step.time)));
        options_.store();
      });
  add_water_warning(asked, steady);
  result.converged = found.converged;
  result.reached = found.reached;
  result.rejected = found.rejected;
  result.start_imbalance = found.start_imbalance;
  summary_.unknowns = std::max(summary_.unknowns, found.unknowns);
  stage_ = std::move(next);
  state_ = found.outputs.back().at;
  record_->add_stage(asked.name, *stage_, state_);
  const results::ConstructionStage* before =
      number > 0 && !asked.reset_displacement ? &summary_.stages[static_cast<std::size_t>(number) - 1] : nullptr;
  result.supports = make_stage_supports(*stage_, state_.solid, supports_before, before);
  if (!found.converged) {
    result.error = fmt::format(
        "no equilibrium beyond {:.3g} % of the change of stage '{}', at {}: the soil fails there or moves by more than "
        "a quarter of the height of the section, or the time steps are too long for it ([consolidation] first_step)",
        100 * found.reached, asked.name, units::format_time(found.outputs.back().time));
    warnings_.push_back(*result.error);
  }
  return found.converged;
}

/// The pore pressures at the end of a drained stage, and the excess of another one, need a steady flow.
void ConstructionRun::add_water_warning(const input::ConstructionStage& asked, const SteadyWater& steady) {
  if (!steady.fault() || asked.drainage != input::StageDrainage::drained) return;
  warnings_.push_back(fmt::format("stage '{}' is drained, and {}", asked.name, *steady.fault()));
}

void ConstructionRun::add_step(const StageModel& stage, const fem::ConsolidationStep& step,
                               const fem::SolidState<2>& solid, const std::vector<double>& head,
                               results::ConstructionStage& result) {
  results::ConstructionStep& out = result.steps.emplace_back();
  out.time = step.time;
  out.length = step.length;
  out.error = step.error;
  out.residual = step.residual;
  out.iterations = step.iterations;
  for (const Vec<2>& u : solid.displacement) {
    out.settlement = std::max(out.settlement, -u[1]);
    out.heave = std::max(out.heave, u[1]);
    out.lateral = std::max(out.lateral, std::abs(u[0]));
  }
  if (stage.is_wet) {
    const fem::ExcessRange excess = fem::find_excess_range<2>(stage.model, head, steady_head_);
    out.excess = excess.largest, out.least_excess = excess.least;
  }
  record_->set_steady(steady_head_);
  record_->add_step(step.time, stage, solid, head);
}

/// Returns the case of the methods at the end of the last stage, with its pore pressures and stresses.
input::Case ConstructionRun::make_later_case() const {
  input::Case later = stage_->data;
  if (stage_->is_wet)
    later.initial.water.known = make_known_water(*stage_->water_mesh, find_pressures(*stage_, state_.head));
  auto stress = std::make_shared<input::KnownStress>();
  stress->mesh = *stage_->solid.mesh;
  stress->elements.resize(mesh_->elements.size());
  const fem::QuadraticMesh<2> mesh = make_quadratic(*stage_);
  const std::size_t states = state_.solid.state.size() / std::max<std::size_t>(1, mesh.points.size());
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    auto& element = stress->elements[static_cast<std::size_t>(mesh.linear_element[k])];
    for (std::size_t q = 0; q < points; ++q) {
      element.stress[q] = state_.solid.stress[k * points + q];
      element.plastic_strain[q] = state_.solid.state[(k * points + q) * states];
    }
  }
  later.initial.stress = input::InitialStress::elements;
  later.initial.known_stress = std::move(stress);
  return later;
}

/// Returns true if excess pore pressures are left at the end of a stage: more than a tenth of the largest so far, and
/// than a hundredth of the pressure of water as high as the section, below which they are errors of the steps.
bool ConstructionRun::keeps_excess(const results::ConstructionStage& result) const {
  constexpr double left_fraction = 0.1, least_fraction = 0.01;
  const auto [low, high] = std::minmax_element(stage_->elevation.begin(), stage_->elevation.end());
  const double least = least_fraction * stage_->flow.unit_weight * (*high - *low);
  double largest = 0;
  for (const results::ConstructionStage& stage : summary_.stages)
    for (const results::ConstructionStep& step : stage.steps) largest = std::max(largest, step.excess);
  return stage_->is_wet && !result.steps.empty() &&
         result.steps.back().excess > std::max(least, left_fraction * largest);
}

/// Soil that contracts as it fails takes up pore pressure unless it drains: at the fixed pore pressures of the other
/// factors it would be too strong. Returns false if there is no equilibrium at full strength.
bool ConstructionRun::add_undrained_factors(const input::Case& later, int number, results::ConstructionStage& result) {
  show(fmt::format("stage '{}', failure without drainage", result.name));
  fem::UndrainedOptions limits;
  limits.resolution = data_.fem.resolution;
  limits.most_iterations = data_.consolidation.most_iterations;
  limits.most_displacement = find_most_displacement();
  limits.threads = options_.threads;
  results::StageFactor factor{Method::fem, "FEM, failure without drainage", {}, {}, {}, {}, true};
  const fem::UndrainedReduction reduced = fem::reduce_undrained<2>(stage_->model, state_, limits);
  if (reduced.stable > 0 && reduced.failed > 0) {
    factor.factor = reduced.stable;  // no interval: what one mesh leaves open is not known
  } else {
    factor.error = reduced.stable > 0 ? fmt::format("no failure up to a factor of {:g}", reduced.stable)
                                      : "no equilibrium at full strength without drainage";
  }
  result.factors.push_back(std::move(factor));
  const RunOptions options = options_.make_nested(join_name(options_.folder, result.folder));
  StageFactors found =
      find_undrained_factors(loaded_, later, fmt::format("{}, end of stage '{}'", data_.title, result.name), options,
                             fmt::format("{}-{}-undrained", hash_, number), std::max(1.0, reduced.stable));
  result.factors.insert(result.factors.end(), found.factors.begin(), found.factors.end());
  add_warnings(result.name, found.warnings);
  return reduced.stable > 0;
}

void ConstructionRun::add_warnings(const std::string& stage, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    std::vector<std::string>& stages = stage_warnings_[warning];
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
  }
}

/// Small displacements end at a quarter of the height of the section.
double ConstructionRun::find_most_displacement() const {
  const auto [low, high] = std::minmax_element(mesh_->nodes.begin(), mesh_->nodes.end(),
                                               [](const auto& a, const auto& b) { return a[1] < b[1]; });
  return 0.25 * ((*high)[1] - (*low)[1]);
}

void ConstructionRun::add_factors(int number, results::ConstructionStage& result) {
  result.folder = fmt::format("stage_{}", number + 1);
  const RunOptions options = options_.make_nested(join_name(options_.folder, result.folder));
  input::Case later = make_later_case();
  std::erase(later.methods, Method::mpm);
  const fem::SolidModel<2>& model = stage_->solid.model;
  std::vector<fem::KnownSpring> known;
  if (!model.bars.empty() || !model.walls.empty()) known = fem::list_known_springs(model, state_.solid);
  StageFactors found =
      find_stage_factors(loaded_, later, fmt::format("{}, end of stage '{}'", data_.title, result.name), options,
                         fmt::format("{}-{}", hash_, number), known);
  result.factors = std::move(found.factors);
  add_warnings(result.name, found.warnings);
  const bool holds_undrained = !keeps_excess(result) || add_undrained_factors(later, number, result);
  for (const results::StageFactor& factor : result.factors)
    if (factor.factor) result.least = std::min(result.least.value_or(*factor.factor), *factor.factor);
  // The other factors would be above that of a state that does not even hold at full strength.
  if (!holds_undrained) result.least.reset();
}

/// Runs MPM from the end of the last stage, or from its last equilibrium under the loads of its end.
void ConstructionRun::release(int number, results::ConstructionStage& result) {
  results::Release& out = result.release.emplace();
  out.time = result.steps.empty() ? result.from : result.steps.back().time;
  out.factor = result.least;
  out.folder = fmt::format("released_{}", number + 1);
  const RunOptions options = options_.make_nested(join_name(options_.folder, out.folder));
  // A case of its own, which knows nothing of regions that are gone.
  input::LoadedCase later = loaded_;
  later.data = make_later_case();
  later.data.methods = {Method::mpm};
  std::erase_if(later.data.regions, [&](const auto& entry) {
    const auto& polygons = later.data.mesh.polygons;
    return std::none_of(polygons.begin(), polygons.end(), [&](const auto& p) { return p.name == entry.first; });
  });
  later.echo = input::drop_absent(later.echo, later.data);
  show(fmt::format("MPM from the end of stage '{}'", result.name));
  const auto complete = [&](results::RunResult& run) {
    run.title = fmt::format("{}, released from stage '{}'", data_.title, result.name);
  };
  out.error = attempt(options, false, [&] {
    results::take_motion(run_points_beside<2>(
                             later, options, hash_text(fmt::format("{}-mpm-{}", hash_, number)),
                             [&](results::RunResult&) -> const input::Case& { return later.data; }, complete),
                         out);
  });
  if (out.error) warnings_.push_back(fmt::format("MPM from stage '{}': {}", result.name, *out.error));
}

/// Sets the least factor, unless a stage failed or has no factor: that of the others would be above it.
void ConstructionRun::find_least() {
  for (const results::ConstructionStage& stage : summary_.stages) {
    const auto& asked = data_.construction[static_cast<std::size_t>(&stage - summary_.stages.data())];
    if (!stage.converged || (asked.factor && !stage.least)) {
      summary_.least.reset();
      summary_.least_stage.reset();
      if (stage.converged)
        warnings_.push_back(fmt::format(
            "no factor is on the safe side at the end of stage '{}', so that the least one is not known", stage.name));
      return;
    }
    if (!stage.least || *stage.least >= summary_.least.value_or(std::numeric_limits<double>::infinity())) continue;
    summary_.least = stage.least;
    summary_.least_stage = stage.name;
  }
}

/// Writes fields, those for ParaView stage by stage, and the monitors as a table.
void ConstructionRun::keep() {
  results::ConstructionFile file = record_->fields();
  file.input_hash = hash_;
  results::write_file(options_.folder / construction_file, file, -1);
  for (std::size_t k = 0; k < file.stages.size(); ++k)
    write_atomically(options_.folder / fmt::format("construction_{}.vtu", k + 1), write_stage_vtu(file, k));
  summary_.monitors = record_->make_monitors();
  summary_.lines = record_->lines();
  if (summary_.monitors.empty()) return;
  std::vector<output::Column> columns{{"time", "s"}};
  for (const results::ConstructionMonitor& m : summary_.monitors)
    for (const auto& [name, unit] : {std::pair{"displacement_x", "m"}, std::pair{"displacement_y", "m"},
                                     std::pair{"pore_pressure", "Pa"}, std::pair{"p", "Pa"}, std::pair{"q", "Pa"}})
      columns.push_back({m.name + "." + name, unit});
  output::History table = output::History::start(options_.folder / "construction_monitors.csv", columns);
  for (std::size_t i = 0; i < record_->times().size(); ++i) {
    std::vector<double> row{record_->times()[i]};
    for (const results::ConstructionMonitor& m : summary_.monitors)
      for (const auto* list : {&m.displacement_x, &m.displacement_y, &m.pressure, &m.mean, &m.deviator})
        row.push_back((*list)[i]);
    table.append(row);
  }
}

void ConstructionRun::write_result(results::RunResult& run) const {
  run.construction = summary_;
  for (const std::string& warning : warnings_) run.warnings.push_back("construction: " + warning);
  for (const auto& [warning, stages] : stage_warnings_)
    run.warnings.push_back(fmt::format("end of stage '{}': {}", fmt::join(stages, "', '"), warning));
}

}  // namespace talus::run
