// SPDX-License-Identifier: MIT
#include "run/compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "input/case/support.hpp"
#include "results/governing.hpp"
#include "run/common/bedding_lines.hpp"
#include "run/common/head.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/compare/slip_line.hpp"
#include "run/lem/run_lem.hpp"
#include "run/lem/slice_run.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;

std::optional<double> get_factor(const lem::Critical& critical) {
  return critical.solution.factor > 0 ? std::optional(critical.solution.factor) : std::nullopt;
}

results::MethodRow begin_row(Method method, std::string name, std::string title, std::string criterion,
                             std::string surface, results::SurfaceSource source) {
  results::MethodRow row;
  row.method = method;
  row.name = std::move(name);
  row.title = row.label = std::move(title);
  row.criterion = std::move(criterion);
  row.surface = std::move(surface);
  row.source = source;
  return row;
}

/// If the LEM factor on the surface of another method differs by more than this ratio, the line is not its mechanism.
constexpr double largest_ratio = 2;

/// Returns why the LEM factor on the surface of another method is not reliable; empty if it is.
std::string judge_handed(std::optional<double> factor, std::optional<double> of_giver) {
  if (!factor || !of_giver || !(*of_giver > 0)) return "";
  const double ratio = *factor / *of_giver;
  if (ratio <= largest_ratio && ratio >= 1 / largest_ratio) return "";
  return fmt::format(
      "LEM gives {:.3g} times the factor of the method that the line is from: it does not follow one "
      "mechanism",
      ratio);
}

class Comparison {
 public:
  Comparison(const input::Case& data, const lem::Slope* slope, const results::RunResult& run, const fs::path& folder,
             int threads)
      : data_(data), slope_(slope), run_(run), folder_(folder), threads_(threads) {}

  using Source = results::SurfaceSource;

  results::MethodComparison make() {
    results_.asked = data_.methods;
    std::erase(results_.asked, Method::seepage);  // it has no factor of the slope
    if (run_.bounds) results_.unjudged = find_judging_obstacle(data_);
    if (run_.slices) add_slices(*run_.slices);
    if (run_.elements) add_elements(*run_.elements);
    if (run_.bounds) add_bounds(*run_.bounds);
    // An MPM run released later has the water of another time than LEM and FEM in this table.
    const bool later = data_.timeline && data_.timeline->release;
    if (input::uses(data_, Method::mpm) && !later) add_points();
    if (slope_ != nullptr) exchange_surfaces();
    results_.warnings = warn_of_disagreement(data_, run_, results_);
    results_.remarks = read_differences(data_, run_, results_);
    return std::move(results_);
  }

 private:
  void add_critical(const results::CriticalSurface& c, const std::string& name, const std::string& criterion,
                    Source source) {
    const results::SlipSurface& s = c.surface;
    results::MethodRow row = begin_row(Method::lem, results::to_word(s.method), s.title, criterion, name, source);
    row.factor = s.factor;
    if (const auto& referee = run_.slices->referee; referee && c.verdict) {
      if (referee->lower && !referee->upper_only) row.lower = results::show_lower(*referee->lower);
      if (referee->upper) row.upper = results::show_upper(*referee->upper);
    }
    if (c.lambda) row.note = fmt::format("λ = {:.3g}", *c.lambda);
    if (c.correction != 1) row.note = fmt::format("f₀ = {:.3f}", c.correction);
    if (!c.checks.refusal.empty()) row.note = c.checks.refusal;
    if (c.verdict == results::Verdict::too_low) row.note = "impossible: below the lower bound";
    if (c.verdict == results::Verdict::too_high) row.note = "impossible: above the upper bound";
    results_.table.push_back(std::move(row));
    results_.surfaces.push_back(
        {name, fmt::format("{}, {}", s.title, criterion), Method::lem, s.factor, s.points, {}, {}, {}});
  }

