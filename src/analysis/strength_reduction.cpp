#include "analysis/strength_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/prepare.hpp"
#include "base/interrupt.hpp"
#include "mesh/generate.hpp"
#include "output/atomic_file.hpp"
#include "output/history.hpp"

namespace talus::analysis {
namespace {

using nlohmann::json;

/// Stage displacements decide nothing in the frozen initialisation, so a stage may take longer than the case's own.
constexpr double longest_frozen_stage = 60;
/// Below this share of the slope's height a displacement is elastic and no jump.
constexpr double elastic_share = 1e-3;

/// The case's plan for mesh `i` of the frozen factor: every element size halved i times, by that factor's mesher.
mesh::Plan plan_mesh(mesh::Plan plan, const model::FrozenFactor& settings, int i) {
  plan.algorithm = settings.algorithm;
  const double share = std::pow(0.5, i);
  plan.size *= share;
  for (mesh::Refinement& r : plan.refinements) r.size *= share;
  return plan;
}

/// Runs the stages of the case at frozen geometry, each to rest.
template <int D>
void run_frozen_stages(mpm::Body<D>& body, const model::Case& data, const model::FrozenFactor& settings,
                       double slope_height, int threads, Progress* progress, const std::string& label,
                       std::vector<std::string>& warnings) {
  double share = 0;
  for (const model::Stage& stage : data.stages) {
    StagePlan<D> plan = make_plan<D>(data, stage, slope_height, threads);
    plan.step.geometry = model::Geometry::frozen;
    plan.step.integration = settings.step_settings.integration;
    plan.step.smoothing = settings.step_settings.smoothing;
    plan.step.courant = settings.step_settings.courant;
    // Undamped or nearly undamped stages would swing for long without changing where they come to rest.
    plan.step.damping = std::max(stage.step.damping, settings.step_settings.damping);
    plan.until_rest = true;
    plan.duration = std::max(stage.duration, longest_frozen_stage);
    plan.rest = settings.rest;
    set_strength(body, data, stage.cohesion, stage.strength_factor.value_or(1));
    StageState state;
    state.gravity_share = share;
    StageHooks<D> hooks;
    hooks.look = [&](const mpm::Body<D>& b, const StageState&) {
      throw_if_interrupted();
      if (progress && progress->is_due())
        progress->show(fmt::format("{}{} at frozen geometry: {:.3f} s", label, plan.name, b.time));
    };
    if (run_stage(body, plan, state, hooks) != StageEnd::rest) {
      warnings.push_back(fmt::format(
          "stage '{}' did not come to rest at frozen geometry within {:g} s; the slope may be unstable as it stands",
          stage.name, plan.duration));
    }
    share = 1;
  }
}

std::pair<double, double> find_dilatancy_range(const model::Case& data) {
  double low = 1e9, high = -1e9;
  for (const auto& [name, m] : data.materials) {
    if (m.model != model::MaterialModel::mohr_coulomb) continue;
    low = std::min(low, m.dilatancy_angle * 180 / std::numbers::pi);
    high = std::max(high, m.dilatancy_angle * 180 / std::numbers::pi);
  }
  return {low, high};
}

json trials_to_json(const std::vector<TrialResult>& trials) {
  json list = json::array();
  for (const TrialResult& t : trials) list.push_back(to_json(t));
  return list;
}

}  // namespace

template <int D>
FrozenResult compute_frozen_factor(const model::Case& data, const mesh::Mesh<D>& base, const TrialContext& context,
                                   int threads, std::vector<std::string>& warnings) {
  const model::FrozenFactor& settings = data.strength_reduction.frozen;
  FrozenResult result;
  const bool ready_mesh = !data.mesh.file.empty();
  int meshes = settings.meshes;
  if (ready_mesh && meshes > 1) {
    warnings.push_back(
        "the mesh is a ready file, which cannot be halved: the factor of safety is that of one mesh and not "
        "extrapolated");
    meshes = 1;
  }
  for (int i = 0; i < meshes; ++i) {
    mesh::Mesh<D> mesh = ready_mesh ? base : mesh::generate<D>(plan_mesh(data.mesh, settings, i));
    mpm::Body<D> body = prepare<D>(data, std::move(mesh));
    const double height = find_slope_height(body, data.gravity);
    const std::string label = fmt::format("mesh {} of {}: ", i + 1, meshes);
    const int threads_inside = count_parallel_trials(body.points.size(), threads) > 1 ? 1 : threads;
    run_frozen_stages(body, data, settings, height, threads_inside, context.progress, label, warnings);

    // Trials of an interrupted run are not calculated again.
    const auto kept = context.folder / "frozen" / fmt::format("mesh_{}.json", i);
    KnownTrials known = context.resume ? load_trials(kept) : KnownTrials{};
    std::vector<TrialResult> done;
    for (const auto& [factor, trial] : known) done.push_back(trial);
    const auto report = [&](const TrialResult& t) {
      done.push_back(t);
      output::make_folder(kept.parent_path());
      output::write_atomically(kept, trials_to_json(done).dump(2) + "\n");
    };
    StageHooks<D> hooks;
    hooks.look = [&](const mpm::Body<D>& b, const StageState& s) {
      throw_if_interrupted();
      if (context.progress && context.progress->is_due()) {
        context.progress->show(fmt::format("{}frozen trials: {} done, {:.2f} s in this one, nodes at {:.2g} m/s", label,
                                           done.size(), b.time - s.start_time, b.monitor.speed));
      }
    };
    MeshFactor factor = find_frozen_factor(body, data, settings, height, threads, known, report, hooks);
    factor.size = ready_mesh ? mesh::measure_quality(body.mesh()).mean_size : data.mesh.size * std::pow(0.5, i);
    if (factor.undecided) {
      warnings.push_back(
          fmt::format("at h = {:g} m a trial neither rested nor ran away within {:g} s; it is counted as failed",
                      factor.size, settings.window));
    }
    result.meshes.push_back(std::move(factor));
  }
  if (result.meshes.size() == 2) {
    const MeshFactor &coarse = result.meshes[0], &fine = result.meshes[1];
    result.extrapolated = extrapolate_to_zero(coarse.size, coarse.factor(), fine.size, fine.factor());
    // The coarse mesh differs from the limit by twice as much as the fine one; far apart, a straight line is a guess.
    constexpr double far_apart = 0.1;
    if (std::abs(coarse.factor() - fine.factor()) > far_apart * fine.factor()) {
      warnings.push_back(fmt::format(
          "the factors of the two meshes differ by {:.0f} %: refine the mesh before trusting the extrapolated factor",
          100 * std::abs(coarse.factor() / fine.factor() - 1)));
    }
  }
  return result;
}

template <int D>
void reduce_strength(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads,
                     json& summary, std::vector<std::string>& warnings) {
  const model::Case& data = *context.data;
  const model::StrengthReduction& settings = data.strength_reduction;
  json& factors = summary["factor_of_safety"] = json::object();
  if (settings.curve.enabled) {
    const CurveResult curve = compute_curve(state, context, slope_height, threads);
    const std::vector<CurvePoint> points = curve.points();
    const auto bilinear = construct_bilinear(points, settings.curve.initial_branch, settings.curve.final_branch);
    std::vector<Criterion> criteria;
    if (bilinear)
      criteria.push_back(bilinear->criterion);
    else
      criteria.push_back({"bilinear", std::nullopt, 0, 0, "too few factors in the branches"});
    criteria.push_back(find_displacement_criterion(points, settings.curve.displacement_ratio * slope_height));
    if (criteria.back().factor)
      criteria.back().note = fmt::format("largest displacement reaches {:g} H, H = {:g} m",
                                         settings.curve.displacement_ratio, slope_height);
    criteria.push_back(find_jump_criterion(points, elastic_share * slope_height));
    summary["curve"] = describe_curve(curve, bilinear, criteria);
    factors["criteria"] = summary["curve"]["criteria"];
    std::string table = "srf,largest displacement [m],end,force ratio,nodal speed [m/s]\n";
    for (const TrialResult& t : curve.trials) {
      table += fmt::format("{},{},{},{},{}\n", output::to_shortest(t.factor), output::to_shortest(t.displacement),
                           to_json(t).at("end").get<std::string>(), output::to_shortest(t.force_ratio),
                           output::to_shortest(t.speed));
    }
    output::write_atomically(context.folder / "curve.csv", table);
    json runouts = json::array();
    for (const RunoutTrial& r : curve.runouts) {
      json j = to_json(r.trial);
      j["runout"] = to_json(r.runout);
      j["profile"] = to_json(r.final);
      runouts.push_back(std::move(j));
      if (r.trial.end != StageEnd::rest) {
        warnings.push_back(fmt::format("the runout at SRF {:g} was still moving after {:g} s; raise runout_time",
                                       r.factor, r.trial.time));
      }
    }
    if (!runouts.empty()) summary["runouts"] = runouts;
  }
  if (settings.frozen.enabled) {
    const FrozenResult frozen = compute_frozen_factor<D>(data, state.mesh(), context, threads, warnings);
    const auto [low, high] = find_dilatancy_range(data);
    factors["frozen"] = to_json(frozen, low, high);
    factors["value"] = frozen.factor();
    if (summary.contains("curve")) {
      Criterion c{"frozen", frozen.factor(), frozen.factor() - frozen.uncertainty(),
                  frozen.factor() + frozen.uncertainty(), "rest or run-away at frozen geometry"};
      summary["curve"]["criteria"].push_back(to_json(c));
    }
  }
}

template FrozenResult compute_frozen_factor<2>(const model::Case&, const mesh::Mesh<2>&, const TrialContext&, int,
                                               std::vector<std::string>&);
template FrozenResult compute_frozen_factor<3>(const model::Case&, const mesh::Mesh<3>&, const TrialContext&, int,
                                               std::vector<std::string>&);
template void reduce_strength<2>(const mpm::Body<2>&, const TrialContext&, double, int, json&,
                                 std::vector<std::string>&);
template void reduce_strength<3>(const mpm::Body<3>&, const TrialContext&, double, int, json&,
                                 std::vector<std::string>&);

}  // namespace talus::analysis
