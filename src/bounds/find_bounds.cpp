// SPDX-License-Identifier: MIT
// Search for the factors of both bounds on a sequence of refined meshes.
#include "bounds/find_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.hpp"
#include "bounds/conic/solve.hpp"
#include "bounds/envelope.hpp"
#include "bounds/program_of.hpp"
#include "bounds/refine.hpp"
#include "bounds/support_rows.hpp"
#include "bounds/uplift.hpp"

namespace talus::bounds {

// Newton's method for m(F) = 0 (T21.2). The lacking cohesion m grows with the factor and its derivative is known; the
// steps are kept inside the bracket of stable and failed factors.

namespace {

/// Lacking cohesion that counts as zero within the tolerance of the solver, in units of stress.
constexpr double no_lack = 2e-6;
constexpr int most_trials = 40;

}  // namespace

bool FactorSearch::try_factor(double factor) {
  // The solver may stall on a degenerate program; the program of a neighbouring factor then often has a solution.
  Trial trial;
  for (const double beside : {1.0, 0.99, 1.01, 0.97, 1.03}) {
    trial = solve_(beside * factor);
    ++programs_, iterations_ += trial.solution.iterations;
    if (trial.solution.end != ConicEnd::stalled) break;
  }
  factor = trial.factor;
  if (trial.solution.end != ConicEnd::solved) {
    why_ = trial.solution.end == ConicEnd::infeasible
               ? "no stress field is in equilibrium with the loads"
               : "the solver of the cone programs stopped: " + trial.solution.why;
    return false;
  }
  // In between the trial is undecided: it proves neither stability nor failure.
  const bool falls = trial.lack > no_lack + trial.doubt;
  const bool stands = trial.lack + trial.doubt <= no_lack || trial.lack + trial.doubt < 0;
  if (stands) stood_ = std::max(stood_.value_or(0), factor);
  if (falls) fell_ = std::min(fell_.value_or(factor), factor);
  is_undecided_ = !stands && !falls;
  // Without cohesion the lack is zero at every factor below the root, and only failed trials indicate its position.
  if (std::abs(trial.lack) > no_lack + trial.doubt && trial.rate > 0) root_ = factor - trial.lack / trial.rate;
  if (root_ && stood_ && *root_ < *stood_) root_ = stood_;
  if (root_ && fell_ && *root_ > *fell_) root_ = fell_;
  if (stood_ && fell_ && *fell_ - *stood_ < 1e-6 * *fell_) root_ = stood_;
  last_ = std::move(trial);
  return true;
}

bool FactorSearch::approach(double start, double tolerance) {
  double factor = start, reach = 0.1;
  for (int i = 0; i < most_trials; ++i) {
    if (!try_factor(factor)) return false;
    double next = is_undecided_ || last_->lack > no_lack ? factor / (1 + reach) : factor * (1 + reach);
    reach *= 2;
    if (root_) {
      if (std::abs(*root_ - factor) <= tolerance * factor) return true;
      next = *root_;
    }
    // Newton's steps are too long where m(F) is strongly curved; a step out of the bracket is replaced by its geometric
    // mean.
    if (stood_ && fell_ && (next <= *stood_ || next >= *fell_)) next = std::sqrt(*stood_ * *fell_);
    next = std::clamp(next, range_.smallest, range_.largest);
    if (next == factor) break;
    factor = next;
  }
  why_ = stood_ && *stood_ >= range_.largest
             ? fmt::format("the slope is stable at every factor up to {:g}", range_.largest)
         : fell_ && *fell_ <= range_.smallest
             ? fmt::format(
                   "no stress field was found at any factor down to {:g}; this is usually a fault of the model, such "
                   "as a load or water on soil without cohesion and tensile strength",
                   range_.smallest)
             : "the cone programs are undecided at all factors that were tried";
  return false;
}

namespace {

constexpr double none = std::numeric_limits<double>::infinity();
/// Relative tolerance of the root on the first mesh.
constexpr double rough = 0.02;
/// Relative tolerance on later meshes before the last one: usually one trial each.
constexpr double loose = 0.1;
/// Relative distances outside the root of the trials that are to prove the bound, increasing after each one that does
/// not.
constexpr double proofs[] = {5e-5, 2e-4, 8e-4, 3.2e-3};
/// Margin by which the strain rates of a mechanism stay inside the flow rule, as multipliers of the program; and the
/// relative increase of the factor for which the flow rule is satisfied.
constexpr double room_of_rates = 1e-8, flow_room = 2e-5;
/// Largest angle of a triangle at a corner of the border [rad].
constexpr double widest_fan = 0.2;
/// The smallest fraction of triangles that are refined, that around a local mechanism, and the fraction up to which
/// triangles are halved twice.
constexpr double fewest_refined = 0.2, fewest_around = 0.01, few = 0.05;
/// Root of the area of a triangle over the height of the section, below which it stays as it is: the fields are stored
/// with places to a nanometre, and have to prove their bounds with these.
constexpr double least_size = 2e-5;

/// Returns the contribution of each triangle to the gap: the strain rates of the mechanism times the strength that the
/// stress field leaves there. The product with exchanged roles is added, since the lower bound alone may have found the
/// critical mechanism, where the upper one has no motion yet.
std::vector<double> find_contributions(const Problem& problem, const Units& units, const ConicSolution& holding,
                                       const ConicSolution& moving) {
  std::vector<double> part(problem.size(), 0);
  std::size_t a = holding.s.size(), b = moving.z.size();
  for (std::size_t e = problem.size(); e-- > 0;) {
    std::size_t rows = 0;
    for (const Strength& soil : problem.strength[e]) rows += soil.count_rows();
    a -= rows, b -= rows;
    for (std::size_t k = 0; k < rows; ++k)
      part[e] += holding.s[a + k] * moving.z[b + k] + moving.s[b + k] * holding.z[a + k];
  }
  add_hinges(problem, units, holding, a, part);
  return part;
}

/// Returns true if the criterion has the same number of rows at every corner.
bool are_alike(const Problem& lower, const Problem& upper) {
  for (std::size_t e = 0; e < lower.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i)
      if (lower.strength[e][i].count_rows() != upper.strength[e][i].count_rows()) return false;
  return true;
}

/// The same where each bound has its own lines of an envelope: the stresses of each program are held to the criterion
/// of the other one.
std::vector<double> find_contributions(const Problem& lower, const Problem& upper, const Units& units,
                                       const Trial& holding, const Trial& moving) {
  std::vector<double> part(lower.size(), 0);
  const auto add = [&](const Problem& problem, Bound bound, const Trial& strain, const Trial& stress) {
    const std::vector<double> slacks = find_slacks(problem, bound, stress.factor, units, stress.solution.x);
    std::size_t row = strain.solution.z.size(), k = slacks.size();
    for (std::size_t e = problem.size(); e-- > 0;) {
      std::size_t rows = 0;
      for (const Strength& soil : problem.strength[e]) rows += soil.count_rows();
      for (row -= rows, k -= rows; rows-- > 0;) part[e] += slacks[k + rows] * strain.solution.z[row + rows];
    }
    return row;
  };
  add(upper, Bound::upper, moving, holding);
  add_hinges(lower, units, holding.solution, add(lower, Bound::lower, holding, moving), part);
  return part;
}

/// Adds the contributions of what the problems of both bounds differ in: the strain rates, by the first row of each
/// cone, times the differences of cohesion and pore pressure.
void add_differences(const Problem& lower, const Problem& upper, const Units& units, const ConicSolution& moving,
                     std::vector<double>& part) {
  std::size_t row = moving.z.size();
  for (std::size_t e = lower.size(); e-- > 0;)
    for (std::size_t i = 3; i-- > 0;) {
      const Strength& weak = lower.strength[e][i];
      const Strength& strong = upper.strength[e][i];
      row -= strong.count_rows();
      const double difference =
          std::abs(strong.cohesion - weak.cohesion) + std::abs(upper.pore_pressure[e][i] - lower.pore_pressure[e][i]);
      double rate = 0;
      for (std::size_t k = 0; k + 2 < strong.count_rows(); k += 3) rate += moving.z[row + k];
      part[e] += difference / units.stress * rate;
    }
}

class BoundsSearch {
 public:
  BoundsSearch(const SafeProblems& problems, const BoundsOptions& options, const BoundsReport& report)
      : options_(options), report_(report), evaluate_(problems.evaluate) {
    result_.problem = fan_out(problems.lower, find_corners(problems.lower), widest_fan);
    if (problems.upper) upper_ = fan_out(*problems.upper, find_corners(*problems.upper), widest_fan);
    evaluate();
    result_.upper = none;
    const auto has_further = [](const auto& corners) { return corners[0].further != nullptr; };
    for (const Problem* p : {&result_.problem, upper_ ? &*upper_ : &result_.problem})
      has_envelopes_ = has_envelopes_ || std::any_of(p->strength.begin(), p->strength.end(), has_further);
  }

