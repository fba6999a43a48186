// SPDX-License-Identifier: MIT
#include "study/sampled_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/case/uncertain_number.hpp"
#include "input/echo.hpp"
#include "input/language/parse.hpp"

namespace talus::study {

namespace {

/// Returns the last `count` parts of a path.
std::string take_end(const std::string& path, std::size_t count) {
  const std::vector<std::string> parts = input::split_path(path);
  std::string text;
  for (std::size_t i = parts.size() - std::min(count, parts.size()); i < parts.size(); ++i)
    text += (text.empty() ? "" : ".") + parts[i];
  return text;
}

}  // namespace

std::string shorten_path(const std::string& path, const std::vector<std::string>& all) {
  for (std::size_t count = 1; count < input::split_path(path).size(); ++count) {
    std::string end = take_end(path, count);
    const auto shares = [&](const std::string& other) { return other != path && take_end(other, count) == end; };
    if (std::none_of(all.begin(), all.end(), shares)) return end;
  }
  return path;
}

namespace {

using input::Distribution;

/// A distribution with a smaller probability beyond the limits of its key is cut there without a note.
constexpr double worth_telling = 1e-6;

std::string write_value(double x, const std::string& unit, int digits = 6) {
  return fmt::format("{:.{}g}{}{}", x, digits, unit.empty() ? "" : " ", unit);
}

/// Formats "lognormal, mean 18 kPa, deviation 3.6 kPa", with the limits given by the case, and adds a note if a limit
/// cuts the distribution.
std::string describe(const results::UncertainNumber& number, const Marginal& m, const input::RandomNumber& given,
                     std::vector<std::string>& notes) {
  const auto write = [&](double x) { return write_value(x, number.unit); };
  std::string text = number.distribution;
  if (m.kind == Distribution::triangular || m.kind == Distribution::uniform) {
    text += fmt::format(" between {} and {}", write(m.lowest), write(m.highest));
    return m.kind == Distribution::uniform ? text : text + fmt::format(", most probable {}", write(m.mode));
  }
  text += fmt::format(", mean {}, deviation {}", write(m.mean), write(m.deviation));
  if (!given.lowest.empty()) text += fmt::format(", cut below {:.6g}", m.lowest);
  if (!given.highest.empty()) text += fmt::format(", cut above {:.6g}", m.highest);
  if (const double share = m.find_cut_share(); share > worth_telling)
    notes.push_back(fmt::format(
        "{:.2g} % of the distribution of {} lies beyond {}: it is cut there, and its mean is {} then.", 100 * share,
        number.key, given.lowest.empty() && given.highest.empty() ? "what the key allows" : "its limits",
        write_value(number.mean, number.unit, 4)));
  return text;
}

std::vector<double> read_correlation(const input::Sampling& sampling, const std::vector<std::string>& keys) {
  const std::size_t n = keys.size();
  std::vector<double> matrix(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1;
  const auto find = [&](const std::string& key) {
    return static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
  };
  for (const input::Correlation& c : sampling.correlations) {
    const std::size_t i = find(c.keys.at(0)), j = find(c.keys.at(1));
    matrix.at(i * n + j) = matrix.at(j * n + i) = c.coefficient;
  }
  return matrix;
}

}  // namespace

SampledNumbers read_sampled_numbers(const input::LoadedCase& base) {
  const input::Sampling& sampling = base.data.study.sampling;
  SampledNumbers sampled;
  std::vector<std::string> keys;
  for (const input::RandomNumber& n : sampling.numbers) keys.push_back(n.key);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const input::UncertainNumber found = input::resolve(sampling.numbers[i], base.data, base.echo.get());
    const Marginal m{found.distribution, found.mean, found.deviation, found.lowest, found.highest, found.mode};
    results::UncertainNumber n;
    n.key = found.key;
    n.name = shorten_path(n.key, keys);
    n.unit = found.unit;
    n.distribution = input::find_key(base.echo, fmt::format("study.random.{}.distribution", i))->text;
    n.mean = m.find_mean();
    n.deviation = m.find_deviation();
    if (std::isfinite(m.lowest)) n.lowest = m.lowest;
    if (std::isfinite(m.highest)) n.highest = m.highest;
    n.text = describe(n, m, sampling.numbers[i], sampled.notes);
    sampled.means.push_back(n.mean);
    sampled.marginals.push_back(m);
    sampled.numbers.push_back(std::move(n));
  }
  sampled.correlation = read_correlation(sampling, keys);
  return sampled;
}

std::vector<input::Override> set_values(const std::vector<input::Override>& overrides, const SampledNumbers& sampled,
                                        const std::vector<double>& values) {
  std::vector<input::Override> changes = overrides;
  changes.push_back({"study", "{}"});
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string number = fmt::format("{}", values[i]);
    const std::string& unit = sampled.numbers[i].unit;
    changes.push_back({sampled.numbers[i].key, unit.empty() ? number : fmt::format("\"{} {}\"", number, unit)});
  }
  return changes;
}

input::LoadedCase read_sample(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                              const SampledNumbers& sampled, const std::vector<double>& values) {
  return input::read_case_text(base.text, base.file, set_values(overrides, sampled, values));
}

}  // namespace talus::study
