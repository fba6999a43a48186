// SPDX-License-Identifier: MIT
#include "run/digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "lem/surface/surface.hpp"
#include "results/governing.hpp"
#include "results/interval.hpp"
#include "results/supports.hpp"

namespace talus::run {
namespace {

/// Pads to `width` characters; a letter outside ASCII counts once.
std::string pad(const std::string& text, std::size_t width) {
  const auto length = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  return text + std::string(length < width ? width - length : 1, ' ');
}

/// " [1.391, 1.426]", rounded outward; empty without an interval.
std::string write_interval(const std::optional<results::ElementInterval>& interval) {
  if (!interval) return "";
  return fmt::format(" [{:.3f}, {:.3f}]", results::show_lower(interval->lower), results::show_upper(interval->upper));
}

/// Formats the check of a design set, in which the factor of safety over γ_R is compared with 1.
std::string write_design_check(const results::RunResult& run) {
  if (!run.methods || !run.methods->partial_factors || !run.methods->partial_factors->over_design) return "";
  const results::DesignStatement& design = *run.methods->partial_factors;
  const bool has_resistance =
      std::any_of(design.values.begin(), design.values.end(),
                  [](const results::PartialFactor& v) { return v.key == "resistance" && v.value != 1.0; });
  return fmt::format("Check with {}: {} = {:.3f}, {}\n", design.set, has_resistance ? "F/γ_R" : "F",
                     results::show_lower(*design.over_design + 1e-9),
                     *design.over_design < 1 ? "below 1: the slope is NOT verified" : "at least 1: verified");
}

/// Formats the governing factor with its method and surface.
std::string write_main_factor(const results::RunResult& run) {
  const std::optional<double> factor = results::find_main_factor(run);
  if (factor && run.construction)
    return fmt::format("Factor of safety {:.3f} (the least at the ends of the stages, '{}')\n", *factor,
                       *run.construction->least_stage);
  const auto surface = results::find_governing_surface(run);
  if (!factor || !run.methods) return "";
  // The governing number of limit analysis is one end of an interval.
  if (run.slices && run.slices->referee && run.slices->referee->is_interval() && !surface &&
      results::find_slices_factor(run) == factor)
    return fmt::format("Factor of safety at least {:.3f}, at most {:.3f} (limit analysis; {})\n",
                       results::show_lower(*run.slices->referee->lower),
                       results::show_upper(*run.slices->referee->upper), results::describe_ruled_out(run));
  if (const auto end = results::find_proven_end(run))
    return *end == results::ProvenEnd::lower
               ? fmt::format("Factor of safety at least {:.3f} (lower bound)\n", results::show_lower(*factor))
               : fmt::format("Factor of safety at most {:.3f} (upper bound)\n", results::show_upper(*factor));
  if (run.timeline && run.timeline->least == factor)
    return fmt::format("Factor of safety {:.3f} (LEM, the least in time, at {})\n", *factor,
                       results::format_moment(*run.timeline, *run.timeline->least_time));
  const results::TimedReduction* later = run.timeline ? results::find_least_reduction(*run.timeline) : nullptr;
  if (later != nullptr && later->runs.front().factor == factor)
    return fmt::format("Factor of safety {:.3f}{} (FEM, at {})\n", *factor,
                       write_interval(later->runs.front().interval),
                       results::format_moment(*run.timeline, later->time));
  const bool by_slices = surface && surface->found->surface.factor == factor;
  const bool is_drawn = by_slices && run.slices->drawdown.has_value();
  const results::ElementRun* elements = results::find_governing_elements(run);
  const bool by_elements = !by_slices && elements != nullptr && elements->factor == factor;
  if (const auto far = results::find_far_extrapolation(run))
    return fmt::format(
        "Factor of safety between {:.3f} and {:.3f} (FEM; {:.3f} is extrapolated by {:.0f} % from elements of {}: "
        "refine "
        "[fem] size)\n",
        results::show_lower(far->lower), results::show_upper(far->upper), *factor, 100 * far->fraction,
        format_value(far->size, read_units(run).length, 3));
  return fmt::format(
      "Factor of safety {}{:.3f}{} ({})\n", is_drawn ? "after drawdown " : "", *factor,
      by_elements ? write_interval(elements->interval) : "",
      by_slices ? fmt::format("{}, {}", surface->found->surface.title, results::name_surface(*surface, read_units(run)))
      : by_elements ? "FEM"
                    : "MPM");
}

/// Formats the stages of rapid drawdown before the governing one, on the same slip surface.
std::string write_drawdown(const results::RunResult& run) {
  const auto surface = results::find_governing_surface(run);
  if (!surface || !surface->found->drawdown || !run.slices->drawdown) return "";
  const results::DrawnSurface& drawn = *surface->found->drawdown;
  std::string text = fmt::format("  {}; the same surface before drawdown: {}", get_title(*run.slices->drawdown),
                                 drawn.factor_before ? fmt::format("{:.3f}", *drawn.factor_before) : "none");
  if (drawn.undrained_factor) text += fmt::format(", by the second stage: {:.3f}", *drawn.undrained_factor);
  return text + "\n";
}

/// Formats the convention of the supports and the forces of those that the governing surface crosses.
std::string write_supports(const results::RunResult& run) {
  if (!run.slices) return "";
  const std::string sense = results::describe_support_sense(*run.slices);
  if (sense.empty()) return "";
  std::string text = fmt::format("  with {}\n", sense);
  const auto surface = results::find_governing_surface(run);
  if (!surface || !surface->found->supports) return text;
  const ShownUnits units = read_units(run);
  for (const results::SupportForce& f : *surface->found->supports)
    text += fmt::format("  {} row {}: crossed {} from its head, force {:.4g} kN/m of {:.4g} kN/m, {}{}\n", f.support,
                        f.row, format_value(f.distance, units.length, 3), f.force / 1e3, f.resistance / 1e3,
                        results::get_title(f.limit),
                        f.required ? fmt::format("; {:.4g} kN/m required", *f.required / 1e3) : "");
  return text;
}

/// "1.441"; "1.432–1.446" for the interval of limit analysis; "none".
std::string write_factor(const results::MethodRow& row) {
  if (row.factor) return fmt::format("{:6.3f}", *row.factor);
  if (row.method != Method::bounds) return "  none";
  const double lower = results::show_lower(row.lower.value_or(0)), upper = results::show_upper(row.upper.value_or(0));
  if (row.lower && row.upper) return fmt::format(" {:.3f}–{:.3f}", lower, upper);
  if (row.lower) return fmt::format("≥ {:.3f}", lower);
  return row.upper ? fmt::format("≤ {:.3f}", upper) : "  none";
}

/// Formats the factors of all methods as a table, and the sentences on their differences.
std::string write_method_table(const results::MethodComparison& methods) {
  if (methods.table.empty()) return "";
  constexpr std::size_t method_width = 30, criterion_width = 52;
  std::string text = "  " + pad("Method", method_width) + pad("Criterion", criterion_width) + "Factor   Seconds\n";
  for (const results::MethodRow& row : methods.table) {
    text += "  " + pad(row.title, method_width) + pad(row.criterion, criterion_width) + write_factor(row);
    if (row.method == Method::fem && row.lower && row.upper)
      text += write_interval(results::ElementInterval{*row.lower, *row.upper});
    if (row.seconds) text += fmt::format("  {:8.3g}", *row.seconds);
    text += '\n';
  }
  for (const results::Remark& remark : methods.remarks) text += remark.text + "\n";
  if (methods.partial_factors) text += methods.partial_factors->text + "\n";
  return text;
}

/// Formats the given surfaces without a factor, with their reasons and the methods that share each.
std::string write_rejected(const results::RunResult& run) {
  if (!run.slices) return "";
  std::vector<std::array<std::string, 3>> rows;  // surface, reason, methods
  for (const results::CriticalSurface& c : run.slices->given) {
    // Bishop's method rejects no polyline: it is not made for them.
    if (c.surface.factor || c.checks.refusal == lem::name_refusal(lem::Refusal::moment_axis)) continue;
    const auto explained = std::find_if(c.warnings.begin(), c.warnings.end(),
                                        [&](const std::string& w) { return w.starts_with(c.checks.refusal); });
    const std::string& reason = explained == c.warnings.end() ? c.checks.refusal : *explained;
    const std::string name = c.surface.name.value_or("");
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const auto& other) { return other[0] == name && other[1] == reason; });
    if (row == rows.end())
      rows.push_back({name, reason, c.surface.title});
    else
      (*row)[2] += ", " + c.surface.title;
  }
  std::string text;
  for (const auto& [name, reason, methods] : rows)
    text += fmt::format("  Given surface '{}' is rejected: {} ({})\n", name, reason, methods);
  return text;
}