  BoundsResult run() {
    double low = options_.start, high = options_.start;
    int unproven = 0;
    bool is_first = true;
    for (;;) {
      const Problem& problem = result_.problem;
      units_ = find_units(problem);
      FactorSearch holding = make_search(Bound::lower), moving = make_search(Bound::upper);
      bool holds = false, moves = false;
      if (std::exchange(is_first, false)) {
        moves = moving.approach(high, rough);
        holds = start_lower(holding, moves ? moving.root() : low);
      } else {
        run_both([&] { holds = approach_lower(holding, low, high); }, [&] { moves = moving.approach(high, loose); });
      }
      result_.no_lower = holds ? "" : holding.why();
      result_.no_upper = moves ? "" : moving.why();
      const bool is_last =
          !holds || !moves || static_cast<int>(problem.size()) >= options_.most_triangles ||
          2 * (moving.root() - holding.root()) <= (options_.gap - 2 * proofs[0]) * (moving.root() + holding.root());
      // Trials that are to prove the bounds may have other lines of envelopes than the problem.
      const std::optional<Trial> before = has_envelopes_ && moves ? std::optional(moving.last()) : std::nullopt;
      is_proving_ = {is_last, is_last};
      run_both(
          [&] {
            if (is_last && holds) finish(holding, Bound::lower);
          },
          [&] {
            if (is_last && moves) finish(moving, Bound::upper);
          });
      is_proving_ = {};
      tell(holding, moving);
      if (is_last && (!holds || !moves || is_done())) break;
      if (is_last && ++unproven >= options_.most_unproven) {
        result_.no_upper = result_.no_lower =
            fmt::format("the fields of {} meshes prove a wider interval than their programs have", unproven);
        break;
      }
      // The meshes are nested: what a coarser one has proven holds on a finer one too, whatever Newton's step.
      low = std::max(holding.root(), result_.lower), high = std::min(moving.root(), result_.upper);
      opening_.forget();
      const std::optional<Trial> local = solve_local(holding.root(), moving.root());
      const Trial& moved = local ? *local : before ? *before : moving.last();
      std::vector<double> parts = !upper_ || are_alike(problem, *upper_)
                                      ? find_contributions(problem, units_, lower_trial_.solution, moved.solution)
                                      : find_contributions(problem, *upper_, units_, lower_trial_, moved);
      if (upper_) add_differences(problem, *upper_, units_, moved.solution, parts);
      if (has_envelopes_) choose_lines(moved);
      leave_smallest(parts);
      refine_marked(mark(parts, local ? fewest_around : fewest_refined,
                         is_last ? 1 : limit_refined(holding.root(), moving.root())));
      evaluate();
    }
    mark_end();
    name_uplift();
    refuse_contradiction();
    return std::move(result_);
  }

