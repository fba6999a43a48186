// SPDX-License-Identifier: MIT
#include "run/construction/construction_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"
#include "mesh/locate.hpp"
#include "results/json.hpp"
#include "run/construction/stage_factors.hpp"
#include "run/fem/start_stress.hpp"

namespace talus::run {
namespace {

constexpr std::size_t points = input::KnownStress::points;

/// Returns the elements of the quadratic mesh by those of the linear one; -1: no soil.
std::vector<int> list_elements(const fem::QuadraticMesh<2>& mesh, std::size_t count) {
  std::vector<int> list(count, -1);
  for (std::size_t k = 0; k < mesh.linear_element.size(); ++k)
    list[static_cast<std::size_t>(mesh.linear_element[k])] = static_cast<int>(k);
  return list;
}

fem::QuadraticMesh<2> make_quadratic(const StageModel& stage) {
  return fem::make_quadratic<2>(*stage.solid.mesh, fem::list_cuts(stage.solid.model));
}

/// Effective mean stress, compression positive, and q.
std::array<double, 2> find_invariants(const std::array<double, 6>& s) {
  const double p = -(s[0] + s[1] + s[2]) / 3;
  double q = 0;
  for (std::size_t i = 0; i < 3; ++i) q += (s[i] + p) * (s[i] + p) + 2 * s[i + 3] * s[i + 3];
  return {p, std::sqrt(1.5 * q)};
}

}  // namespace

ConstructionRun::ConstructionRun(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options,
                                 std::string input_hash)
    : loaded_(loaded), data_(data), options_(options), hash_(std::move(input_hash)) {}

void ConstructionRun::show(const std::string& what) const {
  if (options_.progress) options_.progress->show("construction: " + what);
}

void ConstructionRun::prepare() {
  show("mesh");
  mesh_ = make_whole_mesh(data_, warnings_);
  for (int k = before_stages; k < static_cast<int>(data_.construction.size()); ++k)
    make_stage_model(data_, k, mesh_, nullptr);
  summary_.elements = mesh_->element_count();
  for (const input::Monitor& monitor : data_.output.monitors) {
    const Vec<2> x{monitor.at[0], monitor.at[1]};
    Place place;
    place.element = mesh::find_element(*mesh_, x, 0);
    if (place.element < 0)
      throw Error(ExitCode::wrong_input,
                  fmt::format("monitor '{}' at ({:g}, {:g}) lies outside the section", monitor.name, x[0], x[1]));
    const auto xi = mesh::to_local(*mesh_, place.element, x);
    place.share = {1 - xi[0] - xi[1], xi[0], xi[1]};
    places_.push_back(place);
    summary_.monitors.push_back({monitor.name, {x[0], x[1]}, {}, {}, {}, {}, {}});
  }
  if (options_.progress) options_.progress->clear();
}

/// Computes the equilibrium before the stages, whose displacements do not count.
void ConstructionRun::find_start() {
  show("equilibrium at the start");
  stage_ = make_stage_model(data_, before_stages, mesh_, nullptr);
  first_head_ = stage_->model.steady_head;
  fem::SolidModel<2> solid = stage_->solid.model;
  solid.pore_stress = fem::find_corner_stress<2>(stage_->model, first_head_);
  const fem::SolidResult<2> found = fem::find_equilibrium<2>(solid, make_solid_options(data_.fem, options_.threads));
  if (!found.converged)
    throw Error(ExitCode::wrong_input,
                "the section has no equilibrium at the start of its stages of construction: check strengths, pore "
                "pressures and [[boundary]]");
  state_ = {found.at, first_head_};
  std::fill(state_.solid.displacement.begin(), state_.solid.displacement.end(), Vec<2>{});
  std::fill(state_.solid.strain.begin(), state_.solid.strain.end(), std::array<double, 6>{});
  std::fill(state_.solid.yields.begin(), state_.solid.yields.end(), 0);
}

void ConstructionRun::calculate() {
  const auto start = std::chrono::steady_clock::now();
  std::chrono::duration<double> factors{0};
  file_.input_hash = hash_;
  file_.nodes.assign(mesh_->nodes.begin(), mesh_->nodes.end());
  file_.elements.assign(mesh_->elements.begin(), mesh_->elements.end());
  find_start();
  for (int k = 0; k < static_cast<int>(data_.construction.size()); ++k) {
    if (!run_stage(k)) break;
    const auto before = std::chrono::steady_clock::now();
    if (data_.construction[static_cast<std::size_t>(k)].factor) add_factors(k, summary_.stages.back());
    factors += std::chrono::steady_clock::now() - before;
  }
  find_least();
  summary_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start - factors).count();
  keep();
  if (options_.progress) options_.progress->clear();
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
  const auto water = std::make_shared<const input::KnownWater>(
      input::KnownWater{*stage_->solid.mesh, find_pressures(*stage_, state_.head),
                        std::vector<std::array<double, 2>>(mesh_->elements.size())});
  std::unique_ptr<StageModel> next = make_stage_model(data_, number, mesh_, water);
  if (next->is_wet && asked.drainage == input::StageDrainage::undrained)
    next->model.drainage = fem::StageDrainage::undrained;
  if (next->is_wet && asked.drainage == input::StageDrainage::drained) {
    next->model.drainage = fem::StageDrainage::drained;
    next->model.steady_head = fem::solve_steady_seepage<2>(next->flow, {}, {}, result.to).head;
  }
  fem::ConsolidationState<2> start = fem::carry_state<2>(stage_->model, state_, next->model, next->elevation);
  if (asked.reset_displacement) std::fill(start.solid.displacement.begin(), start.solid.displacement.end(), Vec<2>{});
  const fem::ConsolidationResult<2> found = fem::run_stage<2>(
      next->model, start, make_schedule(number),
      [&](const fem::ConsolidationStep& step, const fem::SolidState<2>& solid, const std::vector<double>& head) {
        add_step(*next, step, solid, head, result);
        show(fmt::format("stage '{}', {}", asked.name, units::format_time(step.time)));
      });
  result.converged = found.converged;
  result.reached = found.reached;
  result.rejected = found.rejected;
  result.start_imbalance = found.start_imbalance;
  summary_.unknowns = std::max(summary_.unknowns, found.unknowns);
  stage_ = std::move(next);
  state_ = found.outputs.back().at;
  add_fields(*stage_, asked.name);
  if (!found.converged) {
    result.error = fmt::format(
        "no equilibrium beyond {:.3g} % of the change of stage '{}', at {}: the soil fails there, or the time steps "
        "are "
        "too long for it ([consolidation] first_step)",
        100 * found.reached, asked.name, units::format_time(found.outputs.back().time));
    warnings_.push_back(*result.error);
  }
  return found.converged;
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
  if (stage.is_wet) out.excess = fem::find_largest_excess<2>(stage.model, head, first_head_);
  add_monitors(stage, solid, head);
}

