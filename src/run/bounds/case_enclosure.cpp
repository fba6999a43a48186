// SPDX-License-Identifier: MIT
// Strengths and pore pressures on the safe side of each bound, and the comparison of the fields with the case.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>

#include "run/bounds/case_fields.hpp"

namespace talus::run {

namespace {

/// Parts of a side of a triangle between the points at which strengths and pressures are compared.
constexpr int lattice = 8;
/// Differences up to this fraction of the largest overburden are rounding errors.
constexpr double rounding = 1e-7;
/// Points of each triangle that the comparison draws at random, and the seed.
constexpr int drawn = 12;
constexpr unsigned seed = 20261130;
/// Relative change of a bound by the comparison above which it is withdrawn, and below which it is rounding.
constexpr double most_change = 0.05, no_change = 1e-6;

Weights move_inwards(Weights w) {
  for (double& x : w) x = (1 - inwards) * x + inwards / 3;
  return w;
}

/// Points of a triangle in rows, the corners first.
struct Lattice {
  std::vector<Weights> points;
  std::array<std::array<std::size_t, lattice + 1>, lattice + 1> number{};  ///< of the point with these two indices

  Lattice() {
    const auto add = [&](int i, int j) {
      number[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = points.size();
      points.push_back(move_inwards({double(i) / lattice, double(j) / lattice, double(lattice - i - j) / lattice}));
    };
    add(lattice, 0);
    add(0, lattice);
    add(0, 0);
    for (int i = 0; i < lattice; ++i)
      for (int j = 0; j <= lattice - i; ++j)
        if (j < lattice && i + j > 0) add(i, j);
  }

  /// Returns the largest second difference of values at the points, in six directions, times `sign`; at least 0.
  double find_second_difference(const double* values, double sign) const {
    constexpr std::array<std::array<int, 2>, 6> directions{{{1, 0}, {0, 1}, {1, -1}, {1, 1}, {2, -1}, {1, -2}}};
    const auto at = [&](int i, int j) {
      return values[number[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]];
    };
    double most = 0;
    for (int i = 0; i <= lattice; ++i)
      for (int j = 0; j <= lattice - i; ++j)
        for (const auto& [di, dj] : directions) {
          const int rest = lattice - i - j, step = di + dj;
          if (std::min({i - di, j - dj, i + di, j + dj, rest - step, rest + step}) < 0) continue;
          most = std::max(most, sign * (at(i - di, j - dj) - 2 * at(i, j) + at(i + di, j + dj)));
        }
    return most;
  }
};

const Lattice& get_lattice() {
  static const Lattice all;
  return all;
}

double interpolate(const std::array<double, 3>& corner, const Weights& w) {
  return w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2];
}

std::array<Vec<2>, 3> get_corners(const bounds::Problem& problem, std::size_t e) {
  std::array<Vec<2>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = problem.nodes[static_cast<std::size_t>(problem.triangles[e][i])];
  return corners;
}

Vec<2> find_place(const bounds::Problem& problem, std::size_t e, const Weights& w) {
  const std::array<Vec<2>, 3> corners = get_corners(problem, e);
  Vec<2> x{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t d = 0; d < 2; ++d) x[d] += w[i] * corners[i][d];
  return x;
}

/// Returns the points of triangles; `origins`: of all triangles in the first mesh.
std::vector<SoilPlace> list_places(const bounds::Problem& problem, const std::vector<std::size_t>& origins,
                                   const std::vector<std::size_t>& triangles, const std::vector<Weights>& points) {
  std::vector<SoilPlace> places;
  for (const std::size_t e : triangles)
    for (const Weights& w : points) places.push_back({origins[e], find_place(problem, e, w)});
  return places;
}

/// Returns the corners of the linear function with these values at the first points of the lattice.
std::array<double, 3> find_corners(const double* values) {
  const double mean = (values[0] + values[1] + values[2]) / 3;
  std::array<double, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) corners[i] = (values[i] - inwards * mean) / (1 - inwards);
  return corners;
}

/// Returns the largest shortage of the linear function between corners at points.
double find_shortage(const std::array<double, 3>& corner, const std::vector<Weights>& points, const double* values) {
  double most = 0;
  for (std::size_t k = 0; k < points.size(); ++k) most = std::max(most, values[k] - interpolate(corner, points[k]));
  return most;
}

/// Returns what each corner must have more so that the function is not short of `values`, each by its weight. Corners
/// with `keep` have nothing more; points at which the others weigh nothing are left out.
Weights find_lift(const std::array<double, 3>& corner, const std::vector<Weights>& points, const double* values,
                  const std::array<bool, 3>& keep) {
  Weights more{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double lack = values[k] - interpolate(corner, points[k]);
    Weights w = points[k];
    for (std::size_t i = 0; i < 3; ++i)
      if (keep[i]) w[i] = 0;
    const double square = dot(w, w);
    if (!(lack > 0) || square < inwards * inwards) continue;
    for (std::size_t i = 0; i < 3; ++i) more[i] = std::max(more[i], lack * w[i] / square);
  }
  return more;
}

/// Adds to the corners what the linear function between them is short of `values` at points. Corners with zero keep it
/// where that is enough: soil without tensile strength cannot carry a pore pressure on its free surface. Returns the
/// largest shortage before.
double lift(std::array<double, 3>& corner, const std::vector<Weights>& points, const double* values, double tolerance) {
  const std::array<double, 3> before = corner;
  for (const bool keeps_zero : {true, false}) {
    corner = before;
    std::array<bool, 3> keep{};
    for (std::size_t i = 0; i < 3; ++i) keep[i] = keeps_zero && before[i] == 0;
    const Weights more = find_lift(before, points, values, keep);
    for (std::size_t i = 0; i < 3; ++i) corner[i] += more[i];
    if (find_shortage(corner, points, values) <= tolerance) break;
  }
  return find_shortage(before, points, values);
}

/// The same below `values`.
double lower(std::array<double, 3>& corner, const std::vector<Weights>& points, const double* values,
             double tolerance) {
  std::array<double, 3> opposite{-corner[0], -corner[1], -corner[2]};
  std::vector<double> opposites(values, values + points.size());
  for (double& v : opposites) v = -v;
  const double most = lift(opposite, points, opposites.data(), tolerance);
  for (std::size_t i = 0; i < 3; ++i) corner[i] = -opposite[i];
  return most;
}

/// Multiplies the corners so that the linear function between them, which is not negative, exceeds none of `values`.
/// Returns the largest excess.
double scale(std::array<double, 3>& corner, const std::vector<Weights>& points, const double* values,
             double /*tolerance*/) {
  double ratio = 1, most = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double linear = interpolate(corner, points[k]);
    if (!(linear > values[k])) continue;
    most = std::max(most, linear - values[k]);
    ratio = std::min(ratio, values[k] / linear);
  }
  for (double& c : corner) c *= ratio;
  return most;
}

