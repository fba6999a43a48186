// SPDX-License-Identifier: MIT
#include "run/bounds/bounds_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bounds/problem.hpp"
#include "fem/solid/solid.hpp"
#include "results/present.hpp"
#include "run/common/head.hpp"

namespace talus::run {

namespace {

/// Stored values are rounded to this many parts of a metre, a pascal, and one. Places and velocities have more digits:
/// those of small triangles differ little, and the strain rates of the stored mechanism are to prove the bound too.
constexpr double place_digits = 1e9, stress_digits = 10, share_digits = 1e6, velocity_digits = 1e9;

results::Point round_place(const Vec<2>& x) {
  return {round_to(x[0], place_digits), round_to(x[1], place_digits)};
}

results::HoldingField make_stress_result(const bounds::Problem& problem, const bounds::StressField& field,
                                         double factor) {
  results::HoldingField result;
  for (const Vec<2>& x : problem.nodes) result.nodes.push_back(round_place(x));
  const std::array<double, 3> none{};
  const bool has_pressure = std::any_of(problem.pore_pressure.begin(), problem.pore_pressure.end(),
                                        [&](const std::array<double, 3>& p) { return p != none; });
  if (has_pressure) result.pressure.emplace();
  for (std::size_t e = 0; e < problem.size(); ++e) {
    result.triangles.emplace_back(problem.triangles[e].begin(), problem.triangles[e].end());
    std::vector<double>& stress = result.stress.emplace_back();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double s : field.stress[e][i]) stress.push_back(round_to(s, stress_digits));
      least = std::min(least, bounds::find_factor(problem.strength[e][i], field.stress[e][i]));
    }
    if (has_pressure) {
      std::vector<double>& pressure = result.pressure->emplace_back();
      for (const double p : problem.pore_pressure[e]) pressure.push_back(round_to(p, stress_digits));
    }
    result.utilisation.push_back(least > 0 ? round_to(std::min(1.0, factor / least), share_digits) : 1);
  }
  return result;
}

/// Makes the velocity field of the mechanism. The shear strain rate of a triangle is the mean of √((ε_x − ε_y)² + γ²)
/// at its corners.
results::MovingField make_velocity_result(const bounds::Problem& problem, const bounds::VelocityField& field) {
  results::MovingField result;
  double fastest = 0, most = 0;
  for (const Vec<2>& v : field.velocity) fastest = std::max(fastest, norm(v));
  for (std::size_t n = 0; n < field.mesh.nodes.size(); ++n) {
    result.nodes.push_back(round_place(field.mesh.nodes[n]));
    result.velocity.push_back({round_to(field.velocity[n][0] / fastest, velocity_digits),
                               round_to(field.velocity[n][1] / fastest, velocity_digits)});
  }
  for (std::size_t e = 0; e < problem.size(); ++e) {
    const auto& t = field.mesh.triangles[e];
    result.triangles.emplace_back(t.begin(), t.end());
    const bounds::Shape shape = bounds::find_shape(problem, e);
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto gradients = bounds::find_quadratic_gradients(shape, c);
      double x = 0, y = 0, xy = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        const Vec<2>& v = field.velocity[static_cast<std::size_t>(t[k])];
        x += gradients[k][0] * v[0], y += gradients[k][1] * v[1];
        xy += gradients[k][1] * v[0] + gradients[k][0] * v[1];
      }
      sum += std::hypot(x - y, xy) / 3;
    }
    result.shear_rate.push_back(sum);
    most = std::max(most, sum);
  }
  for (double& d : result.shear_rate) d = most > 0 ? round_to(d / most, share_digits) : 0;
  return result;
}

