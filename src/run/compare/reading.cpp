// SPDX-License-Identifier: MIT
#include "input/case/support.hpp"
#include "run/compare/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "results/governing.hpp"
#include "run/common/head.hpp"
#include "run/compare/slip_line.hpp"
#include "run/fem/solid_of_case.hpp"

namespace talus::run {
namespace {

/// Factors with a smaller relative difference count as equal [-].
constexpr double same = 0.01;
/// Methods of slices usually differ little; a larger difference between them is reported [-].
constexpr double noticeable = 0.02;
/// Mean distance of two surfaces, over the height of the slope, up to which they are one mechanism, if it exceeds the
/// element size [-].
constexpr double same_surface = 0.06;
/// Fraction of the resistance due to suction from which it is reported [-].
constexpr double noticeable_suction = 0.01;

std::string format_share(double part) {
  return std::abs(part) < 5e-4 ? "0.1 %" : fmt::format("{:.1f} %", 100 * std::abs(part));
}

/// "1.2 % above", "3.7 % below".
std::string compare(double factor, double other) {
  if (std::abs(factor / other - 1) < 5e-4) return "the same as";
  return fmt::format("{} {}", format_share(factor / other - 1), factor >= other ? "above" : "below");
}

/// Returns the critical surface of a method; nullptr if there is none.
const results::CriticalSurface* find_surface(const std::vector<results::CriticalSurface>& list, SliceMethod method) {
  for (const results::CriticalSurface& c : list)
    if (c.surface.method == method) return &c;
  return nullptr;
}

class Reading {
 public:
  Reading(const input::Case& data, const results::RunResult& run, const results::MethodComparison& methods)
      : data_(data), run_(run), methods_(methods), height_(run.slope_height.value_or(0)) {
    if (run.slices) {
      if (const auto governing = results::find_governing_surface(*run.slices, &methods)) {
        const std::string title = get_title(governing->found->surface.method);
        surface_ = governing->found;
        slices_ = surface_->surface.factor;
        name_ = governing->source == results::SurfaceSource::critical ? title : title + "'s polyline";
        place_ = fmt::format("the {} of {}", results::name_surface(*governing, data.units()), title);
      }
    }
    if (run.elements)
      for (const results::ElementRun& r : run.elements->runs)
        (r.flow == results::Flow::associated ? associated_ : given_) = &r;
    if (run.factor_of_safety && run.factor_of_safety->frozen) frozen_ = run.factor_of_safety->frozen->factor;
  }

  std::vector<results::Remark> read() {
    topic_ = results::Topic::agreement;
    read_range();
    topic_ = results::Topic::slices;
    read_search();
    read_slices();
    if (surface_ != nullptr && data_.earthquake.list_directions().size() > 1)
      say("The earthquake acts on each mass as it slides; the governing one slides towards {} x.",
          surface_->slides_left ? "smaller" : "larger");
    read_suction();
    topic_ = results::Topic::elements;
    read_flow();
    read_element_mesh();
    read_element_criterion();
    read_elements();
    topic_ = results::Topic::bounds;
    for (std::string& sentence : read_referee(data_, run_, slices_)) remarks_.push_back({topic_, std::move(sentence)});
    read_bounds();
    topic_ = results::Topic::points;
    read_points_mesh();
    read_points_criterion();
    read_points();
    topic_ = results::Topic::mechanism;
    read_sides();
    read_surfaces();
    topic_ = results::Topic::seconds;
    read_seconds();
    return std::move(remarks_);
  }

 private:
  template <class... Arguments>
  void say(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    remarks_.push_back({topic_, fmt::format(text, std::forward<Arguments>(arguments)...)});
  }

