// SPDX-License-Identifier: MIT
#include "study/root_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/numbers.hpp"

namespace talus::study {

using results::BackAnalysisBracket;
using results::BackAnalysisEnd;

namespace {

/// Undefined arguments in succession that end it.
constexpr int most_undefined = 2;
/// Runs between an argument with a value and one without, and on either side of an extreme value.
constexpr int most_edges = 6, most_extremes = 3;
/// Runs of one narrowing: bisection alone reduces the bracket by 2^60.
constexpr int most_steps = 60;
/// Runs outside the bracket for an end of the interval.
constexpr int most_interval_steps = 8;
/// Width of the bracket of an interval's end, relative to its distance from the root.
constexpr double interval_tolerance = 0.1;
/// Values that differ by less, relative to the target, are equal up to the scatter of searches for slip surfaces.
constexpr double scatter = 3e-3;
/// A bracket within the tolerance is a jump if the value changes over it this many times as fast as beside it.
constexpr double jump_ratio = 20;
constexpr double equal = 1e-9;

double compute_scale(const std::vector<Sample>& samples, double target) {
  double scale = std::abs(target);
  if (scale == 0)
    for (const Sample& s : samples) scale = std::max(scale, std::abs(s.y.value_or(0)));
  return scale;
}

/// Returns the first and the last sample with a value; null without any.
std::array<const Sample*, 2> find_ends(const std::vector<Sample>& samples) {
  std::array<const Sample*, 2> ends{};
  for (const Sample& s : samples)
    if (s.y) ends = {ends[0] == nullptr ? &s : ends[0], &s};
  return ends;
}

class Search {
 public:
  Search(const RootOptions& options, const Evaluate& evaluate) : options_(options), evaluate_(evaluate) {}

  RootFinding run() {
    std::optional<Pair> pair = options_.is_given ? scan() : expand();
    if (pair) {
      const double extent = pair->b.x - pair->a.x;
      pair = narrow(
          *pair, [this](const Sample& s) { return miss(s.y); }, make_root_width(*pair));
      if (!has_gap_) add_interval(*pair, extent);
    }
    conclude(pair);
    return std::move(finding_);
  }

 private:
  using Miss = std::function<std::optional<double>(const Sample&)>;

  /// Two samples with misses of opposite sign; x of `a` is the smaller one.
  struct Pair {
    Sample a, b;
  };

  std::optional<double> miss(const std::optional<double>& y) const {
    return y ? std::optional(*y - options_.target) : std::nullopt;
  }

  const Sample& sample(double x) {
    const auto at =
        std::lower_bound(samples_.begin(), samples_.end(), x, [](const Sample& s, double v) { return s.x < v; });
    if (at != samples_.end() && at->x == x) return *at;
    Sample made = evaluate_(x);
    made.x = x;
    return *samples_.insert(
        std::lower_bound(samples_.begin(), samples_.end(), x, [](const Sample& s, double v) { return s.x < v; }), made);
  }

  /// Returns all neighbours whose misses have opposite signs; undefined samples between them do not count.
  std::vector<Pair> list_pairs(const Miss& g) const {
    std::vector<Pair> pairs;
    const Sample* last = nullptr;
    for (const Sample& s : samples_) {
      const auto here = g(s);
      if (!here) continue;
      if (last != nullptr && *g(*last) * *here < 0) pairs.push_back({*last, s});
      if (*here == 0) pairs.push_back({s, s});
      last = &s;
    }
    return pairs;
  }

  /// Returns the pair nearest to `near`.
  std::optional<Pair> find_pair(const Miss& g, double near) const {
    const std::vector<Pair> pairs = list_pairs(g);
    if (pairs.empty()) return std::nullopt;
    const auto distance = [&](const Pair& p) { return std::max({p.a.x - near, near - p.b.x, 0.0}); };
    return *std::min_element(pairs.begin(), pairs.end(),
                             [&](const Pair& p, const Pair& q) { return distance(p) < distance(q); });
  }
  std::optional<Pair> find_root_pair() const {
    return find_pair([this](const Sample& s) { return miss(s.y); },
                     options_.start.value_or(0.5 * (options_.range.low + options_.range.high)));
  }