/// Returns the slip lines of the mechanism, found in the same way as those of FEM.
std::vector<results::SideLine> find_lines(const bounds::Problem& problem, const bounds::VelocityField& field) {
  fem::QuadraticMesh<2> mesh;
  mesh.nodes = field.mesh.nodes;
  fem::SolidState<2> state;
  state.displacement = field.velocity;
  fem::SolidModel<2> model;
  for (std::size_t e = 0; e < problem.size(); ++e) {
    const auto& t = field.mesh.triangles[e];
    mesh.elements.push_back(t);
    mesh.linear_element.push_back(static_cast<int>(e));
    const bounds::Shape shape = bounds::find_shape(problem, e);
    for (std::size_t c = 0; c < 3; ++c) {
      // The field is linear in the triangle: the point nearest corner c has the weight 2/3 of it and 1/6 of each other
      // corner.
      std::array<double, 6> strain{};
      Vec<2> place{0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        const double share = k == c ? 2.0 / 3 : 1.0 / 6;
        for (std::size_t d = 0; d < 2; ++d) place[d] += share * mesh.nodes[static_cast<std::size_t>(t[k])][d];
        const auto gradients = bounds::find_quadratic_gradients(shape, k);
        for (std::size_t n = 0; n < 6; ++n) {
          const Vec<2>& v = field.velocity[static_cast<std::size_t>(t[n])];
          strain[0] += share * gradients[n][0] * v[0], strain[1] += share * gradients[n][1] * v[1];
          strain[3] += share * (gradients[n][1] * v[0] + gradients[n][0] * v[1]);
        }
      }
      mesh.points.push_back(place);
      mesh.weights.push_back(shape.area / 3);
      state.strain.push_back(strain);
    }
  }
  for (const bounds::Side& s : problem.sides) {
    if (!s.holds_normal && !s.holds_along) continue;
    fem::Support<2> support;
    support.sides = {{s.from, s.to}};
    support.fixed = {true, s.holds_along};
    model.supports.push_back(support);
  }
  std::vector<results::SideLine> lines;
  for (fem::SlipLine& line : fem::find_slip_lines(model, mesh, state))
    lines.push_back({line.direction, std::move(line.points)});
  if (lines.size() > 1 && lines[0].direction > lines[1].direction) std::swap(lines[0], lines[1]);
  return lines;
}

std::vector<std::string> list_warnings(const results::BoundsResult& result, const bounds::BoundsResult& found) {
  std::vector<std::string> warnings;
  if (!result.lower) warnings.push_back("there is no lower bound: " + result.no_lower);
  if (!result.upper) warnings.push_back("there is no upper bound: " + result.no_upper);
  if (!result.is_interval()) return warnings;
  const double gap = 2 * (*result.upper - *result.lower) / (*result.upper + *result.lower);
  if (gap > result.asked_gap)
    warnings.push_back(fmt::format(
        "the interval is {} % wide, wider than the {:.2g} % of [bounds] gap: {}",
        gap < 0.1 ? fmt::format("{:.2g}", 100 * gap) : fmt::format("{:.0f}", 100 * gap), 100 * result.asked_gap,
        found.stopped.empty()
            ? fmt::format("the last mesh has {} triangles, give more 'triangles' in [bounds]", found.problem.size())
            : found.stopped));
  return warnings;
}

}  // namespace

results::BoundsFile make_bounds_result(const bounds::BoundsResult& found, double asked_gap) {
  results::BoundsFile file;
  results::BoundsResult& result = file.summary;
  result.no_lower = found.no_lower, result.no_upper = found.no_upper;
  if (found.lower > 0) result.lower = found.lower;
  if (std::isfinite(found.upper)) result.upper = found.upper;
  if (!result.lower && result.no_lower.empty()) result.no_lower = "no stress field passed its check";
  if (!result.upper && result.no_upper.empty()) result.no_upper = "no mechanism passed its check";
  result.asked_gap = asked_gap;
  result.warnings = list_warnings(result, found);
  for (const bounds::BoundsLevel& level : found.levels) {
    results::BoundsMesh mesh{level.triangles, {}, {}, level.programs, level.iterations, level.seconds};
    if (level.lower > 0) mesh.lower = level.lower;
    if (std::isfinite(level.upper)) mesh.upper = level.upper;
    result.meshes.push_back(mesh);
  }
  if (result.lower) {
    result.imbalance = found.static_check.imbalance / bounds::find_units(found.stress_problem).stress;
    file.holds = make_stress_result(found.stress_problem, found.stress, found.lower);
  }
  if (result.upper) {
    file.moves = make_velocity_result(found.velocity_problem, found.velocity);
    if (auto lines = find_lines(found.velocity_problem, found.velocity); !lines.empty())
      result.sides = std::move(lines);
  }
  return file;
}

namespace {

constexpr const char* bounds_file = "bounds.json";

/// Returns true if a soil has a tensile strength below the apex of its criterion.
bool has_tension_limit(const bounds::Problem& problem) {
  return std::any_of(problem.strength.begin(), problem.strength.end(), [](const auto& corners) {
    return std::any_of(corners.begin(), corners.end(), [](const bounds::Strength& s) { return s.tension.has_value(); });
  });
}

}  // namespace

BoundsRun::BoundsRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash)
    : MethodRun("limit analysis", bounds_file, alone, options, std::move(input_hash)),
      site_(site),
      data_(site_.data()) {}