  /// Describes the interval of limit analysis and the factors inside it.
  void read_bounds() {
    if (!run_.bounds || !run_.bounds->is_interval()) return;
    const double low = *run_.bounds->lower, high = *run_.bounds->upper;
    if (run_.bounds->is_davis)
      return say(
          "With the strength of Davis, which is smaller where ψ < φ, limit analysis bounds the factor between {:.3f} "
          "and "
          "{:.3f}. The bounds hold for this weaker soil; for the soil as given they are an estimate.",
          low, high);
    say("By limit analysis the factor lies between {:.3f} and {:.3f} ({:.1f} % of their middle) for ψ = φ{}.",
        results::show_lower(low), results::show_upper(high), 200 * (high - low) / (high + low),
        run_.bounds->takes_tension ? " and the tensile strength as given" : "");
    if (run_.bounds->earthquake)
      say("Limit analysis: {}.", results::describe_side(*run_.bounds->earthquake, results::proven_stable));
    std::vector<std::string> inside;
    const auto add = [&](std::optional<double> factor, const std::string& name) {
      if (factor && *factor >= low && *factor <= high) inside.push_back(fmt::format("{:.3f} by {}", *factor, name));
    };
    add(slices_, name_);
    if (given_ != nullptr) add(given_->factor, "FEM with " + describe_flow(*given_));
    if (associated_ != nullptr) add(associated_->factor, "FEM with ψ = φ");
    add(frozen_, "MPM");
    if (!inside.empty()) say("The interval holds {}.", fmt::join(inside, ", "));
    if (const auto why = find_judging_obstacle(data_)) say("Factors outside the interval are not judged: {}.", *why);
    for (const results::ElementRun* run : {given_, associated_})
      if (run != nullptr && run->verdict == results::Verdict::too_low)
        say("The factor by FEM with {} ({:.3f}) lies below the lower bound and is impossible.", describe_flow(*run),
            run->factor);
    // LEM has no dilatancy, and its cases may leave it out.
    const bool has_flow = input::uses(data_, Method::fem) || input::uses(data_, Method::mpm);
    if (!has_flow || !is_nonassociated(data_)) return;
    std::vector<std::string> below;
    if (given_ != nullptr && given_->factor < low) below.push_back(fmt::format("{:.3f} by FEM", given_->factor));
    if (frozen_ && *frozen_ < low) below.push_back(fmt::format("{:.3f} by MPM", *frozen_));
    say("Soil of the case has ψ < φ, for which the bound theorems do not hold: it may fail earlier, and its limit load "
        "depends on its history.{}",
        below.empty() ? "" : fmt::format(" Below the interval: {}.", fmt::join(below, ", ")));
  }

  const results::CriticalSurface* find_circle(SliceMethod method) const {
    return run_.slices ? find_surface(run_.slices->critical, method) : nullptr;
  }
  std::optional<double> find_circle_factor(SliceMethod method) const {
    const results::CriticalSurface* found = find_circle(method);
    return found == nullptr ? std::nullopt : found->surface.factor;
  }

  /// Describes the range of one factor of each kind of method: Spencer's circle, FEM, MPM.
  void read_range() {
    std::vector<std::pair<std::string, double>> parts;
    if (slices_) parts.emplace_back(fmt::format("LEM ({}) {:.3f}", name_, *slices_), *slices_);
    if (const results::ElementRun* run = given_ ? given_ : associated_) {
      const double f = run->factor;
      parts.emplace_back(fmt::format("FEM ({}) {:.3f}", describe_flow(*run), f), f);
    }
    if (frozen_) parts.emplace_back(fmt::format("MPM (frozen geometry) {:.3f}", *frozen_), *frozen_);
    if (parts.size() < 2) return;
    std::vector<std::string> words;
    double low = parts.front().second, high = low;
    for (const auto& [text, f] : parts) {
      words.push_back(text);
      low = std::min(low, f);
      high = std::max(high, f);
    }
    say("Factors of safety: {}; they lie within {} of each other.", fmt::join(words, ", "),
        format_share(high / low - 1));
  }

  void read_search() {
    if (!run_.slices || !run_.slices->search) return;
    // Methods that ended at the same limit share one sentence.
    std::vector<std::pair<std::string, std::vector<std::string>>> limits;
    for (const results::LimitHit& hit : run_.slices->search->limit_hits) {
      auto known = std::find_if(limits.begin(), limits.end(), [&](const auto& l) { return l.first == hit.limit; });
      if (known == limits.end()) known = limits.insert(limits.end(), {hit.limit, {}});
      if (std::find(known->second.begin(), known->second.end(), hit.method) == known->second.end())
        known->second.push_back(hit.method);
    }
    for (const auto& [what, methods] : limits)
      say("The search of LEM ended at a limit ({}): {}.", fmt::join(methods, ", "), what);
  }

