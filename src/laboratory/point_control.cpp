// SPDX-License-Identifier: MIT
#include "laboratory/point_control.hpp"

#include <algorithm>
#include <cmath>

namespace talus::laboratory {
namespace {

constexpr int most_iterations = 40, tangent_every = 5, most_halvings = 12;
constexpr double difference = 1e-7;      ///< strain of the difference quotients [-]
constexpr double relative_error = 1e-8;  ///< of the stress that is reached
constexpr double least_scale = 1e3;      ///< of stresses, against which errors count [Pa]
constexpr double most_strain = 0.02;     ///< of a step; beyond it the soil flows rather than deforms [-]

double measure(const Voigt& functional, const Voigt& stress) {
  double sum = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) sum += functional[i] * stress[i];
  return sum;
}

double find_scale(const PointStep& step, const Voigt& stress) {
  double scale = least_scale;
  for (const double s : stress) scale = std::max(scale, std::abs(s));
  for (std::size_t k = 0; k < step.free_count; ++k) scale = std::max(scale, std::abs(step.target[k]));
  return scale;
}

template <class Vector>
Voigt find_strain(const PointStep& step, const Vector& x) {
  Voigt strain = step.fixed;
  for (std::size_t k = 0; k < step.free_count; ++k)
    for (std::size_t i = 0; i < strain.size(); ++i) strain[i] += x[k] * step.free[k][i];
  return strain;
}

template <class Vector>
Vector find_error(const PointStep& step, const PointState& state) {
  Vector error{};
  for (std::size_t k = 0; k < step.free_count; ++k) error[k] = measure(step.measure[k], state.stress) - step.target[k];
  return error;
}

}  // namespace

void PointStep::add(const Voigt& direction, const Voigt& stress, double goal) {
  free[free_count] = direction;
  measure[free_count] = stress;
  target[free_count++] = goal;
}

void PointController::find_tangent(const PointState& from, const PointStep& step, const Vector& x,
                                   const Vector& error) {
  for (std::size_t j = 0; j < step.free_count; ++j) {
    // Along the way that x goes, so that a yielding soil is met as it yields.
    const double h = std::copysign(difference, x[j]);
    Vector moved = x;
    moved[j] += h;
    const Vector there = find_error<Vector>(step, soil_.advance(from, find_strain(step, moved), step.suction));
    for (std::size_t i = 0; i < step.free_count; ++i) tangent_[i][j] = (there[i] - error[i]) / h;
  }
  has_tangent_ = true;
}

bool PointController::solve(PointState& state, Voigt& strain, const PointStep& step) {
  has_model_failed_ = false;
  const std::size_t n = step.free_count;
  const double tolerance = relative_error * find_scale(step, state.stress);
  Vector x = last_;
  PointState trial = soil_.advance(state, find_strain(step, x), step.suction);
  Vector error = find_error<Vector>(step, trial);
  for (int iteration = 0;; ++iteration) {
    double largest = 0;
    for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, std::abs(error[k]));
    for (const double s : trial.stress)
      if (!std::isfinite(s)) {
        has_model_failed_ = true;
        return has_tangent_ = false;
      }
    if (largest <= tolerance) break;
    if (iteration == most_iterations) return false;
    if (!has_tangent_ || iteration % tangent_every == tangent_every - 1) find_tangent(state, step, x, error);
    const auto& t = tangent_;
    const double determinant = n == 1 ? t[0][0] : t[0][0] * t[1][1] - t[0][1] * t[1][0];
    Vector dx{};
    dx[0] = n == 1 ? -error[0] / determinant : (t[0][1] * error[1] - t[1][1] * error[0]) / determinant;
    if (n == 2) dx[1] = (t[1][0] * error[0] - t[0][0] * error[1]) / determinant;
    double square = 0;
    for (std::size_t k = 0; k < n; ++k) {
      x[k] += dx[k];
      square += dx[k] * dx[k];
      if (!(std::abs(x[k]) <= most_strain)) return has_tangent_ = false;
    }
    trial = soil_.advance(state, find_strain(step, x), step.suction);
    const Vector now = find_error<Vector>(step, trial);
    // Broyden: the error of the tangent's prediction.
    for (std::size_t i = 0; i < n && square > 0; ++i)
      for (std::size_t j = 0; j < n; ++j) tangent_[i][j] += now[i] * dx[j] / square;
    error = now;
  }
  state = trial;
  const Voigt done = find_strain(step, x);
  for (std::size_t i = 0; i < strain.size(); ++i) strain[i] += done[i];
  last_ = x;
  return true;
}

bool PointController::advance(PointState& state, Voigt& strain, const PointStep& step, int halvings) {
  if (solve(state, strain, step)) return true;
  if (halvings == 0) return false;
  PointStep half = step;
  has_tangent_ = false;
  for (double& d : half.fixed) d /= 2;
  for (double& d : last_) d /= 2;
  for (std::size_t k = 0; k < step.free_count; ++k)
    half.target[k] = (measure(step.measure[k], state.stress) + step.target[k]) / 2;
  half.suction = (state.suction + step.suction) / 2;
  if (!advance(state, strain, half, halvings - 1)) return false;
  half.target = step.target;
  half.suction = step.suction;
  return advance(state, strain, half, halvings - 1);
}

bool PointController::advance(PointState& state, Voigt& strain, const PointStep& step) {
  strain = {};
  return advance(state, strain, step, most_halvings);
}

}  // namespace talus::laboratory
