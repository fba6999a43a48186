// SPDX-License-Identifier: MIT
#include "laboratory/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "laboratory/calibration_findings.hpp"
#include "laboratory/calibration_model.hpp"
#include "laboratory/calibration_search.hpp"

namespace talus::laboratory {
namespace {

using results::AtLimit;

constexpr double at_limit = 1e-6;  ///< of the range: nearer to its end a parameter counts as being there
constexpr int most_draws = 200;    ///< of a random start that the case does not refuse

/// Uniform numbers that are the same with every compiler, which those of <random> are not.
class Draw {
 public:
  explicit Draw(int seed) : engine_(static_cast<std::uint64_t>(seed)) {}
  double next() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

/// Where the searches begin: at the user's values, then at random.
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

/// Searches end a little short of a limit, or at it within rounding.
std::vector<double> snap(std::vector<double> places) {
  for (double& u : places) u = u < at_limit ? 0 : u > 1 - at_limit ? 1 : u;
  return places;
}

double sum_squares(const std::vector<double>& residuals) {
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return sum;
}

std::vector<results::CalibratedCurve> describe_curves(const input::Calibration& calibration, const Comparison& before,
                                                      const Comparison& fitted) {
  std::vector<results::CalibratedCurve> curves;
  for (std::size_t k = 0; k < calibration.curves.size(); ++k) {
    const input::MeasuredCurve& c = calibration.curves[k];
    results::CalibratedCurve& f = curves.emplace_back();
    f.test = c.test, f.x.name = c.x, f.y.name = c.y, f.deviation = c.deviation, f.weight = c.weight;
    f.before = before.values[k], f.fitted = fitted.values[k], f.missing = fitted.missing[k];
    f.line_before = before.lines[k], f.line = fitted.lines[k];
    const auto n = static_cast<double>(c.points.size());
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      f.at.push_back(c.points[i][0]);
      f.measured.push_back(c.points[i][1]);
      const double now = f.fitted[i] - f.measured[i], then = f.before[i] - f.measured[i];
      f.rms += now * now / n;
      f.rms_before += then * then / n;
      f.mean += now / n;
      if (std::abs(now) >= std::abs(f.largest)) f.largest = now, f.largest_at = f.at[i];
    }
    f.rms = std::sqrt(f.rms);
    f.rms_before = std::sqrt(f.rms_before);
  }
  return curves;
}

/// Standard errors and correlations, scaled with the scatter that is left.
void add_certainty(const CalibrationModel& model, const std::vector<double>& places, const Certainty& certainty,
                   results::Calibration& result) {
  const std::size_t m = places.size();
  result.correlation.assign(m, std::vector<std::optional<double>>(m));
  if (certainty.covariance.empty()) return;
  const auto& c = certainty.covariance;
  for (std::size_t i = 0; i < m; ++i) {
    if (c[i][i] <= 0) continue;  // held at a limit
    result.parameters[i].error = std::sqrt(c[i][i]) * result.scatter * model.find_slope(i, places[i]);
    for (std::size_t j = 0; j < m; ++j)
      if (c[j][j] > 0) result.correlation[i][j] = c[i][j] / std::sqrt(c[i][i] * c[j][j]);
  }
}

}  // namespace

results::Calibration calibrate(const input::Case& data, const CalibrationOptions& options, std::string* log) {
  const CalibrationModel model(data);
  const input::Calibration& calibration = *data.calibration;
  results::Calibration result;
  const std::vector<std::vector<double>> starts = choose_starts(model, calibration, result.evaluations);
  std::vector<Search> searches;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    SearchOptions how{calibration.iterations, options.threads, nullptr};
    how.watch = [&](int iteration, double misfit) {
      if (options.progress == nullptr || !options.progress->is_due()) return;
      options.progress->show(fmt::format("[{} of {}] iteration {}, misfit {:.4g}, {} tests", k + 1, starts.size(),
                                         iteration, misfit, model.count_runs()));
    };
    try {
      searches.push_back(search(model, starts[k], how));
    } catch (const Error& error) {
      if (error.code() != ExitCode::wrong_input) throw;
      throw Error(error.code(), fmt::format("the search cannot begin at the values of 'start': {}", error.what()));
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

}  // namespace talus::laboratory
