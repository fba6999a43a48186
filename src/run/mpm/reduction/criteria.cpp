// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::run {
namespace {

/// A bend smaller than this fraction of the total rise of the curve is not refined.
constexpr double smallest_bend = 0.02;
/// A displacement below this fraction of the slope height is elastic and no jump.
constexpr double elastic_share = 1e-3;

struct Fit {
  results::Branch branch;
  double squares = 0;
};

/// Fits a line to curve[begin, end) by weighted least squares.
Fit fit_line(const std::vector<CurvePoint>& curve, std::size_t begin, std::size_t end) {
  const auto weight = [&](std::size_t i) {
    const double low = i > 0 ? curve[i - 1].factor : curve[i].factor;
    const double high = i + 1 < curve.size() ? curve[i + 1].factor : curve[i].factor;
    return high - low;
  };
  double w = 0, x = 0, y = 0;
  for (std::size_t i = begin; i < end; ++i) {
    w += weight(i);
    x += weight(i) * curve[i].factor;
    y += weight(i) * curve[i].displacement;
  }
  x /= w;
  y /= w;
  double xx = 0, xy = 0;
  for (std::size_t i = begin; i < end; ++i) {
    xx += weight(i) * (curve[i].factor - x) * (curve[i].factor - x);
    xy += weight(i) * (curve[i].factor - x) * (curve[i].displacement - y);
  }
  Fit fit;
  fit.branch.slope = xx > 0 ? xy / xx : 0;
  fit.branch.intercept = y - fit.branch.slope * x;
  for (std::size_t i = begin; i < end; ++i) {
    const double r = curve[i].displacement - fit.branch.intercept - fit.branch.slope * curve[i].factor;
    fit.squares += weight(i) * r * r;
    fit.branch.factors.push_back(curve[i].factor);
  }
  return fit;
}

/// Returns the index range of the points whose factor lies in [range[0], range[1]].
std::pair<std::size_t, std::size_t> find_range(const std::vector<CurvePoint>& curve, const std::vector<double>& range) {
  constexpr double rounding = 1e-9;
  std::size_t begin = 0, end = 0;
  while (begin < curve.size() && curve[begin].factor < range[0] - rounding) ++begin;
  end = begin;
  while (end < curve.size() && curve[end].factor <= range[1] + rounding) ++end;
  return {begin, end};
}

/// Sets the bracket of `c` to the computed factors on either side of `factor`.
void set_bracket(const std::vector<CurvePoint>& curve, double factor, results::Criterion& c) {
  double lower = curve.front().factor, upper = curve.back().factor;
  for (const CurvePoint& p : curve) {
    if (p.factor <= factor) lower = std::max(lower, p.factor);
    if (p.factor >= factor) upper = std::min(upper, p.factor);
  }
  c.lower = lower;
  c.upper = upper;
}

}  // namespace

std::optional<Bilinear> construct_bilinear(const std::vector<CurvePoint>& curve, const std::vector<double>& first,
                                           const std::vector<double>& last) {
  const std::size_t n = curve.size();
  if (n < 4) return std::nullopt;
  Bilinear b;
  b.criterion.kind = results::CriterionKind::bilinear;
  if (first.size() == 2 && last.size() == 2) {
    const auto [b1, e1] = find_range(curve, first);
    const auto [b2, e2] = find_range(curve, last);
    if (e1 < b1 + 2 || e2 < b2 + 2) return std::nullopt;
    b.first = fit_line(curve, b1, e1).branch;
    b.last = fit_line(curve, b2, e2).branch;
    b.criterion.note = "branches as the case names them";
  } else {
    double best = std::numeric_limits<double>::max();
    for (std::size_t cut = 2; cut + 2 <= n; ++cut) {
      const Fit low = fit_line(curve, 0, cut), high = fit_line(curve, cut, n);
      if (low.squares + high.squares >= best) continue;
      best = low.squares + high.squares;
      b.first = low.branch;
      b.last = high.branch;
    }
    b.criterion.note = "branches chosen by least squares";
  }
  const double difference = b.last.slope - b.first.slope;
  if (difference <= 0) {
    b.criterion.note = "the curve does not steepen, so the lines do not meet in it";
    return b;
  }
  const double factor = (b.first.intercept - b.last.intercept) / difference;
  if (factor < curve.front().factor || factor > curve.back().factor) {
    b.criterion.note = fmt::format("the lines meet at {:.3f}, where no factor was computed", factor);
    return b;
  }
  b.criterion.factor = factor;
  set_bracket(curve, factor, b.criterion);
  return b;
}

