// SPDX-License-Identifier: MIT
// Search on whole numbers, such as rows of nails, by doubled steps and bisection.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>

#include "study/root_search.hpp"

namespace talus::study {

using results::BackAnalysisBracket;
using results::BackAnalysisEnd;

namespace {

class WholeSearch {
 public:
  WholeSearch(const RootOptions& options, const Evaluate& evaluate)
      : options_(options),
        evaluate_(evaluate),
        low_(std::ceil(options.range.low)),
        high_(std::floor(options.range.high)) {}

  RootFinding run() {
    if (options_.is_given)
      scan();
    else
      expand();
    std::optional<Pair> pair = find_pair();
    while (pair && pair->b - pair->a > 1 && halve(*pair)) pair = find_pair();
    conclude(pair);
    return std::move(finding_);
  }

 private:
  /// Two numbers of which one has at least the target; between them only undefined ones were tried.
  struct Pair {
    double a, b;
  };

  std::optional<double> sample(double x) {
    auto at = samples_.find(x);
    if (at == samples_.end()) {
      Sample made = evaluate_(x);
      made.x = x;
      at = samples_.emplace(x, made).first;
    }
    return at->second.y;
  }
  bool is_tried(double x) const { return samples_.count(x) > 0; }
  double get(double x) const { return *samples_.at(x).y; }
  bool is_met(double x) const { return get(x) >= options_.target; }

  std::vector<Pair> list_pairs() const {
    std::vector<Pair> pairs;
    std::optional<double> last;
    for (const auto& [x, s] : samples_) {
      if (!s.y) continue;
      if (last && is_met(*last) != is_met(x)) pairs.push_back({*last, x});
      last = x;
    }
    return pairs;
  }

  /// Returns the pair nearest to the start.
  std::optional<Pair> find_pair() const {
    const std::vector<Pair> pairs = list_pairs();
    if (pairs.empty()) return std::nullopt;
    const double near = options_.is_given ? 0.5 * (low_ + high_) : *options_.start;
    const auto distance = [&](const Pair& p) { return std::max({p.a - near, near - p.b, 0.0}); };
    return *std::min_element(pairs.begin(), pairs.end(),
                             [&](const Pair& p, const Pair& q) { return distance(p) < distance(q); });
  }

  void scan() {
    for (const double part : {0.0, 1.0, 0.5, 0.25, 0.75}) {
      sample(std::round(low_ + part * (high_ - low_)));
      if (find_pair()) return;
    }
    approach_edges();
  }

  /// Expands from the start, at first upwards if its value is too small: most keys add to resistance.
  void expand() {
    const std::optional<double> first = sample(*options_.start);
    if (!first) return;
    const double guess = *first < options_.target ? 1 : -1;
    for (const double direction : {guess, -guess}) {
      walk(direction, std::abs(*first - options_.target));
      if (!find_pair()) approach_edges();
      if (find_pair()) return;
    }
  }

  void walk(double direction, double last) {
    double step = 1, x = *options_.start;
    int recessions = 0;
    for (int k = 0; k < most_expansions && recessions < most_recessions; ++k, step *= 2) {
      const double next = std::clamp(x + direction * step, low_, high_);
      if (next == x) return;
      x = next;
      const std::optional<double> here = sample(x);
      if (!here || find_pair()) return;
      const double miss = std::abs(*here - options_.target);
      recessions = miss >= last ? recessions + 1 : 0;
      last = miss;
    }
  }

  /// Bisects between neighbours of which one is undefined, until they follow one another or there is a pair.
  void approach_edges() {
    for (bool is_done = false; !is_done && !find_pair();) {
      is_done = true;
      for (auto a = samples_.begin(), b = std::next(a); b != samples_.end(); a = b++) {
        if (a->second.y.has_value() == b->second.y.has_value() || b->first - a->first <= 1) continue;
        sample(std::floor(0.5 * (a->first + b->first)));
        is_done = false;
        break;
      }
    }
  }

  /// Tries the number nearest to the middle that was not tried; false if there is none.
  bool halve(const Pair& pair) {
    const double middle = std::floor(0.5 * (pair.a + pair.b));
    const auto most = static_cast<std::int64_t>(pair.b - pair.a);
    for (std::int64_t off = 0; off < most; ++off)
      for (const double x : {middle - static_cast<double>(off), middle + static_cast<double>(off)}) {
        if (!(x > pair.a && x < pair.b) || is_tried(x)) continue;
        return sample(x).has_value() || ++gaps_ < most_gaps;
      }
    return false;
  }

  void conclude(const std::optional<Pair>& pair) {
    for (const auto& [x, s] : samples_) finding_.samples.push_back(s);
    const auto make_bracket = [this](const Pair& p) { return BackAnalysisBracket{p.a, p.b, get(p.a), get(p.b)}; };
    if (!pair) {
      finding_.end = judge_missing_root(finding_.samples, options_.target);
      return;
    }
    finding_.bracket = make_bracket(*pair);
    finding_.end = pair->b - pair->a > 1 ? BackAnalysisEnd::gap : BackAnalysisEnd::found;
    if (finding_.end == BackAnalysisEnd::found) finding_.x = is_met(pair->b) ? pair->b : pair->a;
    for (const Pair& p : list_pairs())
      if (p.a != pair->a) finding_.others.push_back(make_bracket(p));
    finding_.largest_reversal = find_reversal(finding_.samples, get(pair->b) - get(pair->a), options_.target);
  }

  const RootOptions& options_;
  const Evaluate& evaluate_;
  const double low_, high_;
  std::map<double, Sample> samples_;
  RootFinding finding_;
  int gaps_ = 0;
};

}  // namespace

RootFinding search_whole_number(const RootOptions& options, const Evaluate& evaluate) {
  return WholeSearch(options, evaluate).run();
}

}  // namespace talus::study