 private:
  static std::size_t get_number(Bound bound) { return bound == Bound::lower ? 0 : 1; }
  const Problem& get_problem(Bound bound) const { return bound == Bound::upper && upper_ ? *upper_ : result_.problem; }

  /// Takes the triangles that are as small as they may become out of the gap.
  void leave_smallest(std::vector<double>& parts) const {
    const double least = least_size * units_.length;
    for (std::size_t e = 0; e < parts.size(); ++e)
      if (find_shape(result_.problem, e).area < least * least) parts[e] = 0;
  }

  /// Halves the marked triangles, and few of them, as around a point, once more.
  void refine_marked(std::vector<bool> marked) {
    const auto count = static_cast<double>(std::count(marked.begin(), marked.end(), true));
    const bool is_local = count < few * static_cast<double>(marked.size());
    for (int rounds = is_local ? 2 : 1; rounds > 0; --rounds) {
      if (upper_) upper_ = refine(*upper_, marked);
      Problem finer = refine(result_.problem, marked);
      if (rounds > 1) marked = mark_inside(result_.problem, marked, finer);
      result_.problem = std::move(finer);
    }
  }

  void evaluate() {
    if (!evaluate_) return;
    evaluate_(result_.problem, Bound::lower);
    if (upper_) evaluate_(*upper_, Bound::upper);
  }