/// Puts values of a triangle on one side of `values` where they differ by more than rounding.
template <class Move>
bool enclose(std::array<double, 3>& corner, const std::vector<Weights>& points, const double* values, double tolerance,
             Move move) {
  std::array<double, 3> moved = corner;
  if (!(move(moved, points, values, tolerance) > tolerance)) return false;
  corner = moved;
  return true;
}

std::array<double, 3> get_cohesion(const bounds::Problem& problem, std::size_t e) {
  const auto& s = problem.strength[e];
  return {s[0].cohesion, s[1].cohesion, s[2].cohesion};
}

void set_cohesion(bounds::Problem& problem, std::size_t e, const std::array<double, 3>& cohesion) {
  for (std::size_t i = 0; i < 3; ++i) problem.strength[e][i].cohesion = cohesion[i];
}

/// Encloses the cohesion of a triangle on the safe side of a bound.
bool enclose_cohesion(bounds::Problem& problem, std::size_t e, bounds::Bound bound, const std::vector<Weights>& points,
                      const double* values, double tolerance) {
  std::array<double, 3> own = get_cohesion(problem, e);
  const bool is_moved = enclose(own, points, values, tolerance, bound == bounds::Bound::lower ? scale : lift);
  set_cohesion(problem, e, own);
  return is_moved;
}

bool enclose_pressure(bounds::Problem& problem, std::size_t e, bounds::Bound bound, const std::vector<Weights>& points,
                      const double* values, double tolerance) {
  return enclose(problem.pore_pressure[e], points, values, tolerance, bound == bounds::Bound::lower ? lift : lower);
}

}  // namespace

CaseEnclosure::CaseEnclosure(std::shared_ptr<const CaseFields> fields, const bounds::Problem& first)
    : fields_(std::move(fields)),
      kinks_(fields_->list_kinks()),
      rounding_(rounding * bounds::find_units(first).stress),
      bends_strength_(first.size(), false),
      bends_pressure_(first.size(), false) {
  std::vector<std::size_t> variable, all(first.size());
  for (std::size_t e = 0; e < first.size(); ++e) {
    all[e] = e;
    if (fields_->has_variable_strength(e)) variable.push_back(e);
  }
  const auto differs = [&](const std::array<double, 3>& corner, const std::vector<Weights>& points,
                           const double* values) {
    for (std::size_t k = 0; k < points.size(); ++k)
      if (!(std::abs(values[k] - interpolate(corner, points[k])) <= rounding_)) return true;
    return false;
  };
  const Sampled cohesions = sample(
      first, all, variable, [&](const auto& places) { return fields_->find_cohesions(places, bounds::Bound::lower); });
  for (std::size_t k = 0; k < variable.size(); ++k)
    bends_strength_[variable[k]] =
        differs(get_cohesion(first, variable[k]), cohesions.points[k], cohesions.get_values(k));
  if (!fields_->has_pressure()) return;
  const Sampled pressures =
      sample(first, all, all, [&](const auto& places) { return fields_->find_pressures(places); });
  for (std::size_t e = 0; e < first.size(); ++e)
    bends_pressure_[e] = differs(first.pore_pressure[e], pressures.points[e], pressures.get_values(e));
}