/// Formats lengths, volumes and suctions in the units of the case: cubic feet with lengths in feet or inches.
class Units {
 public:
  explicit Units(const results::RunResult& run)
      : units_(read_units(run)), volume_(units_.volume(run.mesh && run.mesh->dimension == 3 ? 3 : 2)) {}

  std::string write_length(double metres, int digits = 3) const { return format_value(metres, units_.length, digits); }
  std::string write_length(const results::Estimate& estimate) const {
    return results::format_estimate(estimate, units_.length);
  }
  std::string write_level(double y) const { return format_coordinate(y, units_.length); }
  std::string write_displacement(double metres) const { return format_value(metres, units_.displacement, 3); }
  std::string write_stress(double pascals) const { return format_value(pascals, units_.stress, 3); }
  /// In plane strain the volume is per metre or foot of the slope.
  std::string write_volume(const results::Estimate& volume) const { return results::format_estimate(volume, volume_); }
  const std::string& volume_name() const { return volume_.name; }
  std::string flow_name() const {
    const std::string& foot = units_.span.name;
    return foot + "³/s" + (volume_.name == foot + "³" ? "" : " per " + foot);
  }
  double volume_unit() const { return volume_.si; }
  const ShownUnits& all() const { return units_; }

 private:
  ShownUnits units_;
  ShownUnit volume_;
};

