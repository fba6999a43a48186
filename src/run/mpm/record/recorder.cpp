// SPDX-License-Identifier: MIT
#include "run/mpm/record/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/progress.hpp"
#include "base/units.hpp"
#include "input/case/support.hpp"
#include "mpm/solver/observe.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "run/mpm/record/frame.hpp"
#include "run/mpm/stage/stage.hpp"

namespace talus::run {
namespace {

constexpr int rows_per_leg = 200;

const char* const axes[] = {"x", "y", "z"};

template <int D>
std::vector<output::Column> list_columns(const input::Case& data, bool wet, bool has_front) {
  std::vector<output::Column> columns{{"time", "s"},
                                      {"step", "-"},
                                      {"time_step", "s"},
                                      {"kinetic_energy", "J"},
                                      {"potential_energy", "J"},
                                      {"elastic_energy", "J"},
                                      {"plastic_work", "J"},
                                      {"damping_work", "J"},
                                      {"wall_work", "J"},
                                      {"mapping_loss", "J"},
                                      {"external_work", "J"},
                                      {"force_ratio", "-"},
                                      {"nodal_speed", "m/s"},
                                      {"points", "-"},
                                      {"mass", "kg"}};
  for (int d = 0; d < D; ++d) columns.push_back({fmt::format("momentum_{}", axes[d]), "kg m/s"});
  for (int d = 0; d < D; ++d) columns.push_back({fmt::format("centre_{}", axes[d]), data.output.length_unit});
  columns.push_back({"largest_displacement", data.output.displacement_unit});
  if (has_front)
    for (const char* name : {"front_advance", "toe_distance"}) columns.push_back({name, data.output.length_unit});
  if (!data.supports.empty()) columns.push_back({"support_work", "J"});
  if (wet) columns.insert(columns.end(), {{"drag_work", "J"}, {"pore_water_work", "J"}});
  return columns;
}

bool is_stress(const material::StateField& field) {
  return std::string_view(field.unit) == "Pa";
}

template <int D>
std::vector<output::Column> list_monitor_columns(const input::Case& data, bool wet, const StateFields& states) {
  std::vector<output::Column> columns{{"time", "s"}};
  for (const input::Monitor& m : data.output.monitors) {
    const std::string name = output::make_cell(m.name);
    for (int d = 0; d < D; ++d)
      columns.push_back({fmt::format("{}.displacement_{}", name, axes[d]), data.output.displacement_unit});
    columns.push_back({name + ".displacement", data.output.displacement_unit});
    for (int d = 0; d < D; ++d) columns.push_back({fmt::format("{}.velocity_{}", name, axes[d]), "m/s"});
    columns.push_back({name + ".mean_stress", data.output.stress_unit});
    columns.push_back({name + ".deviatoric_stress", data.output.stress_unit});
    columns.push_back({name + ".deviatoric_strain", "-"});
    if (wet) {
      columns.push_back({name + ".pore_pressure", data.output.stress_unit});
      columns.push_back({name + ".saturation", "-"});
    }
    for (const material::StateField& f : states.list())
      columns.push_back({fmt::format("{}.{}", name, f.name), is_stress(f) ? data.output.stress_unit : f.unit});
  }
  return columns;
}

/// Wall-clock time between two checkpoints.
std::chrono::steady_clock::duration read_interval(const input::Case& data) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(data.output.checkpoint_interval));
}

/// Returns the point nearest to each monitor in the present configuration.
template <int D>
std::vector<int> find_monitor_points(const input::Case& data, const mpm::Body<D>& body) {
  std::vector<int> points;
  for (const input::Monitor& m : data.output.monitors) {
    int nearest = -1;
    double shortest = std::numeric_limits<double>::max();
    for (int id = 0; id < body.points.size(); ++id) {
      if (!mpm::is_present(body, id)) continue;
      double square = 0;
      for (std::size_t d = 0; d < D; ++d)
        square += (body.points.reference[id][d] - m.at[d]) * (body.points.reference[id][d] - m.at[d]);
      if (square < shortest) {
        shortest = square;
        nearest = id;
      }
    }
    points.push_back(nearest);
  }
  return points;
}

}  // namespace

template <int D>
Recorder<D>::Recorder(const RecorderSettings& settings, const mpm::Body<D>& body)
    : settings_(settings),
      states_(body.laws),
      monitor_points_(settings.monitor_points.empty() ? find_monitor_points(*settings.data, body)
                                                      : settings.monitor_points) {
  if (body.water.is_wet()) water_.emplace(*settings.data, body);
}