bool CaseEnclosure::is_needed() const {
  const auto is_set = [](bool b) { return b; };
  return std::any_of(bends_strength_.begin(), bends_strength_.end(), is_set) ||
         std::any_of(bends_pressure_.begin(), bends_pressure_.end(), is_set);
}

std::string CaseEnclosure::describe_gap() const {
  if (!fields_->takes_spline()) return "";
  return "the pore pressures come from a spline, which limit analysis evaluates at 45 points of each triangle and does "
         "not enclose between them";
}

/// Returns the points of the lattice, and those inside the corners of the parts into which lines divide the triangle.
std::vector<Weights> CaseEnclosure::list_points(const bounds::Problem& problem, std::size_t triangle) const {
  std::vector<Weights> points = get_lattice().points;
  const std::vector<Weights> more = kinks_.list(get_corners(problem, triangle));
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

template <class Find>
CaseEnclosure::Sampled CaseEnclosure::sample(const bounds::Problem& problem, const std::vector<std::size_t>& origins,
                                             const std::vector<std::size_t>& triangles, Find find) const {
  Sampled sampled;
  std::vector<SoilPlace> places;
  for (const std::size_t e : triangles) {
    sampled.first.push_back(places.size());
    sampled.points.push_back(list_points(problem, e));
    for (const Weights& w : sampled.points.back()) places.push_back({origins[e], find_place(problem, e, w)});
  }
  sampled.values = find(places);
  return sampled;
}

void CaseEnclosure::apply(bounds::Problem& problem, bounds::Bound bound) const {
  const std::vector<std::size_t> origins = fields_->find_origins(problem);
  std::vector<std::size_t> of_strength, of_pressure;
  for (std::size_t e = 0; e < problem.size(); ++e) {
    if (bends_strength_[origins[e]]) of_strength.push_back(e);
    if (bends_pressure_[origins[e]]) of_pressure.push_back(e);
  }
  const double safe = bound == bounds::Bound::lower ? 1 : -1;
  // A function that is to be below `values` lies above the chords of a lattice where it is concave, and conversely.
  const auto shift = [](Sampled& sampled, std::size_t k, double more) {
    for (std::size_t i = 0; i < sampled.points[k].size(); ++i) sampled.values[sampled.first[k] + i] += more;
  };
  const auto move = [&](Sampled& sampled, std::size_t k, double sign, double least) {
    const double more = sign * std::max(least, get_lattice().find_second_difference(sampled.get_values(k), -sign));
    shift(sampled, k, more);
  };
  Sampled cohesions =
      sample(problem, origins, of_strength, [&](const auto& places) { return fields_->find_cohesions(places, bound); });
  for (std::size_t k = 0; k < of_strength.size(); ++k) {
    const std::size_t e = of_strength[k];
    if (fields_->has_curved_strength(origins[e]))
      move(cohesions, k, -safe, fields_->find_product_error(origins[e], get_corners(problem, e)));
    for (std::size_t i = 0; i < cohesions.points[k].size(); ++i)
      cohesions.values[cohesions.first[k] + i] = std::max(0.0, cohesions.values[cohesions.first[k] + i]);
    const double* values = cohesions.get_values(k);
    std::array<double, 3> corners = find_corners(values);
    for (double& c : corners) c = std::max(0.0, c);
    set_cohesion(problem, e, corners);
    enclose_cohesion(problem, e, bound, cohesions.points[k], values, rounding_);
  }
  if (of_pressure.empty()) return;
  Sampled pressures =
      sample(problem, origins, of_pressure, [&](const auto& places) { return fields_->find_pressures(places); });
  for (std::size_t k = 0; k < of_pressure.size(); ++k) {
    const std::size_t e = of_pressure[k];
    if (fields_->has_curved_pressure(origins[e])) move(pressures, k, safe, 0);
    std::vector<Vec<2>> at;
    for (const Weights& w : pressures.points[k]) at.push_back(find_place(problem, e, w));
    shift(pressures, k, safe * fields_->find_ratio_error(origins[e], get_corners(problem, e), at));
    const double* values = pressures.get_values(k);
    std::array<double, 3>& corners = problem.pore_pressure[e];
    corners = find_corners(values);
    for (double& p : corners) p = std::abs(p) <= rounding_ ? 0 : p;
    enclose_pressure(problem, e, bound, pressures.points[k], values, rounding_);
  }
}

namespace {

/// Strength and pore pressure of the case at the points of one mesh that the comparison uses.
class Comparison {
 public:
  Comparison(const CaseFields& fields, const bounds::Problem& problem, bounds::Bound bound)
      : problem_(problem), bound_(bound), units_(bounds::find_units(problem)) {
    for (const Weights& corner : {Weights{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}})
      points_.push_back(move_inwards(corner));
    points_.push_back({1.0 / 3, 1.0 / 3, 1.0 / 3});
    std::mt19937 random(seed);
    for (int i = 0; i < drawn; ++i) {
      // The distances between two sorted numbers are even in a triangle.
      const auto draw = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
      const auto [first, second] = std::minmax({draw(), draw()});
      points_.push_back({first, second - first, 1 - second});
    }
    const std::vector<std::size_t> origins = fields.find_origins(problem);
    for (std::size_t e = 0; e < problem.size(); ++e)
      if (fields.has_pressure() || fields.has_variable_strength(origins[e])) triangles_.push_back(e);
    const std::vector<SoilPlace> places = list_places(problem, origins, triangles_, points_);
    cohesions_ = fields.find_cohesions(places, bound);
    pressures_ = fields.find_pressures(places);
  }

  /// Returns the largest factor that a stress field proves at all points.
  double find_factor(const bounds::StressField& field) {
    double factor = std::numeric_limits<double>::infinity();
    const double least = bounds::least_strength * units_.stress;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < points_.size(); ++k) {
        const std::size_t e = triangles_[t], i = t * points_.size() + k;
        const Weights& w = points_[k];
        bounds::Strength soil = problem_.strength[e][0];
        soil.cohesion = cohesions_[i];
        const double more = pressures_[i] - interpolate(problem_.pore_pressure[e], w);
        bounds::Stress stress{};
        for (std::size_t d = 0; d < 3; ++d) {
          for (std::size_t c = 0; c < 3; ++c) stress[d] += w[c] * field.stress[e][c][d];
          if (d < 2) stress[d] += more;
        }
        const double own = bounds::find_factor(bounds::raise_to(soil, least), stress);
        if (own >= factor) continue;
        factor = own;
        is_pressure_ = std::abs(more) > std::abs(cohesions_[i] - interpolate(get_cohesion(problem_, e), w));
      }
    return factor;
  }

  /// Returns the least factor that a mechanism proves with strengths not below and pore pressures not above those of
  /// the case at all points.
  double find_factor(const bounds::VelocityField& field) {
    bounds::Problem safe = problem_;
    bool is_moved = false;
    const double tolerance = rounding * units_.stress;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const std::size_t e = triangles_[t], i = t * points_.size();
      const bool is_wetter = enclose_pressure(safe, e, bound_, points_, &pressures_[i], tolerance);
      is_moved = enclose_cohesion(safe, e, bound_, points_, &cohesions_[i], tolerance) || is_wetter || is_moved;
      is_pressure_ = is_pressure_ || is_wetter;
    }
    if (!is_moved) return 0;
    const bounds::KinematicCheck found = check(safe, field);
    return found.holds ? found.factor : std::numeric_limits<double>::infinity();
  }

  /// Returns why a bound is withdrawn.
  std::string describe() const {
    return is_pressure_ ? "not proven: the pore pressure changes inside the triangles"
                        : "not proven: the strength changes inside the triangles";
  }

 private:
  const bounds::Problem& problem_;
  bounds::Bound bound_;
  bounds::Units units_;
  std::vector<Weights> points_;
  std::vector<std::size_t> triangles_;
  std::vector<double> cohesions_, pressures_;  ///< by triangle, of its points
  bool is_pressure_ = false;
};

}  // namespace

void hold_to_case(const CaseFields& fields, bounds::BoundsResult& found) {
  if (found.lower > 0) {
    Comparison compared(fields, found.stress_problem, bounds::Bound::lower);
    const double factor = compared.find_factor(found.stress);
    if (factor < found.lower * (1 - most_change)) {
      found.no_lower = compared.describe();
      found.lower = 0;
    } else if (factor < found.lower * (1 - no_change)) {
      found.lower = factor;
    }
  }
  if (std::isfinite(found.upper)) {
    Comparison compared(fields, found.velocity_problem, bounds::Bound::upper);
    const double factor = compared.find_factor(found.velocity);
    if (factor > found.upper * (1 + most_change)) {
      found.no_upper = compared.describe();
      found.upper = std::numeric_limits<double>::infinity();
    } else if (factor > found.upper * (1 + no_change)) {
      found.upper = factor;
    }
  }
  for (bounds::BoundsLevel& level : found.levels) {
    level.lower = std::min(level.lower, found.lower);
    level.upper = std::max(level.upper, found.upper);
  }
}

}  // namespace talus::run