results::Criterion find_displacement_criterion(const std::vector<CurvePoint>& curve, double displacement,
                                               const ShownUnit& length) {
  results::Criterion c;
  c.kind = results::CriterionKind::displacement;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const CurvePoint &a = curve[i - 1], &b = curve[i];
    if (a.displacement > displacement || b.displacement < displacement) continue;
    const double share = (displacement - a.displacement) / (b.displacement - a.displacement);
    c.factor = a.factor + share * (b.factor - a.factor);
    c.lower = a.factor;
    c.upper = b.factor;
    return c;
  }
  c.note = fmt::format("no computed factor moves the slope by {}", format_value(displacement, length, 3));
  return c;
}

results::Criterion find_jump_criterion(const std::vector<CurvePoint>& curve, double floor) {
  results::Criterion c;
  c.kind = results::CriterionKind::jump;
  double fastest = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const CurvePoint &a = curve[i - 1], &b = curve[i];
    if (a.displacement < floor) continue;
    const double rate = std::log(b.displacement / a.displacement) / (b.factor - a.factor);
    if (rate <= fastest) continue;
    fastest = rate;
    c.factor = 0.5 * (a.factor + b.factor);
    c.lower = a.factor;
    c.upper = b.factor;
    c.note = fmt::format("the displacement grows by a factor {:.3g} in this interval", b.displacement / a.displacement);
  }
  if (!c.factor) c.note = "no two trials moved the slope noticeably";
  return c;
}

std::vector<results::Criterion> find_criteria(const std::vector<CurvePoint>& curve,
                                              const std::optional<Bilinear>& bilinear, double displacement_ratio,
                                              double slope_height, const ShownUnit& length) {
  using results::CriterionKind;
  const double limit = displacement_ratio * slope_height;
  std::vector<results::Criterion> criteria;
  if (!curve.empty() && curve.front().displacement > limit) {
    const std::string note = fmt::format("already the smallest computed factor, {:g}, moves the slope by {}",
                                         curve.front().factor, format_value(curve.front().displacement, length, 3));
    for (const CriterionKind kind : {CriterionKind::bilinear, CriterionKind::displacement, CriterionKind::jump})
      criteria.push_back({kind, {}, {}, {}, note});
    return criteria;
  }
  if (bilinear)
    criteria.push_back(bilinear->criterion);
  else
    criteria.push_back({CriterionKind::bilinear, {}, {}, {}, "too few factors in the branches"});
  criteria.push_back(find_displacement_criterion(curve, limit, length));
  if (criteria.back().factor)
    criteria.back().note = fmt::format("largest displacement reaches {:g} H, H = {}", displacement_ratio,
                                       format_value(slope_height, length));
  criteria.push_back(find_jump_criterion(curve, elastic_share * slope_height));
  return criteria;
}

std::vector<double> choose_refinement(const std::vector<CurvePoint>& curve, double smallest) {
  std::vector<double> added;
  if (curve.size() < 3) return added;
  const double rise = curve.back().displacement - curve.front().displacement;
  const auto halve = [&](std::size_t i) {  // interval [i, i+1]
    const double length = curve[i + 1].factor - curve[i].factor;
    if (length < 2 * smallest - 1e-9) return;
    // on the grid of the smallest interval, so that factors remain round numbers
    const double steps = std::floor(0.5 * length / smallest + 1e-9);
    const double factor = curve[i].factor + steps * smallest;
    if (std::find(added.begin(), added.end(), factor) == added.end()) added.push_back(factor);
  };
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    const auto slope = [&](std::size_t k) {
      return (curve[k + 1].displacement - curve[k].displacement) / (curve[k + 1].factor - curve[k].factor);
    };
    const double length = std::min(curve[i].factor - curve[i - 1].factor, curve[i + 1].factor - curve[i].factor);
    const double bend = std::abs(slope(i) - slope(i - 1)) * length;
    if (bend < smallest_bend * rise) continue;
    halve(i - 1);
    halve(i);
  }
  std::sort(added.begin(), added.end());
  return added;
}

}  // namespace talus::run
