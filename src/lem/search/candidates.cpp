// SPDX-License-Identifier: MIT
// Factors of kept slip surfaces for many samples of the soils. The weight of a slice is linear in the unit weights, so
// each slice stores the areas of the soils above its base; the strengths are taken from the sample.
#include "lem/search/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "lem/search/search_findings.hpp"
#include "lem/slices/slices.hpp"

namespace talus::lem {

namespace {

/// The factor of a method is predicted by the quick factor times the ratio of the two with the mean soils. The
/// prediction is assumed to be within this fraction; surfaces predicted further above the smallest factor are not
/// solved.
constexpr double margin = 0.03;
/// Switches the wedge check off: the search has made it with the mean soils, and it does not hold for those of a
/// sample.
constexpr double judged_once = std::numeric_limits<double>::infinity();
constexpr int kept_trials = 60;  ///< distinct trial circles with the lowest factors that are kept of each search

bool is_same(const Slope& slope, const Surface& a, const Surface& b, double most) {
  return measure_overlap(slope, a, b) > most;
}

/// Returns the surfaces of one search: its local minima, and distinct trial circles in the order of their factors.
std::vector<Surface> choose_surfaces(const Slope& slope, const SearchResult& result) {
  std::vector<Surface> surfaces;
  for (const auto& minima : result.minima)
    for (const Critical& c : minima) surfaces.push_back(c.surface);
  for (const Critical& c : result.noncircular) surfaces.push_back(c.surface);
  std::vector<const TriedCircle*> trials;
  for (const TriedCircle& t : result.trials)
    if (t.factors.front() > 0) trials.push_back(&t);
  std::stable_sort(trials.begin(), trials.end(), [](auto* a, auto* b) { return a->factors[0] < b->factors[0]; });
  int taken = 0;
  for (std::size_t i = 0; i < trials.size() && i < 3000 && taken < kept_trials; ++i) {
    const bool known = std::any_of(surfaces.begin(), surfaces.end(),
                                   [&](const Surface& s) { return is_same(slope, s, trials[i]->surface, 0.93); });
    if (!known) surfaces.push_back(trials[i]->surface), ++taken;
  }
  return surfaces;
}

/// Returns the section with one unit weight of 2 and all others of 1. The weight beyond that with all of 1 is the area
/// of that soil.
Section weigh(Section section, std::size_t soil, bool wet) {
  for (std::size_t i = 0; i < section.soils.size(); ++i) {
    Soil& s = section.soils[i];
    s.unit_weight = i == soil && !wet ? 2 : 1;
    s.saturated_unit_weight = i == soil && wet ? 2 : 1;
    s.pore_pressure_ratio = 0;
  }
  section.pressure_ratio = nullptr;
  return section;
}

}  // namespace

Candidates::Candidates(const Slope& mean, const std::vector<Section>& corners, const SearchOptions& asked,
                       Method method, int threads)
    : slope_(&mean), method_(method), checks_(asked.checks), slices_(asked.slices) {
  checks_.composite = asked.composite;
  checks_.most_below_wedges = judged_once;
  SearchOptions options = asked;
  options.methods = {method};
  options.threads = 1;
  std::vector<std::vector<Surface>> found(corners.size() + 1);
  // Each task is one search. A corner where no surface is found, such as one without driving forces, adds none.
  parallel_tasks(static_cast<int>(found.size()), threads, [&](int i) {
    try {
      if (i == 0) {
        found[0] = choose_surfaces(mean, search(mean, options));
      } else {
        const Slope corner(corners[static_cast<std::size_t>(i - 1)]);
        found[static_cast<std::size_t>(i)] = choose_surfaces(corner, search(corner, options));
      }
    } catch (const Error& error) {
      if (i == 0 || error.code() == ExitCode::interrupted) throw;
    }
  });
  std::vector<Surface> surfaces;
  for (const auto& own : found)
    for (const Surface& s : own)
      if (std::none_of(surfaces.begin(), surfaces.end(), [&](const Surface& t) { return is_same(mean, s, t, 0.985); }))
        surfaces.push_back(s);
  keep(surfaces);
}

Candidates::Candidates(const Slope& mean, const std::vector<Surface>& surfaces, const SearchOptions& options,
                       Method method)
    : slope_(&mean), method_(method), checks_(options.checks), slices_(options.slices) {
  checks_.composite = options.composite;
  checks_.most_below_wedges = judged_once;
  keep(surfaces);
}

void Candidates::keep(const std::vector<Surface>& surfaces) {
  const Section& section = slope_->section();
  // Cut without r_u, so that the slices have the pore pressure of the water table or grid.
  Section dry = section;
  for (Soil& s : dry.soils) s.pore_pressure_ratio = 0;
  dry.pressure_ratio = nullptr;
  const Slope plain(dry);
  for (const Surface& surface : surfaces) {
    Kept kept;
    kept.cut = cut_surface(plain, surface, slices_, checks_);
    if (!section.bars.empty() && kept.cut.refusal == Refusal::none) cross_bars(*slope_, kept.cut);
    if (kept.cut.refusal == Refusal::none) kept_.push_back(std::move(kept));
  }
  keep_areas();
  compare_methods();
}

void Candidates::keep_areas() {
  const Section& section = slope_->section();
  const Slope unit(weigh(section, section.soils.size(), false));
  std::vector<std::vector<std::vector<Part>>> parts;
  for (const Kept& kept : kept_) parts.emplace_back(kept.cut.slices.size());
  for (std::size_t soil = 0; soil < section.soils.size(); ++soil)
    for (const bool wet : {false, true}) {
      const Slope one(weigh(section, soil, wet));
      for (std::size_t k = 0; k < kept_.size(); ++k) {
        for (std::size_t i = 0; i < kept_[k].cut.slices.size(); ++i) {
          const Slice a = weigh_slice(unit, kept_[k].cut.slices[i]), b = weigh_slice(one, kept_[k].cut.slices[i]);
          const double area = b.weight - a.weight, moment = b.weight * b.centroid - a.weight * a.centroid;
          if (area < 1e-12 * a.weight) continue;
          auto& own = parts[k][i];
          if (own.empty() || own.back().soil != static_cast<int>(soil)) own.push_back({static_cast<int>(soil)});
          (wet ? own.back().wet : own.back().dry) = area;
          (wet ? own.back().wet_moment : own.back().dry_moment) = moment;
        }
      }
    }
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    Kept& kept = kept_[k];
    kept.first.push_back(0);
    for (const auto& own : parts[k]) {
      kept.parts.insert(kept.parts.end(), own.begin(), own.end());
      kept.first.push_back(static_cast<int>(kept.parts.size()));
    }
    // The moment of everything but the weights.
    CutSurface weightless = kept.cut;
    for (Slice& slice : weightless.slices) slice.weight = 0;
    kept.mass.set(*slope_, weightless, 0);
    kept.fixed_moment = kept.mass.moment;
  }
}