  void add_slices(const results::SliceResult& slices) {
    const std::size_t first = results_.table.size();
    for (const auto& c : slices.critical)
      add_critical(c, fmt::format("lem.{}", results::to_word(c.surface.method)),
                   c.crack ? fmt::format("critical circle, tension crack of {}", format_length(run_, *c.crack, 2))
                           : "critical circle",
                   Source::critical);
    for (const auto& c : slices.noncircular)
      add_critical(c, fmt::format("lem.noncircular.{}", results::to_word(c.surface.method)), "critical polyline",
                   Source::noncircular);
    for (const auto& c : slices.given) {
      const std::string given = c.surface.name.value_or("");
      add_critical(c, fmt::format("lem.surface[{}].{}", given, results::to_word(c.surface.method)),
                   fmt::format("given surface '{}'", given), Source::given);
    }
    if (results_.table.size() > first) results_.table[first].seconds = slices.seconds;  // of all of them together
  }

  void add_elements(const results::ElementResult& fem) {
    for (const results::ElementRun& run : fem.runs) {
      const std::string words = describe_flow(run), band = name_band(run.flow);
      results::MethodRow row =
          begin_row(Method::fem, results::to_word(run.flow), "FEM, " + words, "non-convergence",
                    run.slip_line.empty() ? "" : band, run.slip_line.empty() ? Source::none : Source::band);
      row.label = words;
      row.measure = results::FactorMeasure::equilibrium;
      row.factor = run.factor;
      if (run.interval) {
        row.lower = run.interval->lower;
        row.upper = run.interval->upper;
      }
      row.seconds = run.seconds;
      row.note = fmt::format("{}, {} elements of {}", fem.element, fem.elements, format_length(run_, fem.size));
      if (run.meshes && run.meshes->size() > 2)
        row.note += fmt::format(", {} where the soil shears", format_length(run_, run.meshes->back().size));
      row.note += run.meshes ? fmt::format(", extrapolated with those of {}",
                                           format_length(run_, run.meshes->at(run.meshes->size() - 2).size))
                             : "; one mesh: the mesh error is not known";
      if (run.earthquake) row.note += "; " + results::describe_side(*run.earthquake, results::stable_on_mesh);
      if (run.verdict == results::Verdict::too_low) row.note = "impossible: below the lower bound; " + row.note;
      if (run.verdict == results::Verdict::too_high) row.note = "above the upper bound; " + row.note;
      results_.table.push_back(row);
      if (run.by_displacement) {
        row.criterion = "sharp rise of displacement";
        row.measure = results::FactorMeasure::displacement;
        row.factor = run.by_displacement;
        row.lower = row.upper = row.seconds = std::nullopt;
        results_.table.push_back(row);
      }
      if (!run.slip_line.empty())
        add_lines({band, "Shear band of FEM, " + words, Method::fem, run.factor, run.slip_line, {}, {}, {}},
                  run.sides.value_or(std::vector<results::SideLine>{}));
    }
  }

  /// Adds a row with an interval instead of a factor.
  void add_bounds(const results::BoundsResult& bounds) {
    if (bounds.error) return;
    results::MethodRow row =
        begin_row(Method::bounds, "bounds", "Lower and upper bound", "ψ = φ",
                  bounds.sides ? results::mechanism_name : "", bounds.sides ? Source::mechanism : Source::none);
    row.label = "lower and upper bound";
    row.lower = bounds.lower;
    row.upper = bounds.upper;
    row.seconds = bounds.seconds;
    if (!bounds.meshes.empty()) row.note = fmt::format("{} triangles", bounds.meshes.back().triangles);
    if (bounds.earthquake) row.note += "; " + results::describe_side(*bounds.earthquake, results::proven_stable);
    for (const std::string& why : {bounds.no_lower, bounds.no_upper})
      if (!why.empty()) row.note += "; " + why;
    results_.table.push_back(std::move(row));
    if (bounds.sides)
      add_lines({results::mechanism_name,
                 "Mechanism of the upper bound",
                 Method::bounds,
                 bounds.upper ? std::optional(results::show_upper(*bounds.upper)) : std::nullopt,
                 bounds.sides->front().points,
                 {},
                 {},
                 {}},
                *bounds.sides);
  }

