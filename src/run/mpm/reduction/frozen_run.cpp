// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/frozen_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/atomic_file.hpp"
#include "base/user_file.hpp"
#include "mesh/quality.hpp"
#include "mpm/solver/observe.hpp"
#include "results/json.hpp"
#include "run/common/bedding_lines.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/record/sections.hpp"
#include "run/mpm/reduction/leg.hpp"
#include "run/mpm/stage/stage_warnings.hpp"
#include "run/mpm/start/conditions.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;

/// At frozen geometry only rest matters, not displacement, so a stage may take longer than in the case.
constexpr double longest_frozen_stage = 60;
/// State at the start of the current stage, stored beside its checkpoint.
constexpr const char* stage_start = "stage_start.h5";

/// One of the meshes of the factor.
struct MeshChoice {
  std::string name;  ///< of its folder: "mesh_0"
  std::string label;
  int halvings = 0;  ///< of the element size of the case; −1: doubled
  mesh::Algorithm algorithm = mesh::Algorithm::meshadapt;
};

/// Returns the mesh plan of the case for this mesh.
mesh::Plan plan_mesh(const mesh::Plan& plan, const input::FrozenFactor& settings, const MeshChoice& choice) {
  mesh::Plan chosen = plan_frozen_mesh(plan, settings, choice.halvings);
  chosen.algorithm = choice.algorithm;
  return chosen;
}

/// Returns a mesher other than `algorithm`.
mesh::Algorithm choose_other(mesh::Algorithm algorithm) {
  return algorithm == mesh::Algorithm::delaunay ? mesh::Algorithm::meshadapt : mesh::Algorithm::delaunay;
}

/// Returns the case with all stages at frozen geometry, where loads on the ground act on the sides of the mesh.
input::Case freeze(input::Case data) {
  for (input::Stage& stage : data.stages) stage.step.geometry = input::Geometry::frozen;
  return data;
}

/// Returns the plan of a stage at frozen geometry, until rest.
template <int D>
StagePlan<D> make_frozen_stage(const input::Case& data, const input::Stage& stage, double slope_height, int threads) {
  const input::FrozenFactor& settings = data.strength_reduction.frozen;
  StagePlan<D> plan = make_plan<D>(data, stage, slope_height, threads);
  plan.name += " at frozen geometry";
  // The settings are those of the trials, except for the mass scaling of the stage and, below, its damping if that is
  // larger.
  plan.step = settings.step_settings;
  plan.step.geometry = input::Geometry::frozen;
  plan.step.mass_scaling = stage.step.mass_scaling;
  plan.step.objective_rate = stage.step.objective_rate;
  // Stages with little damping would oscillate for long without a change of their state of rest.
  plan.step.damping = std::max(stage.step.damping, settings.step_settings.damping);
  plan.equalises_mass = true;
  plan.until_rest = true;
  plan.duration = std::max(stage.duration, longest_frozen_stage);
  plan.rest = settings.rest;
  return plan;
}

/// One mesh of the factor: its files, and how its stages and trials are run and resumed.
template <int D>
class FrozenMesh {
 public:
  FrozenMesh(const TrialContext& context, const MeshChoice& choice, int threads)
      : context_(context),
        data_(freeze(*context.data)),
        settings_(data_.strength_reduction.frozen),
        choice_(choice),
        threads_(threads),
        folder_(join_name(context.folder / "frozen", choice.name)) {
    recording_.folder = folder_;
    recording_.input_hash = context.input_hash;
    recording_.data = &data_;
    recording_.keeps_frames = recording_.keeps_history = false;
    recording_.progress = context.progress;
    recording_.label = choice.label;
  }

  results::MeshFactor compute(const mesh::Mesh<D>& base, std::vector<std::string>& warnings) {
    run_stages(base, warnings);
    if (context_.resume) {
      known_ = load_trials(folder_ / "trials.json");
      for (const auto& [factor, trial] : known_) done_.push_back(trial);
    }
    const int side_by_side = count_parallel_trials(state_.points.size(), threads_);
    const StagePlan<D> plan = make_frozen_plan<D>(data_, settings_, height_, side_by_side > 1 ? 1 : threads_);
    results::MeshFactor factor = search_frozen_factor(
        settings_, [&](const std::vector<double>& factors) { return run_round(factors, side_by_side, plan); });
    factor.points = state_.points.size();
    factor.size = data_.mesh.file.empty() ? data_.mesh.size * std::pow(0.5, choice_.halvings)
                                          : mesh::measure_quality(state_.mesh()).mean_size;
    const ShownUnit& length = data_.units().length;
    if (std::string undecided = describe_undecided(factor, settings_, length); !undecided.empty())
      warnings.push_back(std::move(undecided));
    for (const results::Trial& trial : factor.trials)
      if (trial.setbacks)
        for (const results::Retry& setback : *trial.setbacks)
          warnings.push_back(describe_setback(
              fmt::format("at h = {} the frozen trial at SRF {:.4g}", format_value(factor.size, length), trial.factor),
              setback));
    remove_file(folder_ / recording_.checkpoint_name);
    remove_file(folder_ / stage_start);
    return factor;
  }