std::string write_factors(const results::PointFactors& factors, const Units& in) {
  std::string text;
  if (factors.frozen) {
    const results::FrozenFactor& f = *factors.frozen;
    text += f.factor ? fmt::format("Factor of safety {:.3f}", *f.factor) : "Factor of safety: none, " + f.note;
    // Intervals are rounded outward, so that the printed one is not narrower than the computed one.
    if (f.uncertainty) text += fmt::format(" ± {:.2f}", std::ceil(100 * *f.uncertainty - 1e-9) / 100);
    if (!f.factor) {
      text += " (at frozen geometry)";
    } else if (f.extrapolated) {
      text += " (";
      for (const results::MeshFactor* m : f.list_found())
        text += fmt::format("{:.3f} at h = {}, ", *m->factor(), in.write_length(m->size, 6));
      text += fmt::format("extrapolated to h = 0; brackets ± {:.3f}{})", f.bracket,
                          f.mesh_effect ? fmt::format(", mesh ± {:.3f}", *f.mesh_effect) : "");
    } else {
      text += " (one mesh, not extrapolated: the mesh error is not known)";
    }
    text += fmt::format(", dilatancy angle {:.3g}°\n", f.dilatancy_angle_max);
  }
  if (!factors.criteria) return text;
  for (const results::Criterion& c : *factors.criteria) {
    const char* name = results::to_word(c.kind);
    if (c.factor)
      text += fmt::format("  by the {} criterion on moving geometry: {:.3f} [{:g}, {:g}]\n", name, *c.factor,
                          c.lower.value_or(*c.factor), c.upper.value_or(*c.factor));
    else
      text += fmt::format("  by the {} criterion: none ({})\n", name, c.note);
  }
  return text;
}

/// "front advances 1.3 ± 0.4 m"; "advance of the front not determined (two meshes: …)".
std::string write_estimate(const char* verb, const char* noun, const results::Estimate& estimate, const Units& in) {
  return fmt::format("{} {}", estimate.is_determined() ? verb : noun, in.write_length(estimate));
}

std::string write_side(const results::RunoutSide& side, const results::RunoutEstimates& about, const Units& in) {
  const bool is_behind = about.toe_distance.is_determined() && side.toe_distance <= 0;
  return fmt::format("{} and {}{}, {}",
                     write_estimate("front advances", "advance of the front", about.front_advance, in),
                     is_behind ? "stays behind the toe"
                               : write_estimate("passes the toe by", "distance beyond the toe", about.toe_distance, in),
                     side.limits && side.limits->front ? " (limited by the end of the box)" : "",
                     write_estimate("crest retreats", "retreat of the crest", about.crest_retreat, in));
}