template <int D>
void Recorder<D>::open_histories(bool resumes) {
  const auto open = [&](const char* name, const std::vector<output::Column>& columns) {
    const auto path = settings_.folder / name;
    return resumes ? output::History::resume(path, columns) : output::History::start(path, columns);
  };
  if (!settings_.keeps_history) return;
  std::vector<output::Column> columns =
      list_columns<D>(*settings_.data, water_.has_value(), settings_.runout_start != nullptr);
  if (water_) {
    const auto more = water_->list_columns();
    columns.insert(columns.end(), more.begin(), more.end());
  }
  history_.emplace(open("history.csv", columns));
  if (!settings_.data->output.monitors.empty())
    monitors_.emplace(open("monitors.csv", list_monitor_columns<D>(*settings_.data, water_.has_value(), states_)));
}

template <int D>
Recorder<D> Recorder<D>::start(const RecorderSettings& settings, const mpm::Body<D>& body) {
  make_folder(settings.folder);
  Recorder r(settings, body);
  if (settings.keeps_frames) {
    output::remove_results(settings.folder);
    r.results_.emplace(output::ResultsWriter::start(settings.folder));
  }
  r.open_histories(false);
  return r;
}

template <int D>
Recorder<D> Recorder<D>::resume(const RecorderSettings& settings, const mpm::Body<D>& body,
                                const output::ArchiveReader& checkpoint) {
  Recorder r(settings, body);
  const auto& times = checkpoint.reals("recorder");
  r.next_frame_ = times[0];
  r.next_row_ = times[1];
  r.last_row_ = times[2];
  r.last_frame_ = times[3];
  r.monitor_points_ = checkpoint.integers("monitor_points");
  if (r.water_) r.water_->restore(checkpoint.reals("recorder_water"));
  // Output written after the checkpoint at exactly body.time is written again, hence last_frame_ and not body.time.
  if (settings.keeps_frames) r.results_.emplace(output::ResultsWriter::resume(settings.folder, r.last_frame_));
  r.open_histories(true);
  if (r.history_) r.history_->truncate_after(r.last_row_);
  if (r.monitors_) r.monitors_->truncate_after(r.last_row_);
  return r;
}

template <int D>
StageHooks<D> Recorder<D>::begin_leg(int index, const StagePlan<D>& plan, const mpm::Body<D>& body,
                                     const StageState& state) {
  leg_ = index;
  calmed_plan_ = make_retry_plan(plan, state.setbacks.size(), body.water.is_wet());
  plan_ = state.setbacks.empty() ? &plan : &calmed_plan_;
  const double wanted = settings_.data->output.history_interval;
  row_interval_ = wanted > 0 ? wanted : plan.duration / rows_per_leg;
  if (!state.started) next_row_ = next_frame_ = body.time;
  leg_start_ = std::chrono::steady_clock::now();
  leg_start_steps_ = state.steps;
  next_checkpoint_ = leg_start_ + read_interval(*settings_.data);
  StageHooks<D> hooks;
  hooks.output = [this](Pause<D>& now, StageState& s) { on_output(now, s); };
  hooks.look_is_due = [this] { return is_look_due(); };
  hooks.look = [this](const mpm::Body<D>& b, const StageState& s) { on_look(b, s); };
  hooks.report_is_due = [this] { return settings_.progress && settings_.progress->is_due(); };
  hooks.report = [this](const mpm::Body<D>& b, const StageState& s, double moved) { show_progress(b, s, moved); };
  hooks.mark = [this] { return mark(); };
  hooks.save_last_good = [this](const mpm::Body<D>& b, const StageState& s) {
    // --resume starts from this checkpoint, with a smaller Courant number for instance.
    write_checkpoint(b, s, leg_, settings_.checkpoint_name);
    write_frame(b);
    if (results_) results_->finish();
    return settings_.folder.string() + ", from where --resume continues";
  };
  return hooks;
}

template <int D>
void Recorder<D>::end_leg(const mpm::Body<D>& body, bool saves) {
  PauseHere<D> here(body);
  write_rows(here);
  write_frame(body);
  if (saves) {
    StageState fresh;
    fresh.gravity_share = 1;
    write_checkpoint(body, fresh, leg_ + 1, settings_.checkpoint_name);
  }
}