  void read_slices() {
    const auto bishop = find_circle_factor(SliceMethod::bishop), spencer = find_circle_factor(SliceMethod::spencer),
               janbu = find_circle_factor(SliceMethod::janbu);
    if (bishop && spencer) {
      if (std::abs(*bishop / *spencer - 1) < same)
        say("Bishop ({:.3f}) and Spencer ({:.3f}) agree within {}: on circles the interslice forces matter little "
            "here.",
            *bishop, *spencer, format_share(*bishop / *spencer - 1));
      else
        say("Bishop ({:.3f}) lies {} Spencer ({:.3f}): it does not satisfy the horizontal equilibrium of the slices, "
            "which matters in this slope.",
            *bishop, compare(*bishop, *spencer), *spencer);
    }
    if (janbu && spencer && *janbu / *spencer < 1 - noticeable) {
      const double f0 = find_circle(SliceMethod::janbu)->correction;
      const auto corrected = find_circle_factor(SliceMethod::janbu_corrected);
      say("Simplified Janbu ({:.3f}) lies {} Spencer, as it neglects the interslice shear{}.", *janbu,
          compare(*janbu, *spencer),
          corrected ? fmt::format("; with its correction it is {:.3f}", *corrected)
                    : (f0 != 1 ? fmt::format("; its correction would be {:.3f}", f0) : ""));
    }
    if (surface_ == nullptr) return;
    const SliceMethod method = surface_->surface.method;
    const results::CriticalSurface *circle = find_circle(method),
                                   *polyline = find_surface(run_.slices->noncircular, method);
    const auto is_possible = [](const results::CriticalSurface* c) {
      return c != nullptr && c->surface.factor &&
             c->verdict.value_or(results::Verdict::possible) == results::Verdict::possible;
    };
    if (!is_possible(circle) || !is_possible(polyline)) return;
    const double of_circle = *circle->surface.factor, of_polyline = *polyline->surface.factor;
    if (of_polyline / of_circle < 1 - same)
      say("The best polyline ({}, {:.3f}) lies {} the best circle ({:.3f}): the weakest surface is no circle.",
          get_title(method), of_polyline, compare(of_polyline, of_circle), of_circle);
    else if (of_polyline / of_circle < 1 + same)
      say("The best polyline ({}, {:.3f}) is no more than {} from the best circle: a circle describes the mechanism "
          "well here.",
          get_title(method), of_polyline, format_share(of_polyline / of_circle - 1));
  }

  /// Describes the fraction of the resistance due to suction on the governing surface.
  void read_suction() {
    if (surface_ == nullptr) return;
    const results::SliceTable& slices = surface_->slices;
    double suction = 0, all = 0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
      const double length = slices.length[i], u = slices.pore_pressure[i];
      suction += slices.suction_strength[i] * length;
      all += slices.cohesion[i] * length +
             std::max(0.0, slices.normal[i] - std::max(0.0, u) * length) * slices.tan_friction[i];
    }
    if (!(all > 0) || suction < noticeable_suction * all) return;
    bool by_angle = false, by_saturation = false, by_default = false;
    for (const auto& [region, name] : data_.regions) {
      const input::SuctionStrength how = data_.materials.at(name).slices.suction_strength;
      by_angle = by_angle || how == input::SuctionStrength::phi_b;
      by_default = by_default || (how == input::SuctionStrength::from_water && data_.materials.at(name).water.is_wet());
      by_saturation =
          by_saturation || how == input::SuctionStrength::from_water || how == input::SuctionStrength::saturation;
    }
    say("Suction gives {} of the resistance on {}{}.", format_share(suction / all), place_,
        by_angle && (given_ || associated_) ? "; FEM takes it as an effective stress, s tan φ_b / tan φ"
        : by_saturation && (given_ != nullptr || associated_ != nullptr || frozen_)
            ? "; every method takes it as χ s with the same χ"
            : "");
    // Pore water is often given for the seepage alone.
    if (by_default)
      say("It counts where [materials.NAME.water] stands without suction_strength; \"none\" leaves it out.");
  }

