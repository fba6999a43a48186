// SPDX-License-Identifier: MIT
#include "laboratory/calibration.hpp"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "laboratory/calibration_model.hpp"

namespace talus::laboratory {

namespace {

using results::AtLimit;

constexpr double strong_correlation = 0.95;
constexpr double share_of_direction = 0.2;  ///< smaller components of a direction are not listed
constexpr double alike = 0.01;              ///< of the misfit: largest difference of equally good searches
constexpr double apart = 0.01;              ///< of the range of a parameter

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

void add_limits(const input::Calibration& calibration, const results::Calibration& result,
                std::vector<std::string>& list) {
  for (std::size_t i = 0; i < result.parameters.size(); ++i)
    if (const results::CalibratedParameter& p = result.parameters[i]; p.limit != AtLimit::no)
      list.push_back(fmt::format(
          "'{}' ended at its {} value, {:.5g}{}{}: the curves require {}. Widen the range, or check the model. It has "
          "no standard error; those of the others treat it as known.",
          p.key, p.limit == AtLimit::low ? "smallest" : "largest", p.value / calibration.parameters[i].factor,
          p.unit.empty() ? "" : " ", p.unit, p.limit == AtLimit::low ? "less" : "more"));
}

void add_unfixed(const results::Calibration& result, const std::vector<std::vector<double>>& unfixed,
                 std::vector<std::string>& list) {
  for (const std::vector<double>& direction : unfixed) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < direction.size(); ++i)
      if (std::abs(direction[i]) > share_of_direction) names.push_back("'" + result.parameters[i].key + "'");
    list.push_back(names.size() == 1
                       ? fmt::format("The curves do not depend on {}: its value is that of the start. Leave it out, or "
                                     "add a test that depends on it; there are no standard errors.",
                                     names[0])
                       : fmt::format("The curves determine only a combination of {}. Fix one of them, or add a test "
                                     "that separates them; there are no standard errors.",
                                     join(names)));
  }
}

void add_correlations(const results::Calibration& result, std::vector<std::string>& list) {
  for (std::size_t i = 0; i < result.parameters.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const auto c = result.correlation[i][j]; c && std::abs(*c) > strong_correlation)
        list.push_back(
            fmt::format("These curves hardly separate '{}' and '{}' (correlation {:.3f}): a {} of one compensates for "
                        "a {} of the other.",
                        result.parameters[j].key, result.parameters[i].key, *c, "larger value",
                        *c > 0 ? "larger value" : "smaller value"));
}

/// Lists searches with nearly the same misfit but other values.
void add_rivals(const results::Calibration& result, std::vector<std::string>& list) {
  const results::CalibrationSearch& best = result.starts[result.best];
  std::size_t rivals = 0, agree = 0;
  for (const results::CalibrationSearch& start : result.starts) {
    // Misfits that are rounding errors count as equal.
    const double slack = std::max(alike * best.misfit, 1e-6 * static_cast<double>(result.values));
    if (start.misfit > best.misfit + slack) continue;
    double distance = 0;
    for (std::size_t i = 0; i < result.parameters.size(); ++i) {
      const results::CalibratedParameter& p = result.parameters[i];
      distance = std::max(distance, std::abs(start.to[i] - best.to[i]) / (p.high - p.low));
    }
    ++(distance > apart ? rivals : agree);
  }
  if (rivals > 0)
    list.push_back(fmt::format("{} of {} searches reached the same misfit with other values: the fit is not unique.",
                               rivals, result.starts.size()));
  if (result.starts.size() > 2 && agree == 1 && rivals == 0)
    list.push_back("Only one search reached this misfit, so a better fit may exist. Use more 'starts'.");
}

}  // namespace

std::vector<std::string> list_findings(const input::Calibration& calibration, const results::Calibration& result,
                                       const std::vector<std::vector<double>>& unfixed, double freedom) {
  std::vector<std::string> list;
  if (!result.starts[result.best].converged)
    list.push_back(fmt::format("The best search did not converge: {} Raise 'iterations', or begin nearer.",
                               result.starts[result.best].message));
  add_limits(calibration, result, list);
  add_unfixed(result, unfixed, list);
  add_correlations(result, list);
  for (const results::CalibratedCurve& c : result.curves)
    if (c.missing > 1e-6)
      list.push_back(
          fmt::format("'{}' does not reach all abscissae of its {} curve: {:.3g} % of them are missing on "
                      "average; each such point counts as missed by 100 standard errors and more.",
                      c.test, c.y.name, 100 * c.missing));
  add_rivals(result, list);
  if (freedom <= 0)
    list.push_back(
        "There are no more measured values than parameters: the fit is exact for any errors, so no standard errors can "
        "be given.");
  if (static_cast<int>(result.starts.size()) < calibration.starts)
    list.push_back(fmt::format("Only {} of {} searches could begin: the case refuses most values within the limits.",
                               result.starts.size(), calibration.starts));
  return list;
}