  /// Evaluates the limits of the given range, its middle and its quarters until there is a pair, then approaches
  /// undefined limits.
  std::optional<Pair> scan() {
    const double low = options_.range.low, high = options_.range.high;
    for (const double part : {0.0, 1.0, 0.5, 0.25, 0.75}) {
      const double x = low + part * (high - low);
      sample(part == 0 || part == 1 ? x : round_within(x, 0.01 * (high - low)));
      if (part > 0)
        if (auto pair = find_root_pair()) return pair;
    }
    return approach_edges();
  }

  /// Bisects on both sides of the value nearest to the target, if it has neighbours on both sides.
  std::optional<Pair> approach_extreme() {
    for (int k = 0; k < most_extremes; ++k) {
      std::vector<Sample> defined;
      std::copy_if(samples_.begin(), samples_.end(), std::back_inserter(defined),
                   [](const Sample& s) { return s.y.has_value(); });
      const auto best = std::min_element(defined.begin(), defined.end(), [this](const Sample& a, const Sample& b) {
        return std::abs(*miss(a.y)) < std::abs(*miss(b.y));
      });
      if (best == defined.end() || best == defined.begin() || best + 1 == defined.end()) return std::nullopt;
      const double x = best->x;
      for (const double other : {(best - 1)->x, (best + 1)->x}) {
        sample(round_within(0.5 * (x + other), 0.1 * std::abs(x - other)));
        if (auto pair = find_root_pair()) return pair;
      }
    }
    return std::nullopt;
  }

  /// Bisects between each pair of neighbours of which one is undefined.
  std::optional<Pair> approach_edges() {
    if (auto pair = approach_extreme()) return pair;
    for (int k = 0; k < most_edges; ++k) {
      std::vector<double> middles;
      for (std::size_t i = 1; i < samples_.size(); ++i)
        if (samples_[i - 1].y.has_value() != samples_[i].y.has_value())
          middles.push_back(
              round_within(0.5 * (samples_[i - 1].x + samples_[i].x), 0.1 * (samples_[i].x - samples_[i - 1].x)));
      for (const double x : middles) sample(x);
      if (auto pair = find_root_pair()) return pair;
    }
    return std::nullopt;
  }

  /// Returns argument number k = 1, 2, … from the start in a direction; nullopt beyond the range.
  std::optional<double> compute_step(int direction, int k) const {
    const double start = *options_.start;
    const SearchRange& range = options_.range;
    double x = start + direction * options_.step * (std::exp2(k) - 1);
    const double limit = direction > 0 ? range.high : range.low;
    const bool is_open = direction > 0 ? range.high_open : range.low_open;
    // Half of the remaining distance: the limit is often far from usual values, such as a cohesion of zero.
    if (std::isfinite(limit)) {
      const double nearer = start + (limit - start) * (1 - std::exp2(-k));
      if (direction * (nearer - x) < 0) x = nearer;
      constexpr int last_before_limit = 5;
      if (k > last_before_limit && direction * (limit - x) < std::abs(limit - start) / 16 && !is_open) x = limit;
    }
    x = round_within(x, 0.05 * std::abs(x - start));
    if (k > 1 && std::isfinite(limit) && x == compute_step(direction, k - 1)) return std::nullopt;
    return range.holds(x) ? std::optional(x) : std::nullopt;
  }