 private:
  void run_stages(const mesh::Mesh<D>& base, std::vector<std::string>& warnings) {
    const auto checkpoint =
        context_.resume ? open_checkpoint(folder_ / recording_.checkpoint_name, context_.input_hash) : nullptr;
    const bool ready = !data_.mesh.file.empty() || !data_.initial.result.empty();
    state_ = prepare<D>(
        data_, checkpoint ? get_mesh<D>(*checkpoint)
               : ready    ? base
                          : generate_along_bedding<D>(data_, plan_mesh(data_.mesh, settings_, choice_), warnings));
    // Hydrostatic pore pressures and external water levels are those of the start in every trial.
    if (settings_.step_settings.water == input::WaterMotion::held) hold_surfaces(state_, 0);
    height_ = find_slope_height(state_, data_.gravity);
    auto [recorder, stage_state, first] = begin_recording(recording_, state_, checkpoint.get());
    const int threads = count_parallel_trials(state_.points.size(), threads_) > 1 ? 1 : threads_;
    for (int i = first; i < static_cast<int>(data_.stages.size()); ++i) {
      const input::Stage& stage = data_.stages[i];
      StagePlan<D> plan = make_frozen_stage<D>(data_, stage, height_, threads);
      // The first stage applies the weight and may settle the slope by any amount; a later one shows whether the slope
      // is stable.
      if (i > 0) plan.failed_displacement = settings_.failed_displacement * height_;
      set_strength(state_, data_, stage.cohesion, stage.strength_factor.value_or(1));
      if (i > 0 && !stage_state.started) stage_state.gravity_share = 1;
      const StageHooks<D> hooks = recorder.begin_leg(i, plan, state_, stage_state);
      mpm::Body<D> before = state_;
      if (stage_state.started && fs::exists(folder_ / stage_start)) {
        get_body(output::ArchiveReader(folder_ / stage_start), before);
      }
      if (!stage_state.started) mpm::reset_displacements(state_);
      if (run_stage(state_, plan, stage_state, hooks) != results::StageEnd::rest) {
        // A slope that fails under its own weight has a factor below one; its trials start from the state before it
        // moved.
        if (i > 0) state_ = before;
        const std::string warning = fmt::format(
            "stage '{}' did not come to rest at frozen geometry: the slope does not stand with the strength of this "
            "stage{}",
            stage.name, i > 0 ? ", and the trials start from the state before it" : "");
        if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
      }
      if (is_equilibrium_stage(data_, i)) set_preconsolidation(state_, data_);
      recorder.end_leg(state_);
      fs::copy_file(folder_ / recording_.checkpoint_name, begin_file(folder_ / stage_start));
      publish(folder_ / stage_start);
      stage_state = {};
    }
  }

  std::vector<results::Trial> run_round(const std::vector<double>& factors, int side_by_side,
                                        const StagePlan<D>& plan) {
    std::vector<results::Trial> trials;
    for (const results::TrialOutcome& o : run_side_by_side(static_cast<int>(factors.size()), side_by_side,
                                                           [&](int i) { return run_one(factors[i], plan); })) {
      keep(o);  // for trials that another group of ranks has calculated
      trials.push_back(o.trial);
    }
    return trials;
  }

  /// Thread-safe.
  results::TrialOutcome run_one(double factor, const StagePlan<D>& plan) {
    if (const auto before = known_.find(factor); before != known_.end()) return {before->second, {}, {}};
    RecorderSettings recording = recording_;
    recording.checkpoint_name = fmt::format("trial_{:.9f}.h5", factor);
    recording.label += fmt::format("SRF {:.3f}, ", factor);
    mpm::Body<D> body = start_trial(state_, data_, factor);
    const auto checkpoint =
        context_.resume ? open_checkpoint(folder_ / recording.checkpoint_name, context_.input_hash) : nullptr;
    auto [recorder, stage, leg] = begin_recording(recording, body, checkpoint.get());
    const StageHooks<D> hooks = recorder.begin_leg(leg, plan, body, stage);
    results::TrialOutcome outcome{run_trial(body, factor, plan, stage, hooks), {}, {}};
    if constexpr (D == 2)
      if (outcome.trial.end == results::StageEnd::failed) outcome.slip_line = find_slip_line(factor, body);
    keep(outcome);
    show(outcome, recording.label);
    recorder.finish(true);
    context_.add_timing(body.timing);
    return outcome;
  }

