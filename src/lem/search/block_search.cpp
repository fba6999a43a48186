// SPDX-License-Identifier: MIT
// Polylines through windows or along a path: their geometry, the trials, and the optimisation within the windows.
#include "lem/search/block_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/numbers.hpp"
#include "base/parallel.hpp"
#include "lem/search/optimise.hpp"
#include "lem/search/search_findings.hpp"
#include "lem/search/trial_circles.hpp"
#include "lem/section/strips.hpp"
#include "lem/slices/wedge_mechanism.hpp"

namespace talus::lem {

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Relative thickness of a path below which it is a line.
constexpr double thin = 1e-9;
/// Two masses with a greater overlap lead to the same minimum.
constexpr double same_start = 0.9, same_minimum = 0.8;

double find_middle(const Window& window) {
  const auto [low, high] = std::minmax_element(window.points.begin(), window.points.end());
  return 0.5 * ((*low)[0] + (*high)[0]);
}

std::size_t count_parameters(const Window& window) {
  return window.is_box ? 2 : window.points.size() > 1 ? 1 : 0;
}

/// Returns the point of a polyline at a fraction of its length.
Point walk(const std::vector<Point>& line, double fraction) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  double left = std::clamp(fraction, 0.0, 1.0) * length;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point &a = line[i - 1], &b = line[i];
    const double own = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (left <= own || i + 1 == line.size()) {
      const double t = own > 0 ? std::min(1.0, left / own) : 0;
      return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
    }
    left -= own;
  }
  return line.front();
}

/// Returns number `index` of the Halton sequence to a prime base, in (0, 1).
double compute_halton(int index, int base) {
  double value = 0, part = 1;
  for (int i = index; i > 0; i /= base) {
    part /= base;
    value += part * (i % base);
  }
  return value;
}

}  // namespace

BlockFamily::BlockFamily(const Slope& slope, const BlockSearch& search, int direction)
    : slope_(&slope), search_(search), direction_(direction), near_(1e-7 * (slope.right() - slope.left())) {
  std::stable_sort(search_.windows.begin(), search_.windows.end(),
                   [](const Window& a, const Window& b) { return find_middle(a) < find_middle(b); });
  // Lines run from left to right, or from the bottom up, so that a mirrored window has the same parameters.
  for (Window& w : search_.windows)
    if (!w.is_box && w.points.back() < w.points.front()) std::reverse(w.points.begin(), w.points.end());
  for (const Window& w : search_.windows) places_ += count_parameters(w);
  if (!search_.path.bottom.empty()) places_ = 3;
}

std::vector<Point> BlockFamily::follow_path(const std::vector<double>& parameters, bool falls_left) const {
  const auto &bottom = search_.path.bottom, &top = search_.path.top;
  const double left = bottom.front()[0], width = bottom.back()[0] - left;
  const auto place = [&](double t) { return left + width * (falls_left ? t : 1 - t); };
  const double from = std::min(place(parameters[1]), place(parameters[2])),
               to = std::max(place(parameters[1]), place(parameters[2])), level = parameters[3];
  const auto find = [&](double x) {
    const double low = follow_line(bottom, x), high = follow_line(top, x);
    // Just inside the layer: along a boundary the upper soil counts.
    const double inset = std::min(3 * near_, 0.1 * (high - low));
    return Point{x, low + inset + level * (high - low - 2 * inset)};
  };
  std::vector<Point> points{find(from)};
  for (const Point& p : bottom)
    if (p[0] > from + near_ && p[0] < to - near_) points.push_back(find(p[0]));
  points.push_back(find(to));
  return points;
}

