// SPDX-License-Identifier: MIT
#include "lem/section/piles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::lem {

namespace {

/// Smallest moment of a side about the slip surface against the force on the mass, and the distance from the surface at
/// which its pressure changes sign, or its hinge lies: the derivative of that moment by the force.
struct Response {
  double moment = 0;    ///< [N m/m]
  double distance = 0;  ///< [m]
  bool is_hinged = false;
};

/// Ultimate pressures of a side, summed from the slip surface.
class SideSums {
 public:
  explicit SideSums(const PileSide& side)
      : side_(side), strength_(side.compute_strength()), moment_(find_moment(side.end)) {}

  double strength() const { return strength_; }

  /// The soil of a side can turn its part of the pile by reversing its pressure beyond a distance, with M = ∫₀ᵃ p ζ dζ
  /// - ∫ₐ p ζ dζ, or, at most by M_p, up to a hinge, with M = ∫₀ʰ p ζ dζ - M_p.
  Response respond(double force, double plastic_moment) const {
    const double turn = find_place(0.5 * (strength_ + force)), hinge = find_place(force);
    const Response rigid{2 * find_moment(turn) - moment_, std::abs(turn - side_.slip), false},
        hinged{find_moment(hinge) - plastic_moment, std::abs(hinge - side_.slip), true};
    return hinged.moment > rigid.moment ? hinged : rigid;
  }

 private:
  /// Returns the distance from the head up to which the pressure adds up to a force.
  double find_place(double force) const {
    const double sign = side_.end < side_.slip ? -1 : 1;
    const auto [low, high] = std::minmax(side_.slip, side_.end);
    const double sum = side_.diagram->find_part(0, side_.slip);
    return std::clamp(side_.diagram->find_place(sum + sign * force), low, high);
  }

  /// Returns the moment about the slip surface of the pressure up to a place.
  double find_moment(double place) const {
    return side_.diagram->find_moment(side_.slip, place) - side_.slip * side_.diagram->find_part(side_.slip, place);
  }

  const PileSide& side_;
  double strength_, moment_;
};

}  // namespace

double PileSide::compute_strength() const {
  return std::abs(diagram->find_part(slip, end));
}

PileForce compute_pile_force(const PileSide& mass, const PileSide& stable, const PileStrength& strength) {
  const SideSums front(mass), behind(stable);
  PileForce found{std::min(front.strength(), strength.lateral), BarLimit::lateral};
  if (strength.shear <= found.force) found = {strength.shear, BarLimit::shear};
  if (behind.strength() < found.force) found = {behind.strength(), BarLimit::embedment};
  // The moments of both sides have to balance. The excess is convex and grows with the force, so that Newton's method
  // approaches its root from above.
  constexpr int iterations = 60;
  constexpr double tolerance = 1e-12;
  for (int i = 0; i < iterations && found.force > 0; ++i) {
    const Response a = front.respond(found.force, strength.moment), b = behind.respond(found.force, strength.moment);
    const double excess = a.moment + b.moment, growth = a.distance + b.distance;
    if (!(excess > tolerance * found.force * growth)) break;
    const int hinges = static_cast<int>(a.is_hinged) + static_cast<int>(b.is_hinged);
    found.limit = hinges == 2 ? BarLimit::two_hinges : hinges == 1 ? BarLimit::one_hinge : BarLimit::rotation;
    found.force = std::max(0.0, found.force - excess / growth);
  }
  return found;
}

BarDiagram make_embedded_diagram(const Slope& slope, const Bar& pile) {
  return make_bar_diagram(slope, pile, [&](const StrengthTangent& soil, double effective_stress) {
    return compute_embedded_pressure(soil, effective_stress, pile.spacing, pile.diameter) / pile.spacing;
  });
}

double compute_embedded_pressure(const StrengthTangent& soil, double effective_stress, double spacing,
                                 double diameter) {
  const double cohesion = std::max(0.0, soil.cohesion), stress = std::max(0.0, effective_stress);
  const double root = std::tan(std::numbers::pi / 4 + 0.5 * std::atan(soil.tan_friction));
  const double by_weight = (root * root - 1 / (root * root)) * stress;
  const double wall = spacing * (by_weight + 2 * cohesion * (root + 1 / root));
  return diameter > 0 ? std::min(wall, diameter * (9 * cohesion + 3 * by_weight)) : wall;
}

}  // namespace talus::lem