  void read_flow() {
    if (given_ && associated_) {
      const double a = given_->factor, b = associated_->factor;
      if (std::abs(a / b - 1) < same / 2)
        say("The flow rule hardly matters: FEM gives {:.3f} with {} and {:.3f} with ψ = φ.", a, describe_flow(*given_),
            b);
      else
        say("The flow rule matters: FEM gives {:.3f} with ψ = φ and {:.3f}, {} it, with {}. LEM has no flow rule; "
            "compare it with ψ = φ.",
            b, a, compare(a, b), describe_flow(*given_));
    } else if (given_ && slices_ && is_nonassociated(data_)) {
      const double f = given_->factor;
      if (f / *slices_ < 1 - same)
        say("FEM uses {} < φ, LEM has no flow rule: [fem] flow = \"both\" shows its part of the difference ({} {}).",
            describe_flow(*given_), compare(f, *slices_), name_);
    }
  }

  void read_element_criterion() {
    for (const results::ElementRun* run : {given_, associated_}) {
      if (run == nullptr) continue;
      const auto other = run->by_displacement;
      const double f = run->factor;
      if (!other || std::abs(*other / f - 1) < same) continue;
      say("With {} the criteria of FEM differ: displacements rise sharply at {:.3f}, {} the factor by non-convergence "
          "({:.3f}).",
          describe_flow(*run), *other, compare(*other, f), f);
    }
  }

  /// Describes the interval of two meshes, or its absence.
  void read_element_mesh() {
    for (const results::ElementRun* run : {given_, associated_}) {
      if (run == nullptr) continue;
      const std::string flow = describe_flow(*run);
      if (run->interval && run->meshes)
        say("FEM ({}): {:.3f} on elements of {} and {:.3f} on {}, {:.3f} at size zero; the "
            "interval of mesh and search is {:.3f} to {:.3f}.",
            flow, run->meshes->front().factor, format_length(run_, run->meshes->front().size),
            run->meshes->back().factor, format_length(run_, run->meshes->back().size), run->factor,
            results::show_lower(run->interval->lower), results::show_upper(run->interval->upper));
      else
        say("FEM ({}), {}: the mesh error is not known.", flow, run->meshes ? "two meshes" : "one mesh");
      if (run->earthquake)
        say("FEM ({}): {}.", flow, results::describe_side(*run->earthquake, results::stable_on_mesh));
    }
  }

  /// Compares FEM with LEM.
  void read_elements() {
    const results::ElementRun* run = associated_ ? associated_ : given_;
    if (run == nullptr || !slices_) return;
    const double f = run->factor, margin = same * *slices_;
    const results::ElementInterval known = run->interval.value_or(results::ElementInterval{run->stable, run->failed});
    if (*slices_ >= known.lower - margin && *slices_ <= known.upper + margin)
      say("FEM ({}, {:.3f}) and {} ({:.3f}) agree within {}.", describe_flow(*run), f, name_, *slices_,
          format_share(f / *slices_ - 1));
    else
      say("FEM ({}, {:.3f}) lies {} {} ({:.3f}){}.", describe_flow(*run), f, compare(f, *slices_), name_, *slices_,
          softens_in_trials(data_) ? "; its soil softens, while LEM uses the strength of `limit_strength`"
          : f <= *slices_          ? ""
          : input::has_passive_supports(data_)
              ? "; the factor divides the tensile strength of passive supports in LEM only"
              : "; a finer mesh ([fem] size) shows whether the elements are too stiff");
  }