/// "100 ± 9 m³/m move, 40 ± 3 m³/m lie over the old ground".
std::string write_volumes(const results::RunoutEstimates& about, const Units& in) {
  const auto write = [&](const results::Estimate& volume, const char* verb, const char* noun) {
    return volume.is_determined() ? fmt::format("{} {}", in.write_volume(volume), verb)
                                  : fmt::format("{} {}", noun, in.write_volume(volume));
  };
  std::string text = write(about.moved_volume, "move", "moved volume");
  if (about.deposit_volume.is_determined() && about.deposit_volume.value <= 0) return text;
  return text + ", " + write(about.deposit_volume, "lie over the old ground", "volume over the old ground");
}

std::string write_runout(const results::Runout& r, const std::string& name, const std::string& end, const Units& in) {
  const results::RunoutEstimates about(r);
  const std::string largest = "largest displacement " + in.write_length(r.largest_displacement),
                    moved = write_volumes(about, in) + end;
  if (r.moved_volume <= 0)
    return fmt::format("{}: no soil moves more than {}; {}{}\n", name, in.write_length(r.threshold), largest, end);
  if (!r.sides) return fmt::format("{}: {}, {}, {}\n", name, write_side(r, about, in), largest, moved);
  std::string text = fmt::format("{} to both sides: {}, {}\n", name, largest, moved);
  for (const results::RunoutSide& side : *r.sides) {
    const results::RunoutEstimates own(side);  // two meshes have only the sum of both sides
    text += fmt::format("  {}: {}, {}\n", results::name_side(side.direction),
                        write_side(side, r.coarser_mesh && side.direction == r.direction ? about : own, in),
                        write_volumes(own, in));
  }
  return text;
}

std::string write_runouts(const results::RunResult& run, const Units& in) {
  std::string text;
  if (run.runouts)
    for (const results::RunoutTrial& r : *run.runouts)
      text +=
          write_runout(r.runout, fmt::format("Runout at SRF {:g}", r.trial.factor),
                       fmt::format(", {} after {:.3g} s",
                                   r.trial.end == results::StageEnd::rest ? "at rest" : "still moving", r.trial.time),
                       in);
  if (run.runout) text += write_runout(*run.runout, "Runout", "", in);
  if (run.motion) text += run.motion->sentence + "\n";
  return text;
}

/// Formats the outflow by boundary in the initial state of the methods, and the depth of standing water.
std::string write_state(const results::WaterState& state, const Units& in) {
  std::string text;
  const double least = 1e-6 * std::max(state.inflow, state.outflow);  // smaller flows are rounding errors of the solver
  for (const results::Discharge& d : state.discharges) {
    for (const auto& [flow, way] : {std::pair{d.inflow, "in"}, std::pair{d.outflow, "out"}})
      if (flow > least)
        text += fmt::format("{} {:.3g} {} through '{}'", text.empty() ? "" : ",", flow / in.volume_unit(), way, d.name);
  }
  if (!text.empty())
    text = fmt::format("Water at the start ({} seepage), {}:{}\n", to_word(state.flow), in.flow_name(), text);
  double level = -std::numeric_limits<double>::infinity();
  for (const results::StandingWater& pond : state.ponds) level = std::max({level, pond.level_from, pond.level_to});
  if (std::isfinite(level))
    text += fmt::format("{} stands on the ground up to y = {}\n",
                        state.flow == results::WaterFlow::lowered ? "After drawdown water" : "Water",
                        in.write_level(level));
  return text;
}

std::string write_timeline(const results::Timeline& t, const Units& in) {
  std::string text = "  " + pad("Time", t.start ? 30 : 15) + "Factor   Slip surface\n";
  for (const results::TimedFactor& f : t.factors)
    text += "  " + pad(results::format_moment(t, f.time), t.start ? 30 : 15) +
            (f.factor ? fmt::format("{:6.3f}   {}, {}{}\n", *f.factor, f.surface.title, f.source,
                                    f.refusal.empty() ? "" : " (" + f.refusal + ")")
                      : std::string("  none\n"));
  for (const results::TimedReduction& e : t.elements)
    for (const results::ElementRun& r : e.runs)
      text += "  " + pad(results::format_moment(t, e.time), t.start ? 30 : 15) +
              fmt::format("{:6.3f}   FEM, {}{}\n", r.factor, results::name_flow(r), write_interval(r.interval));
  text += results::format_failure(t) + "\n";
  if (const std::string releases = results::format_releases(t, in.all()); !releases.empty()) text += releases + "\n";
  return text;
}

