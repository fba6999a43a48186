// SPDX-License-Identifier: MIT
#include "run/case_results.hpp"

#include "results/governing.hpp"
#include "results/json.hpp"
#include "results/named.hpp"
#include "results/present.hpp"
#include "run/check_case.hpp"
#include "run/common/head.hpp"
#include "run/common/section_of_case.hpp"
#include "run/compare/compare.hpp"
#include "run/fem/solid_of_case.hpp"
#include "site/design_values.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;

/// Compares FEM with ψ = φ with limit analysis, if both have the same strength and tensile strength.
void judge_elements(const input::Case& data, results::RunResult& run) {
  if (!run.elements || !run.bounds || !run.bounds->is_interval() || run.bounds->is_davis ||
      find_judging_obstacle(data) || data.bounds.tension != input::BoundsTension::as_given || softens_in_trials(data))
    return;
  results::Referee referee;
  referee.lower = run.bounds->lower, referee.upper = run.bounds->upper;
  for (results::ElementRun& r : run.elements->runs)
    if (r.flow == results::Flow::associated || !is_nonassociated(data)) r.verdict = referee.judge(r.factor);
}

/// Writes water.json, the fields of the initial water of the methods, and timeline_water.json, those in time.
template <int D>
void keep_water(const fs::path& folder, const CaseMethods<D>& m) {
  const results::WaterFields* fields = m.points ? m.points->water_fields() : nullptr;
  if (fields == nullptr && m.slices) fields = m.slices->water_fields();
  if (fields == nullptr && m.elements) fields = m.elements->water_fields();
  if (fields == nullptr && m.bounds) fields = m.bounds->water_fields();
  if (fields == nullptr && m.seepage) fields = m.seepage->water_fields();
  if (fields != nullptr) results::write_file(folder / "water.json", *fields, -1);
  if (const results::WaterFields* in_time = m.timeline ? m.timeline->water_fields() : nullptr)
    results::write_file(folder / "timeline_water.json", *in_time, -1);
}

/// Lists the times of a run without MPM [s].
std::vector<results::TimedPart> list_parts(const results::RunResult& run) {
  std::vector<results::TimedPart> parts;
  if (run.slices) parts.push_back({"lem", "limit equilibrium", run.slices->seconds});
  if (run.elements) parts.push_back({"fem", "FEM", run.elements->seconds.value_or(0)});
  if (run.bounds) parts.push_back({"bounds", "limit analysis", run.bounds->seconds.value_or(0)});
  if (run.flow) parts.push_back({"seepage", "seepage", run.flow->seconds.value_or(0)});
  return parts;
}

/// MPM or seepage alone, with the values of the case, has no other method to be compared with.
template <int D>
void compare(const CaseContext& context, const CaseMethods<D>& m, results::RunResult& run) {
  const site::DesignValues& design = context.design;
  const RunOptions& options = context.options;
  if (!m.slices && !m.elements && !m.bounds && !design.statement) return;
  run.methods =
      compare_methods(design.data, m.slices ? m.slices->slope() : nullptr, run, options.folder, options.threads);
  run.warnings.insert(run.warnings.begin(), run.methods->warnings.begin(), run.methods->warnings.end());
  run.methods->partial_factors = design.statement;
  if (const auto factor = results::find_main_factor(run); factor && design.statement)
    site::state_over_design(*run.methods->partial_factors, design.resistance, *factor);
}

/// States first that two factors lie too far apart to be used.
void state_disagreement(results::RunResult& run) {
  if (auto disagreement = results::find_disagreement(run))
    run.warnings.insert(run.warnings.begin(), std::move(disagreement->text));
}

/// Adds the results of the methods other than MPM; `all`: also of those that have none yet.
template <int D>
void add_methods(const input::Case& data, const CaseMethods<D>& m, bool all, results::RunResult& run) {
  if (m.slices) m.slices->write_result(run);
  if (m.elements) m.elements->write_result(run);
  if (m.bounds && (all || m.bounds->has_result())) m.bounds->write_result(run);
  if (m.seepage && (all || m.seepage->has_states())) m.seepage->write_result(run);
  judge_elements(data, run);
  if (m.construction) m.construction->write_result(run);
}

}  // namespace

template <int D>
void write_present_results(const CaseContext& context, const CaseMethods<D>& m, results::RunResult run) {
  add_methods(context.design.data, m, false, run);
  if (m.timeline) m.timeline->write_result(run);
  if (run.construction && run.construction->stages.empty()) run.construction.reset();
  if (run.timeline && run.timeline->factors.empty()) run.timeline.reset();
  keep_water(context.options.folder, m);
  compare(context, m, run);
  state_disagreement(run);
  run.results = list_results(context.loaded.data, run);
  results::write_file(context.options.folder / results::present_summary_file, run);
}

template <int D>
void write_case_results(const CaseContext& context, CaseMethods<D>& m, Releases<D>& releases, const RunStart& start,
                        bool has_points, results::RunResult& run) {
  const input::Case& data = context.design.data;
  if (m.points) m.points->finish(run);
  run.warnings.insert(run.warnings.end(), m.point_notes.begin(), m.point_notes.end());
  for (const Diagnostic& warning : context.loaded.warnings) run.warnings.push_back(warning.sentence);
  for (std::string& sentence : list_ground_warnings(data)) run.warnings.push_back(std::move(sentence));
  results::Timing& timing = run.timing.emplace();
  timing.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start.wall).count();
  if (m.points) {
    timing.cpu = find_process_seconds() - start.cpu;
    timing.stage_steps = m.points->get_stage_seconds();
    timing.parts = m.points->list_parts(*timing.cpu);
  }
  add_methods(data, m, true, run);
  if (m.timeline) {
    releases.add_results(run, has_points);
    m.timeline->write_result(run);
  }
  if (!m.points) timing.parts = list_parts(run);
  keep_water(context.options.folder, m);
  compare(context, m, run);
  state_disagreement(run);
  run.results = list_results(context.loaded.data, run);
  run.comparisons = compare_results(context.loaded.data, run);
  results::write_file(context.options.folder / summary_file, run);
  remove_present(context.options);
  if (run.status != results::Status::finished) return;
  if (m.points) m.points->forget();
  if (m.timeline) m.timeline->forget();
  if (m.construction) m.construction->forget();
  if (m.seepage) m.seepage->forget();
}

template void write_present_results<2>(const CaseContext&, const CaseMethods<2>&, results::RunResult);
template void write_present_results<3>(const CaseContext&, const CaseMethods<3>&, results::RunResult);
template void write_case_results<2>(const CaseContext&, CaseMethods<2>&, Releases<2>&, const RunStart&, bool,
                                    results::RunResult&);
template void write_case_results<3>(const CaseContext&, CaseMethods<3>&, Releases<3>&, const RunStart&, bool,
                                    results::RunResult&);

}  // namespace talus::run