template <int D>
void Recorder<D>::finish(bool done) {
  if (results_) results_->finish();
  if (done) remove_file(settings_.folder / settings_.checkpoint_name);
}

template <int D>
void Recorder<D>::write_rows(Pause<D>& now) {
  const mpm::Body<D>& body = now.known();
  if (!history_ || body.time <= last_row_) return;
  last_row_ = body.time;
  const double length = units::get_si_factor(settings_.data->output.length_unit);
  const double displacement = units::get_si_factor(settings_.data->output.displacement_unit);
  const mpm::Observation<D> seen = now.observe(plan_->gravity, monitor_points_);
  const mpm::Totals<D>& t = seen.totals;
  const mpm::Work work = body.work - settings_.work_before;
  std::vector<double> row{body.time,
                          static_cast<double>(body.step_count),
                          body.step_count > 0 ? plan_->step.courant * now.find_critical_step(*plan_).dt : 0.0,
                          t.kinetic,
                          t.potential,
                          t.elastic,
                          work.dissipated,
                          work.damped,
                          work.walls,
                          work.mapping,
                          work.external,
                          find_force_ratio(body.monitor),
                          body.monitor.speed,
                          static_cast<double>(t.points),
                          t.mass};
  for (const double p : t.momentum) row.push_back(p);
  for (const double x : t.centre) row.push_back(x / length);
  row.push_back(seen.largest_displacement / displacement);
  if (settings_.runout_start != nullptr) {
    const results::Runout runout = find_runout(now.whole(), *settings_.runout_start);
    row.insert(row.end(), {runout.front_advance / length, runout.toe_distance / length});
  }
  if (!settings_.data->supports.empty()) row.push_back(work.supports);
  if (water_) {
    row.insert(row.end(), {work.drag, work.pore_water});
    water_->append(body, seen.water, row);
  }
  history_->append(row);
  if (monitors_) write_monitors(body, seen.points);
}

