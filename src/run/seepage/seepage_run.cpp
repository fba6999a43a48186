// SPDX-License-Identifier: MIT
#include "run/seepage/seepage_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.hpp"
#include "base/units.hpp"
#include "results/flow_restart.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/initial_water.hpp"
#include "site/season.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {

namespace {

constexpr const char *seepage_file = "seepage.json", *water_file = "seepage_state.json";
/// Imbalance of the water over the flow, above which a state has a warning.
constexpr double largest_error = 1e-3;

}  // namespace

template <int D>
SeepageRun<D>::SeepageRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash)
    : MethodRun("seepage", seepage_file, alone, options, std::move(input_hash)),
      site_(site::close_sides(site.data())) {}

template <int D>
void SeepageRun<D>::prepare() {
  try_part([&] {
    const input::Case& data = site_.data();
    show("mesh");
    mesh_ = generate_for_seepage<D>(site_);
    model_ = site::make_seepage_model<D>(data, mesh_, wet_mesh_);
    if (!data.seepage.times.empty()) fem::check_storage(model_);
    measures_.emplace(site_, mesh_, model_);
    clear_progress();
    restore();
  });
}

/// Takes the flow that an interrupted run has computed, if both of its files are there.
template <int D>
void SeepageRun<D>::restore() {
  if (!options_.resume) return;
  auto known = results::find_file<results::FlowRestart>(options_.folder / water_file);
  if (!known || known->input_hash != hash_ || !read_kept()) return;
  water_ = {std::move(known->seepage), std::move(known->season), std::move(known->states), std::move(known->fields)};
  is_known_ = true;
}

template <int D>
void SeepageRun<D>::keep() const {
  const results::FlowRestart restart{hash_, water_.seepage, water_.season, water_.states, water_.fields};
  results::write_file(options_.folder / water_file, restart, -1);
  write_kept();  // last: with it the flow counts as computed
}

template <int D>
void SeepageRun<D>::forget() const {
  remove_file(options_.folder / water_file);
}

template <int D>
void SeepageRun<D>::add_state(const fem::SeepageResult<D>& state, results::WaterFlow flow, double time) {
  file_.summary.states.push_back(measures_->measure(state, time));
  const double through = std::max(state.inflow, state.outflow);
  if (std::abs(state.balance_error) > largest_error * through)
    file_.summary.warnings.push_back(fmt::format("the water balance has an error of {:.1g} of the flow at {:g} s",
                                                 std::abs(state.balance_error) / through, time));
  if (time == 0 && flow == results::WaterFlow::steady) return;  // among the results of the initial water
  water_.states->push_back(site::make_state_result<D>(site_, state, flow, time));
  if constexpr (D == 2)
    if (water_.fields) water_.fields->states.push_back(site::make_field_result<2>(wet_mesh_, state, flow, time));
}

/// Follows the flow from the initial pore pressure.
template <int D>
void SeepageRun<D>::follow() {
  const input::Case& data = site_.data();
  const site::InitialWater<D> initial = site::find_initial_water<D>(data, mesh_);
  water_ = site::make_water_result<D>(site_, mesh_, initial.seepage, initial.season);
  if (!water_.states) water_.states.emplace();
  if constexpr (D == 2)
    if (!initial.seepage && !initial.season) {  // water at rest has triangles of its own
      water_.states->clear();
      water_.fields = site::begin_fields(data, wet_mesh_);
    }
  if (initial.seepage && !initial.season) add_state(*initial.seepage, results::WaterFlow::steady, 0);
  if (data.seepage.times.empty()) return;
  std::vector<double> heads = initial.nodal.empty() ? site::find_nodal_pressure<D>(data, mesh_) : initial.nodal;
  for (std::size_t i = 0; i < heads.size(); ++i) heads[i] = mesh_.nodes[i][1] - heads[i] / model_.unit_weight;
  fem::SeepageSchedule schedule;
  schedule.outputs = data.seepage.times;
  schedule.head_tolerance = site::head_tolerance;
  const double end = schedule.outputs.back();
  schedule.report = [&](double time) {
    if (!options_.progress || !options_.progress->is_due()) return;
    options_.progress->show(
        {fmt::format("{}: flow at {} of {}", title_, units::format_time(time), units::format_time(end)),
         {},
         title_,
         time,
         end,
         {.method = "seepage"}});
  };
  const site::FlowInTime<D> flow =
      site::follow_flow<D>(data, model_, heads, schedule, "[seepage] times", [&](const fem::SeepageResult<D>& state) {
        add_state(state, results::WaterFlow::transient, state.time);
        options_.store();
      });
  file_.summary.step_error = flow.history.largest_error;
}

template <int D>
void SeepageRun<D>::calculate() {
  if (!measures_ || is_known_) return;
  const bool is_found = try_part([&] {
    show("flow");
    file_.summary.warnings = measures_->notes();
    follow();
    add_warnings_of_state();
  });
  if (!is_found) return measures_.reset();
  file_.input_hash = hash_;
  file_.summary.elements = mesh_.element_count();
  file_.summary.seconds = spent_.count();
  keep();
  clear_progress();
}

/// Adds warnings of factors below 1 and of gradients that depend on the mesh.
template <int D>
void SeepageRun<D>::add_warnings_of_state() {
  results::FlowResult& flow = file_.summary;
  const ShownUnit& length = site_.data().units().length;
  const auto place = [&](const std::vector<double>& at) {
    return fmt::format("x = {}, y = {}", format_coordinate(at[0], length), format_coordinate(at[1], length));
  };
  if (flow.states.empty()) return;
  std::vector<std::string> named;
  for (const results::FlowState& state : flow.states)
    for (const results::ExitGradient& exit : state.exits) {
      if (std::find(named.begin(), named.end(), exit.name) != named.end()) continue;
      named.push_back(exit.name);
      const results::ExitGradient* found = results::find_worst_exit(flow, exit.name).found;
      if (found == nullptr) continue;
      const results::ExitGradient& worst = *found;
      if (worst.grows)
        flow.warnings.push_back(
            fmt::format("the exit gradient at '{}' rises steeply towards {}, as beside a corner of an impermeable "
                        "body, where it is infinite in theory: its value depends on the size of the elements",
                        worst.name, place(worst.at)));
      if (worst.factor && *worst.factor < 1)
        flow.warnings.push_back(fmt::format("the soil boils at '{}', {}: the exit gradient {:.3g} exceeds {:.3g}",
                                            worst.name, place(worst.at), worst.gradient, *worst.critical));
    }
  if (const auto worst = results::find_worst_uplift(flow); worst.found != nullptr && worst.found->factor < 1)
    flow.warnings.push_back(fmt::format("layer '{}' floats at {}: factor {:.3g} against uplift", worst.found->layer,
                                        place(worst.found->at), worst.found->factor));
  for (const results::Heave& heave : flow.states.front().heaves)
    if (const auto worst = results::find_worst_heave(flow, heave.name);
        worst.found != nullptr && *worst.found->factor < 1)
      flow.warnings.push_back(fmt::format("block '{}' heaves: factor {:.3g}", heave.name, *worst.found->factor));
}

template <int D>
void SeepageRun<D>::write_result(results::RunResult& run) const {
  run.flow = file_.summary;
  add_warnings(run);
  site::give(water_, run);
}

template class SeepageRun<2>;
template class SeepageRun<3>;

}  // namespace talus::run