/// Formats the excess pore pressures of a step: the largest or, of a cut, the least one, whichever is further from
/// zero.
std::string write_excess(const results::ConstructionStep& step, const Units& in) {
  constexpr double noticeable = 1;  // [Pa]; less is the rounding of the solver
  const double least = step.least_excess.value_or(0);
  if (std::max(-least, step.excess) < noticeable) return in.write_stress(0);
  return in.write_stress(-least > step.excess ? least : step.excess);
}

std::string write_release(const results::Release& release, const Units& in) {
  const results::Estimate moved = results::make_estimates(release).moved_volume;
  const std::string volume = in.write_volume(moved), largest = in.write_displacement(release.largest_displacement);
  return moved.is_determined()
             ? fmt::format("    MPM from its end: {} moves by at most {}\n", volume, largest)
             : fmt::format("    MPM from its end: moved volume {}, largest displacement {}\n", volume, largest);
}

std::string write_construction(const results::Construction& c, const Units& in) {
  std::string text = "  Stage                    End         Settlement   Heave        Excess pressure   Factor\n";
  for (const results::ConstructionStage& stage : c.stages) {
    text += "  " + pad(stage.name, 25) + pad(units::format_time(stage.to), 12);
    if (!stage.steps.empty())
      text += pad(in.write_displacement(stage.steps.back().settlement), 13) +
              pad(in.write_displacement(stage.steps.back().heave), 13) + pad(write_excess(stage.steps.back(), in), 18);
    for (const results::StageFactor& factor : stage.factors)
      text += factor.factor ? fmt::format("{:.3f} ({}) ", *factor.factor, factor.title)
                            : fmt::format("none ({}) ", factor.title);
    text += stage.error ? "fails\n" : "\n";
    if (stage.release)
      text += stage.release->error ? fmt::format("    MPM: {}\n", *stage.release->error)
                                   : write_release(*stage.release, in);
  }
  for (const results::ConstructionMonitor& m : c.monitors) {
    if (m.measured_settlement && m.measured_settlement->rms)
      text += fmt::format("  Settlement of '{}' differs from the measured one by {} (root mean square)\n", m.name,
                          in.write_displacement(*m.measured_settlement->rms));
    if (m.measured_lateral && m.measured_lateral->rms)
      text += fmt::format("  Horizontal displacement of '{}' differs from the measured one by {}\n", m.name,
                          in.write_displacement(*m.measured_lateral->rms));
    if (m.measured_pressure && m.measured_pressure->rms)
      text += fmt::format("  Pore pressure of '{}' differs from the measured one by {}\n", m.name,
                          in.write_stress(*m.measured_pressure->rms));
  }
  if (c.least)
    text += fmt::format("The factor of safety is least at the end of stage '{}', {:.3f}.\n", *c.least_stage, *c.least);
  return text;
}

std::string write_water(const results::RunResult& run, const Units& in) {
  std::string text;
  if (const auto& w = run.seepage)
    text += fmt::format("Steady seepage: {:.3g} {} through, largest suction {}\n", w->inflow / in.volume_unit(),
                        in.flow_name(), in.write_stress(w->largest_suction));
  if (run.water_states && !run.water_states->empty()) text += write_state(run.water_states->back(), in);
  if (const auto& w = run.season)
    text += fmt::format(
        "Season of {:.4g} days: {:.3g} {} of rain and inflow entered, {:.3g} left, {:.3g} of {:.3g} transpired; "
        "water balance error {:.1g} of the total\n",
        w->duration / 86400, w->inflow / in.volume_unit(), in.volume_name(), w->outflow / in.volume_unit(),
        w->transpired / in.volume_unit(), w->potential / in.volume_unit(), std::abs(w->error));
  if (const auto& w = run.water)
    text += fmt::format(
        "Water: {:.5g} kg at the start, {:.3g} kg came in, {:.3g} kg left, {:.5g} kg now; water balance "
        "error {:.1g} of the total\n",
        w->initial, w->entered, w->left, w->stored, std::abs(w->error));
  return text;
}