  void read_points_mesh() {
    if (!frozen_) return;
    const results::FrozenFactor& frozen = *run_.factor_of_safety->frozen;
    const std::vector<results::MeshFactor>& meshes = frozen.meshes;
    if (meshes.size() < 2) return;
    const double coarse = *meshes[0].factor(), fine = *meshes[1].factor(), bracket = frozen.bracket;
    if (std::abs(coarse - fine) <= bracket)
      say("MPM: halving the elements changes the factor by less than the width of the bracket ({:.3f} and "
          "{:.3f}).",
          coarse, fine);
    else
      say("MPM: {:.3f} on elements of {} and {:.3f} on {}, {:.3f} at size zero; the mesh "
          "contributes {} to the factor on the coarse mesh.",
          coarse, format_length(run_, meshes[0].size, 6), fine, format_length(run_, meshes[1].size, 6), *frozen_,
          format_share(coarse / *frozen_ - 1));
  }

  void read_points_criterion() {
    if (!run_.factor_of_safety || !run_.factor_of_safety->criteria) return;
    for (const results::Criterion& c : *run_.factor_of_safety->criteria) {
      const auto f = c.factor;
      if (c.kind != results::CriterionKind::bilinear || !f) continue;
      if (!frozen_) {
        if (slices_ && std::abs(*f / *slices_ - 1) > noticeable)
          say("The bilinear construction on the displacement curve of MPM gives {:.3f}, {} {}: it "
              "derives failure from the growth of displacements, not from equilibrium.",
              *f, compare(*f, *slices_), name_);
        return;
      }
      if (std::abs(*f / *frozen_ - 1) > noticeable)
        say("The criterion matters: the same soil fails at {:.3f} by the bilinear construction on the displacement "
            "curve and at {:.3f} by rest or run-away; the bilinear one lies {} and reads the growth of displacements, "
            "not "
            "the loss of equilibrium.",
            *f, *frozen_, compare(*f, *frozen_));
    }
  }

  void read_points() {
    if (!frozen_) return;
    const results::ElementRun* run = given_ ? given_ : associated_;
    if (run == nullptr && !slices_) return;
    const double other = run ? run->factor : *slices_;
    const std::string words = run ? fmt::format("FEM ({})", describe_flow(*run)) : name_;
    if (std::abs(*frozen_ / other - 1) < noticeable)
      say("MPM at frozen geometry ({:.3f}) confirms {} ({:.3f}).", *frozen_, words, other);
    else
      say("MPM at frozen geometry ({:.3f}) lies {} {} ({:.3f}){}.", *frozen_, compare(*frozen_, other), words, other,
          is_extrapolated()
              ? ""
              : "; it is from one mesh, and [strength_reduction.frozen] meshes = 2 shows the part of the mesh");
  }

  bool is_extrapolated() const { return run_.factor_of_safety->frozen->extrapolated.has_value(); }

  /// Describes mechanisms on both sides of a section.
  void read_sides() {
    for (const results::MethodSurface& s : methods_.surfaces) {
      if (!s.beside || !s.direction) continue;
      const std::string of = s.method == Method::bounds ? "mechanism of the upper bound"
                             : s.method == Method::fem  ? "shear band of FEM" + name_rule(s)
                                                        : "slip line of MPM";
      say("In the {} the soil moves to both sides, along a line of its own on each.{}", of,
          run_.slices ? fmt::format(" Spencer's method was run on the slip surface of the soil that moves {}, the "
                                    "nearer one to its own.",
                                    results::name_side(-*s.direction))
                      : "");
    }
  }

  /// Describes whether the methods find one mechanism, and the LEM factors on the surfaces of the others.
  void read_surfaces() {
    if (surface_ == nullptr || !(height_ > 0)) return;
    const site::Polyline& own = surface_->surface.points;
    if (own.size() < 2) return;
    for (const results::MethodSurface& s : methods_.surfaces) {
      if (s.method == Method::lem || s.beside || s.points.size() < 2) continue;
      const double mean = find_mean_distance(own, s.points);
      const bool by_elements = s.method == Method::fem;
      const std::string of = s.method == Method::bounds ? "line of the upper bound's mechanism"
                             : by_elements              ? "shear band of FEM" + name_rule(s)
                                                        : "slip line of MPM";
      const std::string handed = describe_handed(s.name);
      const double size = by_elements ? run_.elements->size : run_.mesh ? run_.mesh->mean_size : 0;
      if (mean < std::max(same_surface * height_, size))
        say("One mechanism: the {} is on average {} ({} of the height) from {}{}.", of, format_length(run_, mean, 2),
            format_share(mean / height_), place_, handed);
      else
        say("The {} is on average {} ({} of the height) from {}: the mechanisms "
            "differ{}{}.",
            of, format_length(run_, mean, 2), format_share(mean / height_), place_, handed,
            describe_near_minimum(s.points, size));
    }
  }

