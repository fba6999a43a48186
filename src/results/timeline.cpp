// SPDX-License-Identifier: MIT
#include "results/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/units.hpp"

namespace talus::results {

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
    return fmt::format(
        "the soil {}moves {} at most{}{}.", before, format_value(r.largest_displacement, length, 3),
        r.front_advance > 0 ? ", its front " + format_uncertain(r.front_advance, r.front_uncertainty, length) : "",
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