void BoundsRun::prepare() {
  const bool is_made = try_part([&] {
    show("mesh");
    made_ = make_bounds_problem(site_);
    water_ = std::move(made_->water);
    clear_progress();
    is_known_ = read_kept();
  });
  if (!is_made) made_.reset();
}

results::BoundsFile BoundsRun::search(const ProblemOfCase& made, const bounds::BoundsOptions& options) {
  show(fmt::format("{} triangles", made.problem.size()));
  ProgressValues values{.method = "bounds"};
  // Each of two problems proves one bound of the case alone, and the lower bound of one direction of an earthquake may
  // not hold in the other.
  const bool is_whole = !made.stronger && data_.earthquake.list_directions().size() == 1;
  return make_bounds_result(
      find_case_bounds(made, options,
                       [&](const bounds::BoundsResult& found) {
                         const bounds::BoundsLevel& level = found.levels.back();
                         if (is_whole && level.lower > 0)
                           values.lower = std::max(values.lower.value_or(0), level.lower);
                         if (is_whole && std::isfinite(level.upper))
                           values.upper = std::min(values.upper.value_or(level.upper), level.upper);
                         show(fmt::format("{} triangles, {:.4g} to {:.4g}", level.triangles, level.lower, level.upper),
                              values);
                         if (options_.keeps_present && is_whole) clock_.update([&] { keep_present(found); });
                       }),
      data_.bounds.gap);
}

void BoundsRun::keep_present(const bounds::BoundsResult& found) const {
  results::BoundsFile file = make_bounds_result(found, data_.bounds.gap);
  file.summary.warnings.clear();  // they are those of the end
  file.summary.fields_file = results::present_bounds_file;
  results::write_file(options_.folder / results::present_bounds_file, file, -1);
}

/// Searches the other direction of the earthquake. The result is that of the direction with the smaller upper bound;
/// its lower bound holds for both.
void BoundsRun::search_other_direction(const bounds::BoundsOptions& options) {
  const auto directed = [&](input::EarthquakeDirection direction) {
    input::Case data = data_;
    data.earthquake.direction = direction;
    data.earthquake.horizontal = std::abs(data.earthquake.horizontal);
    return make_bounds_problem(data);
  };
  const ProblemOfCase left = directed(input::EarthquakeDirection::left);
  const bool was_left = left.problem.body_force == made_->problem.body_force;
  results::BoundsFile other = search(was_left ? directed(input::EarthquakeDirection::right) : left, options);
  const auto get_upper = [](const results::BoundsFile& file) {
    return file.summary.upper.value_or(std::numeric_limits<double>::infinity());
  };
  const bool is_first_governing = get_upper(file_) <= get_upper(other);
  if (!is_first_governing) std::swap(file_, other);
  results::BoundsResult& out = file_.summary;
  out.earthquake = results::EarthquakeSide{was_left == is_first_governing ? -1 : 1, other.summary.lower};
  if (!out.lower || (other.summary.lower && *other.summary.lower >= *out.lower)) return;
  // The reason for the low bound of the other direction is the reason for the width of this interval.
  out.lower = other.summary.lower;
  out.no_lower = other.summary.no_lower;
  for (const std::string& warning : other.summary.warnings)
    out.warnings.push_back("earthquake in the other direction: " + warning);
}

void BoundsRun::calculate(std::optional<double> start) {
  if (!made_ || is_known_) return;
  const bool is_found = try_part([&] {
    bounds::BoundsOptions options;
    options.gap = data_.bounds.gap;
    options.most_triangles = data_.bounds.triangles;
    options.start = start.value_or(1);
    options.threads = options_.threads;
    file_ = search(*made_, options);
    if (data_.earthquake.list_directions().size() > 1) search_other_direction(options);
    file_.summary.warnings.insert(file_.summary.warnings.begin(), made_->notes.begin(), made_->notes.end());
  });
  if (!is_found) return made_.reset();
  file_.input_hash = hash_;
  results::BoundsResult& result = file_.summary;
  result.is_davis = data_.bounds.flow == input::BoundsFlow::davis;
  result.takes_tension = has_tension_limit(made_->problem);
  result.fields_file = bounds_file;
  result.seepage = water_.seepage;
  result.seconds = spent_.count();
  write_kept();
  clear_progress();
}

void BoundsRun::write_result(results::RunResult& run) const {
  run.bounds = file_.summary;
  add_warnings(run);
  site::give(water_, run);
}

}  // namespace talus::run
