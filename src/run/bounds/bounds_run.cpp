// SPDX-License-Identifier: MIT
#include "run/bounds/bounds_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "results/json.hpp"
#include "run/attempt.hpp"
#include "run/bounds/tell_bounds.hpp"

namespace talus::run {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char *bounds_file = "bounds.json", *bounds_title = "proven bounds";

/// Whether some soil bears less tension than the apex of its criterion.
bool has_tension_limit(const bounds::Problem& problem) {
  return std::any_of(problem.strength.begin(), problem.strength.end(), [](const auto& corners) {
    return std::any_of(corners.begin(), corners.end(), [](const bounds::Strength& s) { return s.tension.has_value(); });
  });
}

}  // namespace

BoundsRun::BoundsRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash)
    : data_(data), options_(options), hash_(std::move(input_hash)), alone_(alone) {}

/// Runs `part`. If the case has other methods as well, its exception becomes a part of the result.
template <class Part>
void BoundsRun::attempt(Part part) {
  const auto start = Clock::now();
  if (const auto why = run::attempt(options_, alone_, part)) {
    made_.reset();
    file_ = {};
    file_.summary.error = why;
    file_.summary.warnings = {fmt::format("{}: {}", bounds_title, *why)};
  }
  spent_ += Clock::now() - start;
}

void BoundsRun::show(const std::string& what) const {
  if (options_.progress) options_.progress->show(fmt::format("{}: {}", bounds_title, what));
}

void BoundsRun::prepare() {
  attempt([&] {
    show("mesh");
    made_ = make_bounds_problem(data_);
    water_ = std::move(made_->water);
    if (options_.progress) options_.progress->clear();
    if (!options_.resume) return;
    auto known = results::find_file<results::BoundsFile>(options_.folder / bounds_file);
    if (!known || known->input_hash != hash_) return;
    file_ = std::move(*known);
    is_known_ = true;
  });
}

results::BoundsFile BoundsRun::search(const bounds::Problem& problem, const bounds::BoundsOptions& options) const {
  show(fmt::format("{} triangles", problem.size()));
  return make_bounds_result(bounds::find_bounds(problem, options,
                                         [&](const bounds::BoundsLevel& level) {
                                           show(fmt::format("{} triangles, {:.4g} to {:.4g}", level.triangles,
                                                            level.lower, level.upper));
                                         }),
                     data_.bounds.gap);
}

/// The result is of the direction with the smaller upper bound; its lower bound holds in both.
void BoundsRun::search_other_direction(const bounds::BoundsOptions& options) {
  const auto directed = [&](input::EarthquakeDirection direction) {
    input::Case data = data_;
    data.earthquake.direction = direction;
    data.earthquake.horizontal = std::abs(data.earthquake.horizontal);
    return make_bounds_problem(data).problem;
  };
  const bounds::Problem left = directed(input::EarthquakeDirection::left);
  const bool was_left = left.body_force == made_->problem.body_force;
  results::BoundsFile other = search(was_left ? directed(input::EarthquakeDirection::right) : left, options);
  const auto get_upper = [](const results::BoundsFile& file) {
    return file.summary.upper.value_or(std::numeric_limits<double>::infinity());
  };
  const bool is_first_governing = get_upper(file_) <= get_upper(other);
  if (!is_first_governing) std::swap(file_, other);
  results::BoundsResult& out = file_.summary;
  out.earthquake = results::EarthquakeSide{was_left == is_first_governing ? -1 : 1, other.summary.lower};
  if (!out.lower || (other.summary.lower && *other.summary.lower >= *out.lower)) return;
  // What leaves the other direction's bound low leaves this interval wide.
  out.lower = other.summary.lower;
  out.no_lower = other.summary.no_lower;
  for (const std::string& warning : other.summary.warnings)
    out.warnings.push_back("earthquake in the other direction: " + warning);
}

void BoundsRun::calculate(std::optional<double> start) {
  if (!made_ || is_known_) return;
  attempt([&] {
    bounds::BoundsOptions options;
    options.gap = data_.bounds.gap;
    options.most_triangles = data_.bounds.triangles;
    options.start = start.value_or(1);
    options.threads = options_.threads;
    file_ = search(made_->problem, options);
    if (data_.earthquake.list_directions().size() > 1) search_other_direction(options);
    file_.summary.warnings.insert(file_.summary.warnings.begin(), made_->notes.begin(), made_->notes.end());
  });
  if (!made_) return;
  file_.input_hash = hash_;
  results::BoundsResult& result = file_.summary;
  result.is_davis = data_.bounds.flow == input::BoundsFlow::davis;
  result.takes_tension = has_tension_limit(made_->problem);
  result.fields_file = bounds_file;
  result.seepage = water_.seepage;
  result.seconds = spent_.count();
  results::write_file(options_.folder / bounds_file, file_, -1);
  if (options_.progress) options_.progress->clear();
}

void BoundsRun::write_result(results::RunResult& run) const {
  const results::BoundsResult& result = file_.summary;
  run.bounds = result;
  for (const std::string& warning : result.warnings)
    run.warnings.push_back(result.error ? warning : fmt::format("{}: {}", bounds_title, warning));
  ground::give(water_, run);
}

}  // namespace talus::run
