// SPDX-License-Identifier: MIT
#include "bounds/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::bounds {
namespace {

/// A point of the envelope with its tangent.
struct Touch {
  double normal = 0;
  StrengthTangent tangent;

  double find_strength() const { return tangent.cohesion + normal * tangent.tan_friction; }
};

class Enclosure {
 public:
  Enclosure(const std::function<StrengthTangent(double)>& find_tangent, const EnvelopeRange& range)
      : find_tangent_(find_tangent), range_(range), least_(range.tolerance / 2 * touch(range.usual).find_strength()) {}

  EnvelopePolygons run() {
    // Above the usual stresses one chord is near enough, and above it a horizontal line makes it safe.
    constexpr double largest = 1.5, beyond = 10;
    points_.push_back(touch(range_.lowest));
    split(touch(largest * range_.usual), 0);
    if (beyond * range_.usual > points_.back().normal) points_.push_back(touch(beyond * range_.usual));
    std::vector<StrengthTangent> inner{points_.front().tangent}, outer{points_.front().tangent};
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const Touch &a = points_[i - 1], &b = points_[i];
      const double slope = (b.find_strength() - a.find_strength()) / (b.normal - a.normal);
      inner.push_back({a.find_strength() - slope * a.normal, slope});
      outer.push_back(b.tangent);
    }
    inner.push_back({points_.back().find_strength(), 0});
    return {make_strength(inner), make_strength(outer)};
  }

 private:
  Touch touch(double normal) const { return {normal, find_tangent_(normal)}; }

  /// Adds points up to `to` from the last one, so that tangents and chords are close everywhere.
  void split(const Touch& to, int depth) {
    constexpr int deepest = 12;
    const Touch from = points_.back();
    if (!(to.normal > from.normal)) return;
    const double turn = from.tangent.tan_friction - to.tangent.tan_friction;
    if (depth < deepest && turn > 0) {
      const double meet = (to.tangent.cohesion - from.tangent.cohesion) / turn,
                   outer = from.tangent.cohesion + meet * from.tangent.tan_friction,
                   slope = (to.find_strength() - from.find_strength()) / (to.normal - from.normal),
                   inner = from.find_strength() + slope * (meet - from.normal);
      const bool is_between = meet > from.normal && meet < to.normal;
      if (is_between && outer - inner > std::max(least_, range_.tolerance * outer)) {
        split(touch(meet), depth + 1);
        split(to, depth + 1);
        return;
      }
    }
    points_.push_back(to);
  }

  /// Lines that are parallel to their predecessor are left out: those of straight parts.
  static Strength make_strength(const std::vector<StrengthTangent>& lines) {
    constexpr double parallel = 1e-9;
    std::vector<FurtherLine> further;
    double last = lines.front().tan_friction;
    for (const StrengthTangent& line : lines) {
      if (line.tan_friction > last - parallel * std::max(1.0, last)) continue;
      further.push_back({line.cohesion - lines.front().cohesion, last = line.tan_friction});
    }
    Strength strength{lines.front().cohesion, lines.front().tan_friction, {}, true, {}};
    if (!further.empty()) strength.further = std::make_shared<const std::vector<FurtherLine>>(std::move(further));
    return strength;
  }

  const std::function<StrengthTangent(double)>& find_tangent_;
  EnvelopeRange range_;
  double least_;
  std::vector<Touch> points_;
};

}  // namespace

EnvelopePolygons enclose_envelope(const std::function<StrengthTangent(double)>& find_tangent,
                                  const EnvelopeRange& range) {
  return Enclosure(find_tangent, range).run();
}

namespace {

/// Returns the number of the line that is nearest to the centre of a circle.
std::size_t find_nearest_line(const Strength& soil, double factor, double mean) {
  const double divisor = soil.find_divisor(factor);
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0, number = 0;
  soil.visit_lines([&](double more_cohesion, double tan_friction) {
    const double distance = (soil.cohesion + more_cohesion - mean * tan_friction) / std::hypot(divisor, tan_friction);
    if (distance < least) least = distance, nearest = number;
    ++number;
  });
  return nearest;
}

}  // namespace

void choose_lines(Problem& problem, const Units& units, const std::array<TriedStresses, 2>& tried) {
  for (std::size_t e = 0; e < problem.size(); ++e) {
    auto& corners = problem.strength[e];
    if (!corners[0].further) continue;
    std::size_t first = std::numeric_limits<std::size_t>::max(), last = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (const TriedStresses& at : tried) {
        const double mean = (*at.unknowns)[9 * e + 3 * i] * units.stress;
        const std::size_t nearest = find_nearest_line(corners[i], at.factor, mean);
        first = std::min(first, nearest), last = std::max(last, nearest);
      }
    for (Strength& soil : corners) soil.programmed = {first > 0 ? first - 1 : 0, last + 1};
  }
}

bool add_exceeded_lines(Problem& problem, const Units& units, const TriedStresses& tried) {
  constexpr double tolerance = 1e-5;  // of the stresses of a solution [units of stress]
  bool has_added = false;
  for (std::size_t e = 0; e < problem.size(); ++e) {
    auto& corners = problem.strength[e];
    if (!corners[0].further) continue;
    LineRange range = corners[0].programmed;
    for (std::size_t i = 0; i < 3; ++i) {
      const Strength& soil = corners[i];
      const double *stress = &(*tried.unknowns)[9 * e + 3 * i], radius = std::hypot(stress[1], stress[2]),
                   lack = tried.unknowns->back(), divisor = soil.find_divisor(tried.factor);
      std::size_t number = 0;
      soil.visit_lines([&](double more_cohesion, double tan_friction) {
        const double cohesion = (soil.cohesion + more_cohesion) / units.stress / divisor + lack,
                     tangent = tan_friction / divisor;
        if ((cohesion - stress[0] * tangent) / std::hypot(1.0, tangent) < radius - tolerance)
          range.first = std::min(range.first, number), range.last = std::max(range.last, number);
        ++number;
      });
    }
    if (range.first == corners[0].programmed.first && range.last == corners[0].programmed.last) continue;
    for (Strength& soil : corners) soil.programmed = range;
    has_added = true;
  }
  return has_added;
}

}  // namespace talus::bounds