  /// Adds a line of FEM, of the upper bound mechanism or of MPM. If the soil moves to both sides, each has its line,
  /// and the one nearer to the LEM surface comes first.
  void add_lines(results::MethodSurface line, const std::vector<results::SideLine>& sides) {
    if (sides.size() != 2) {
      results_.surfaces.push_back(std::move(line));
      return;
    }
    const std::string name = line.name, title = line.title;
    std::size_t first = sides[0].points == line.points ? 0 : 1;
    const auto governing = run_.slices ? results::find_governing_surface(*run_.slices, nullptr) : std::nullopt;
    if (governing && governing->found->surface.points.size() > 1) {
      const site::Polyline& own = governing->found->surface.points;
      first = find_mean_distance(own, sides[0].points) <= find_mean_distance(own, sides[1].points) ? 0 : 1;
    }
    for (const std::size_t i : {first, 1 - first}) {
      line.title = fmt::format("{}, {}", title, sides[i].direction < 0 ? "left" : "right");
      line.direction = sides[i].direction;
      line.points = sides[i].points;
      results_.surfaces.push_back(line);
      line.name = name + results::other_side_name;
      line.beside = name;
    }
  }

  void add_points() {
    const PointsSlipLine line = find_line();
    const std::string surface = line.line.empty() ? "" : results::slip_line_name;
    const std::size_t first = results_.table.size();
    if (run_.factor_of_safety) add_point_factors(*run_.factor_of_safety, surface);
    if (results_.table.size() > first) {
      double others = run_.slices ? run_.slices->seconds : 0;
      if (run_.elements) others += run_.elements->seconds.value_or(0);
      results_.table[first].seconds = std::max(0.0, (run_.timing ? run_.timing->wall : 0) - others);
    }
    if (line.line.empty()) return;
    add_lines(
        {results::slip_line_name,
         line.factor > 1 ? fmt::format("Slip line of MPM at SRF {:.4g}", line.factor) : std::string("Slip line of MPM"),
         Method::mpm,
         line.factor,
         line.line,
         line.source,
         {},
         {}},
        line.sides);
  }

  void add_point_factors(const results::PointFactors& factors, const std::string& surface) {
    const Source source = surface.empty() ? Source::none : Source::slip_line;
    if (const auto& frozen = factors.frozen) {
      results::MethodRow row =
          begin_row(Method::mpm, "frozen", "MPM", "rest or run-away at frozen geometry", surface, source);
      row.factor = frozen->factor;
      row.lower = frozen->lower();
      row.upper = frozen->upper();
      row.note = frozen->note;
      for (const results::MeshFactor* m : frozen->list_found())
        if (frozen->factor)
          row.note += fmt::format("{}{:.3f} at h = {}", row.note.empty() ? "" : ", ", *m->factor(),
                                  format_length(run_, m->size, 6));
      if (frozen->extrapolated) row.note += ", extrapolated to h = 0";
      results_.table.push_back(std::move(row));
    }
    if (!factors.criteria) return;
    for (const results::Criterion& c : *factors.criteria) {
      const std::string word = results::to_word(c.kind);
      results::MethodRow row =
          begin_row(Method::mpm, word, "MPM", word + " criterion on the displacement curve", surface, source);
      row.factor = c.factor;
      row.lower = c.lower;
      row.upper = c.upper;
      row.note = c.note;
      results_.table.push_back(std::move(row));
    }
  }

  PointsSlipLine find_line() const {
    try {
      return find_points_slip_line(data_, run_, folder_);
    } catch (const Error&) {  // frames of an interrupted run may be damaged
      return {};
    }
  }