std::optional<std::vector<Point>> BlockFamily::place_vertices(const std::vector<double>& parameters,
                                                              bool falls_left) const {
  std::vector<Point> points;
  if (!search_.path.bottom.empty()) {
    points = follow_path(parameters, falls_left);
  } else {
    std::size_t n = 1;
    const std::size_t count = search_.windows.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Window& w = search_.windows[falls_left ? i : count - 1 - i];
      if (w.is_box) {
        const double tx = falls_left ? parameters[n] : 1 - parameters[n], ty = parameters[n + 1];
        points.push_back({w.points[0][0] + tx * (w.points[1][0] - w.points[0][0]),
                          w.points[0][1] + ty * (w.points[1][1] - w.points[0][1])});
      } else if (w.points.size() == 1) {
        points.push_back(w.points.front());
      } else {
        // A line is walked from the lower side of the slope; one that is vertical from the bottom up.
        const bool is_vertical = std::abs(w.points.back()[0] - w.points.front()[0]) < near_;
        points.push_back(walk(w.points, falls_left || is_vertical ? parameters[n] : 1 - parameters[n]));
      }
      n += count_parameters(w);
    }
    if (!falls_left) std::reverse(points.begin(), points.end());
  }
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i][0] - points[i - 1][0] < near_) return std::nullopt;
  return points;
}

std::optional<Point> BlockFamily::find_end(const Point& from, int way, double angle) const {
  const double rise = std::tan(angle);
  const std::vector<Point>& ground = slope_->section().ground;
  const auto above = [&](const Point& p) { return from[1] + rise * way * (p[0] - from[0]) - p[1]; };
  Point last{from[0], slope_->ground(from[0])};
  const auto count = ground.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& p = ground[way > 0 ? i : count - 1 - i];
    if (way * (p[0] - from[0]) <= 0) continue;
    const double a = above(last), b = above(p);
    if (b >= 0) {
      const double t = b > a ? std::clamp(-a / (b - a), 0.0, 1.0) : 1;
      return Point{last[0] + t * (p[0] - last[0]), last[1] + t * (p[1] - last[1])};
    }
    last = p;
  }
  return std::nullopt;
}

std::optional<Surface> BlockFamily::make(const std::vector<double>& parameters, bool falls_left) const {
  const auto points = place_vertices(parameters, falls_left);
  if (!points || points->size() < 2) return std::nullopt;
  const auto incline = [&](const std::array<double, 2>& range, double t) {
    return range[0] + t * (range[1] - range[0]);
  };
  const double passive = incline(search_.passive, parameters.front()),
               active = incline(search_.active, parameters.back());
  Surface surface;
  for (const int way : {-1, 1}) {
    const Point& p = way < 0 ? points->front() : points->back();
    const double depth = slope_->ground(p[0]) - p[1];
    if (depth < -10 * near_) return std::nullopt;
    if (way > 0) surface.line.insert(surface.line.end(), points->begin(), points->end());
    if (depth <= 10 * near_) continue;  // this vertex is the end
    const bool is_lower = (way < 0) == falls_left;
    const auto end = find_end(p, way, is_lower ? passive : active);
    if (!end || std::abs((*end)[0] - p[0]) < near_) return std::nullopt;
    surface.line.push_back(*end);
  }
  const auto is_in = [&](const std::optional<std::array<double, 2>>& range, double x) {
    return !range || (x >= (*range)[0] - near_ && x <= (*range)[1] + near_);
  };
  surface.from = surface.line.front()[0];
  surface.to = surface.line.back()[0];
  // Ends of the mass, as the ground above a window may be a heap.
  const double rise = surface.line.back()[1] - surface.line.front()[1];
  if (falls_left ? rise < 0 : rise > 0) return std::nullopt;
  if (!is_in(search_.exit, falls_left ? surface.from : surface.to) ||
      !is_in(search_.entry, falls_left ? surface.to : surface.from))
    return std::nullopt;
  return surface;
}

