// SPDX-License-Identifier: MIT
// NLopt's minimisers behind one function. docs/decisions/0022-optimiser.md says which was chosen for what.

#include "lem/search/minimise.hpp"

#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <memory>

namespace talus::lem {

namespace {

struct Task {
  const std::function<double(const std::vector<double>&)>* function;
  nlopt_opt optimiser;
  Minimum best;
  std::exception_ptr thrown;
};

double evaluate(unsigned n, const double* x, double*, void* data) {
  Task& task = *static_cast<Task*>(data);
  if (task.thrown) return 0;
  try {  // no exception may pass through a C library
    const std::vector<double> at(x, x + n);
    const double value = (*task.function)(at);
    ++task.best.evaluations;
    if (value < task.best.value) task.best.at = at, task.best.value = value;
    return value;
  } catch (...) {
    task.thrown = std::current_exception();
    nlopt_force_stop(task.optimiser);
    return 0;
  }
}

nlopt_algorithm choose_algorithm(Minimiser minimiser) {
  if (minimiser == Minimiser::subspaces) return NLOPT_LN_SBPLX;
  return minimiser == Minimiser::quadratic ? NLOPT_LN_BOBYQA : NLOPT_LN_NELDERMEAD;
}

}  // namespace

Minimum minimise(const std::function<double(const std::vector<double>&)>& function, const std::vector<double>& start,
                 const std::vector<double>& step, const std::vector<double>& lower, const std::vector<double>& upper,
                 const MinimiseOptions& options) {
  std::vector<double> x = start, steps = step;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::clamp(x[i], lower[i], upper[i]);
    if (x[i] + steps[i] > upper[i]) steps[i] = -steps[i];
    if (x[i] + steps[i] < lower[i]) steps[i] = 0.5 * std::max(upper[i] - x[i], x[i] - lower[i]);
    if (!(upper[i] > lower[i])) steps[i] = 1;
  }
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimiser(
      nlopt_create(choose_algorithm(options.minimiser), static_cast<unsigned>(x.size())), nlopt_destroy);
  Task task{&function, optimiser.get(), {x, function(x), 1}, nullptr};
  nlopt_set_min_objective(optimiser.get(), evaluate, &task);
  nlopt_set_lower_bounds(optimiser.get(), lower.data());
  nlopt_set_upper_bounds(optimiser.get(), upper.data());
  nlopt_set_initial_step(optimiser.get(), steps.data());
  nlopt_set_ftol_rel(optimiser.get(), options.tolerance);
  // Relative to the bounds: relative to the variables it would depend on the origin of the coordinates.
  std::vector<double> nearest;
  for (std::size_t i = 0; i < x.size(); ++i) nearest.push_back(1e-9 * (upper[i] - lower[i]));
  nlopt_set_xtol_abs(optimiser.get(), nearest.data());
  nlopt_set_maxeval(optimiser.get(), options.most_evaluations);
  double value = 0;
  // Its return code tells why it stopped; what counts is the best point that was seen.
  nlopt_optimize(optimiser.get(), x.data(), &value);
  if (task.thrown) std::rethrow_exception(task.thrown);
  return task.best;
}

}  // namespace talus::lem