  /// Chooses the lines of envelopes in the programs of the next mesh.
  void choose_lines(const Trial& moving) {
    const std::array tried{TriedStresses{lower_trial_.factor, &lower_trial_.solution.x},
                           TriedStresses{moving.factor, &moving.solution.x}};
    bounds::choose_lines(result_.problem, units_, tried);
    if (upper_) bounds::choose_lines(*upper_, units_, tried);
    exceeded_ = {};
  }

  /// Runs the programs of both bounds in parallel; they only read the problems.
  template <class Lower, class Upper>
  void run_both(Lower lower, Upper upper) const {
    parallel_tasks(2, options_.threads, [&](int i) {
      if (i == 0) {
        lower();
      } else {
        upper();
      }
    });
  }

  FactorSearch make_search(Bound bound) {
    return {options_.range, [this, bound](double factor) { return solve_program(bound, factor); }};
  }

  /// Solves a program with the lines of envelopes that the stresses of the one before exceed and that it did not have.
  /// A trial that is to prove the bound is solved again with those that its own stresses exceed.
  Trial solve_program(Bound bound, double factor) {
    constexpr int most_rounds = 4;
    if (!has_envelopes_) return prove_solved(get_problem(bound), bound, factor);
    Problem& own = bound == Bound::upper && upper_ ? *upper_ : result_.problem;
    std::pair<double, std::vector<double>>& last = exceeded_[get_number(bound)];
    const auto add_lines = [&](Problem& problem) {
      return !last.second.empty() && add_exceeded_lines(problem, units_, {last.first, &last.second});
    };
    if (!is_proving_[get_number(bound)]) {
      add_lines(own);
      Trial trial = prove_solved(own, bound, factor);
      if (trial.solution.end == ConicEnd::solved) last = {factor, trial.solution.x};
      return trial;
    }
    Problem widened = own;
    add_lines(widened);
    for (int round = 1;; ++round) {
      Trial trial = prove_solved(widened, bound, factor);
      if (trial.solution.end != ConicEnd::solved) return trial;
      last = {factor, trial.solution.x};
      if (round == most_rounds || !add_lines(widened)) return trial;
    }
  }

  Trial prove_solved(const Problem& given, Bound bound, double factor) {
    const std::optional<Problem> held =
        bound == Bound::upper ? hold_narrow_corners(given, factor, units_) : std::nullopt;
    const Problem& problem = held ? *held : given;
    // The tolerance of the lack refers to the unit of stress and not to the lack itself, which is near zero.
    ConicOptions options;
    options.tolerance = 1e-5, options.value_size = 1;
    ConicProgram program = make_program(problem, bound, factor, units_);
    // The solver's tolerance refers to the largest entry of the right-hand side, which in strong soil exceeds the
    // loads.
    double largest = 1;
    for (const double b : program.right) largest = std::max(largest, std::abs(b));
    options.tolerance /= largest;
    const double room = bound == Bound::upper ? room_of_rates : 0;
    leave_room(program, room);
    Trial trial{factor, 0, 0, 0, solve(program, options)};
    if (trial.solution.end != ConicEnd::solved) return trial;
    trial.lack = use_room(program, room, trial.solution);
    trial.doubt = std::abs(trial.solution.primal - trial.solution.dual);
    trial.rate = find_lack_rate(problem, program, bound, factor, units_, trial.solution);
    prove(given, problem, bound, trial);
    return trial;
  }

