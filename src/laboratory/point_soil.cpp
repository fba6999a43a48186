// SPDX-License-Identifier: MIT
#include "laboratory/point_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "input/case/soil_water_law.hpp"
#include "material/every_law.hpp"

namespace talus::laboratory {

PointSoil::PointSoil(const input::Material& material, const Voigt& stress, double suction, const ShownUnit& unit)
    : law_(std::make_shared<const material::Law>(input::make_law(material))),
      retention_(input::make_retention(material.water)),
      is_wet_(material.water.is_wet()),
      chi_air_entry_(material.water.chi == input::BishopChi::khalili_khabbaz ? material.water.chi_air_entry : 0),
      void_ratio_(material.void_ratio()) {
  start_.stress = stress;
  for (std::size_t i = 0; i < 3; ++i) start_.stress[i] -= find_suction_stress(suction);
  start_.suction = suction;
  set_start_state(material);
  // A stress beyond the strength would change in a step without strain.
  const PointState same = advance(start_, {}, suction);
  throw_failure();
  double largest = 0, jump = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    largest = std::max(largest, std::abs(start_.stress[i]));
    jump = std::max(jump, std::abs(same.stress[i] - start_.stress[i]));
  }
  if (!(jump <= 1e-6 * largest))
    fail_input(
        "the soil does not carry the stress at the start, {} axial and {} radial: it is outside the yield surface{}",
        format_value(-start_.stress[1], unit), format_value(-start_.stress[0], unit),
        find_preconsolidation(start_) > 0
            ? ", whose preconsolidation pressure is " + format_value(find_preconsolidation(start_), unit)
            : "");
}

void PointSoil::set_start_state(const input::Material& material) {
  const double saturation = find_saturation(start_.suction);
  material::StateStart start{start_.stress.data(), void_ratio_, saturation};
  start.root_content = material.root_content;
  start.root_cohesion = material.root_cohesion;
  material::set_initial_state(*law_, material, start, start_.state.data());
  std::visit(
      [&]<class L>([[maybe_unused]] const L& law) {
        if constexpr (material::IsPreconsolidated<L>)
          if (!material.preconsolidation) {
            // Without stages the ratio is that to the initial stress.
            input::Material known = material;
            std::array<double, material::max_state_size> state{};
            law.set_preconsolidation(material.preconsolidation_ratio.value_or(1), start_.stress.data(), state.data());
            known.preconsolidation = state[1];
            material::set_initial_state(*law_, known, start, start_.state.data());
          }
      },
      *law_);
}

PointState PointSoil::advance(const PointState& from, const Voigt& d_epsilon, double suction) const {
  PointState to = from;
  to.suction = suction;
  to.time = from.time + 1;
  const int point = 0;
  const material::Surroundings<double> around{find_saturation(suction), &point, from.time, 1};
  std::visit(
      [&](const auto& law) {
        law.template update<6>(to.stress.data(), d_epsilon.data(), to.state.data(), true, around);
      },
      *law_);
  if (auto failure = material::take_failure(*law_)) {
    failure_ = std::move(failure);
    to.stress.fill(std::numeric_limits<double>::quiet_NaN());  // a caller that ignores the failure must not continue
  }
  return to;
}

void PointSoil::throw_failure() const {
  if (failure_) throw Error(ExitCode::unstable, failure_->describe(""));
}

double PointSoil::find_saturation(double suction) const {
  if (!is_wet_) return 1;
  return std::visit([&](const auto& curve) { return curve.template evaluate<double>(suction).value; }, retention_);
}

double PointSoil::find_suction_stress(double suction) const {
  if (!is_wet_ || suction <= 0) return 0;
  if (chi_air_entry_ <= 0) return find_saturation(suction) * suction;
  return suction * std::pow(std::max(1.0, suction / chi_air_entry_), -0.55);
}

double PointSoil::find_preconsolidation(const PointState& at) const {
  double pressure = 0;
  std::visit(
      [&]<class L>([[maybe_unused]] const L& law) {
        if constexpr (material::IsPreconsolidated<L>)
          pressure = law.find_preconsolidation(at.state.data(), find_saturation(at.suction));
      },
      *law_);
  return pressure;
}

double PointSoil::find_void_ratio(const PointState& at, double volumetric_strain) const {
  return std::visit(
      [&]<class L>(const L&) {
        if constexpr (requires { L::find_void_ratio(at.state.data()); })
          return L::find_void_ratio(at.state.data());
        else
          return (1 + void_ratio_) * std::exp(-volumetric_strain) - 1;
      },
      *law_);
}

namespace {

constexpr int most_iterations = 40, tangent_every = 5, most_halvings = 12;
constexpr double difference = 1e-7;      ///< strain of the difference quotients [-]
constexpr double relative_error = 1e-8;  ///< of the stress reached
constexpr double least_scale = 1e3;      ///< least stress to which errors are relative [Pa]
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

Voigt find_strain(const PointStep& step, const auto& x) {
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
    // The difference has the direction of x, so that the tangent of a yielding soil is that of plastic loading.
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
    // Broyden's update: the error of the prediction by the tangent.
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
