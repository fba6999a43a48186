// SPDX-License-Identifier: MIT
// The factor of safety of one slip surface by any method, the checks of the solution, and the yield acceleration.
#include "lem/slices/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lem/slices/mass.hpp"
#include "lem/slices/slices.hpp"
#include "lem/slices/wedge_mechanism.hpp"

namespace talus::lem {

namespace {

/// Factors above this are meaningless: under level ground the mass is driven by rounding errors alone.
constexpr double largest_factor = 1000;
/// Largest residual of the equations over the weight of a converged solution [-].
constexpr double largest_residual = 1e-5;

/// Limit of the change of a strength over the mean one, after which the next tangents are taken as those of the
/// solution. Convergence is quadratic, so that they differ by some 1e-10 of it [-].
constexpr double tangent_tolerance = 1e-5;
constexpr int most_tangents = 60;

/// Largest relative difference between the factor of a solution and the one by which it multiplied the strengths that
/// no factor divides [-].
constexpr double scale_tolerance = 1e-9, rounding_of_scale = 1e-6;
constexpr int most_scales = 60;

/// Memory of one thread, reused for all surfaces.
struct Scratch {
  Mass mass;
  std::vector<Forces> forces;
  std::vector<double> level;
};

/// Depth over length at which the chart of Janbu's correction ends (Janbu 1973; Abramson et al. 2002) [-].
constexpr double longest_chart = 0.4;

/// Computes the normal forces of Fellenius (T18.7).
void find_fellenius_forces(const Mass& mass, double factor, std::vector<Forces>& forces) {
  forces.clear();
  for (std::size_t i = 0; i < mass.wedges.size(); ++i) {
    const Wedge& w = mass.wedges[i];
    const Held held = mass.has_held() ? mass.held[i] : Held{};
    const double normal = (w.down + held.down / factor) * w.cosine - (w.push + held.push / factor) * w.sine;
    forces.push_back({normal, (w.strength + w.friction * normal) / factor, 0, 0, 1});
  }
}

void judge_forces(const CutSurface& cut, const Scratch& s, Solution& solution) {
  double length = 0, tensile = 0;
  const auto size = cut.slices.size();
  solution.smallest_m_alpha = 1;
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    length += slice.length;
    // Without friction the normal force adds no strength, however unreliable it is. It matters to the methods of
    // complete equilibrium alone, which need it for the balance.
    if (!(s.mass.wedges[i].friction > 0) && !is_rigorous(solution.method)) continue;
    solution.smallest_m_alpha = std::min(solution.smallest_m_alpha, s.forces[i].m_alpha);
    if (s.forces[i].normal - s.mass.wedges[i].uplift < 0) tensile += slice.length;
  }
  solution.tensile_share = tensile / length;
}

/// Computes the fraction of Σ|E| that acts outside the mass by more than a tenth of its height. It is weighted with E,
/// since the position of a small force matters little.
void judge_thrust(const CutSurface& cut, const Scratch& s, Solution& solution) {
  const auto size = cut.slices.size();
  double all = 0, outside = 0;
  for (std::size_t i = 0; i + 1 < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    const double low = cut.slides_left ? slice.base_left[1] : slice.base_right[1];
    const double high = cut.slides_left ? slice.top_left : slice.top_right, near = 0.1 * (high - low);
    const double e = std::abs(s.forces[i].normal_side);
    all += e;
    if (!std::isnan(s.level[i]) && (s.level[i] < low - near || s.level[i] > high + near)) outside += e;
  }
  solution.thrust_outside = all > 0 ? outside / all : 0;
}

/// Rejects a polyline whose factor lies too far below the wedge mechanism of its base.
void judge_wedges(const Slope& slope, const CutSurface& cut, const Checks& checks, double horizontal,
                  Solution& solution) {
  static thread_local WedgeMechanism wedges;
  if (!std::isfinite(checks.most_below_wedges) || !has_wedge_check(slope, cut, solution.method)) return;
  wedges.set(slope, cut, horizontal);
  if (wedges.compute_net_power(solution.factor / (1 - checks.most_below_wedges)) < 0) solution.refusal = Refusal::kinks;
}

/// Applies Janbu's correction; rejects surfaces outside its chart.
void correct(const CutSurface& cut, Solution& solution) {
  double ratio = 0;
  solution.correction = correct_janbu(cut, ratio);
  if (ratio > longest_chart && solution.refusal == Refusal::none) solution.refusal = Refusal::chart;
}

void write_forces(CutSurface& cut, const Scratch& s, bool thrust) {
  const auto size = cut.slices.size();
  for (std::size_t i = 0; i < size; ++i) {
    Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    const Forces& f = s.forces[i];
    slice.normal = f.normal;
    slice.shear = f.shear;
    slice.m_alpha = f.m_alpha;
    // The right side is the upper one if the mass slides to the left.
    const bool end = cut.slides_left && i == 0;
    const std::size_t side = cut.slides_left && i > 0 ? i - 1 : i;
    slice.normal_right = end ? s.mass.crack : s.forces[side].normal_side;
    slice.shear_right = end ? 0 : s.forces[side].shear_side;
    slice.thrust_right = !thrust ? 0 : end ? cut.crack_thrust_level : s.level[side];
    if (end && !(s.mass.crack > 0)) slice.thrust_right = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

Refusal check_solution(const CutSurface& cut, const Solution& solution, const Checks& checks) {
  const double toe = cut.slides_left ? cut.slices.front().alpha() : cut.slices.back().alpha();
  if (-toe > checks.steepest_toe) return Refusal::steep_toe;
  if (solution.smallest_m_alpha < checks.smallest_m_alpha) return Refusal::m_alpha;
  // Also for Fellenius: his N' = W cos α - u l satisfies no equilibrium and falls below zero where pressures are high.
  // A search would then end at the surface with the worst forces, down to a factor of zero.
  if (solution.tensile_share > checks.most_tension) return Refusal::tension;
  if (solution.thrust_outside > checks.most_thrust_outside) return Refusal::thrust;
  return Refusal::none;
}

namespace {

/// Solves the equations of a method for the mass in `s`, without checks; factor 0 if they have no solution. Returns a
/// simpler method's factor, as an estimate where there is none.
double solve_equations(const CutSurface& cut, const Checks& checks, Scratch& s, Solution& solution) {
  const Method method = solution.method;
  const bool circular = cut.surface.circle.has_value(), complete = is_rigorous(method);
  const FelleniusSums sums = sum_fellenius(s.mass, circular);
  if (!(sums.driving * largest_factor > sums.resisting && sums.driving > 0)) {
    solution.refusal = Refusal::no_driving;
    return 0;
  }
  if (method == Method::bishop && !circular) {
    solution.refusal = Refusal::moment_axis;
    return 0;
  }
  const double start = sums.find_factor();
  if (method == Method::fellenius) {
    solution.factor = start;
  } else if (has_given_inclinations(method)) {
    s.mass.set_inclinations(method, cut);
    const Complete found = solve_forces(s.mass, solve_simplified(s.mass, false, start, solution.iterations));
    solution.factor = found.factor;
    solution.lambda = found.lambda;
    solution.iterations += found.iterations;
  } else if (!complete) {
    solution.factor = solve_simplified(s.mass, method == Method::bishop, start, solution.iterations);
  } else {
    s.mass.set_interslice_function(method == Method::morgenstern_price, cut);
    int more = 0;
    const double near = solve_simplified(s.mass, circular, start, more);
    // Two algorithms for the same equations; each is the fall-back of the other.
    const bool bracket = method == Method::morgenstern_price_constant;
    Complete found = bracket ? solve_bracket(s.mass, near) : solve_newton(s.mass, near);
    if (!(found.factor > 0) || !checks.has_sensible_lambda(found.lambda)) {
      const Complete other = bracket ? solve_newton(s.mass, near) : solve_bracket(s.mass, near);
      if (!(found.factor > 0) || (other.factor > 0 && checks.has_sensible_lambda(other.lambda))) found = other;
    }
    solution.factor = found.factor;
    solution.lambda = found.lambda;
    solution.iterations = found.iterations;
    if (near > 0) return near;
  }
  return start;
}

/// Solves with the strengths that the slices have.
Solution solve_linear(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces,
                      double horizontal) {
  static thread_local Scratch s;
  Solution solution;
  solution.method = method;
  solution.refusal = cut.refusal;
  if (cut.refusal != Refusal::none || cut.slices.empty()) return solution;
  const bool complete = is_rigorous(method);
  tighten_bars(cut);
  for (bool is_tight = false; !is_tight;) {
    s.mass.set(slope, cut, horizontal);
    const double estimate = solve_equations(cut, checks, s, solution);
    if (solution.refusal != Refusal::none) return solution;
    const bool has_factor = solution.factor > 0 && std::isfinite(solution.factor);
    is_tight = !release_bars(slope, cut, has_factor ? solution.factor : estimate);
  }
  if (!(solution.factor > 0) || !std::isfinite(solution.factor)) {
    solution.factor = 0;
    solution.refusal = method == Method::fellenius ? Refusal::tension : Refusal::not_converged;
    return solution;
  }
  if (method == Method::fellenius) {
    find_fellenius_forces(s.mass, solution.factor, s.forces);
  } else {
    find_forces(s.mass, solution.factor, solution.lambda, s.forces);
    const bool moments = complete || method == Method::bishop, forces = complete || !moments;
    solution.residual = measure_residual(s.mass, solution.factor, s.forces, forces, moments);
  }
  judge_forces(cut, s, solution);
  if (complete) {
    find_thrust_line(slope, cut, s.mass, horizontal, solution.factor, s.forces, s.level);
    judge_thrust(cut, s, solution);
  }
  if (keep_forces) write_forces(cut, s, complete);
  // Also with `reject` off: interslice forces beyond the strength of soil give no factor of safety.
  if (complete && !checks.has_sensible_lambda(solution.lambda)) solution.refusal = Refusal::lambda;
  if (!(solution.residual <= largest_residual)) solution.refusal = Refusal::not_converged;
  if (checks.reject && solution.refusal == Refusal::none) solution.refusal = check_solution(cut, solution, checks);
  if (checks.reject && solution.refusal == Refusal::none) judge_wedges(slope, cut, checks, horizontal, solution);
  if (method == Method::janbu_corrected) correct(cut, solution);
  solution.factor = solution.refusal == Refusal::none ? solution.factor * solution.correction : 0;
  return solution;
}

/// Returns true if the strength of a slice depends on its normal force.
bool is_curved(const Slope& slope, const CutSurface& cut) {
  const std::vector<Soil>& soils = slope.section().soils;
  return slope.strips().curved_laws && std::any_of(cut.slices.begin(), cut.slices.end(), [&](const Slice& slice) {
           const auto& law = soils[static_cast<std::size_t>(slice.soil)].law;
           return law && law->is_curved;
         });
}

/// Multiplies the strengths of the slices whose soil the factor does not divide.
void scale_unreduced(const Slope& slope, CutSurface& cut, double by) {
  if (by == 1) return;
  for (Slice& slice : cut.slices)
    if (!slope.section().soils[static_cast<std::size_t>(slice.soil)].reduced) {
      slice.cohesion *= by;
      slice.tan_friction *= by;
    }
}

/// Solves with the strengths of the laws. Those that the factor does not divide are multiplied by `scale`.
Solution solve_laws(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces,
                    double horizontal, double scale) {
  if (!is_curved(slope, cut)) return solve_linear(slope, cut, method, checks, keep_forces, horizontal);
  // The tangents at the normal stresses of one solution give the next one: Newton's method for the envelopes.
  Checks lenient = checks;
  lenient.reject = false;
  for (int i = 0; i < most_tangents; ++i) {
    Solution solution = solve_linear(slope, cut, method, lenient, true, horizontal);
    if (!(solution.factor > 0)) return solution;
    scale_unreduced(slope, cut, 1 / scale);
    const double change = set_law_strengths(slope.strips(), cut.slices, true, cut.before);
    scale_unreduced(slope, cut, scale);
    if (change < tangent_tolerance) return solve_linear(slope, cut, method, checks, keep_forces, horizontal);
  }
  Solution none;
  none.method = method;
  none.refusal = Refusal::not_converged;
  return none;
}

/// Solves a surface in soil that the factor does not divide. The equations divide all strengths, so that such soil has
/// its own strength where it was multiplied by the factor of the solution; the secant method finds that factor.
Solution solve_unreduced(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces,
                         double horizontal) {
  const auto solve_scaled = [&](double scale, const Checks& judge, bool keep) {
    scale_unreduced(slope, cut, scale);
    Solution solution = solve_laws(slope, cut, method, judge, keep, horizontal, scale);
    scale_unreduced(slope, cut, 1 / scale);
    return solution;
  };
  Checks lenient = checks;
  lenient.reject = false;
  Solution solution;
  double scale = 1, last_scale = 0, last_excess = 0;
  for (int i = 0; i < most_scales; ++i) {
    solution = solve_scaled(scale, lenient, false);
    if (!(solution.factor > 0)) return solution;
    const double excess = solution.factor / solution.correction - scale;
    const double slope_of_excess = i == 0 ? -1 : (excess - last_excess) / (scale - last_scale);
    // Near the root the secant may be that of rounding errors.
    const bool is_rounded = i > 0 && !(slope_of_excess < 0) && std::abs(excess) < rounding_of_scale * scale;
    if (std::abs(excess) < scale_tolerance * scale || is_rounded) {
      // The wedge mechanism takes the strengths as they are, and the factor with them.
      Checks rest = checks;
      rest.most_below_wedges = std::numeric_limits<double>::infinity();
      solution = solve_scaled(scale, rest, keep_forces);
      if (checks.reject && solution.refusal == Refusal::none) judge_wedges(slope, cut, checks, horizontal, solution);
      if (solution.refusal != Refusal::none) solution.factor = 0;
      return solution;
    }
    // A secant that rises above zero has no root: with any factor the soil that is not reduced holds the mass.
    const double next = slope_of_excess < 0 ? scale - excess / slope_of_excess
                        : excess < 0        ? 0.5 * scale
                                            : largest_factor + 1;
    last_scale = std::exchange(scale, next);
    last_excess = excess;
    if (!(scale > 0)) scale = 0.5 * last_scale;
    if (scale > largest_factor) {
      solution.refusal = Refusal::held;
      solution.factor = 0;
      return solution;
    }
  }
  solution.refusal = Refusal::not_converged;
  solution.factor = 0;
  return solution;
}

bool has_unreduced(const Slope& slope, const CutSurface& cut) {
  return slope.strips().unreduced && std::any_of(cut.slices.begin(), cut.slices.end(), [&](const Slice& slice) {
           return !slope.section().soils[static_cast<std::size_t>(slice.soil)].reduced;
         });
}

}  // namespace

Solution solve_with(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces,
                    double horizontal) {
  if (slope.strips().laws) set_law_strengths(slope.strips(), cut.slices, false, cut.before);
  if (has_unreduced(slope, cut)) return solve_unreduced(slope, cut, method, checks, keep_forces, horizontal);
  return solve_laws(slope, cut, method, checks, keep_forces, horizontal, 1);
}

Solution solve(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces) {
  if (slope.before() != nullptr) return solve_drawdown(slope, cut, method, checks, keep_forces);
  const Section& section = slope.section();
  return solve_with(slope, cut, method, checks, keep_forces,
                    section.turn_to_sliding(section.horizontal_acceleration, cut.slides_left));
}

// Forces on the slices of a solution, and the line of thrust.

void find_forces(const Mass& mass, double factor, double lambda, std::vector<Forces>& forces) {
  const double q = 1 / factor;
  double e = mass.crack, x = 0;
  forces.clear();
  for (std::size_t i = 0; i < mass.wedges.size(); ++i) {
    const Wedge& w = mass.wedges[i];
    if (mass.has_held()) e += q * mass.held[i].push, x += q * mass.held[i].down;
    const double t = w.friction * q, a = lambda * w.ratio, slip = w.sine - t * w.cosine;
    const double m = w.cosine + t * w.sine + a * slip;
    const double pushed = e - q * w.strength * w.cosine + w.push;
    Forces f;
    f.normal = (w.down + x - q * w.strength * w.sine - a * pushed) / m;
    f.shear = q * (w.strength + w.friction * f.normal);
    f.normal_side = e = pushed + f.normal * slip;
    f.shear_side = x = a * e;
    f.m_alpha = m / std::sqrt(1 + a * a);
    forces.push_back(f);
  }
}

double measure_residual(const Mass& mass, double factor, const std::vector<Forces>& forces, bool of_forces,
                        bool of_moments) {
  double residual = of_forces ? std::abs(forces.back().normal_side) / mass.scale : 0;
  if (of_moments) {
    double moment = mass.moment + mass.held_moment / factor;
    for (std::size_t i = 0; i < forces.size(); ++i)
      moment += forces[i].normal * mass.wedges[i].arm_normal - forces[i].shear * mass.wedges[i].arm_shear;
    residual = std::max(residual, std::abs(moment) / (mass.scale * mass.radius));
  }
  return residual;
}

void find_thrust_line(const Slope& slope, const CutSurface& cut, const Mass& mass, double horizontal, double factor,
                      const std::vector<Forces>& forces, std::vector<double>& level) {
  const double way = cut.slides_left ? -1 : 1;
  double largest = std::abs(mass.crack);
  for (const Forces& f : forces) largest = std::max(largest, std::abs(f.normal_side));
  double e = mass.crack, x = 0, moment = e * cut.crack_thrust_level;  // `moment` is E times its elevation
  const auto size = cut.slices.size();
  level.assign(size, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    const Forces& f = forces[i];
    const double y = 0.5 * (slice.base_left[1] + slice.base_right[1]);
    const double half = 0.5 * (slice.right - slice.left);
    // Moments about the middle of the base, where N and T have none (T18.9).
    double about = moment - y * e - half * (x + f.shear_side) + way * slice.surface_moment +
                   (slice.centroid - y) * horizontal * slice.weight;
    for (const BarPart& part : cut.parts) {
      const BarPull& pull = cut.pulls[static_cast<std::size_t>(part.pull)];
      if (pull.force() == 0 || &cut.slices[static_cast<std::size_t>(part.slice)] != &slice) continue;
      const bool is_active = slope.section().bars[static_cast<std::size_t>(pull.bar)].is_active;
      const double force = part.fraction * pull.force() / (is_active ? 1 : factor);
      about +=
          way * force *
          ((pull.at[1] - y) * part.direction[0] - (pull.at[0] - 0.5 * (slice.left + slice.right)) * part.direction[1]);
    }
    e = f.normal_side;
    x = f.shear_side;
    moment = about + y * e;
    if (std::abs(e) > 1e-3 * largest) level[i] = moment / e;
  }
}

// Yield acceleration: the horizontal acceleration with which the factor of a surface is 1.

std::optional<double> find_yield_acceleration(const Slope& slope, const CutSurface& cut, Method method,
                                              const Checks& checks) {
  if (slope.before() != nullptr) return std::nullopt;
  CutSurface copy = cut;
  Checks lenient = checks;
  lenient.reject = false;
  const auto excess = [&](double k) {
    const Solution solution = solve_with(slope, copy, method, lenient, false, k);
    return solution.factor > 0 ? solution.factor - 1 : std::nan("");
  };
  double a = 0, fa = excess(0);
  if (!(fa >= 0)) return std::nullopt;
  double b = 0.1, fb = excess(b);
  while (fb > 0 && b < 4) {
    a = b;
    fa = fb;
    b *= 1.5;
    fb = excess(b);
  }
  if (!(fb <= 0)) return std::nullopt;
  // Regula falsi with halving (Illinois).
  for (int i = 0; i < 100 && fb != 0; ++i) {
    const double middle = b - fb * (b - a) / (fb - fa), f = excess(middle), moved = std::abs(middle - b);
    if (std::isnan(f)) return std::nullopt;
    if ((f < 0) != (fb < 0)) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = middle;
    fb = f;
    if (moved < 1e-12) break;
  }
  return b;
}

}  // namespace talus::lem
