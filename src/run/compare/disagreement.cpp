// SPDX-License-Identifier: MIT
#include "input/case/support.hpp"
#include "run/compare/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "results/governing.hpp"
#include "run/common/head.hpp"
#include "run/fem/solid_of_case.hpp"
#include "site/ground_line.hpp"

namespace talus::run {

namespace {

/// A larger difference between circle and polyline indicates two mechanisms [-].
constexpr double far_surfaces = 0.05;
/// A larger difference between methods is not explained by meshes and flow rules alone [-].
constexpr double far_methods = 0.10;
/// A larger difference between the criteria of FEM indicates that trials ended too early [-].
constexpr double far_criteria = 0.03;
/// Fraction of the length of a surface in one soil from which the surface follows that soil, and its least excess over
/// a surface that does not follow it [-].
constexpr double following = 0.3, more_than_other = 0.15;
/// With fewer rows of elements across a layer, the layer is too stiff.
constexpr double fewest_rows = 3;

double differ(double a, double b) {
  return std::abs(a / b - 1);
}

/// Fraction of the base of a surface in each soil.
std::map<std::string, double> share_soils(const results::CriticalSurface& c) {
  std::map<std::string, double> shares;
  double all = 0;
  for (std::size_t i = 0; i < c.slices.size(); ++i) all += c.slices.length[i];
  for (std::size_t i = 0; i < c.slices.size(); ++i) shares[c.slices.soil[i]] += c.slices.length[i] / all;
  return shares;
}

/// A soil that a surface follows.
struct Followed {
  std::string soil;
  double share = 0;  ///< fraction of the length [-]
};

class Warnings {
 public:
  Warnings(const input::Case& data, const results::RunResult& run, const results::MethodComparison& methods)
      : data_(data), run_(run) {
    if (run.slices) governing_ = results::find_governing_surface(*run.slices, &methods);
  }

  std::vector<std::string> list() {
    warn_of_methods();
    warn_of_bounds();
    warn_of_referee();
    warn_of_surfaces();
    warn_of_skin();
    warn_of_criteria();
    return std::move(warnings_);
  }

 private:
  /// Returns the circle of the method; nullptr if there is none.
  const results::CriticalSurface* find(const std::vector<results::CriticalSurface>& list, SliceMethod method) const {
    const auto found = std::find_if(list.begin(), list.end(), [&](const results::CriticalSurface& c) {
      return c.surface.method == method && c.surface.factor;
    });
    return found == list.end() ? nullptr : &*found;
  }

  /// Returns the soil with the largest excess of the length of `surface` over that of `other`.
  static std::optional<Followed> find_followed(const results::CriticalSurface& surface,
                                               const results::CriticalSurface& other) {
    const std::map<std::string, double> own = share_soils(surface);
    std::map<std::string, double> others = share_soils(other);
    std::optional<Followed> followed;
    double most = more_than_other;
    for (const auto& [soil, share] : own)
      if (share >= following && share - others[soil] > most) {
        most = share - others[soil];
        followed = {soil, share};
      }
    return followed;
  }

  void warn_of_surfaces() {
    if (!governing_ || !run_.slices) return;
    const results::CriticalSurface& least = *governing_->found;
    const SliceMethod method = least.surface.method;
    const results::CriticalSurface* circle = find(run_.slices->critical, method);
    if (circle == nullptr) return;
    const double f = *least.surface.factor, of_circle = *circle->surface.factor;
    const char* title = get_title(method);
    if (&least != circle && differ(of_circle, f) > far_surfaces) {
      const std::optional<Followed> followed = find_followed(least, *circle);
      warnings_.push_back(fmt::format(
          "{}: the {} has the factor {:.3f}, the critical circle {:.3f}, {:.0f} % more. {} The smaller one governs; {}",
          title, results::name_surface(*governing_, data_.units()), f, of_circle, 100 * (of_circle / f - 1),
          followed ? fmt::format("The weaker surface lies in '{}' for {:.0f} % of its length, which no circle can.",
                                 followed->soil, 100 * followed->share)
                   : "The weaker surface is no circle.",
          followed ? fmt::format("check the strength and the extent of '{}'.", followed->soil)
                   : "compare it with FEM, and check that such a surface is possible on your slope."));
      return;
    }
    const results::CriticalSurface* polyline = find(run_.slices->noncircular, method);
    if (polyline != nullptr && *polyline->surface.factor > of_circle * (1 + far_surfaces))
      warnings_.push_back(fmt::format(
          "{}: the best polyline has the factor {:.3f}, the critical circle {:.3f}. The circle governs: polylines with "
          "a "
          "smaller factor lie below the wedge mechanism of their own base, or their search ended too early. More [lem] "
          "vertices help against the latter.",
          title, *polyline->surface.factor, of_circle));
  }

