// SPDX-License-Identifier: MIT
// Solution of the equilibrium equations for the factor: simplified methods (Fellenius, Bishop, Janbu), given
// inclinations, and complete equilibrium (Spencer, Morgenstern and Price).
#include <algorithm>
#include <cmath>

#include "lem/slices/mass.hpp"

namespace talus::lem {

namespace {

struct Residual {
  double value = 0, slope = 0;
};

/// Returns the driving less the resisting moment (or horizontal force) with X = 0, and its derivative by q = 1/F.
/// `has_held`: with passive bars.
template <bool has_held>
Residual sum_simplified(const Mass& mass, bool moments, double q) {
  Residual sum{moments ? mass.moment : mass.crack, 0};
  if constexpr (has_held) {
    if (moments)
      sum = {mass.moment + q * mass.held_moment, mass.held_moment};
    else
      for (const Held& held : mass.held) sum.value += q * held.push, sum.slope += held.push;
  }
  for (std::size_t i = 0; i < mass.wedges.size(); ++i) {
    const Wedge& wedge = mass.wedges[i];
    const double t = wedge.friction * q, m_alpha = wedge.cosine + t * wedge.sine;
    double down = wedge.down;
    if constexpr (has_held) down += q * mass.held[i].down;
    const double normal = (down - q * wedge.strength * wedge.sine) / m_alpha;
    const double resistance = wedge.strength + wedge.friction * normal, shear = q * resistance;
    double normal_slope = -wedge.sine * resistance / m_alpha;
    if constexpr (has_held) normal_slope += mass.held[i].down / m_alpha;
    const double shear_slope = resistance + t * normal_slope;
    const double on_normal = moments ? wedge.arm_normal : wedge.sine;
    const double on_shear = moments ? wedge.arm_shear : wedge.cosine;
    sum.value += normal * on_normal - shear * on_shear + (moments ? 0 : wedge.push);
    sum.slope += normal_slope * on_normal - shear_slope * on_shear;
  }
  return sum;
}

}  // namespace

FelleniusSums sum_fellenius(const Mass& mass, bool moments) {
  FelleniusSums sums{0, moments ? mass.moment : mass.crack * mass.wedges.front().cosine};
  for (const Wedge& wedge : mass.wedges) {
    const double normal = wedge.down * wedge.cosine - wedge.push * wedge.sine;
    sums.driving += moments ? normal * wedge.arm_normal : wedge.down * wedge.sine + wedge.push * wedge.cosine;
    sums.resisting += (wedge.strength + normal * wedge.friction) * (moments ? wedge.arm_shear : 1);
  }
  if (moments) sums.resisting -= mass.held_moment;
  for (std::size_t i = 0; i < mass.held.size(); ++i) {
    const Wedge& wedge = mass.wedges[i];
    const Held& held = mass.held[i];
    const double normal = held.down * wedge.cosine - held.push * wedge.sine;
    sums.resisting -= moments ? normal * wedge.arm_normal : held.down * wedge.sine + held.push * wedge.cosine;
    sums.held_friction += normal * wedge.friction * (moments ? wedge.arm_shear : 1);
  }
  return sums;
}

double FelleniusSums::find_factor() const {
  if (held_friction == 0) return resisting / driving;
  return (resisting + std::sqrt(std::max(0.0, resisting * resisting + 4 * driving * held_friction))) / (2 * driving);
}

double solve_simplified(const Mass& mass, bool moments, double start, int& iterations) {
  // The residual is nearly linear in 1/F, so that Newton's method needs a few steps from any start.
  double q = start > 0 ? 1 / start : 1;
  for (iterations = 1; iterations <= 60; ++iterations) {
    const Residual sum =
        mass.has_held() ? sum_simplified<true>(mass, moments, q) : sum_simplified<false>(mass, moments, q);
    if (!(sum.slope < 0)) return 0;
    double next = q - sum.value / sum.slope;
    if (!(next > 0)) next = iterations < 30 ? 0.2 * q : 0;
    next = std::min(next, 5 * q);
    const double step = std::abs(next - q);
    q = next;
    if (!(q > 1e-9)) return 0;
    if (step <= 1e-13 * q) return 1 / q;
    if (step <= 1e-7 * q)
      return 1 / q;  // quadratic convergence: the remaining error is of the order of the square of
                     // this step
  }
  return 0;
}

double correct_janbu(const CutSurface& cut, double& ratio) {
  const Point &a = cut.slices.front().base_left, &b = cut.slices.back().base_right;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  double depth = 0;
  bool cohesion = false, friction = false;
  for (const Slice& slice : cut.slices) {
    const double dx = slice.base_right[0] - a[0], dy = slice.base_right[1] - a[1];
    depth = std::max(depth, (dy * (a[0] - b[0]) + dx * (b[1] - a[1])) / length);
    cohesion = cohesion || slice.cohesion > 0;
    friction = friction || slice.tan_friction > 0;
  }
  const double b1 = !friction ? 0.69 : !cohesion ? 0.31 : 0.50;
  ratio = depth / length;
  return 1 + b1 * (ratio - 1.4 * ratio * ratio);
}

// Complete equilibrium: X = λ f E between the slices (Spencer, Morgenstern and Price).

namespace {

/// Residual force at the lower end and residual moment (T18.6) for q = 1/F and λ, with their derivatives.
struct Balance {
  double force = 0, force_q = 0, force_l = 0;
  double moment = 0, moment_q = 0, moment_l = 0;
  bool sound = true;  ///< all m_α positive
};

template <bool has_held>
Balance sum_balance(const Mass& mass, double q, double lambda) {
  Balance sum;
  sum.moment = mass.moment;
  if constexpr (has_held) {
    sum.moment += q * mass.held_moment;
    sum.moment_q = mass.held_moment;
  }
  double e = mass.crack, e_q = 0, e_l = 0, x = 0, x_q = 0, x_l = 0;
  for (std::size_t i = 0; i < mass.wedges.size(); ++i) {
    const Wedge& w = mass.wedges[i];
    if constexpr (has_held) {
      e += q * mass.held[i].push;
      e_q += mass.held[i].push;
      x += q * mass.held[i].down;
      x_q += mass.held[i].down;
    }
    const double t = w.friction * q, a = lambda * w.ratio;
    const double slip = w.sine - t * w.cosine, slip_q = -w.friction * w.cosine;
    const double m = w.cosine + t * w.sine + a * slip;
    const double m_q = w.friction * w.sine + a * slip_q, m_l = w.ratio * slip;
    const double pushed = e - q * w.strength * w.cosine + w.push, pushed_q = e_q - w.strength * w.cosine;
    const double top = w.down + x - q * w.strength * w.sine - a * pushed;
    const double inverse = 1 / m, normal = top * inverse;
    const double normal_q = (x_q - w.strength * w.sine - a * pushed_q - normal * m_q) * inverse;
    const double normal_l = (x_l - w.ratio * pushed - a * e_l - normal * m_l) * inverse;
    sum.sound = sum.sound && m > 0;
    const double resistance = w.strength + w.friction * normal;
    sum.moment += normal * w.arm_normal - q * resistance * w.arm_shear;
    sum.moment_q += normal_q * w.arm_normal - (resistance + t * normal_q) * w.arm_shear;
    sum.moment_l += normal_l * (w.arm_normal - t * w.arm_shear);
    e = pushed + normal * slip;
    e_q = pushed_q + normal_q * slip + normal * slip_q;
    e_l += normal_l * slip;
    x = a * e;
    x_q = a * e_q;
    x_l = w.ratio * e + a * e_l;
  }
  sum.force = e;
  sum.force_q = e_q;
  sum.force_l = e_l;
  return sum;
}

Balance balance(const Mass& mass, double q, double lambda) {
  return mass.has_held() ? sum_balance<true>(mass, q, lambda) : sum_balance<false>(mass, q, lambda);
}

/// Returns the q = 1/F that satisfies force equilibrium for a given λ, from a nearby start; 0 if there is none.
double close_forces(const Mass& mass, double lambda, double q, Balance& end, int& iterations) {
  for (int k = 0; k < 60; ++k) {
    end = balance(mass, q, lambda);
    ++iterations;
    if (!end.sound || !(end.force_q < 0)) return 0;
    double next = q - end.force / end.force_q;
    next = std::clamp(next, 0.3 * q, 3 * q);
    const double step = std::abs(next - q);
    q = next;
    if (step <= 1e-9 * q) {
      end = balance(mass, q, lambda);
      return end.sound ? q : 0;
    }
  }
  return 0;
}

/// Point of the curve q(λ) of force equilibrium, with the residual moment there.
struct Try {
  double lambda = 0, q = 0, moment = 0;
};

/// Returns the root of the residual moment between two points of the curve, by regula falsi with halving (Illinois); q
/// = 0 if the curve ends between them.
Try close_bracket(const Mass& mass, Try a, Try b, int& iterations) {
  Balance end;
  for (int i = 0; i < 100; ++i) {
    Try c{b.moment == a.moment ? b.lambda : b.lambda - b.moment * (b.lambda - a.lambda) / (b.moment - a.moment), 0, 0};
    c.q = close_forces(mass, c.lambda, b.q, end, iterations);
    if (!(c.q > 0)) return c;
    c.moment = end.moment;
    const double moved = std::abs(c.lambda - b.lambda);
    if ((c.moment < 0) != (b.moment < 0)) {
      a = b;
    } else {
      a.moment *= 0.5;
    }
    b = c;
    if (moved <= 1e-11 || std::abs(c.moment) <= 1e-14 * mass.scale * mass.radius) break;
  }
  return b;
}

}  // namespace

Complete solve_forces(const Mass& mass, double start) {
  Complete found;
  Balance end;
  double q = start > 0 ? 1 / start : 1;
  // Continuation from λ = 0 to the given inclinations, since Newton's method may not converge from afar.
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    q = close_forces(mass, share, q, end, found.iterations);
    if (!(q > 0)) return found;
  }
  found.factor = 1 / q;
  found.lambda = 1;
  return found;
}

