// SPDX-License-Identifier: MIT
#include "bounds/flow_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace talus::bounds {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns the dissipation of the soil itself: the least of all divisions of the strain rate between two lines
/// R ≤ a − b σ_m of the criterion (the tension cut-off has b = 1).
double find_own_dissipation(const Strength& soil, double factor, const Strain& strain) {
  struct Line {
    double a, b;
  };
  std::vector<Line> lines;
  const double divisor = soil.find_divisor(factor), shear = strain.find_shear();
  if (soil.tension) lines.push_back({*soil.tension / divisor, 1});
  soil.visit_lines([&](double more_cohesion, double tan_friction) {
    const double tangent = tan_friction / divisor, cosine = 1 / std::hypot(1.0, tangent);
    lines.push_back({(soil.cohesion + more_cohesion) / divisor * cosine, tangent * cosine});
  });
  if (lines.size() == 1 && lines[0].b == 0) return lines[0].a * shear;
  double least = infinity;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [a, b] = lines[i];
    // Above the apex the shear is less than the flow rule of the line allows.
    if (b > 0 && strain.opening >= b * shear) least = std::min(least, a * strain.opening / b);
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const double rest = strain.opening - lines[j].b * shear, share = rest / (b - lines[j].b);
      if (rest >= 0 && b > lines[j].b && share <= shear)
        least = std::min(least, a * share + lines[j].a * (shear - share));
    }
  }
  return least;
}

/// Motion on weak planes in the sense of the shear along them, and the strain rate that it leaves to the soil. It has
/// one number p: the planes open by p tan φ and slip by p, or by all of the shear along them if that is less, since
/// opening without slip dissipates c cot φ as opening with slip does.
class Slip {
 public:
  Slip(const Strength& soil, double factor, const Strain& strain)
      : opening_(strain.opening),
        sine_(find_sine(soil, factor)),
        cohesion_(soil.planes->cohesion / soil.find_divisor(factor)),
        tangent_(soil.planes->tan_friction / soil.find_divisor(factor)) {
    const double c = std::cos(2 * soil.planes->angle), s = std::sin(2 * soil.planes->angle);
    across_ = -strain.difference * c - strain.distortion * s;
    along_ = std::abs(strain.distortion * c - strain.difference * s);
  }

  /// Returns what motion p leaves, in the axes of the planes.
  Strain leave(double p) const {
    return {opening_ - p * tangent_, across_ - p * tangent_, along_ - std::min(along_, p)};
  }
  double find_lack(double p) const {
    const Strain rest = leave(p);
    return sine_ * rest.find_shear() - rest.opening;
  }

  /// Returns the p with the least lack. Its derivative is zero where the shear that is left has a certain share along
  /// the motion.
  double find_easiest() const {
    if (tangent_ == 0) return along_;
    const double square = 1 + tangent_ * tangent_, share = tangent_ / (sine_ * std::sqrt(square));
    if (!(share < 1)) return 0;
    const double least_shear = (along_ + across_ * tangent_) / square,
                 rest = std::abs(across_ - along_ * tangent_) / square;
    return std::clamp(least_shear - rest * share / std::sqrt(1 - share * share), 0.0, along_);
  }

  /// Returns the least dissipation of the planes and of `own`, that of a strain rate of the soil. The sum is convex in
  /// p, and every p gives an upper bound.
  double minimise(auto own) const {
    const auto sum = [&](double p) { return cohesion_ * p + own(leave(p)); };
    const double easiest = find_easiest();
    const double most = tangent_ > 0 ? std::max(easiest, opening_ / tangent_) : easiest;
    return std::min({sum(0), sum(easiest), search(sum, easiest, 0), search(sum, easiest, most)});
  }

 private:
  /// Returns the least sum between two p by golden sections; it is finite next to the first one, if anywhere.
  static double search(auto sum, double from, double to) {
    constexpr int steps = 40;
    constexpr double ratio = 0.6180339887498949;
    if (from == to) return infinity;
    double a = to - ratio * (to - from), b = from + ratio * (to - from), of_a = sum(a), of_b = sum(b);
    double least = std::min(of_a, of_b);
    for (int i = 0; i < steps; ++i) {
      if (of_a <= of_b) {
        to = b, b = a, of_b = of_a, a = to - ratio * (to - from), of_a = sum(a);
      } else {
        from = a, a = b, of_a = of_b, b = from + ratio * (to - from), of_b = sum(b);
      }
      least = std::min({least, of_a, of_b});
    }
    return least;
  }

  double opening_, sine_, cohesion_, tangent_;
  double across_ = 0, along_ = 0;  ///< shear rates: opening of the planes less extension along them, and along them
};

}  // namespace

double find_sine(const Strength& soil, double factor) {
  const double tangent = soil.find_least_friction();
  return tangent / std::hypot(soil.find_divisor(factor), tangent);
}

double find_lack(const Strength& soil, double factor, const Strain& strain) {
  const double own = find_sine(soil, factor) * strain.find_shear() - strain.opening;
  if (!soil.planes) return own;
  const Slip slip(soil, factor, strain);
  return std::min(own, slip.find_lack(slip.find_easiest()));
}

double find_dissipation(const Strength& soil, double factor, const Strain& strain) {
  const auto own = [&](const Strain& rest) { return find_own_dissipation(soil, factor, rest); };
  return soil.planes ? Slip(soil, factor, strain).minimise(own) : own(strain);
}

}  // namespace talus::bounds