std::vector<std::vector<double>> BlockFamily::spread(int seed) const {
  const auto count_angles = [&](const std::array<double, 2>& range) {
    return range[1] > range[0] ? search_.angles : 1;
  };
  std::vector<int> counts(size(), 1);
  counts.front() = count_angles(search_.passive);
  counts.back() = count_angles(search_.active);
  double free = static_cast<double>(places_), rest = 1.0 * search_.surfaces / (counts.front() * counts.back());
  if (!search_.path.bottom.empty()) {
    bool is_line = true;
    for (std::size_t i = 0; i < search_.path.bottom.size(); ++i)
      is_line =
          is_line && search_.path.top[i][1] - search_.path.bottom[i][1] <= thin * (slope_->right() - slope_->left());
    counts[3] = is_line ? 1 : 3;
    free = 2;
    rest *= 2.0 / counts[3];  // of two places only those in their order count
  }
  const int each = free > 0 ? static_cast<int>(std::floor(std::pow(std::max(rest, 1.0), 1 / free) + 1e-9)) : 1;
  std::vector<std::vector<double>> all;
  // A lattice with fewer places on each axis misses too much between them.
  constexpr int coarsest = 5;
  constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61};
  if (free > 0 && each < coarsest) {
    for (int i = 1; i <= search_.surfaces; ++i) {
      std::vector<double>& p = all.emplace_back();
      for (std::size_t k = 0; k < size(); ++k) p.push_back(compute_halton(i + 7919 * seed, primes[k % primes.size()]));
    }
    return all;
  }
  for (std::size_t k = 1; k + 1 < size(); ++k)
    if (search_.path.bottom.empty() || k < 3) counts[k] = each;
  RandomParts parts(seed);
  std::vector<int> at(size(), 0);
  while (true) {
    std::vector<double>& p = all.emplace_back();
    for (std::size_t k = 0; k < size(); ++k) {
      const double moved = at[k] + (seed > 0 && counts[k] > 1 ? 0.49 * parts.draw() : 0);
      p.push_back(counts[k] > 1 ? std::clamp(moved / (counts[k] - 1), 0.0, 1.0) : 0.5);
    }
    std::size_t k = 0;
    while (k < size() && ++at[k] == counts[k]) at[k++] = 0;
    if (k == size()) return all;
  }
}

namespace {

struct Trial {
  std::vector<double> parameters;
  bool falls_left = true;
};

struct Found {
  Trial trial;
  OptimisedSurface surface;
};

/// Optimises one trial within the windows; the result passes all checks, or is refused.
Found improve(const Slope& slope, const SearchOptions& options, Method method, const BlockFamily& family,
              const Trial& start) {
  Evaluator evaluate(slope, method, options.checks, options.slices, options.ends_at_signal);
  const auto function = [&](const std::vector<double>& x) {
    const auto surface = family.make(x, start.falls_left);
    return surface ? evaluate(*surface) : Evaluator::refused;
  };
  const std::vector<double> lower(family.size(), 0), upper(family.size(), 1);
  std::vector<double> at = start.parameters;
  double value = Evaluator::refused;
  const int most = 60 * static_cast<int>(family.size());
  // A simplex that has collapsed against a limit of the checks continues from a new one on the other side.
  int idle = 0;
  for (const double reach : {1.0, -0.7, 0.5, -0.35, 0.25, -0.1}) {
    const std::vector<double> step(family.size(), reach * family.step());
    const Minimum m = minimise(function, at, step, lower, upper, {Minimiser::simplex, 1e-7, most});
    if (m.value < value) at = m.at;
    const double gain = value - m.value;
    value = std::min(value, m.value);
    idle = gain < 1e-6 * value ? idle + 1 : 0;
    if (idle == 2) break;
  }
  const OptimisedSurface best = evaluate.passing();
  Found found{{at, start.falls_left}, {{}, Evaluator::refused, best.evaluations}};
  if (best.factor < Evaluator::refused && evaluate.passes_all_checks(best.surface)) found.surface = best;
  return found;
}

/// Returns the numbers of the best trials that differ from one another.
std::vector<std::size_t> choose_trials(const Slope& slope, const SearchResult& result, std::size_t method,
                                       std::size_t count) {
  std::vector<std::size_t> order, chosen;
  for (std::size_t i = 0; i < result.trials.size(); ++i)
    if (result.trials[i].factors[method] > 0) order.push_back(i);
  const auto factor = [&](std::size_t i) { return result.trials[i].factors[method]; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return factor(a) < factor(b); });
  for (const std::size_t i : order) {
    if (chosen.size() == count) break;
    if (std::none_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
          return measure_overlap(slope, result.trials[i].surface, result.trials[other].surface) > same_start;
        }))
      chosen.push_back(i);
  }
  return chosen;
}