  void show(const results::TrialOutcome& outcome, const std::string& label) const {
    if (!context_.progress) return;
    ProgressValues values{.method = "mpm",
                          .series = "frozen geometry",
                          .factor = outcome.trial.factor,
                          .displacement = outcome.trial.displacement};
    if (outcome.trial.end != results::StageEnd::time) values.holds = outcome.trial.end == results::StageEnd::rest;
    if (outcome.slip_line) values.surface = outcome.slip_line->points;
    context_.progress->show(fmt::format("{}{}", label, results::to_word(outcome.trial.end)), std::move(values));
  }

  /// Writes the outcome of a trial to files, once.
  void keep(const results::TrialOutcome& outcome) {
    const std::lock_guard lock(keeping_);
    const double factor = outcome.trial.factor;
    if (std::any_of(done_.begin(), done_.end(), [&](const auto& done) { return done.factor == factor; })) return;
    done_.push_back(outcome.trial);
    if (outcome.slip_line) {
      const fs::path file = folder_ / slip_line_file;  // of the smallest factor that has failed so far
      const auto kept = results::find_file<results::SlipLine>(file);
      if (!kept || factor <= kept->factor) results::write_file(file, *outcome.slip_line, -1);
    }
    save_trials(folder_ / "trials.json", done_);  // last: a resumed run takes the trial as complete
  }

  static std::optional<results::SlipLine> find_slip_line(double factor, const mpm::Body<2>& body) {
    MovedLimit limit = find_frozen_limit(body);
    if (limit.line.empty()) return std::nullopt;
    results::SlipLine out{factor, std::move(limit.line), {}};
    if (!limit.sides.empty()) out.sides = std::move(limit.sides);
    return out;
  }

  const TrialContext& context_;
  const input::Case data_;
  const input::FrozenFactor& settings_;
  const MeshChoice choice_;
  int threads_;
  fs::path folder_;
  RecorderSettings recording_;
  mpm::Body<D> state_;
  double height_ = 0;
  KnownTrials known_;
  std::vector<results::Trial> done_;
  std::mutex keeping_;
};

}  // namespace

template <int D>
results::FrozenFactor compute_frozen_factor(const mesh::Mesh<D>& base, const TrialContext& context, int threads,
                                            std::vector<std::string>& warnings) {
  const input::FrozenFactor& settings = context.data->strength_reduction.frozen;
  std::vector<results::MeshFactor> found;
  int meshes = settings.meshes;
  if (!context.data->mesh.file.empty() && meshes > 1) {
    warnings.push_back(
        "the mesh is a ready file, which cannot be halved: the factor of safety is that of one mesh and not "
        "extrapolated");
    meshes = 1;
  }
  for (int i = 0; i < meshes; ++i)
    found.push_back(
        FrozenMesh<D>(context,
                      {fmt::format("mesh_{}", i), fmt::format("mesh {} of {}: ", i + 1, meshes), i, settings.algorithm},
                      threads)
            .compute(base, warnings));
  std::optional<results::MeshFactor> coarser, other;
  const bool all_found =
      std::all_of(found.begin(), found.end(), [](const results::MeshFactor& m) { return m.factor().has_value(); });
  if (meshes == 2 && all_found) {
    std::string reason = "it brackets no factor";
    try {
      coarser = FrozenMesh<D>(context, {"mesh_coarser", "coarser mesh: ", -1, settings.algorithm}, threads)
                    .compute(base, warnings);
    } catch (const Error& error) {  // the two requested meshes suffice for a factor
      if (error.code() == ExitCode::interrupted) throw;
      reason = error.what();
    }
    if (!coarser || !coarser->factor())
      warnings.push_back(
          "the factor of safety is extrapolated from two meshes, not from three, because the coarser one failed: " +
          reason);
  }
  if (meshes == 2 && settings.mesh_scatter && all_found) {
    other = FrozenMesh<D>(context, {"mesh_other", "another mesher: ", 0, choose_other(settings.algorithm)}, threads)
                .compute(base, warnings);
  }
  if (found.size() > 1 && all_found) {
    const double f = *found[found.size() - 2].factor(), finer = *found.back().factor();
    if (std::abs(f - finer) > far_apart * finer)
      warnings.push_back(fmt::format(
          "the factors of the two meshes differ by {:.0f} %: refine the mesh before trusting the extrapolated factor",
          100 * std::abs(f / finer - 1)));
  }
  results::FrozenFactor frozen = join_meshes(std::move(found), std::move(coarser), std::move(other), D);
  if (!frozen.factor) warnings.push_back("MPM, rest or run-away at frozen geometry: " + frozen.note);
  return frozen;
}

template results::FrozenFactor compute_frozen_factor<2>(const mesh::Mesh<2>&, const TrialContext&, int,
                                                        std::vector<std::string>&);
template results::FrozenFactor compute_frozen_factor<3>(const mesh::Mesh<3>&, const TrialContext&, int,
                                                        std::vector<std::string>&);

}  // namespace talus::run