  /// Warns of a critical surface at the smallest depth of the search, which is no minimum.
  void warn_of_skin() {
    if (!governing_ || !run_.slices || !run_.slices->search) return;
    const double smallest = run_.slices->search->smallest_depth, depth = governing_->found->depth;
    constexpr double at_limit = 1.005;
    if (!(smallest > 0) || depth > at_limit * smallest) return;
    warnings_.push_back(fmt::format(
        "{}: the {} is a skin of {}, and the search took no shallower one. Soil without cohesion slides so, and "
        "soil beside the edge of a load. If such slides do not matter, give a larger smallest_depth in [lem].",
        get_title(governing_->found->surface.method), results::name_surface(*governing_, data_.units()),
        format_length(run_, depth, 2)));
  }

  struct Part {
    std::string words;
    double factor;
  };

  void warn_of_methods() {
    std::vector<Part> parts;
    if (governing_)
      parts.push_back({fmt::format("LEM ({}, {})", get_title(governing_->found->surface.method),
                                   results::name_surface(*governing_, data_.units())),
                       *governing_->found->surface.factor});
    if (const results::ElementRun* elements = results::find_governing_elements(run_))
      parts.push_back({fmt::format("FEM ({})", describe_flow(*elements)), elements->factor});
    if (const auto f = results::find_points_factor(run_)) parts.push_back({"MPM", *f});
    if (parts.size() < 2) return;
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.factor < b.factor; });
    const Part &low = parts.front(), &high = parts.back();
    const bool both_sides = low.factor < 1 && high.factor >= 1;
    if (!both_sides && differ(high.factor, low.factor) <= far_methods) return;
    std::vector<std::string> list;
    for (const Part& part : parts) list.push_back(fmt::format("{:.3f} by {}", part.factor, part.words));
    const std::vector<std::string> causes = list_causes(high.factor / low.factor - 1);
    // Above that ratio the run states that neither factor may be used.
    const bool counts = high.factor <= results::largest_ratio * low.factor;
    warnings_.push_back(fmt::format(
        "The methods {}: {}. {}{}",
        both_sides ? "disagree on whether the slope is stable"
                   : fmt::format("lie {:.0f} % apart", 100 * (high.factor / low.factor - 1)),
        fmt::join(list, ", "),
        causes.empty()
            ? "Compare their mechanisms and their water."
            : fmt::format("Likely {}: {}.", causes.size() == 1 ? "cause" : "causes", fmt::join(causes, "; ")),
        counts ? " Until that is settled, the smallest factor counts." : ""));
  }

  /// Warns of a factor outside the interval of limit analysis. FEM and MPM with ψ < φ may be below it.
  void warn_of_bounds() {
    if (!run_.bounds || run_.bounds->error || run_.bounds->is_davis || find_judging_obstacle(data_)) return;
    const bool flows_less = is_nonassociated(data_);
    const results::BoundsResult& bounds = *run_.bounds;
    const std::string tension =
        bounds.takes_tension ? " Limit analysis limits tension to the tensile strength of the soil; LEM does not "
                               "([bounds] tension = \"apex\" corresponds to it)."
                             : "";
    if (governing_ && !run_.slices->referee) {
      const std::string words = fmt::format("LEM ({}, {})", get_title(governing_->found->surface.method),
                                            results::name_surface(*governing_, data_.units()));
      warn_outside(words, *governing_->found->surface.factor, {}, tension,
                   "The surface that was found may not be admissible: look at its forces.");
    }
    // In a progressive failure FEM has less strength than limit analysis at peak, and more than at residual strength.
    if (run_.elements && !softens_in_trials(data_))
      for (const results::ElementRun& r : run_.elements->runs)
        warn_outside(
            fmt::format("FEM ({})", describe_flow(r)), r.factor,
            r.interval.value_or(results::ElementInterval{r.stable, r.failed}),
            " The FEM mesh is too stiff: refine [fem] size.",
            r.flow == results::Flow::associated || !flows_less ? "Trials may have run out of iterations." : "");
    if (const auto f = results::find_points_factor(run_)) {
      const auto& frozen = run_.factor_of_safety->frozen;
      const double uncertainty = frozen ? frozen->uncertainty.value_or(frozen->bracket) : 0;
      warn_outside("MPM", *f, results::ElementInterval{*f - uncertainty, *f + uncertainty},
                   " Its mesh is too coarse, or its trials end too early.",
                   flows_less ? "" : "A trial may have failed at one place only: look at its slip line.");
    }
  }

