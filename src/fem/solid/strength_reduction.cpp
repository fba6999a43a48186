// SPDX-License-Identifier: MIT
// Strength reduction by bracketing. Every trial starts from the equilibrium at full strength, so that its result does
// not depend on the other trials.
#include "fem/solid/softening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "material/every_law.hpp"

namespace talus::fem {
namespace {

using Clock = std::chrono::steady_clock;

double find_seconds(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

/// Returns the F at which u(F) exceeds `limit`, linear in ln u between the two trials around it, the first of which may
/// be the start `base` without displacement; 0 if it does not.
double find_passing(const std::vector<ReductionTrial>& trials, double base, double limit) {
  double factor = base, low = std::log(1e-3 * limit);
  for (const auto& trial : trials) {
    const double high = std::log(std::max(trial.displacement, 1e-3 * limit));
    if (trial.displacement > limit)
      return factor + (trial.factor - factor) * std::clamp((std::log(limit) - low) / (high - low), 0.0, 1.0);
    if (!trial.converged) return 0;  // the iterations ran out before it had moved so far
    factor = trial.factor;
    low = high;
  }
  return 0;
}

/// Returns the smallest factor that failed by flow; 0 if in every failed trial the iterations ran out.
double find_flowing(const std::vector<ReductionTrial>& trials) {
  const auto first = std::find_if(trials.begin(), trials.end(), [](const auto& t) { return !t.converged && t.flows; });
  return first == trials.end() ? 0 : first->factor;
}

template <int D>
class Reduction {
 public:
  Reduction(const SolidModel<D>& model, const ReductionOptions& options, const ReductionReport<D>& report)
      : model_(model),
        options_(options),
        report_(report),
        system_(model),
        newton_(system_, options.solid),
        softening_(system_, options.solid) {}

  ReductionResult<D> run() {
    const auto begin = Clock::now();
    find_base();
    bracket();
    while (high_ - low_ > options_.resolution * (1 + 1e-9)) {
      const double middle = 0.5 * (low_ + high_);
      (try_factor(middle) ? low_ : high_) = middle;
    }
    std::sort(result_.trials.begin(), result_.trials.end(),
              [](const auto& a, const auto& b) { return a.factor < b.factor; });
    result_.stable = low_;
    result_.failed = high_;
    result_.flowing = find_flowing(result_.trials);
    result_.factor = 0.5 * (low_ + high_);
    result_.elastic_displacement = newton_.elastic_displacement();
    result_.by_displacement =
        find_passing(result_.trials, result_.base_factor, options_.displacement_limit * result_.elastic_displacement);
    result_.unknowns = system_.unknowns;
    result_.factorisations = newton_.factorisations();
    result_.seconds = find_seconds(begin);
    return std::move(result_);
  }

  bool is_stable(double factor) {
    find_base();
    return factor <= result_.base_factor || try_factor(factor);
  }

 private:
  /// Computes the equilibrium at full strength, or at the first of successively doubled strengths that has one.
  void find_base() {
    double factor = 1;
    while (factor >= options_.smallest) {
      const SolidAssembly<D> assembly(system_, make_laws(model_, factor), options_.solid.threads, {factor, true});
      auto found = apply_loads(system_, newton_, softening_, assembly, options_.solid, assembly.make_start());
      result_.iterations += found.iterations;
      if (found.converged) {
        result_.base_factor = factor;
        result_.at_full_strength = std::move(found.at);
        return;
      }
      unstable_ = factor;
      factor *= 0.5;
    }
    fail_input(
        "FEM does not converge even with the strength multiplied by {:g}: check weights, supports and pore "
        "pressures",
        1 / options_.smallest);
  }

  /// Searches a stable factor below a failed one, both confirmed by trials.
  void bracket() {
    low_ = result_.base_factor;
    if (unstable_ > 0) {
      if (!try_factor(unstable_)) {
        high_ = unstable_;
        return;
      }
      low_ = unstable_;
    }
    double width = std::max(options_.to - std::max(options_.from, low_), options_.resolution);
    if (options_.from > low_) {
      high_ = options_.from;
      if (!try_factor(high_)) {
        widen_down(width);
        return;
      }
      low_ = options_.from;
    }
    while (low_ < options_.largest) {
      high_ = std::min(low_ + width, options_.largest);
      if (!try_factor(high_)) return;
      low_ = high_;
      width *= 2;
    }
    fail_input("the soil is still stable with its strength divided by {:g}: it has no factor of safety",
               options_.largest);
  }

  /// Searches a stable factor below the failed high_; low_ is known to be one.
  void widen_down(double width) {
    while (high_ - width > low_) {
      if (try_factor(high_ - width)) {
        low_ = high_ - width;
        return;
      }
      high_ -= width;
      width *= 2;
    }
  }

  bool try_factor(double factor) {
    throw_if_interrupted();
    const auto begin = Clock::now();
    const SolidAssembly<D> assembly(system_, make_laws(model_, factor), options_.solid.threads, {factor, false});
    SolidState<D> start = result_.at_full_strength, end;
    std::fill(start.displacement.begin(), start.displacement.end(), Vec<D>{});
    std::fill(start.yields.begin(), start.yields.end(), 0);
    std::fill(start.strain.begin(), start.strain.end(), std::array<double, 6>{});
    const SofteningOutcome out = softening_.solve(newton_, assembly, start, system_.load, end);
    ReductionTrial trial{
        factor, out.converged, out.flows, out.iterations, out.force_residual, out.displacement_residual, 0,
        0,      out.softenings};
    for (const auto& u : end.displacement) trial.displacement = std::max(trial.displacement, norm(u));
    trial.seconds = find_seconds(begin);
    if (report_) report_(trial, end);
    if (!out.converged) {  // the failed trials come in the order of decreasing factors
      result_.at_failure = std::move(end);
      result_.mechanism = newton_.last_motion();
    }
    result_.iterations += out.iterations;
    result_.trials.push_back(trial);
    return out.converged;
  }

  const SolidModel<D>& model_;
  ReductionOptions options_;
  ReductionReport<D> report_;
  SolidSystem<D> system_;
  SolidNewton<D> newton_;
  SolidSoftening<D> softening_;
  double low_ = 0, high_ = 0;
  double unstable_ = 0;  ///< lowest factor at which the loads were not in equilibrium; 0: none
  ReductionResult<D> result_;
};

}  // namespace

template <int D>
ReductionResult<D> reduce_strength(const SolidModel<D>& model, const ReductionOptions& options,
                                   const ReductionReport<D>& report) {
  return Reduction<D>(model, options, report).run();
}

template <int D>
bool is_stable(const SolidModel<D>& model, const ReductionOptions& options, double factor) {
  return Reduction<D>(model, options, {}).is_stable(factor);
}

template bool is_stable<2>(const SolidModel<2>&, const ReductionOptions&, double);
template bool is_stable<3>(const SolidModel<3>&, const ReductionOptions&, double);
template ReductionResult<2> reduce_strength<2>(const SolidModel<2>&, const ReductionOptions&,
                                               const ReductionReport<2>&);
template ReductionResult<3> reduce_strength<3>(const SolidModel<3>&, const ReductionOptions&,
                                               const ReductionReport<3>&);

}  // namespace talus::fem