  /// Evaluates the surfaces of the other methods by LEM.
  void exchange_surfaces() {
    lem::SearchOptions options = make_search_options(data_, threads_);
    options.kind = lem::SearchKind::entry_exit;  // these surfaces belong to no search for blocks
    const std::vector<results::MethodSurface> given = results_.surfaces;
    for (const results::MethodSurface& s : given) {
      if (s.method == Method::lem || s.beside) continue;
      const auto surface = make_surface(*slope_, s.points);
      for (const SliceMethod method : input::list_polyline_methods(data_.lem)) {
        const std::string name = to_word(method), title = fmt::format("{} on: {}", get_title(method), s.title);
        if (!surface) {
          results_.handed.push_back({s.name, name, title, {}, "the line does not separate a mass from the ground"});
          continue;
        }
        const lem::Critical found = solve_surface(*slope_, *surface, method, options);
        const lem::Refusal why = found.cut.refusal != lem::Refusal::none ? found.cut.refusal : found.solution.refusal;
        std::optional<double> factor = get_factor(found);
        std::string refusal = why == lem::Refusal::none ? "" : lem::name_refusal(why);
        if (const std::string strange = judge_handed(factor, s.factor); !strange.empty()) {
          refusal = strange;
          factor.reset();
        }
        results_.handed.push_back({s.name, name, title, factor, refusal});
        if (method != SliceMethod::spencer && method != SliceMethod::morgenstern_price) continue;
        results::MethodRow row =
            begin_row(Method::lem, name, get_title(method), "on: " + s.title, s.name, Source::handed);
        row.factor = factor;
        row.note = refusal;
        results_.table.push_back(std::move(row));
      }
      if (surface) optimise(*surface, s, options);
    }
  }

  void optimise(const lem::Surface& surface, const results::MethodSurface& of, const lem::SearchOptions& options) {
    const lem::Critical best = lem::optimise(*slope_, surface, SliceMethod::spencer, options);
    const std::optional<double> factor = get_factor(best);
    if (!factor) return;
    const std::string title = "Spencer, optimised from: " + of.title,
                      name = fmt::format("lem.handed[{}].spencer_optimised", of.name);
    results_.handed.push_back({of.name, "spencer_optimised", title, factor, ""});
    results::CriticalSurface& found = results_.optimised.emplace_back(make_critical_result(*slope_, best));
    found.surface.name = name;
    if (const auto& referee = run_.slices->referee; referee && !referee->why_not)
      found.verdict = results::judge(*referee, found);
    if (data_.lem.yield_acceleration)
      found.yield_acceleration = lem::find_yield_acceleration(*slope_, best.cut, best.method, options.checks);
    results::MethodRow row =
        begin_row(Method::lem, "spencer_optimised", "Spencer", "optimised from: " + of.title, name, Source::optimised);
    row.factor = factor;
    results_.table.push_back(std::move(row));
    results_.surfaces.push_back({name, title, Method::lem, factor, best.surface.line, {}, {}, {}});
  }

  const input::Case& data_;
  const lem::Slope* slope_;
  const results::RunResult& run_;
  const fs::path& folder_;
  int threads_;
  results::MethodComparison results_;
};

}  // namespace

const char* name_band(results::Flow flow) {
  return flow == results::Flow::associated ? results::associated_band_name : results::band_name;
}

std::string describe_flow(const results::ElementRun& run) {
  if (run.flow == results::Flow::associated || run.davis) return results::name_flow(run);
  const double low = run.psi[0], high = run.psi[1], degrees = 180 / std::numbers::pi;
  return std::abs(high - low) < 1e-9 ? fmt::format("ψ = {:.3g}°", low * degrees) : "ψ as given";
}

results::MethodComparison compare_methods(const input::Case& data, const lem::Slope* slope,
                                          const results::RunResult& run, const fs::path& folder, int threads) {
  return Comparison(data, slope, run, folder, threads).make();
}

std::optional<std::string> find_judging_obstacle(const input::Case& data) {
  const bool has_bars = std::any_of(data.supports.begin(), data.supports.end(),
                                    [](const auto& entry) { return entry.second.kind != input::SupportKind::wall; });
  if (!has_bars && !data.supports.empty() && input::uses(data, Method::lem))
    return "in limit analysis soil slips along walls and bends them, which slip surfaces of LEM do not show";
  if (has_rough_walls(data))
    return "the interfaces of walls dilate as they slip, and keep their adhesion as they open, in limit analysis alone";
  if (has_bars)
    return fmt::format(
        "in limit analysis the soil below the heads of supports may fail{}",
        input::has_passive_supports(data)
            ? ", and the factor divides the forces of passive supports in LEM and limit analysis, not in FEM and MPM"
            : "");
  for (const auto& [region, name] : data.regions)
    if (input::uses(data, Method::lem) && has_wide_bedding(data.materials.at(name)))
      return fmt::format("in LEM the bedding of '{}' has a range of directions, in limit analysis one", name);
  return std::nullopt;
}

}  // namespace talus::run