void Candidates::compare_methods() {
  const Section& section = slope_->section();
  Workspace work;
  find_tangents(section.soils, work);
  double least = 0;
  for (Kept& kept : kept_) {
    const int number = static_cast<int>(&kept - kept_.data());
    const double quick =
        find_quick(kept, section.soils, section.horizontal_acceleration, section.vertical_acceleration, work);
    const double own = find_factor(number, section.soils, section.horizontal_acceleration,
                                   section.vertical_acceleration, method_, work);
    kept.ratio = quick > 0 && own > 0 ? own / quick : 0;
    if (kept.ratio > 0 && (least == 0 || kept.ratio < least)) least = kept.ratio;
  }
  for (Kept& kept : kept_)
    if (kept.ratio == 0) kept.ratio = least > 0 ? least : 1;  // smallest ratio if rejected with the mean soils
}

Candidates::Strength Candidates::find_strength(const Soil& soil, double tan_friction, double weight,
                                               const Slice& slice) const {
  Strength strength{soil.cohesion + slice.root_cohesion, slice.pore_pressure};
  if (soil.cohesion_gradient != 0) {
    const double y = 0.5 * (slice.base_left[1] + slice.base_right[1]);
    strength.cohesion += soil.cohesion_gradient * std::max(0.0, soil.cohesion_level - y);
  }
  if (soil.undrained) return strength;
  const Point base{0.5 * (slice.left + slice.right), 0.5 * (slice.base_left[1] + slice.base_right[1])};
  if (const double ratio = slope_->section().find_pressure_ratio(soil, base); ratio > 0) {
    strength.pore_pressure = ratio * weight / (slice.right - slice.left);
  } else if (slice.suction_strength > 0) {
    const Soil& old = slope_->section().soils[static_cast<std::size_t>(slice.soil)];
    const bool phi_b = soil.suction == Suction::phi_b;
    const double then = std::tan(phi_b ? old.phi_b : old.friction_angle);
    if (then > 0) strength.cohesion += slice.suction_strength * (phi_b ? std::tan(soil.phi_b) : tan_friction) / then;
  }
  return strength;
}

/// Returns the weight of a slice in `dry` and its moment about y = 0 in `dry_moment`.
Candidates::Part Candidates::sum_weight(const Kept& kept, std::size_t slice, const std::vector<Soil>& soils) {
  Part sum;
  for (int p = kept.first[slice]; p < kept.first[slice + 1]; ++p) {
    const Part& part = kept.parts[static_cast<std::size_t>(p)];
    const Soil& soil = soils[static_cast<std::size_t>(part.soil)];
    sum.dry += soil.unit_weight * part.dry + soil.saturated_unit_weight * part.wet;
    sum.dry_moment += soil.unit_weight * part.dry_moment + soil.saturated_unit_weight * part.wet_moment;
  }
  return sum;
}