void ConstructionRun::add_monitors(const StageModel& stage, const fem::SolidState<2>& solid,
                                   const std::vector<double>& head) {
  if (places_.empty()) return;
  const fem::QuadraticMesh<2> mesh = make_quadratic(stage);
  const std::vector<int> elements = list_elements(mesh, mesh_->elements.size());
  const std::vector<double> pressure = find_pressures(stage, head);
  for (std::size_t m = 0; m < places_.size(); ++m) {
    results::ConstructionMonitor& monitor = summary_.monitors[m];
    const int k = elements[static_cast<std::size_t>(places_[m].element)];
    std::array<double, 5> values;
    values.fill(std::nan(""));
    if (k >= 0) {
      const auto& l = places_[m].share;
      const auto& nodes = mesh.elements[static_cast<std::size_t>(k)];
      values = {};
      // Quadratic: corners l (2 l − 1), middles of the edges 0-1, 1-2, 2-0.
      const std::array<double, 6> shape{l[0] * (2 * l[0] - 1), l[1] * (2 * l[1] - 1), l[2] * (2 * l[2] - 1),
                                        4 * l[0] * l[1],       4 * l[1] * l[2],       4 * l[2] * l[0]};
      for (std::size_t i = 0; i < shape.size(); ++i)
        for (std::size_t d = 0; d < 2; ++d)
          values[d] += shape[i] * solid.displacement[static_cast<std::size_t>(nodes[i])][d];
      const auto& corners = mesh_->elements[static_cast<std::size_t>(places_[m].element)];
      for (std::size_t i = 0; i < 3; ++i) values[2] -= l[i] * pressure[static_cast<std::size_t>(corners[i])];
      const auto nearest = static_cast<std::size_t>(std::max_element(l.begin(), l.end()) - l.begin());
      const auto [p, q] = find_invariants(solid.stress[static_cast<std::size_t>(k) * points + nearest]);
      values[3] = p, values[4] = q;
    }
    const std::array<std::vector<double>*, 5> lists{&monitor.displacement_x, &monitor.displacement_y, &monitor.pressure,
                                                    &monitor.mean, &monitor.deviator};
    for (std::size_t i = 0; i < lists.size(); ++i) lists[i]->push_back(values[i]);
  }
}