template <int D>
void Recorder<D>::write_monitors(const mpm::Body<D>& body, const std::vector<mpm::PointView<D>>& points) {
  const double displacement = units::get_si_factor(settings_.data->output.displacement_unit);
  const double stress = units::get_si_factor(settings_.data->output.stress_unit);
  std::vector<double> row{body.time};
  for (const mpm::PointView<D>& p : points) {
    if (p.element < 0) {
      row.insert(row.end(), 2 * D + (water_ ? 6 : 4) + states_.list().size(), std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    constexpr int NS = material::stress_size<D>;
    for (const double u : p.displacement) row.push_back(u / displacement);
    row.push_back(norm(p.displacement) / displacement);
    for (const double v : p.velocity) row.push_back(v);
    const Invariants s = find_stress_invariants<NS>(p.stress);
    row.push_back(s.mean / stress);
    row.push_back(s.deviatoric / stress);
    row.push_back(find_strain_invariants<NS>(p.strain).deviatoric);
    if (water_) {
      row.push_back(p.wet ? -p.pressure / stress : 0.0);
      row.push_back(p.saturation);
    }
    const std::vector<double> state = states_.read(body, p);
    for (std::size_t k = 0; k < state.size(); ++k)
      row.push_back(is_stress(states_.list()[k]) ? state[k] / stress : state[k]);
  }
  monitors_->append(row);
}

template <int D>
void Recorder<D>::write_frame(const mpm::Body<D>& body) {
  if (!results_ || body.time <= last_frame_) return;
  last_frame_ = body.time;
  results_->write(make_frame(body, plan_->name, settings_.data->output.cells, settings_.data->output.nodes));
}

template <int D>
void Recorder<D>::write_checkpoint(const mpm::Body<D>& body, const StageState& state, int leg,
                                   const std::string& name) const {
  output::ArchiveWriter archive;
  archive.put("input_hash", settings_.input_hash);
  const std::vector<int> legs{leg};
  archive.put("leg", legs);
  const std::vector<double> times{next_frame_, next_row_, last_row_, last_frame_};
  archive.put("monitor_points", monitor_points_);
  archive.put("recorder", times);
  if (water_) archive.put("recorder_water", water_->save());
  put_mesh(archive, body.mesh());
  put_body(archive, body);
  put_stage(archive, state);
  make_folder(settings_.folder);
  if (history_) history_->keep();
  if (monitors_) monitors_->keep();
  archive.write(settings_.folder / name);
}

/// Returns a function that drops rows and frames written after this call, and overwrites the checkpoint with the
/// present state.
template <int D>
GoBack<D> Recorder<D>::mark() {
  const std::vector<double> water = water_ ? water_->save() : std::vector<double>();
  return [this, water, frame = next_frame_, row = next_row_, last_row = last_row_, last_frame = last_frame_](
             const mpm::Body<D>& body, const StageState& state, const StagePlan<D>& plan) {
    next_frame_ = frame;
    next_row_ = row;
    last_row_ = last_row;
    last_frame_ = last_frame;
    if (water_) water_->restore(water);
    if (results_) results_.emplace(output::ResultsWriter::resume(settings_.folder, last_frame));
    if (history_) history_->truncate_after(last_row);
    if (monitors_) monitors_->truncate_after(last_row);
    calmed_plan_ = plan;
    plan_ = &calmed_plan_;
    write_checkpoint(body, state, leg_, settings_.checkpoint_name);
  };
}

template <int D>
void Recorder<D>::on_output(Pause<D>& now, StageState& state) {
  const double time = now.known().time;
  constexpr double never = std::numeric_limits<double>::infinity();
  if (history_ && time >= next_row_) {
    write_rows(now);
    next_row_ += row_interval_;
    if (next_row_ <= time) next_row_ = time + row_interval_;
  }
  const bool frames = results_ && settings_.frame_interval > 0;
  if (frames && time >= next_frame_) {
    write_frame(now.whole());
    next_frame_ += settings_.frame_interval;
    if (next_frame_ <= time) next_frame_ = time + settings_.frame_interval;
  }
  state.next_output = std::min(history_ ? next_row_ : never, frames ? next_frame_ : never);
}

template <int D>
bool Recorder<D>::is_look_due() const {
  return is_interrupted() || std::chrono::steady_clock::now() >= next_checkpoint_;
}

template <int D>
void Recorder<D>::on_look(const mpm::Body<D>& body, const StageState& state) {
  write_checkpoint(body, state, leg_, settings_.checkpoint_name);
  next_checkpoint_ = std::chrono::steady_clock::now() + read_interval(*settings_.data);
  if (!is_interrupted()) return;
  if (results_ && results_->frame_count() > 0) results_->finish();
  throw Error(ExitCode::interrupted,
              fmt::format("interrupted in '{}' at t = {:.4g} s; the state is saved, --resume continues from there",
                          plan_->name, body.time));
}

template <int D>
void Recorder<D>::show_progress(const mpm::Body<D>& body, const StageState& state, double moved) {
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - leg_start_).count();
  const double speed = elapsed > 0 ? static_cast<double>(state.steps - leg_start_steps_) / elapsed : 0;
  const double left = plan_->duration - (body.time - state.start_time);
  const std::string remaining = speed > 0 && state.dt > 0 ? format_duration(left / state.dt / speed) : "?";
  const double displacement = units::get_si_factor(settings_.data->output.displacement_unit);
  const double time = body.time - state.start_time;
  settings_.progress->show(
      {fmt::format("{}{}: {:.3f} of {}{:g} s, {:.0f} steps/s, {} left, u_max {:.4g} {}, E_kin {:.3g} J",
                   settings_.label, plan_->name, time, plan_->until_rest ? "at most " : "", plan_->duration, speed,
                   remaining, moved / displacement, settings_.data->output.displacement_unit,
                   body.monitor.kinetic_energy),
       settings_.label,
       plan_->name,
       time,
       plan_->duration,
       {.method = "mpm", .displacement = moved}});
}

template <int D>
RecordedRun<D> begin_recording(const RecorderSettings& settings, mpm::Body<D>& body,
                               const output::ArchiveReader* checkpoint) {
  if (checkpoint == nullptr) return {Recorder<D>::start(settings, body), {}, 0};
  get_body(*checkpoint, body);
  return {Recorder<D>::resume(settings, body, *checkpoint), get_stage(*checkpoint), get_leg(*checkpoint)};
}

template RecordedRun<2> begin_recording<2>(const RecorderSettings&, mpm::Body<2>&, const output::ArchiveReader*);
template RecordedRun<3> begin_recording<3>(const RecorderSettings&, mpm::Body<3>&, const output::ArchiveReader*);
template class Recorder<2>;
template class Recorder<3>;

}  // namespace talus::run