Complete solve_newton(const Mass& mass, double start) {
  double q = start > 0 ? 1 / start : 1, lambda = 0.2;
  Balance now = balance(mass, q, lambda);
  const double by_force = 1 / mass.scale, by_moment = 1 / (mass.scale * mass.radius);
  const auto size = [&](const Balance& b) { return std::hypot(b.force * by_force, b.moment * by_moment); };
  for (int k = 1; k <= 30 && now.sound; ++k) {
    const double determinant = now.force_q * now.moment_l - now.force_l * now.moment_q;
    const double dq = -(now.force * now.moment_l - now.force_l * now.moment) / determinant;
    const double dl = -(now.force_q * now.moment - now.force * now.moment_q) / determinant;
    double part = std::min({1.0, 0.5 * q / std::abs(dq), 0.5 / std::abs(dl)});
    if (!(part > 0)) break;
    Balance next;
    bool better = false;
    for (int halving = 0; halving < 8 && !better; ++halving) {
      if (halving > 0) part *= 0.5;
      next = balance(mass, q + part * dq, lambda + part * dl);
      better = next.sound && size(next) <= size(now) * (1 - 1e-4 * part) + 1e-14;
    }
    if (!better) break;
    q += part * dq;
    lambda += part * dl;
    now = next;
    if (part == 1 && std::abs(dq) <= 1e-7 * q && std::abs(dl) <= 1e-6) {
      // One more step; the error after it is of the order of its square.
      const double end = now.force_q * now.moment_l - now.force_l * now.moment_q;
      q -= (now.force * now.moment_l - now.force_l * now.moment) / end;
      lambda -= (now.force_q * now.moment - now.force * now.moment_q) / end;
      return {1 / q, lambda, k};
    }
  }
  return {};
}

Complete solve_bracket(const Mass& mass, double start) {
  Complete found;
  Balance end;
  Try zero{0, 0, 0};
  zero.q = close_forces(mass, 0, start > 0 ? 1 / start : 1, end, found.iterations);
  if (!(zero.q > 0)) return found;
  zero.moment = end.moment;
  // If there are two roots, the one with λ > 0 is the physical one: the lower slices support the upper ones.
  constexpr double largest = 2, smallest = -1, first = 0.1, finest = 1e-3;
  for (const double way : {1.0, -1.0}) {
    Try at = zero;
    double step = first;
    while (step > finest && at.lambda < largest && at.lambda > smallest) {
      Try next{at.lambda + way * step, 0, 0};
      next.q = close_forces(mass, next.lambda, at.q, end, found.iterations);
      next.moment = end.moment;
      if (!(next.q > 0)) {
        step *= 0.5;  // the curve ends, or curves too sharply for this step
        continue;
      }
      if ((next.moment < 0) != (at.moment < 0)) {
        const Try root = close_bracket(mass, at, next, found.iterations);
        if (root.q > 0) return {1 / root.q, root.lambda, found.iterations};
        break;
      }
      at = next;
    }
  }
  return found;
}

}  // namespace talus::lem