void Candidates::fill(const Kept& kept, const std::vector<Soil>& soils, double vertical, Workspace& work) const {
  // The methods scale all weights by the vertical acceleration of the section.
  const double scale = (1 + vertical) / (1 + slope_->section().vertical_acceleration);
  work.cut = kept.cut;
  for (std::size_t i = 0; i < work.cut.slices.size(); ++i) {
    Slice& slice = work.cut.slices[i];
    const Part sum = sum_weight(kept, i, soils);
    slice.weight = scale * sum.dry;
    if (sum.dry > 0) slice.centroid = sum.dry_moment / sum.dry;
    const Soil& soil = soils[static_cast<std::size_t>(slice.soil)];
    slice.tan_friction = std::tan(soil.friction_angle);
    const Strength strength = find_strength(soil, slice.tan_friction, sum.dry, slice);
    slice.cohesion = strength.cohesion, slice.pore_pressure = strength.pore_pressure;
  }
}

double Candidates::find_quick(const Kept& kept, const std::vector<Soil>& soils, double horizontal, double vertical,
                              Workspace& work) const {
  horizontal = slope_->section().turn_to_sliding(horizontal, kept.cut.slides_left);
  Mass& mass = work.mass;
  mass = kept.mass;
  mass.moment = kept.fixed_moment;
  mass.scale = 0;
  const double way = kept.cut.slides_left ? -1 : 1, xo = way * kept.cut.moment_centre[0],
               yo = kept.cut.moment_centre[1];
  const auto size = kept.cut.slices.size();
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = kept.cut.slides_left ? size - 1 - i : i;
    const Slice& shape = kept.cut.slices[at];
    const Part sum = sum_weight(kept, at, soils);
    const auto soil = static_cast<std::size_t>(shape.soil);
    const double tan_friction = work.tan_friction[soil];
    const Strength strength = find_strength(soils[soil], tan_friction, sum.dry, shape);
    Wedge& wedge = mass.wedges[i];
    wedge.friction = tan_friction;
    wedge.uplift = std::max(0.0, strength.pore_pressure) * shape.length;
    wedge.strength = strength.cohesion * shape.length - wedge.uplift * tan_friction;
    const double x = way * 0.5 * (shape.left + shape.right);
    wedge.down += (1 + vertical) * sum.dry;
    wedge.push += horizontal * sum.dry;
    mass.moment += (xo - x) * (1 + vertical) * sum.dry + horizontal * (yo * sum.dry - sum.dry_moment);
    mass.scale += wedge.down;
  }
  const bool circular = kept.cut.surface.circle.has_value();
  const FelleniusSums sums = sum_fellenius(mass, circular);
  const double start = sums.driving > 0 && sums.resisting > 0 ? sums.find_factor() : 0;
  if (method_ == Method::fellenius) return start;
  int iterations = 0;
  const bool forces = method_ == Method::janbu || method_ == Method::janbu_corrected || has_given_inclinations(method_);
  return solve_simplified(mass, method_ == Method::bishop || (circular && !forces), start, iterations);
}

void Candidates::find_tangents(const std::vector<Soil>& soils, Workspace& work) {
  work.tan_friction.resize(soils.size());
  for (std::size_t i = 0; i < soils.size(); ++i) work.tan_friction[i] = std::tan(soils[i].friction_angle);
}

double Candidates::find_factor(int surface, const std::vector<Soil>& soils, double horizontal, double vertical,
                               Method method, Workspace& work) const {
  fill(kept_[static_cast<std::size_t>(surface)], soils, vertical, work);
  const double scale = (1 + slope_->section().vertical_acceleration) / (1 + vertical);
  const double acting = slope_->section().turn_to_sliding(horizontal * scale, work.cut.slides_left);
  return solve_with(*slope_, work.cut, method, checks_, false, acting).factor;
}

double Candidates::find_factor(const std::vector<Soil>& soils, double horizontal, double vertical,
                               Workspace& work) const {
  double smallest = 0;
  work.smallest = -1;
  work.order.clear();
  find_tangents(soils, work);
  for (int i = 0; i < count(); ++i) {
    const Kept& kept = kept_[static_cast<std::size_t>(i)];
    work.order.push_back({kept.ratio * find_quick(kept, soils, horizontal, vertical, work), i});
  }
  std::sort(work.order.begin(), work.order.end());
  // The quick factor takes bars as they bear with the mean soils.
  const bool exact = slope_->section().bars.empty() &&
                     (method_ == Method::fellenius || method_ == Method::bishop || method_ == Method::janbu);
  for (const auto& [guess, i] : work.order) {
    // A quick factor of 0 (no driving force or no solution) predicts nothing, so the method itself is evaluated.
    if (guess > 0 && smallest > 0 && guess > (exact ? 1 : 1 + margin) * smallest) break;
    const double factor = find_factor(i, soils, horizontal, vertical, method_, work);
    if (factor > 0 && (smallest == 0 || factor < smallest)) smallest = factor, work.smallest = i;
  }
  return smallest;
}

}  // namespace talus::lem