  void warn_of_referee() {
    if (!run_.slices || !run_.slices->referee || !run_.slices->referee->is_interval()) return;
    const results::Referee& referee = *run_.slices->referee;
    if (referee.is_wide())
      warnings_.push_back(fmt::format(
          "The factors of limit equilibrium were held against an interval of limit analysis that is {:.0f} % wide, "
          "{:.3f} to {:.3f}: no factor is ruled out as too low, and wrong factors inside it are not found. methods = "
          "[\"lem\", \"bounds\"] with a smaller [bounds] size may narrow it.",
          100 * referee.find_width(), results::show_lower(*referee.lower), results::show_upper(*referee.upper)));
  }

  /// `interval`: the interval of the factor; nullopt: the factor alone. `below`: the reason why the factor may be
  /// below the lower bound; empty if this is expected, as the comparison of the methods reports then.
  void warn_outside(const std::string& words, double factor, std::optional<results::ElementInterval> interval,
                    const std::string& above, const std::string& below) {
    const auto &lower = run_.bounds->lower, &upper = run_.bounds->upper;
    const double least = interval ? interval->lower : factor, greatest = interval ? interval->upper : factor;
    if (upper && least > (1 + results::judging_tolerance) * *upper)
      warnings_.push_back(fmt::format(
          "The factor {:.3f} by {} is above the upper bound, {:.3f}: it is too high by {:.1f} % at least.{}", factor,
          words, results::show_upper(*upper), 100 * (factor / *upper - 1), above));
    if (lower && greatest < (1 - results::judging_tolerance) * *lower && !below.empty())
      warnings_.push_back(fmt::format("The factor {:.3f} by {} is below the lower bound for ψ = φ, {:.3f}. {}", factor,
                                      words, results::show_lower(*lower), below));
  }

  /// Lists known causes of a difference of this order.
  std::vector<std::string> list_causes(double difference) const {
    std::vector<std::string> causes;
    const results::ElementRun *given = nullptr, *associated = nullptr;
    if (run_.elements)
      for (const results::ElementRun& r : run_.elements->runs)
        (r.flow == results::Flow::associated ? associated : given) = &r;
    if (given && associated && differ(given->factor, associated->factor) > difference / 3)
      causes.push_back(fmt::format("the flow rule, which makes {:.0f} % in FEM and which LEM does not have",
                                   100 * differ(given->factor, associated->factor)));
    if ((given || associated) && softens_in_trials(data_))
      causes.push_back(
          "softening, which FEM follows, while LEM and limit analysis use the strength of `limit_strength`");
    // A factor above one makes their force in LEM smaller, and with it the factor; one below one makes both larger.
    const std::optional<double> slices = results::find_slices_factor(run_),
                                other = given        ? given->factor
                                        : associated ? associated->factor
                                                     : results::find_points_factor(run_);
    if (slices && other && (*other > *slices) == (*slices > 1) && input::has_passive_supports(data_))
      causes.push_back("passive supports, whose tensile strength the factor divides in LEM, and not in FEM and MPM");
    if (run_.factor_of_safety && run_.factor_of_safety->frozen && !run_.factor_of_safety->frozen->extrapolated)
      causes.push_back(
          "the mesh of MPM, which is one and not extrapolated ([strength_reduction.frozen] meshes = 2 "
          "extrapolates)");
    for (const std::string& layer : list_thin_layers())
      causes.push_back(
          fmt::format("'{}', which has fewer than {:.0f} rows of elements over its thickness (a finer "
                      "[mesh] size or refinement there)",
                      layer, fewest_rows));
    if (run_.factor_of_safety && run_.factor_of_safety->frozen && has_flowing_water())
      causes.push_back(
          "pore water that moves in the trials of MPM, whose pressures change while the soil moves "
          "([strength_reduction.frozen] water = \"held\" keeps them, as LEM does)");
    return causes;
  }

  /// Lists soils of the governing surface that are thinner than a few elements.
  std::vector<std::string> list_thin_layers() const {
    std::vector<std::string> thin;
    if (!governing_) return thin;
    const double size = run_.mesh ? run_.mesh->mean_size : run_.elements ? run_.elements->size : 0;
    for (const auto& [soil, share] : share_soils(*governing_->found))
      if (share >= following && find_thickness(soil) < fewest_rows * size) thin.push_back(soil);
    return thin;
  }

  /// Thickness of the thickest polygon of this soil [m]: twice its area over its perimeter, which is exact for a long
  /// layer.
  double find_thickness(const std::string& soil) const {
    double thickest = 0;
    for (const mesh::Polygon& polygon : data_.mesh.polygons) {
      const auto region = data_.regions.find(polygon.name);
      if (region == data_.regions.end() || region->second != soil) continue;
      double area = 0, perimeter = 0;
      for (std::size_t i = 0; i < polygon.points.size(); ++i) {
        const auto &a = polygon.points[i], &b = polygon.points[(i + 1) % polygon.points.size()];
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
        perimeter += std::hypot(b[0] - a[0], b[1] - a[1]);
      }
      thickest = std::max(thickest, 2 * std::abs(area) / perimeter);
    }
    return thickest;
  }