/// Formats the discharges of the last state, and the least safety of all times.
std::string write_flow(const results::FlowResult& flow, const Units& in) {
  if (flow.states.empty()) return "";
  const auto at = [&](const std::vector<double>& x) {
    return fmt::format("x = {}, y = {}", in.write_level(x[0]), in.write_level(x[1]));
  };
  const auto when = [&](double time) {
    return flow.states.size() > 1 ? ", at " + units::format_time(time) : std::string();
  };
  std::string text;
  const results::FlowState& last = flow.states.back();
  for (const results::SectionFlow& s : last.sections)
    text += fmt::format("Through '{}': {:.4g} {}{}\n", s.name, s.discharge / in.volume_unit(), in.flow_name(),
                        when(last.time));
  std::set<std::string> named;
  for (const results::FlowState& state : flow.states)
    for (const results::ExitGradient& exit : state.exits) {
      if (!named.insert(exit.name).second) continue;
      const auto worst = results::find_worst_exit(flow, exit.name);
      if (worst.found == nullptr) continue;
      text +=
          fmt::format("Exit gradient at '{}': {:.3g} at {}{}{}{}\n", exit.name, worst.found->gradient,
                      at(worst.found->at), when(worst.time),
                      worst.found->factor ? fmt::format(", factor against boiling {:.3g}", *worst.found->factor) : "",
                      worst.found->grows ? ", depends on the mesh" : "");
    }
  if (const auto worst = results::find_worst_uplift(flow); worst.found != nullptr)
    text += fmt::format("Factor against uplift of '{}': {:.3g} at {}{}\n", worst.found->layer, worst.found->factor,
                        at(worst.found->at), when(worst.time));
  for (const results::Heave& heave : last.heaves) {
    const auto worst = results::find_worst_heave(flow, heave.name);
    text += worst.found == nullptr ? fmt::format("Heave of '{}': nothing lifts it\n", heave.name)
                                   : fmt::format("Factor against heave of '{}': {:.3g}{}\n", heave.name,
                                                 *worst.found->factor, when(worst.time));
  }
  return text;
}

/// "Spencer, factor of safety: 1.386, published 1.39 ± 0.02 (a referee): passes".
std::string write_comparisons(const std::vector<results::Comparison>& comparisons) {
  std::string text = comparisons.empty() ? "" : "Compared with published values:\n";
  for (const results::Comparison& c : comparisons) {
    const std::string unit = c.unit.name.empty() ? "" : " " + c.unit.name;
    const std::string computed = c.computed ? fmt::format("{:.4g}{}", *c.computed / c.unit.si, unit) : "not calculated";
    text += fmt::format("  {}: {}, published {:.4g}{} ± {} ({}){}{}\n", c.title, computed, c.published / c.unit.si,
                        unit, c.tolerance_text, c.source,
                        !c.computed ? ""
                        : c.passes  ? ": passes"
                                    : ": misses",
                        c.note.empty() ? "" : "; " + c.note);
  }
  return text;
}

}  // namespace

std::string write_digest(const results::RunResult& run) {
  const Units units(run);
  std::string text = run.title + "\n";
  if (const auto disagreement = results::find_disagreement(run)) text += disagreement->text + "\n";
  text += write_design_check(run);
  text += write_main_factor(run);
  text += write_drawdown(run);
  text += write_supports(run);
  if (run.timeline && run.methods) text += "At time 0:\n";
  if (run.methods) text += write_method_table(*run.methods);
  text += write_rejected(run);
  if (run.timeline) text += write_timeline(*run.timeline, units);
  if (run.construction) text += write_construction(*run.construction, units);
  if (const auto& mesh = run.mesh)
    text += fmt::format("  {} points in {} elements, critical time step {:.3g} s\n", mesh->points, mesh->soil_elements,
                        mesh->critical_time_step);
  if (run.stages)
    for (const results::Stage& stage : *run.stages)
      text += fmt::format("  stage '{}': {} steps to t = {:.4g} s, {}\n", stage.name, stage.steps, stage.time,
                          stage.end == results::StageEnd::rest ? "at rest"
                          : stage.moving                       ? "time is up, and it still moves"
                                                               : "time is up");
  if (run.factor_of_safety) text += write_factors(*run.factor_of_safety, units);
  text += write_runouts(run, units);
  text += write_water(run, units);
  if (run.flow) text += write_flow(*run.flow, units);
  text += write_comparisons(run.comparisons);
  for (const std::string& w : run.warnings) text += fmt::format("warning: {}\n", w);
  return text;
}

}  // namespace talus::run
