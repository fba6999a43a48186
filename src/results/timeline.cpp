// SPDX-License-Identifier: MIT
#include "results/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, TimedFactor& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("surface", r.surface, {"", "the slip surface that governs"});
  v.key("source", r.source, {"", "what the surface is"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
  v.maybe("referee", r.referee, {"", "limit analysis at this time, where the time governs"});
}

void describe(Visitor& v, FailureTime& r) {
  v.key("from", r.from, {"s", "the last time at or above the target"});
  v.key("to", r.to, {"s", "the first time below it"});
  v.key("factor_from", r.factor_from, {"", "factor of safety at the first of them"});
  v.key("factor_to", r.factor_to, {"", "factor of safety at the second"});
  v.key("earliest", r.earliest,
        {"s", "last time before at which it is above the target by more than searches scatter"});
  v.key("latest", r.latest, {"s", "first time at which it is below the target by as much"});
}

void describe(Visitor& v, Release& r) {
  v.key("time", r.time, {"s", "start of MPM"});
  v.key("factor", r.factor, {"", "factor of safety at that time, by LEM"});
  v.key("folder", r.folder, {"", "folder of its results; empty: the run itself"});
  v.key("rests", r.rests, {"", "whether the soil came to rest before it was let go"});
  v.key("start_factor", r.start_factor,
        {"", "strength reduction factor of the FEM equilibrium that gave the initial stress"});
  v.key("error", r.error, {"", "why it did not end"});
  v.key("largest_displacement", r.largest_displacement, {"m", "largest displacement"});
  v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
  v.key("front_advance", r.front_advance, {"m", "advance of the front"});
  v.key("toe_distance", r.toe_distance, {"m", "runout beyond the toe"});
  v.key("mass_front_advance", r.mass_front_advance, {"m", "advance of 99 % of the moved mass"});
  v.maybe("front_uncertainty", r.front_uncertainty,
          {"m", "what the mesh leaves open in the advance of the front, from a coarser mesh"});
  v.maybe("coarser_mesh", r.coarser_mesh, {"", "the runout on elements twice as large"});
  v.maybe("undetermined", r.undetermined,
          {"", "measures whose uncertainty exceeds half of them: their numbers hold for this mesh alone"});
  v.maybe("limits", r.limits, {"", "what the ends of the box limit"});
}

RunoutEstimates make_estimates(const Release& r) {
  Runout runout;
  runout.moved_volume = r.moved_volume;
  runout.front_advance = r.front_advance;
  runout.toe_distance = r.toe_distance;
  runout.coarser_mesh = r.coarser_mesh;
  return RunoutEstimates(runout);
}

void describe(Visitor& v, TimedReduction& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("folder", r.folder, {"", "folder of its results"});
  v.key("runs", r.runs, {"", "strength reductions by flow rule"});
  v.key("error", r.error, {"", "why there is no answer"});
}

void describe(Visitor& v, EquilibriumLoss& r) {
  v.key("from", r.from, {"s", "the last time with equilibrium"});
  v.key("to", r.to, {"s", "the first time without"});
  v.key("trials", r.trials, {"", "equilibria that were looked for"});
}

void describe(Visitor& v, Timeline& r) {
  v.key("duration", r.duration, {"s", "length of the timeline"});
  v.key("start", r.start, {"", "date of time 0"});
  v.key("target", r.target, {"", "a factor below it is failure"});
  v.key("factors", r.factors, {"", "factor of safety in time"});
  v.key("least", r.least, {"", "least factor of safety in time"});
  v.key("least_time", r.least_time, {"s", "when the factor is least"});
  v.key("fails_from_start", r.fails_from_start, {"", "whether the factor is below the target at time 0"});
  v.key("failure", r.failure, {"", "when the factor falls below the target"});
  v.key("chosen", r.chosen, {"", "whether the times were chosen"});
  v.key("distance", r.distance, {"", "what straight lines between the times are off at most, over the factor"});
  v.key("states", r.states, {"", "where the water stood at the times of the factors"});
  v.key("elements", r.elements, {"", "factors of safety by FEM in time"});
  v.key("equilibrium", r.equilibrium, {"", "loss of equilibrium by FEM"});
  v.key("pool_loading", r.pool_loading, {"", "whether the weight of pools compresses saturated soil"});
  v.key("releases", r.releases, {"", "MPM runs that start from the timeline, the run itself first"});
  v.key("notes", r.notes, {"", "what must be known of it"});
  v.key("weather", r.weather, {"", "water that came, went and is stored"});
  v.key("step_error", r.step_error, {"m", "the largest error of a step of the seepage, by its prediction"});
  v.key("seepage_seconds", r.seepage_seconds, {"s", "seconds of the seepage"});
  v.key("search_seconds", r.search_seconds, {"s", "seconds of the searches"});
}

void describe(Visitor& v, SearchedMoment& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("circular", r.circular, {"", "critical circles"});
  v.key("noncircular", r.noncircular, {"", "critical polylines"});
  v.key("given", r.given, {"", "surfaces that the case gives"});
  v.key("error", r.error, {"", "why there is none"});
}

void describe(Visitor& v, TimelineFile& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("moments", r.moments, {"", "times that are searched"});
}

const TimedReduction* find_least_reduction(const Timeline& t) {
  const TimedReduction* least = nullptr;
  for (const TimedReduction& r : t.elements)
    if (!r.runs.empty() && (least == nullptr || r.runs.front().factor < least->runs.front().factor)) least = &r;
  return least;
}

void find_failure(Timeline& t) {
  const TimedFactor* last = nullptr;
  double above = 0;  // last time with a factor above the target by more than search_scatter; 0 if there is none
  for (const TimedFactor& f : t.factors) {
    if (!f.factor) continue;
    if (!t.least || *f.factor < *t.least) t.least = f.factor, t.least_time = f.time;
    if (*f.factor < t.target && !t.failure && !t.fails_from_start) {
      if (last == nullptr)
        t.fails_from_start = true;
      else
        t.failure = {last->time, f.time, *last->factor, *f.factor, above, std::nullopt};
    }
    if (t.failure && !t.failure->latest && *f.factor < t.target * (1 - search_scatter)) t.failure->latest = f.time;
    if (!t.failure && *f.factor > t.target * (1 + search_scatter)) above = f.time;
    last = &f;
  }
}

std::string format_moment(const Timeline& t, double time) {
  std::string text = units::format_time(time);
  if (const auto zero = t.start ? parse_date(*t.start) : std::nullopt) text += " (" + format_date(*zero + time) + ")";
  return text;
}

std::string format_failure(const Timeline& t) {
  if (!t.least) return "No slip surface was admissible at any time.";
  const std::string least = fmt::format("It is least at {}, {:.3f}.", format_moment(t, *t.least_time), *t.least);
  if (t.fails_from_start) return fmt::format("The factor of safety is below {:g} from the start. {}", t.target, least);
  if (!t.failure)
    return fmt::format("The factor of safety stays at or above {:g} at all {} times that were tried. {}", t.target,
                       t.factors.size(), least);
  const FailureTime& f = *t.failure;
  std::string text =
      fmt::format("The factor of safety falls below {:g} between {} and {}, where it is {:.4f} and {:.4f}. ", t.target,
                  format_moment(t, f.from), format_moment(t, f.to), f.factor_from, f.factor_to);
  if (f.earliest < f.from || f.latest != f.to)
    text += fmt::format(
        "Allowing ± {:g} % for the search, it fails {}. ", 100 * search_scatter,
        f.latest ? fmt::format("between {} and {}", format_moment(t, f.earliest), format_moment(t, *f.latest))
                 : fmt::format("after {}, or not at all", format_moment(t, f.earliest)));
  return text + least;
}

namespace {

/// Returns a sentence on the loss of equilibrium in FEM, followed by a space; empty if it was not computed.
std::string format_loss(const Timeline& t) {
  if (!t.equilibrium || !t.equilibrium->to) return "";
  const EquilibriumLoss& loss = *t.equilibrium;
  if (!loss.from)
    return fmt::format("FEM with the strength as given does not converge at {}. ", format_moment(t, *loss.to));
  return fmt::format("FEM with the strength as given converges at {} and not at {}. ", format_moment(t, *loss.from),
                     format_moment(t, *loss.to));
}

/// Returns a sentence on the initial stress of MPM, followed by a space; empty if it is not from FEM.
std::string format_start(const std::vector<Release>& releases) {
  double most = 1;
  bool any = false;
  for (const Release& r : releases)
    if (r.start_factor) any = true, most = std::max(most, 1 / *r.start_factor);
  if (!any) return "";
  if (most == 1) return " MPM starts from the equilibrium stress by FEM.";
  return fmt::format(" MPM starts from the equilibrium stress by FEM, with up to {:.3g} times the strength.", most);
}

}  // namespace

std::string format_releases(const Timeline& t, const ShownUnits& units) {
  if (t.releases.empty()) return "";
  const ShownUnit& length = units.length;
  const auto say = [&](const Release& r, const char* before) {
    if (r.error) return fmt::format("the run did not end: {}", *r.error);
    const Estimate front = make_estimates(r).front_advance;
    const std::string advance = format_estimate(front, length);
    return fmt::format("the soil {}moves {} at most{}{}.", before, format_value(r.largest_displacement, length, 3),
                       !front.is_determined() ? "; the advance of its front is " + advance
                       : r.front_advance > 0  ? ", its front " + advance
                                              : "",
                       r.limits && r.limits->front ? ", where the box ends" : "");
  };
  const Release& first = t.releases.front();
  std::string text = format_loss(t);
  text += fmt::format("MPM starts at {}: {}", format_moment(t, first.time),
                      say(first, first.rests ? "comes to rest, is let go and " : ""));
  for (std::size_t i = 1; i < t.releases.size(); ++i)
    text += fmt::format(" When it starts {} {}, {}", units::format_time(std::abs(t.releases[i].time - first.time)),
                        t.releases[i].time < first.time ? "earlier" : "later", say(t.releases[i], ""));
  text += format_start(t.releases);
  return text;
}

}  // namespace talus::results