  bool has_flowing_water() const {
    return run_.water.has_value() && input::moves(data_.strength_reduction.frozen.step_settings.water);
  }

  void warn_of_criteria() {
    if (!run_.elements) return;
    for (const results::ElementRun& r : run_.elements->runs) {
      if (!r.by_displacement || differ(*r.by_displacement, r.factor) <= far_criteria) continue;
      const bool ran_out = std::any_of(r.trials.begin(), r.trials.end(), [&](const results::ElementTrial& t) {
        return !t.converged && t.factor < *r.by_displacement && t.iterations >= data_.fem.iterations;
      });
      warnings_.push_back(fmt::format(
          "FEM ({}): by the last equilibrium the factor is {:.3f}, by the sharp rise of displacements {:.3f}{}, "
          "{:.0f} % apart. {}",
          describe_flow(r), r.factor, *r.by_displacement, r.meshes ? " (both extrapolated from two meshes)" : "",
          100 * differ(*r.by_displacement, r.factor),
          ran_out ? fmt::format("Trials ran out of iterations: raise [fem] iterations above {}.", data_.fem.iterations)
                  : "The mesh is too coarse for the mechanism, or a small part of the ground fails first: refine [fem] "
                    "size, and look at the strains at failure."));
    }
  }

  const input::Case& data_;
  const results::RunResult& run_;
  std::optional<results::GoverningSurface> governing_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> warn_of_disagreement(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods) {
  return Warnings(data, run, methods).list();
}

namespace {

/// Formats the factors with this verdict as one sentence; empty if there are none.
std::string read_verdicts(const results::SliceResult& slices, results::Verdict verdict, const char* words) {
  std::vector<std::string> list;
  const auto add = [&](const std::vector<results::CriticalSurface>& surfaces, const char* surface) {
    for (const results::CriticalSurface& c : surfaces)
      if (c.verdict == verdict)
        list.push_back(fmt::format("{:.3f} ({}, {})", *c.surface.factor, c.surface.title, surface));
  };
  add(slices.critical, "circle");
  add(slices.noncircular, "polyline");
  add(slices.given, "given surface");
  return list.empty() ? "" : fmt::format("These factors {}: {}.", words, fmt::join(list, ", "));
}

std::string describe_interval(const results::Referee& referee) {
  if (referee.is_interval())
    return fmt::format(
        "Limit analysis proves for the soil of limit equilibrium (ψ = φ, tension up to c/tan φ) that the factor lies "
        "between {:.3f} and {:.3f}.",
        results::show_lower(*referee.lower), results::show_upper(*referee.upper));
  if (referee.upper)
    return fmt::format("Limit analysis proves that the factor is at most {:.3f}; there is no lower bound: {}.",
                       results::show_upper(*referee.upper), referee.no_lower);
  if (referee.lower)
    return fmt::format("Limit analysis proves that the factor is at least {:.3f}; there is no upper bound: {}.",
                       results::show_lower(*referee.lower), referee.no_upper);
  return fmt::format("Limit analysis is undecided, so that the factors of limit equilibrium are not judged: {}.",
                     referee.no_upper);
}

}  // namespace

std::vector<std::string> read_referee(const input::Case& data, const results::RunResult& run,
                                      std::optional<double> governing) {
  if (!run.slices || run.slices->error) return {};
  if (const auto why = input::find_axial_obstacle(data))
    return {fmt::format("The factors of limit equilibrium were not held against limit analysis: {}.", *why)};
  if (!data.lem.referee)
    return {"The factors of limit equilibrium were not held against limit analysis (referee = false)."};
  if (!run.slices->referee) return {};
  const results::Referee& referee = *run.slices->referee;
  if (referee.why_not)
    return {fmt::format("Limit analysis cannot judge the factors of limit equilibrium: {}.", *referee.why_not)};
  std::vector<std::string> sentences{describe_interval(referee)};
  if (!run.slices->search && referee.upper && governing && *governing > results::show_upper(*referee.upper))
    sentences.push_back(
        fmt::format("The factors are those of the given surfaces. The slope has a mechanism with a lower factor, of "
                    "at most {:.3f}.",
                    results::show_upper(*referee.upper)));
  if (referee.upper_only)
    sentences.push_back(fmt::format("Factors below the lower bound are not refused: {}.", *referee.upper_only));
  for (std::string sentence :
       {read_verdicts(*run.slices, results::Verdict::too_low, "lie below the lower bound and are impossible"),
        read_verdicts(*run.slices, results::Verdict::too_high,
                      "lie above the upper bound, so that a weaker mechanism exists")})
    if (!sentence.empty()) sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace talus::run