  /// Expands from the start in the direction in which the value approaches the target, at first upwards if it is too
  /// small: most keys add to resistance.
  std::optional<Pair> expand() {
    const std::optional<double> first = miss(sample(*options_.start).y);
    if (!first) return std::nullopt;
    if (auto pair = find_root_pair()) {
      // The trend at an exact root needs a second value.
      for (const int direction : {1, -1})
        if (const auto x = compute_step(direction, 1); x && sample(*x).y) break;
      return pair;
    }
    struct Side {
      int direction, steps = 0, recessions = 0, undefined = 0;
      double last;  ///< absolute miss
      bool is_done = false;
    };
    const int guess = *first < 0 ? 1 : -1;
    std::array sides{Side{guess, 0, 0, 0, std::abs(*first)}, Side{-guess, 0, 0, 0, std::abs(*first)}};
    std::size_t now = 0;
    while (!sides[0].is_done || !sides[1].is_done) {
      if (sides[now].is_done) now = 1 - now;
      Side& side = sides[now];
      const std::optional<double> x =
          ++side.steps <= most_expansions ? compute_step(side.direction, side.steps) : std::nullopt;
      const std::optional<double> here = x ? miss(sample(*x).y) : std::nullopt;
      if (x)
        if (auto pair = find_root_pair()) return pair;
      const bool recedes = here && std::abs(*here) >= side.last * (1 - equal);
      side.recessions = recedes ? side.recessions + 1 : 0;
      side.undefined = here ? 0 : side.undefined + 1;
      side.is_done = !x || side.undefined == most_undefined || side.recessions == most_recessions;
      if (here) side.last = std::abs(*here);
      if (recedes || !here) now = 1 - now;
    }
    return approach_edges();
  }

  /// Narrows a pair by Chandrupatla's method (Advances in Engineering Software 28 (1997) 145-149): inverse quadratic
  /// interpolation where it is safe, otherwise bisection; steps of at least half the final width close the bracket
  /// from both sides.
  Pair narrow(Pair pair, const Miss& g, const std::function<double(const Pair&)>& compute_width) {
    Sample newest = pair.b, opposite = pair.a, previous = pair.a;
    std::optional<double> part = *g(newest) / (*g(newest) - *g(opposite));
    int gaps = 0;
    for (int step = 0; step < most_steps && pair.b.x > pair.a.x; ++step) {
      const double width = compute_width(pair), extent = pair.b.x - pair.a.x;
      if (extent <= width || is_resolved(pair, g)) break;
      const double least = std::min(0.5, 0.5 * width / extent);
      double x = newest.x + std::clamp(part.value_or(0.5), least, 1 - least) * (opposite.x - newest.x);
      if (gaps > 0 && !part) x = select_widest_gap(pair, g);
      x = round_within(x, 0.05 * std::min(x - pair.a.x, pair.b.x - x));
      if (x <= pair.a.x || x >= pair.b.x) break;
      const Sample made = sample(x);
      const std::optional<double> here = g(made);
      if (!here) {
        part.reset();
        if (++gaps < most_gaps) continue;
        has_gap_ = true;
        break;
      }
      if (*here == 0) return {made, made};
      if (*here * *g(newest) > 0) {
        previous = newest;
      } else {
        previous = opposite;
        opposite = newest;
      }
      newest = made;
      pair = newest.x < opposite.x ? Pair{newest, opposite} : Pair{opposite, newest};
      part = interpolate({newest.x, *g(newest)}, {opposite.x, *g(opposite)}, {previous.x, *g(previous)});
    }
    return pair;
  }

  using Point = std::array<double, 2>;

  /// Returns the part of the way from `a` to `b` at which a quadratic x(f) through the three points is zero; 0.5 if the
  /// curve may not be monotone between them.
  static double interpolate(Point a, Point b, Point c) {
    const double xi = (a[0] - b[0]) / (c[0] - b[0]), phi = (a[1] - b[1]) / (c[1] - b[1]);
    if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)) return 0.5;
    return a[1] / (b[1] - a[1]) * c[1] / (b[1] - c[1]) +
           (c[0] - a[0]) / (b[0] - a[0]) * a[1] / (c[1] - a[1]) * b[1] / (c[1] - b[1]);
  }

  bool is_resolved(const Pair& pair, const Miss& g) const {
    return std::abs(*g(pair.b) - *g(pair.a)) <= (1 + equal) * std::min(pair.a.resolution, pair.b.resolution);
  }