  /// Searches the root of the lower bound on the first mesh from the root of the upper one, where no stress field is
  /// admissible. A trial inside the root then proves a bound.
  bool start_lower(FactorSearch& holding, double start) {
    constexpr double inside = 0.01;
    if (!holding.approach(start, rough)) return false;
    lower_trial_ = holding.last();
    if (holding.last().factor < holding.root()) return true;
    is_flat_ = holding.try_factor((1 - inside) * holding.root()) &&
               std::abs(holding.last().lack) <= no_lack + holding.last().doubt;
    return true;
  }

  /// Searches the root of the lower bound on a refined mesh. Where a free surface has neither cohesion nor tensile
  /// strength, the lack is zero at every stable factor: only a failed one, such as the root of the upper bound, gives
  /// the root, and a second trial proves the bound.
  bool approach_lower(FactorSearch& holding, double low, double high) {
    if (!holding.approach(is_flat_ ? high : low, loose)) return false;
    lower_trial_ = holding.last();
    // The lines of the problem stay those of the trial that is kept.
    is_proving_[get_number(Bound::lower)] = true;
    if (is_flat_ && holding.last().factor > holding.root()) holding.try_factor((1 - proofs[0]) * holding.root());
    is_proving_[get_number(Bound::lower)] = false;
    return true;
  }

  /// Runs trials just outside the root until one proves the bound.
  void finish(FactorSearch& search, Bound bound) {
    for (const double outside : proofs) {
      const double aim = search.root() * (bound == Bound::lower ? 1 - outside : 1 + outside);
      const auto is_near = [&] {
        return bound == Bound::lower ? result_.lower >= aim - 2 * outside * aim
                                     : result_.upper <= aim + 2 * outside * aim;
      };
      if (is_near()) return;
      search.try_factor(aim);  // if the solver stalls, the next trial is further from the degenerate root
    }
  }

  /// Returns the trial of the upper bound at the root of the lower one, where the lower bound has converged and the
  /// upper one is far above it, as below the edge of a load, where a wedge of any size may fail: its mechanism is the
  /// critical one at that factor. At the root of the upper bound another one is critical, which the mesh resolves.
  std::optional<Trial> solve_local(double lower_root, double upper_root) {
    constexpr double converged = 0.03;  ///< change on the last mesh and distance of the root, over the gap
    const double before = std::exchange(lower_before_, result_.lower);
    const double near = converged * (upper_root - result_.lower);
    if (before == 0 || result_.lower - before > near || std::abs(lower_root - result_.lower) > near) return {};
    Trial trial = solve_program(Bound::upper, lower_root);
    if (trial.solution.end != ConicEnd::solved) return {};
    return trial;
  }

  /// Returns the largest fraction of triangles to refine. Near the gap asked for, few of them suffice.
  double limit_refined(double lower, double upper) const {
    constexpr double fewest = 0.1, per_excess = 0.5;
    return options_.gap > 0 ? std::max(fewest, per_excess * (2 * (upper - lower) / (upper + lower) / options_.gap - 1))
                            : 1;
  }

  /// Keeps the bound of an earlier mesh if the search stopped on a later one.
  void mark_end() {
    if (result_.lower > 0) result_.stopped = std::exchange(result_.no_lower, "");
    if (!std::isfinite(result_.upper)) return;
    if (result_.stopped.empty()) result_.stopped = result_.no_upper;
    result_.no_upper.clear();
  }