/// Adds the ends whose inclination lies at a limit of its range. A window on the ground is an end without one.
void add_angle_hits(const BlockFamily& family, Method method, const Found& found, SearchResult& result) {
  constexpr double near = 1e-3;
  const std::vector<Point>& line = found.surface.surface.line;
  const auto check = [&](const Point& end, const Point& inner, const std::array<double, 2>& range, const char* name,
                         const char* key) {
    const double width = range[1] - range[0];
    const double t = (std::atan2(end[1] - inner[1], std::abs(end[0] - inner[0])) - range[0]) / width;
    if (!(width > 0) || std::min(std::abs(t), std::abs(t - 1)) > near) return;
    result.limit_hits.push_back(
        {method,
         fmt::format("the {} end of the critical block rises at {:.4g}°, an end of the range searched ({:.4g}° "
                     "to {:.4g}°); widen [lem.block] {}",
                     name, (t > 0.5 ? range[1] : range[0]) / degree, range[0] / degree, range[1] / degree, key)});
  };
  const bool is_left = found.trial.falls_left;
  const std::size_t last = line.size() - 1;
  check(line[is_left ? 0 : last], line[is_left ? 1 : last - 1], family.search().passive, "lower", "passive");
  check(line[is_left ? last : 0], line[is_left ? last - 1 : 1], family.search().active, "upper", "active");
}

/// Solves the trials without the check of their wedges. Blocks with low factors often fail it, and the best blocks that
/// pass it lie near them.
SearchResult solve_without_wedges(const Slope& slope, SearchOptions options, Method method,
                                  const TrialCircles& blocks) {
  options.methods = {method};
  options.checks.most_below_wedges = std::numeric_limits<double>::infinity();
  SearchResult result;
  solve_trials(slope, options, blocks, result);
  return result;
}

/// Adds a warning if a block has a lower factor than the critical one but fails the check of its wedges: programs
/// without this check have its factor as their result.
void warn_of_kinks(const Slope& slope, const SearchOptions& options, const BlockFamily& family, const Trial& start,
                   Method method, SearchResult& result) {
  SearchOptions lenient = options;
  lenient.checks.most_below_wedges = std::numeric_limits<double>::infinity();
  const OptimisedSurface lowest = improve(slope, lenient, method, family, start).surface;
  const auto own = std::find_if(result.noncircular.begin(), result.noncircular.end(),
                                [&](const Critical& c) { return c.method == method; });
  if (lowest.factor >= Evaluator::refused) return;
  if (own != result.noncircular.end() && lowest.factor > (1 - options.checks.most_below_wedges) * own->solution.factor)
    return;
  const CutSurface cut = cut_surface(slope, lowest.surface, options.slices, lenient.checks);
  const Section& section = slope.section();
  WedgeMechanism wedges;
  wedges.set(slope, cut, section.turn_to_sliding(section.horizontal_acceleration, cut.slides_left));
  result.warnings.push_back(fmt::format(
      "{} has a factor of {:.3f} on a block that is rejected, because its kinks would slide without strength: the "
      "wedge "
      "mechanism of this block, with strength on the interfaces of the wedges, has {:.3f}. Programs without this check "
      "print the lower factor",
      get_title(method), lowest.factor, wedges.search_factor(lowest.factor)));
}