namespace {

constexpr double rank_limit =
    1e-5;                      ///< of singular values, over the largest: below it a direction counts as undetermined
constexpr double felt = 1e-4;  ///< effect of a parameter over its range, in standard errors: below it there is none

double sum_squares(const std::vector<double>& residuals) {
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return sum;
}

void refuse_when_interrupted() {
  if (is_interrupted()) throw Error(ExitCode::interrupted, "interrupted; a calibration keeps nothing of what it began");
}

/// Residuals and their derivatives. The numeric differentiation of Ceres has no bounds and fails if a neighbour is
/// invalid. Here differences are central if both neighbours are valid and one-sided otherwise, and columns are
/// computed in parallel.
class Residuals final : public ceres::CostFunction {
 public:
  Residuals(const CalibrationModel& model, int threads) : model_(model), threads_(threads) {
    set_num_residuals(static_cast<int>(model.count_values()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(model.count_parameters()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    double* const jacobian = jacobians == nullptr ? nullptr : jacobians[0];
    try {
      if (!failure) return evaluate(parameters[0], residuals, jacobian);
    } catch (...) {
      failure = std::current_exception();
    }
    // No exception may pass through Ceres, and it logs evaluations that fail. At zeros it ends, and the search
    // rethrows.
    const int count = num_residuals();
    std::fill_n(residuals, count, 0.0);
    if (jacobian != nullptr) std::fill_n(jacobian, count * parameter_block_sizes().front(), 0.0);
    return true;
  }

  mutable std::exception_ptr failure;
  mutable long evaluations = 0;
  std::function<void(const std::vector<double>&, double)> tried;

 private:
  bool evaluate(const double* at, double* residuals, double* jacobian) const {
    refuse_when_interrupted();
    const std::size_t m = model_.count_parameters(), n = model_.count_values();
    const std::vector<double> centre(at, at + m);
    const std::size_t sets = jacobian == nullptr ? 1 : 2 * m + 1;
    std::vector<std::optional<Comparison>> found(sets);
    std::vector<double> step(sets, 0);
    for (std::size_t s = 1; s < sets; ++s) {
      const double u = centre[(s - 1) / 2], wanted = u + (s % 2 == 1 ? 1 : -1) * model_.difference_step();
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
    if (tried) tried(centre, 0.5 * sum_squares(found[0]->residuals));
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

/// Reports the progress, and ends the search when the user interrupts.
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
  if (!model.compare(from, &why)) fail_input(why);
  Search result;
  result.places = from;
  Residuals residuals(model, options.threads);
  residuals.tried = options.tried;
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
  settings.function_tolerance = model.search_tolerance();
  settings.parameter_tolerance = 0.1 * model.search_tolerance();
  settings.gradient_tolerance = 1e-12;
  settings.logging_type = ceres::SILENT;
  settings.num_threads = 1;  // the tests take the time, and they run in parallel
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
  std::vector<int> free;
  for (int i = 0; i < static_cast<int>(m); ++i)
    if (at[static_cast<std::size_t>(i)] > 0 && at[static_cast<std::size_t>(i)] < 1) free.push_back(i);
  if (free.empty()) return result;
  // Columns are scaled to length 1 for the search of a direction without effect, which would otherwise depend on the
  // units.
  Eigen::MatrixXd scaled(n, static_cast<Eigen::Index>(free.size()));
  Eigen::VectorXd scale(static_cast<Eigen::Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    for (int i = 0; i < n; ++i)
      scaled(i, column) = jacobian[static_cast<std::size_t>(i) * m + static_cast<std::size_t>(free[k])];
    const double norm = scaled.col(column).norm();
    scale(column) = norm > felt ? 1 / norm : 0;
    scaled.col(column) *= scale(column);
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
  // (JᵀJ)⁻¹ of the scaled columns, and back to the places.
  const Eigen::MatrixXd& v = svd.matrixV();
  const Eigen::VectorXd weights = svd.singularValues().cwiseAbs2().cwiseInverse();
  const Eigen::MatrixXd inverse = scale.asDiagonal() * v * weights.asDiagonal() * v.transpose() * scale.asDiagonal();
  result.covariance.assign(m, std::vector<double>(m, 0));
  for (std::size_t k = 0; k < free.size(); ++k)
    for (std::size_t l = 0; l < free.size(); ++l)
      result.covariance[static_cast<std::size_t>(free[k])][static_cast<std::size_t>(free[l])] =
          inverse(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l));
  return result;
}

namespace {

constexpr double at_limit = 1e-6;  ///< of the range: a parameter nearer to its end counts as at its limit
constexpr int most_draws = 200;    ///< attempts to draw a random start that is a valid case

/// Uniform random numbers that, unlike those of <random>, are the same with every compiler.
class Draw {
 public:
  explicit Draw(int seed) : engine_(static_cast<std::uint64_t>(seed)) {}
  double next() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

/// Chooses the starts of the searches: the values of the user, then random ones.
std::vector<std::vector<double>> choose_starts(const CalibrationModel& model, const input::Calibration& calibration,
                                               long& evaluations) {
  const std::size_t m = model.count_parameters();
  std::vector<std::vector<double>> starts(1);
  for (std::size_t i = 0; i < m; ++i) starts[0].push_back(model.find_place(i, calibration.parameters[i].first));
  Draw draw(calibration.seed);
  std::vector<double> places(m);
  for (int k = 0; k < most_draws * calibration.starts && static_cast<int>(starts.size()) < calibration.starts; ++k) {
    for (double& u : places) u = draw.next();
    ++evaluations;
    if (model.compare(places)) starts.push_back(places);
  }
  return starts;
}

/// Moves places to a limit that a search has reached within its tolerance.
std::vector<double> snap(std::vector<double> places) {
  for (double& u : places) u = u < at_limit ? 0 : u > 1 - at_limit ? 1 : u;
  return places;
}

/// Adds what was measured and computed, and their differences.
void add_values(const std::vector<std::array<double, 2>>& points, results::CalibratedCurve& f) {
  const auto n = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    f.at.push_back(points[i][0]);
    f.measured.push_back(points[i][1]);
    const double now = f.fitted[i] - f.measured[i], then = f.before[i] - f.measured[i];
    f.rms += now * now / n;
    f.rms_before += then * then / n;
    f.mean += now / n;
    if (std::abs(now) >= std::abs(f.largest)) f.largest = now, f.largest_at = f.at[i];
  }
  f.rms = std::sqrt(f.rms);
  f.rms_before = std::sqrt(f.rms_before);
}

std::vector<results::CalibratedCurve> describe_curves(const input::Calibration& calibration, const Comparison& before,
                                                      const Comparison& fitted) {
  std::vector<results::CalibratedCurve> curves;
  const auto add = [&](const auto& measured, const std::string& of, const std::string& x, const std::string& y) {
    const std::size_t k = curves.size();
    results::CalibratedCurve& f = curves.emplace_back();
    f.test = of, f.x.name = x, f.y.name = y, f.deviation = measured.deviation, f.weight = measured.weight;
    f.before = before.values[k], f.fitted = fitted.values[k], f.missing = fitted.missing[k];
    f.line_before = before.lines[k], f.line = fitted.lines[k];
    add_values(measured.points, f);
  };
  for (const input::MeasuredCurve& c : calibration.curves) add(c, c.test, c.x, c.y);
  for (const input::MonitoredCurve& c : calibration.monitors) add(c, c.monitor, time_axis, input::get_word(c.quantity));
  return curves;
}

/// Computes standard errors and correlations, scaled with the remaining scatter.
void add_certainty(const CalibrationModel& model, const std::vector<double>& places, const Certainty& certainty,
                   results::Calibration& result) {
  const std::size_t m = places.size();
  result.correlation.assign(m, std::vector<std::optional<double>>(m));
  if (certainty.covariance.empty()) return;
  const auto& c = certainty.covariance;
  for (std::size_t i = 0; i < m; ++i) {
    if (c[i][i] <= 0) continue;  // fixed at a limit
    result.parameters[i].error = std::sqrt(c[i][i]) * result.scatter * model.find_slope(i, places[i]);
    for (std::size_t j = 0; j < m; ++j)
      if (c[j][j] > 0) result.correlation[i][j] = c[i][j] / std::sqrt(c[i][i] * c[j][j]);
  }
}

/// The best places of all searches so far, of which an interruption tells the user.
struct BestPlaces {
  std::vector<double> places;
  double misfit = 0, first_misfit = 0;

  void take(const std::vector<double>& tried, double its_misfit) {
    if (places.empty()) first_misfit = its_misfit;
    if (!places.empty() && its_misfit >= misfit) return;
    places = tried;
    misfit = its_misfit;
  }
};

std::string describe_interruption(const CalibrationModel& model, const input::Calibration& calibration,
                                  const BestPlaces& best, const EvaluationStore* store) {
  const std::string kept = store == nullptr || store->size() == 0
                               ? ""
                               : fmt::format("; {} evaluations are in '{}', from which --resume continues",
                                             store->size(), store->file().string());
  if (best.places.empty())
    return "interrupted before any set of parameters was compared" + (kept.empty() ? "; nothing is written" : kept);
  std::string starts;
  for (std::size_t i = 0; i < best.places.size(); ++i)
    starts += fmt::format(" --set calibration.parameter.{}.start={}", i,
                          write_shortest(model.find_value(i, best.places[i]) / calibration.parameters[i].factor));
  return fmt::format(
      "interrupted{}. To begin anew from the best parameters so far (misfit {:.4g}, at the start {:.4g}), add{}",
      kept.empty() ? "; nothing is written" : kept, best.misfit, best.first_misfit, starts);
}

results::Calibration search_parameters(const input::Case& data, const CalibrationModel& model,
                                       const CalibrationOptions& options, BestPlaces& best, std::string* log) {
  const input::Calibration& calibration = *data.calibration;
  results::Calibration result;
  const std::vector<std::vector<double>> starts = choose_starts(model, calibration, result.evaluations);
  std::vector<Search> searches;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    SearchOptions how{calibration.iterations, options.threads, nullptr,
                      [&](const std::vector<double>& places, double misfit) { best.take(places, misfit); }};
    how.watch = [&](int iteration, double misfit) {
      if (options.progress == nullptr || !options.progress->is_due()) return;
      options.progress->show(fmt::format("[{} of {}] iteration {}, misfit {:.4g}, {} tests", k + 1, starts.size(),
                                         iteration, misfit, model.count_runs()));
    };
    try {
      searches.push_back(search(model, starts[k], how));
    } catch (const Error& error) {
      if (error.code() != ExitCode::wrong_input) throw;
      throw Error(error.code(), "the search cannot begin at the values of 'start': {}", error.what());
    }
    result.evaluations += searches.back().evaluations;
    result.starts.push_back(searches.back().summary);
    if (result.starts[k].misfit < result.starts[result.best].misfit) result.best = k;
  }
  const std::vector<double> places = snap(searches[result.best].places);
  const std::optional<Comparison> before = model.compare(starts[0], nullptr, true),
                                  fitted = model.compare(places, nullptr, true);
  if (!before || !fitted) throw Error(ExitCode::internal_error, "the best parameters are refused");
  if (log != nullptr) *log = searches[result.best].log;
  result.values = model.count_values();
  result.curves = describe_curves(calibration, *before, *fitted);
  std::size_t held = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const input::CalibrationParameter& p = calibration.parameters[i];
    const AtLimit limit = places[i] <= 0 ? AtLimit::low : places[i] >= 1 ? AtLimit::high : AtLimit::no;
    held += limit == AtLimit::no ? 0 : 1;
    result.parameters.push_back(
        {p.key, p.unit, p.first, model.find_value(i, places[i]), "", p.low, p.high, std::nullopt, limit});
  }
  // Without more values than parameters the scatter is unknown.
  const auto freedom = static_cast<double>(result.values) - static_cast<double>(places.size() - held);
  result.scatter = freedom > 0 ? std::sqrt(sum_squares(fitted->residuals) / freedom) : 0;
  const Certainty certainty = find_certainty(model, places, options.threads);
  result.evaluations += certainty.evaluations;
  if (freedom > 0) add_certainty(model, places, certainty, result);
  result.tests = model.count_runs();
  result.findings = list_findings(calibration, result, certainty.unfixed, freedom);
  return result;
}

}  // namespace

results::Calibration calibrate(const input::Case& data, const CalibrationOptions& options, std::string* log) {
  const CalibrationModel model(data, options.store);
  BestPlaces best;
  try {
    return search_parameters(data, model, options, best, log);
  } catch (const Error& error) {
    if (error.code() != ExitCode::interrupted) throw;
    throw Error(ExitCode::interrupted, describe_interruption(model, *data.calibration, best, options.store));
  }
}

}  // namespace talus::laboratory