  /// Names the place of the border that rules out every stress field, where there is one.
  void name_uplift() {
    if (result_.lower > 0) return;
    const auto uplift = search_uplift(result_.problem);
    if (!uplift) return;
    result_.no_lower = fmt::format(
        "no stress field exists at any factor: at ({:.4g}, {:.4g}) m the pore pressure and the load pull at the "
        "surface with {:.3g} kPa, and its soil carries c / tan φ = {:.3g} kPa. Lower the pore pressure there",
        uplift->place[0], uplift->place[1], 1e-3 * uplift->pull, 1e-3 * uplift->limit);
  }

  /// Withdraws both bounds if they contradict each other.
  void refuse_contradiction() {
    constexpr double least_strengths = 1e-3;  ///< tolerance for soil that was given the least strength
    if (result_.lower <= result_.upper * (1 + least_strengths)) return;
    result_.no_lower = result_.no_upper =
        "the two bounds contradict each other, which is a fault of the program; please report it with the case";
    result_.lower = 0, result_.upper = none;
  }

  bool is_done() const {
    return static_cast<int>(result_.problem.size()) >= options_.most_triangles ||
           2 * (result_.upper - result_.lower) <= options_.gap * (result_.upper + result_.lower);
  }

  /// Records the factor that the check of the field proves, if it narrows the interval. The bounds of coarser meshes
  /// remain valid. `solved`: the problem of the program, in which some soil may be at rest.
  void prove(const Problem& problem, const Problem& solved, Bound bound, const Trial& trial) {
    if (bound == Bound::lower) {
      StressField field = read_stress(problem, make_program(problem, bound, trial.factor, units_), trial.factor,
                                      trial.solution, units_);
      const StaticCheck found = check(problem, field);
      if (!found.holds || !std::isfinite(found.factor) || found.factor <= result_.lower) return;
      result_.lower = found.factor, result_.static_check = found, result_.stress = std::move(field);
      result_.stress_problem = problem;
    } else {
      VelocityField field = read_velocity(solved, (1 + flow_room) * trial.factor, trial.solution, opening_);
      const KinematicCheck found = check(problem, field);
      if (!found.holds || found.factor >= result_.upper) return;
      result_.upper = found.factor, result_.kinematic_check = found, result_.velocity = std::move(field);
      result_.velocity_problem = problem;
    }
  }

  void tell(const FactorSearch& holding, const FactorSearch& moving) {
    result_.levels.push_back({static_cast<int>(result_.problem.size()), result_.lower, result_.upper,
                              holding.programs() + moving.programs(), holding.iterations() + moving.iterations(),
                              std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count()});
    if (report_) report_(result_);
  }

  const BoundsOptions& options_;
  const BoundsReport& report_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  const std::function<void(Problem&, Bound)>& evaluate_;
  BoundsResult result_;
  std::optional<Problem> upper_;  ///< on the mesh of `result_.problem`; none: the same strengths and pressures
  Units units_;
  Trial lower_trial_;  ///< that gave the root of the lower bound on the current mesh
  /// Factor and unknowns of the last program of each bound on the current mesh, with envelopes.
  std::array<std::pair<double, std::vector<double>>, 2> exceeded_;
  bool has_envelopes_ = false;
  std::array<bool, 2> is_proving_{};  ///< by bound: its trials are to prove it and leave the lines of the problem
  double lower_before_ = 0;           ///< the lower bound on the mesh before
  bool is_flat_ = false;              ///< the lack of the lower bound is zero at all stable factors
  OpeningSearch opening_;             ///< of the current mesh
};

}  // namespace

BoundsResult find_bounds(const Problem& problem, const BoundsOptions& options, const BoundsReport& report) {
  return find_bounds(SafeProblems{problem, {}, {}}, options, report);
}

BoundsResult find_bounds(const SafeProblems& problems, const BoundsOptions& options, const BoundsReport& report) {
  return BoundsSearch(problems, options, report).run();
}

}  // namespace talus::bounds