  /// Returns the middle between the two most distant neighbours, undefined ones included, from pair.a to pair.b.
  double select_widest_gap(const Pair& pair, const Miss& g) const {
    double last = pair.a.x, widest = 0, middle = last;
    for (const Sample& s : samples_) {
      const bool is_between = s.x > pair.a.x && s.x < pair.b.x && !g(s);
      if (!is_between && s.x != pair.b.x) continue;
      if (s.x - last > widest) {
        widest = s.x - last;
        middle = 0.5 * (s.x + last);
      }
      last = s.x;
    }
    return middle;
  }

  std::function<double(const Pair&)> make_root_width(const Pair& first) const {
    const double least = 0.01 * (first.b.x - first.a.x);
    return [this, least](const Pair& p) {
      return options_.tolerance * std::max({std::abs(p.a.x), std::abs(p.b.x), least});
    };
  }

  double interpolate_root(const Pair& p) const {
    if (p.a.x == p.b.x) return p.a.x;
    const double a = *miss(p.a.y), b = *miss(p.b.y);
    return p.a.x + (p.b.x - p.a.x) * a / (a - b);
  }

  /// Searches where the lower and the upper end of the interval reach the target.
  void add_interval(const Pair& root, double first_extent) {
    const double x = interpolate_root(root);
    for (const auto end : {&Sample::lower, &Sample::upper}) {
      if (!(root.a.*end)) continue;
      const Miss g = [this, end](const Sample& s) { return miss(s.*end); };
      std::optional<Pair> pair = find_pair(g, x);
      if (!pair) pair = expand_interval(root, end, g, first_extent);
      if (!pair) continue;
      const auto compute_width = [&](const Pair& p) {
        return std::max(make_root_width(p)(p), interval_tolerance * std::max(std::abs(p.a.x - x), std::abs(p.b.x - x)));
      };
      pair = narrow(*pair, g, compute_width);
      // The excluded side: the lower end of the result is above the target, or its upper end below.
      const bool is_lower = end == &Sample::lower, is_above = (compute_trend(root) > 0) == is_lower;
      const Sample& outer = is_above ? pair->b : pair->a;
      if (is_lower ? *g(outer) < 0 : *g(outer) > 0) continue;  // of another crossing
      (is_above ? finding_.high : finding_.low) = outer.x;
    }
    has_gap_ = false;
  }

  std::optional<Pair> expand_interval(const Pair& root, std::optional<double> Sample::*end, const Miss& g,
                                      double first_extent) {
    const double x = interpolate_root(root), rises = compute_trend(root) > 0 ? 1 : -1;
    const double direction = end == &Sample::lower ? rises : -rises;
    const double fraction = std::abs(*(root.a.*end) - *root.a.y) / std::max(std::abs(*root.a.y), scatter);
    double step =
        std::max(2 * fraction * std::max(std::abs(x), 0.01 * first_extent), 2 * options_.tolerance * std::abs(x));
    for (int k = 0; k < most_interval_steps; ++k, step *= 2) {
      const SearchRange& range = options_.range;
      double next = round_within(x + direction * step, 0.05 * step);
      const bool is_last = !range.holds(next);
      if (is_last) next = direction > 0 ? range.high : range.low;
      if (!std::isfinite(next) || !range.holds(next)) return std::nullopt;
      const Sample made = sample(next);
      if (auto pair = find_pair(g, x)) return pair;
      if (is_last || !g(made)) return std::nullopt;
    }
    return std::nullopt;
  }

  /// Returns the sign of the slope at the root: that between the nearest values outside of the pair.
  double compute_trend(const Pair& root) const {
    if (root.a.x != root.b.x) return *root.b.y - *root.a.y;
    Sample low = root.a, high = root.b;
    for (const Sample& s : samples_) {
      if (!s.y) continue;
      if (s.x < root.a.x) low = s;
      if (s.x > root.b.x) {
        high = s;
        break;
      }
    }
    return *high.y - *low.y;
  }