void ConstructionRun::add_fields(const StageModel& stage, const std::string& name) {
  results::ConstructionFields& fields = file_.stages.emplace_back();
  fields.stage = name;
  const fem::QuadraticMesh<2> mesh = make_quadratic(stage);
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    fields.elements.push_back(mesh.linear_element[k]);
    int yields = 0;
    for (std::size_t q = 0; q < points; ++q) yields += state_.solid.yields[k * points + q] != 0;
    fields.yields.push_back(yields / static_cast<double>(points));
  }
  const std::vector<double> pressure = find_pressures(stage, state_.head);
  for (std::size_t i = 0; i < mesh_->nodes.size(); ++i) {
    fields.displacement_x.push_back(state_.solid.displacement[i][0]);
    fields.displacement_y.push_back(state_.solid.displacement[i][1]);
    fields.pressure.push_back(stage.is_wet ? -pressure[i] : 0);
    fields.excess.push_back(stage.is_wet ? stage.flow.unit_weight * (state_.head[i] - first_head_[i]) : 0);
  }
}

/// Returns the case of the methods at the end of the last stage, with its pore pressures and stresses.
input::Case ConstructionRun::make_later_case() const {
  input::Case later = stage_->data;
  if (stage_->is_wet) {
    later.initial.water.pressure = input::InitialPressure::zero;
    later.initial.water.known = std::make_shared<const input::KnownWater>(
        input::KnownWater{*stage_->solid.mesh, find_pressures(*stage_, state_.head),
                          std::vector<std::array<double, 2>>(mesh_->elements.size())});
  }
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

void ConstructionRun::add_factors(int number, results::ConstructionStage& result) {
  RunOptions options = options_;
  result.folder = fmt::format("stage_{}", number + 1);
  options.folder = join_name(options_.folder, result.folder);
  const input::Case later = make_later_case();
  StageFactors found =
      find_stage_factors(loaded_, later, fmt::format("{}, end of stage '{}'", data_.title, result.name), options,
                         fmt::format("{}-{}", hash_, number));
  result.factors = std::move(found.factors);
  for (const std::string& warning : found.warnings) {
    std::vector<std::string>& stages = stage_warnings_[warning];
    if (stages.empty() || stages.back() != result.name) stages.push_back(result.name);
  }
  for (const results::StageFactor& factor : result.factors)
    if (factor.factor) result.least = std::min(result.least.value_or(*factor.factor), *factor.factor);
}

/// Sets the least factor, unless a stage failed or has no factor: that of the others would be above it.
void ConstructionRun::find_least() {
  for (const results::ConstructionStage& stage : summary_.stages) {
    const auto& asked = data_.construction[static_cast<std::size_t>(&stage - summary_.stages.data())];
    if (!stage.converged || (asked.factor && !stage.least)) {
      summary_.least.reset();
      summary_.least_stage.reset();
      if (stage.converged)
        warnings_.push_back(
            fmt::format("no method has a factor at the end of stage '{}', so that the least one is not "
                        "known",
                        stage.name));
      return;
    }
    if (!stage.least || *stage.least >= summary_.least.value_or(std::numeric_limits<double>::infinity())) continue;
    summary_.least = stage.least;
    summary_.least_stage = stage.name;
  }
}

void ConstructionRun::keep() const {
  results::write_file(options_.folder / construction_file, file_, -1);
}

void ConstructionRun::write_result(results::RunResult& run) const {
  run.construction = summary_;
  for (const std::string& warning : warnings_) run.warnings.push_back("construction: " + warning);
  for (const auto& [warning, stages] : stage_warnings_)
    run.warnings.push_back(fmt::format("end of stage '{}': {}", fmt::join(stages, "', '"), warning));
}

}  // namespace talus::run