  /// Name of an FEM surface if there are two bands; empty if there is one.
  std::string name_rule(const results::MethodSurface& s) const {
    if (given_ == nullptr || associated_ == nullptr) return "";
    const bool associated = s.beside.value_or(s.name) == name_band(results::Flow::associated);
    return " with " + describe_flow(associated ? *associated_ : *given_);
  }

  /// Describes another local minimum of the LEM search that is this mechanism.
  std::string describe_near_minimum(const site::Polyline& line, double size) const {
    const auto minima = run_.slices->minima.find(results::to_word(surface_->surface.method));
    if (minima == run_.slices->minima.end()) return "";
    double nearest = std::max(same_surface * height_, size);
    std::string words;
    for (const results::SlipSurface& m : minima->second) {
      if (!m.factor || m.points.size() < 2) continue;
      const double mean = find_mean_distance(m.points, line);
      if (mean >= nearest) continue;
      nearest = mean;
      words = fmt::format("; a local minimum of {} ({:.3f}) lies {} from it", get_title(surface_->surface.method),
                          *m.factor, format_length(run_, mean, 2));
    }
    return words;
  }

  std::string describe_handed(const std::string& from) const {
    for (const results::HandedSurface& h : methods_.handed) {
      if (h.from != from || h.to != results::to_word(SliceMethod::spencer) || !h.factor) continue;
      return fmt::format(", and Spencer on it gives {:.3f}, {} {} ({:.3f})", *h.factor, compare(*h.factor, *slices_),
                         name_, *slices_);
    }
    return "";
  }

  void read_seconds() {
    std::vector<std::string> parts;
    const auto add = [&](const char* words, double seconds) {
      if (seconds > 0) parts.push_back(fmt::format("{} {:.3g} s", words, seconds));
    };
    add("LEM", run_.slices ? run_.slices->seconds : 0);
    add("FEM", run_.elements ? run_.elements->seconds.value_or(0) : 0);
    add("limit analysis", run_.bounds ? run_.bounds->seconds.value_or(0) : 0);
    for (const results::MethodRow& row : methods_.table)
      if (row.method == Method::mpm && row.seconds) add("MPM", *row.seconds);
    if (parts.size() > 1) say("Computing time: {}.", fmt::join(parts, ", "));
  }

  const input::Case& data_;
  const results::RunResult& run_;
  const results::MethodComparison& methods_;
  double height_;
  const results::CriticalSurface* surface_ = nullptr;  ///< the governing LEM surface
  std::optional<double> slices_, frozen_;
  std::string name_, place_;  ///< of the surface: "Spencer's polyline", "the critical polyline of Spencer"
  const results::ElementRun *given_ = nullptr, *associated_ = nullptr;
  results::Topic topic_ = results::Topic::agreement;
  std::vector<results::Remark> remarks_;
};

}  // namespace

bool is_nonassociated(const input::Case& data) {
  return std::any_of(data.regions.begin(), data.regions.end(), [&](const auto& region) {
    const input::Material m = input::find_limit_soil(data.materials.at(region.second));
    if (material::needs<material::FlowRatio>(m.model)) return m.dilatancy_ratio < 1;
    return m.friction_angle > 0 && m.dilatancy_angle < m.friction_angle - 1e-9;
  });
}

std::vector<results::Remark> read_differences(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods) {
  return Reading(data, run, methods).read();
}

}  // namespace talus::run