  /// Returns true if the value changes over a narrow pair much faster than beside it.
  bool is_jump(const Pair& pair) const {
    if (pair.a.x == pair.b.x) return false;
    double beside = 0;
    bool has_neighbour = false;
    const double noise = scatter * compute_scale(samples_, options_.target);
    const Sample* last = nullptr;
    for (const Sample& s : samples_) {
      if (!s.y) continue;
      if (last != nullptr && (s.x <= pair.a.x || last->x >= pair.b.x) && (s.x == pair.a.x || last->x == pair.b.x))
        has_neighbour = true, beside = std::max(beside, (std::abs(*s.y - *last->y) - noise) / (s.x - last->x));
      last = &s;
    }
    const double change = std::abs(*pair.b.y - *pair.a.y);
    return has_neighbour && change > std::max(noise, pair.a.resolution) &&
           change > jump_ratio * beside * (pair.b.x - pair.a.x);
  }

  void conclude(const std::optional<Pair>& pair) {
    finding_.samples = samples_;
    const auto make_bracket = [](const Pair& p) { return BackAnalysisBracket{p.a.x, p.b.x, *p.a.y, *p.b.y}; };
    if (!pair) {
      finding_.end = judge_missing_root(samples_, options_.target);
      const auto [first, last] = find_ends(samples_);
      if (first) finding_.largest_reversal = find_reversal(samples_, *last->y - *first->y, options_.target);
      return;
    }
    finding_.bracket = make_bracket(*pair);
    finding_.end = has_gap_ ? BackAnalysisEnd::gap : is_jump(*pair) ? BackAnalysisEnd::jump : BackAnalysisEnd::found;
    if (finding_.end == BackAnalysisEnd::found) finding_.x = interpolate_root(*pair);
    for (const Pair& p : list_pairs([this](const Sample& s) { return miss(s.y); }))
      if (p.a.x != pair->a.x && p.b.x != pair->b.x) finding_.others.push_back(make_bracket(p));
    finding_.largest_reversal = find_reversal(samples_, compute_trend(*pair), options_.target);
  }

  const RootOptions& options_;
  const Evaluate& evaluate_;
  std::vector<Sample> samples_;  ///< in ascending order
  RootFinding finding_;
  bool has_gap_ = false;
};

}  // namespace

std::optional<double> find_reversal(const std::vector<Sample>& samples, double trend, double target) {
  double extreme = 0, largest = 0, noise = scatter * compute_scale(samples, target);
  bool is_first = true;
  for (const Sample& s : samples) {
    if (!s.y) continue;
    const double y = trend < 0 ? -*s.y : *s.y;
    noise = std::max(noise, s.resolution);
    if (!is_first) largest = std::max(largest, extreme - y);
    extreme = is_first ? y : std::max(extreme, y);
    is_first = false;
  }
  return largest > noise ? std::optional(largest) : std::nullopt;
}

BackAnalysisEnd judge_missing_root(const std::vector<Sample>& samples, double target) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  int count = 0;
  for (const Sample& s : samples) {
    if (!s.y) continue;
    ++count;
    least = std::min(least, *s.y), greatest = std::max(greatest, *s.y);
  }
  if (count == 0) return BackAnalysisEnd::no_result;
  return count > 1 && greatest - least <= equal * compute_scale(samples, target) ? BackAnalysisEnd::no_effect
                                                                                 : BackAnalysisEnd::not_reached;
}

RootFinding search_root(const RootOptions& options, const Evaluate& evaluate) {
  return Search(options, evaluate).run();
}

double round_within(double x, double tolerance) {
  constexpr int all_digits = 17;
  for (int digits = 1; digits < all_digits; ++digits)
    if (const double rounded = round_to_digits(x, digits); std::abs(rounded - x) <= tolerance) return rounded;
  return x;
}

}  // namespace talus::study
