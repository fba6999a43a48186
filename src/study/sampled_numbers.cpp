#include "study/sampled_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/case/uncertain_number.hpp"
#include "study/key_paths.hpp"

namespace talus::study {
namespace {

using input::Distribution;

/// A distribution of which less than this lies beyond the limits of its key is cut there without a word.
constexpr double worth_telling = 1e-6;
constexpr double per_cent = 100;

std::string describe(const SampledNumber& number) {
  const Marginal& m = number.marginal;
  const auto write = [&](double x) {
    return fmt::format("{:.6g}{}{}", x, number.unit.empty() ? "" : " ", number.unit);
  };
  std::string text = name_distribution(m.kind);
  if (m.kind == Distribution::triangular || m.kind == Distribution::uniform) {
    text += fmt::format(" between {} and {}", write(m.lowest), write(m.highest));
    return m.kind == Distribution::uniform ? text : text + fmt::format(", most probable {}", write(m.mode));
  }
  return text + fmt::format(", mean {}, deviation {}", write(m.mean), write(m.deviation));
}

/// The limits that the case or the key sets, in words, and a note where they take something away.
void tell_cut(SampledNumber& number, const input::RandomNumber& given, std::vector<std::string>& notes) {
  const Marginal& m = number.marginal;
  if (m.kind == Distribution::triangular || m.kind == Distribution::uniform) return;
  if (!given.lowest.empty()) number.text += fmt::format(", cut below {:.6g}", m.lowest);
  if (!given.highest.empty()) number.text += fmt::format(", cut above {:.6g}", m.highest);
  if (const double share = m.find_cut_share(); share > worth_telling)
    notes.push_back(
        fmt::format("{:.2g} % of the distribution of {} lies beyond {}: it is cut there, and its mean is "
                    "{:.4g}{}{} then.",
                    per_cent * share, number.key,
                    given.lowest.empty() && given.highest.empty() ? "what the key allows" : "its limits", m.find_mean(),
                    number.unit.empty() ? "" : " ", number.unit));
}

SampledNumber read_number(const input::LoadedCase& base, const input::RandomNumber& given,
                          std::vector<std::string>& notes) {
  const input::UncertainNumber found = input::resolve(given, base.data, base.echo.get());
  SampledNumber number;
  number.key = found.key;
  number.unit = found.unit;
  number.marginal = {found.distribution, found.mean, found.deviation, found.lowest, found.highest, found.mode};
  number.text = describe(number);
  tell_cut(number, given, notes);
  return number;
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

std::vector<Marginal> SampledNumbers::list_marginals() const {
  std::vector<Marginal> list;
  for (const SampledNumber& n : numbers) list.push_back(n.marginal);
  return list;
}

std::vector<double> SampledNumbers::list_means() const {
  std::vector<double> list;
  for (const SampledNumber& n : numbers) list.push_back(n.marginal.find_mean());
  return list;
}

SampledNumbers read_sampled_numbers(const input::LoadedCase& base) {
  const input::Sampling& sampling = base.data.study.sampling;
  SampledNumbers sampled;
  std::vector<std::string> keys;
  for (const input::RandomNumber& n : sampling.numbers) keys.push_back(n.key);
  for (const input::RandomNumber& n : sampling.numbers) {
    sampled.numbers.push_back(read_number(base, n, sampled.notes));
    sampled.numbers.back().name = shorten_path(n.key, keys);
  }
  sampled.correlation = read_correlation(sampling, keys);
  return sampled;
}

std::vector<input::Override> set_values(const SampledNumbers& sampled, const std::vector<double>& values) {
  std::vector<input::Override> changes;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string number = fmt::format("{}", values[i]);
    const std::string& unit = sampled.numbers[i].unit;
    changes.push_back({sampled.numbers[i].key, unit.empty() ? number : fmt::format("\"{} {}\"", number, unit)});
  }
  return changes;
}

input::LoadedCase read_sample(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                              const SampledNumbers& sampled, const std::vector<double>& values) {
  std::vector<input::Override> changes = overrides;
  changes.push_back({"study", "{}"});
  for (input::Override& change : set_values(sampled, values)) changes.push_back(std::move(change));
  return input::read_case_text(base.text, base.file, changes);
}

}  // namespace talus::study
