// SPDX-License-Identifier: MIT
#include "laboratory/calibration_search.hpp"

#include <ceres/cost_function.h>
#include <ceres/covariance.h>
#include <ceres/iteration_callback.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/parallel.hpp"

namespace talus::laboratory {
namespace {

/// Of the range of a parameter. The tests are solved to ten digits, so that smaller steps would see their last ones.
constexpr double difference_step = 5e-4;
constexpr double rank_limit = 1e-5;  ///< of singular values, over the largest: below it a direction counts as unfixed
constexpr double felt = 1e-4;        ///< effect of a parameter over its range, in standard errors: below it has none

void refuse_when_interrupted() {
  if (is_interrupted()) throw Error(ExitCode::interrupted, "interrupted; a calibration keeps nothing of what it began");
}

/// The residuals with their derivatives. Ceres has numeric differentiation of its own, which knows of no bounds and
/// gives up where one neighbour is refused; here differences are central where both neighbours can be had, one-sided
/// elsewhere, and columns are calculated side by side.
class Residuals final : public ceres::CostFunction {
 public:
  Residuals(const CalibrationModel& model, int threads) : model_(model), threads_(threads) {
    set_num_residuals(static_cast<int>(model.count_values()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(model.count_parameters()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    try {
      return evaluate(parameters[0], residuals, jacobians == nullptr ? nullptr : jacobians[0]);
    } catch (...) {
      // No exception may pass through Ceres; the search throws it when Ceres has returned.
      failure = std::current_exception();
      return false;
    }
  }

  mutable std::exception_ptr failure;
  mutable long evaluations = 0;

 private:
  bool evaluate(const double* at, double* residuals, double* jacobian) const {
    refuse_when_interrupted();
    const std::size_t m = model_.count_parameters(), n = model_.count_values();
    const std::vector<double> centre(at, at + m);
    const std::size_t sets = jacobian == nullptr ? 1 : 2 * m + 1;
    std::vector<std::optional<Comparison>> found(sets);
    std::vector<double> step(sets, 0);
    for (std::size_t s = 1; s < sets; ++s) {
      const double u = centre[(s - 1) / 2], wanted = u + (s % 2 == 1 ? difference_step : -difference_step);
      step[s] = std::clamp(wanted, 0.0, 1.0) - u;
    }
    parallel_tasks(static_cast<int>(sets), threads_, [&](int task) {
      const auto s = static_cast<std::size_t>(task);
      std::vector<double> places = centre;
      if (s > 0) places[(s - 1) / 2] += step[s];
      if (s == 0 || step[s] != 0) found[s] = model_.compare(places);
    });
    evaluations += static_cast<long>(sets);
    if (!found[0]) return false;
    std::copy(found[0]->residuals.begin(), found[0]->residuals.end(), residuals);
    for (std::size_t j = 0; j < m && jacobian != nullptr; ++j) {
      const std::size_t up = found[2 * j + 1] ? 2 * j + 1 : 0, down = found[2 * j + 2] ? 2 * j + 2 : 0;
      const double distance = step[up] - step[down];
      for (std::size_t i = 0; i < n; ++i)
        jacobian[i * m + j] = distance > 0 ? (found[up]->residuals[i] - found[down]->residuals[i]) / distance : 0;
    }
    return true;
  }

  const CalibrationModel& model_;
  int threads_;
};

/// Tells of the progress, and ends the search when the user wishes so.
class Watch final : public ceres::IterationCallback {
 public:
  explicit Watch(const std::function<void(int, double)>& tell) : tell_(tell) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (tell_) tell_(summary.iteration, summary.cost);
    return is_interrupted() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::function<void(int, double)>& tell_;
};

ceres::Problem::Options keep_residuals() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

}  // namespace

Search search(const CalibrationModel& model, const std::vector<double>& from, const SearchOptions& options) {
  std::string why;
  if (!model.compare(from, &why)) throw Error(ExitCode::wrong_input, why);
  Search result;
  result.places = from;
  Residuals residuals(model, options.threads);
  ceres::Problem problem(keep_residuals());
  double* places = result.places.data();
  problem.AddResidualBlock(&residuals, nullptr, places);
  for (int i = 0; i < static_cast<int>(from.size()); ++i) {
    problem.SetParameterLowerBound(places, i, 0);
    problem.SetParameterUpperBound(places, i, 1);
  }
  Watch watch(options.watch);
  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::DENSE_QR;
  settings.max_num_iterations = options.iterations;
  settings.max_num_consecutive_invalid_steps = 20;
  settings.function_tolerance = 1e-10;
  settings.parameter_tolerance = 1e-9;
  settings.gradient_tolerance = 1e-12;
  settings.logging_type = ceres::SILENT;
  settings.num_threads = 1;  // the tests are what takes time, and they are run side by side
  settings.callbacks.push_back(&watch);
  ceres::Solver::Summary summary;
  ceres::Solve(settings, &problem, &summary);
  if (residuals.failure) std::rethrow_exception(residuals.failure);
  refuse_when_interrupted();
  result.summary = {model.find_values(from),
                 model.find_values(result.places),
                 summary.final_cost,
                 summary.initial_cost,
                 summary.termination_type == ceres::CONVERGENCE,
                 static_cast<int>(summary.iterations.size()) - 1,
                 summary.message};
  result.evaluations = residuals.evaluations;
  result.log = summary.FullReport();
  return result;
}

Certainty find_certainty(const CalibrationModel& model, const std::vector<double>& places, int threads) {
  Certainty result;
  const std::size_t m = places.size();
  const int n = static_cast<int>(model.count_values());
  Residuals residuals(model, threads);
  std::vector<double> at = places;
  std::vector<double> values(static_cast<std::size_t>(n)), jacobian(static_cast<std::size_t>(n) * m);
  double* const block = at.data();
  double* derivatives = jacobian.data();
  residuals.Evaluate(&block, values.data(), &derivatives);
  if (residuals.failure) std::rethrow_exception(residuals.failure);
  result.evaluations = residuals.evaluations;
  std::vector<int> held, free;
  for (int i = 0; i < static_cast<int>(m); ++i)
    (at[static_cast<std::size_t>(i)] <= 0 || at[static_cast<std::size_t>(i)] >= 1 ? held : free).push_back(i);
  if (free.empty()) return result;
  // A direction without any effect is looked for with columns of length 1, or units would decide.
  Eigen::MatrixXd scaled(n, static_cast<Eigen::Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    for (int i = 0; i < n; ++i)
      scaled(i, column) = jacobian[static_cast<std::size_t>(i) * m + static_cast<std::size_t>(free[k])];
    const double norm = scaled.col(column).norm();
    scaled.col(column) *= norm > felt ? 1 / norm : 0;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeFullV);
  for (Eigen::Index k = 0; k < scaled.cols(); ++k) {
    const bool is_fixed =
        k < svd.singularValues().size() && svd.singularValues()(k) > rank_limit * svd.singularValues()(0);
    if (is_fixed) continue;
    std::vector<double> direction(m, 0);
    for (std::size_t j = 0; j < free.size(); ++j)
      direction[static_cast<std::size_t>(free[j])] = svd.matrixV()(static_cast<Eigen::Index>(j), k);
    result.unfixed.push_back(std::move(direction));
  }
  if (!result.unfixed.empty()) return result;
  ceres::Problem problem(keep_residuals());
  problem.AddResidualBlock(&residuals, nullptr, block);
  if (!held.empty()) problem.SetManifold(block, new ceres::SubsetManifold(static_cast<int>(m), held));
  ceres::Covariance::Options settings;
  settings.algorithm_type = ceres::DENSE_SVD;
  settings.min_reciprocal_condition_number = 1e-40;  // looked for above, without regard to units
  ceres::Covariance covariance(settings);
  std::vector<double> matrix(m * m);
  const std::vector<const double*> blocks{block};
  if (!covariance.Compute(blocks, &problem) || !covariance.GetCovarianceBlock(block, block, matrix.data())) {
    if (residuals.failure) std::rethrow_exception(residuals.failure);
    throw Error(ExitCode::internal_error, "the covariance of the parameters cannot be calculated");
  }
  result.evaluations = residuals.evaluations;
  for (std::size_t i = 0; i < m; ++i)
    result.covariance.emplace_back(matrix.begin() + static_cast<std::ptrdiff_t>(i * m),
                                   matrix.begin() + static_cast<std::ptrdiff_t>((i + 1) * m));
  return result;
}

}  // namespace talus::laboratory