/// Optimises the starts, and then perturbations of the best result. Returns all, the best first.
std::vector<Found> improve_all(const Slope& slope, const SearchOptions& options, Method method,
                               const BlockFamily& family, const std::vector<Trial>& starts) {
  constexpr int perturbations = 6;
  constexpr double reach = 0.15;
  const auto run = [&](const std::vector<Trial>& from, std::vector<Found>& found) {
    std::vector<Found> own(from.size());
    parallel_tasks(static_cast<int>(from.size()), options.threads, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      own[k] = improve(slope, options, method, family, from[k]);
    });
    found.insert(found.end(), own.begin(), own.end());
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.surface.factor < b.surface.factor; });
  };
  std::vector<Found> found;
  run(starts, found);
  if (found.empty() || found.front().surface.factor >= Evaluator::refused) return found;
  RandomParts parts(options.seed);
  std::vector<Trial> near(perturbations, found.front().trial);
  for (Trial& trial : near)
    for (double& p : trial.parameters) p = std::clamp(p + reach * parts.draw(), 0.0, 1.0);
  run(near, found);
  return found;
}

}  // namespace

void search_blocks(const Slope& slope, const SearchOptions& options, SearchResult& result) {
  const BlockFamily family(slope, *options.block, options.checks.limits ? options.checks.limits->direction : 0);
  result.block = family.search();
  TrialCircles blocks;
  std::vector<Trial> trials;
  for (const bool falls_left : {true, false}) {
    if (!family.is_searched(falls_left)) continue;
    for (const std::vector<double>& p : family.spread(options.seed)) {
      const auto surface = family.make(p, falls_left);
      if (!surface) continue;
      blocks.surfaces.push_back(*surface);
      trials.push_back({p, falls_left});
    }
  }
  solve_trials(slope, options, blocks, result);
  result.minima.resize(options.methods.size());
  blocks.left = blocks.right = {slope.left(), slope.right()};
  for (std::size_t m = 0; m < options.methods.size(); ++m) {
    const Method method = options.methods[m];
    if (!suits_polylines(method)) continue;
    const auto count = static_cast<std::size_t>(options.kept_minima) + 3;
    std::vector<Trial> starts;
    for (const std::size_t i : choose_trials(slope, result, m, count)) starts.push_back(trials[i]);
    std::optional<Trial> without_wedges;
    if (result.refused[m].count(Refusal::kinks) > 0)
      for (const std::size_t i :
           choose_trials(slope, solve_without_wedges(slope, options, method, blocks), 0, count / 2)) {
        starts.push_back(trials[i]);
        if (!without_wedges) without_wedges = trials[i];
      }
    const std::vector<Found> found = improve_all(slope, options, method, family, starts);
    for (const Found& f : found) {
      auto& minima = result.minima[m];
      if (f.surface.factor >= Evaluator::refused || static_cast<int>(minima.size()) == options.kept_minima) break;
      const bool is_known = std::any_of(minima.begin(), minima.end(), [&](const Critical& other) {
        return measure_overlap(slope, f.surface.surface, other.surface) > same_minimum;
      });
      if (is_known) continue;
      minima.push_back(make_critical(slope, options, f.surface.surface, method));
      if (minima.size() > 1) continue;
      add_angle_hits(family, method, f, result);
      const auto hits = find_limit_hits(slope, options, result, blocks, minima.front(), -1);
      result.limit_hits.insert(result.limit_hits.end(), hits.begin(), hits.end());
      result.noncircular.push_back(minima.front());
    }
    if (without_wedges) warn_of_kinks(slope, options, family, *without_wedges, method, result);
    if (result.minima[m].empty())
      result.limit_hits.push_back(
          {method, fmt::format("no admissible block, {}", describe_refusals(result.refused[m], result.tried))});
  }
}

}  // namespace talus::lem
