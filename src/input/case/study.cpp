// SPDX-License-Identifier: MIT
// Checks of [study] with mode = "sample" that do not depend on numbers of the case. The others are in read.cpp.
#include "input/case/study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "input/case/checks.hpp"
#include "input/case/uncertain_number.hpp"

namespace talus::input {

namespace {

std::vector<std::string> list_keys(const Sampling& sampling) {
  std::vector<std::string> keys;
  for (const RandomNumber& number : sampling.numbers) keys.push_back(number.key);
  return keys;
}

void check_mode(const Study& study, Findings& findings) {
  const bool samples = study.mode == StudyMode::sample;
  if (!findings.is_sound("study.mode")) return;
  if (samples && study.sampling.numbers.empty() && findings.is_sound("study.random"))
    findings.add("study.mode", "mode = \"sample\" needs at least one [[study.random]], with a key and its deviation");
  if (samples && !study.vary.empty() && findings.is_sound("study.vary"))
    findings.add("study.vary.0", "[[study.vary]] has no meaning with mode = \"sample\"; write [[study.random]]");
  if (!samples && !study.sampling.numbers.empty())
    findings.add("study.random.0", "[[study.random]] has a meaning only with mode = \"sample\" in [study]");
}

/// Reports partial factors, because samples use characteristic soil parameters.
void check_no_partial_factors(const Case& data, Findings& findings) {
  if (data.study.mode == StudyMode::sample && data.partial_factors.set != DesignApproach::none &&
      findings.is_sound("study.mode") && findings.is_sound("partial_factors"))
    findings.add("partial_factors.set",
                 "partial factors have no meaning with mode = \"sample\" in [study]: samples use the soil without "
                 "partial factors");
}

void check_method(const Case& data, Findings& findings) {
  if (data.study.mode != StudyMode::sample || !findings.is_sound("study") || !findings.is_sound("analysis")) return;
  const Method method = find_method(data.study.sampling.method);
  if (!uses(data, method))
    findings.add("study.method",
                 "the samples are to be calculated by \"{}\", which 'methods' in [analysis] does not name",
                 get_word(method));
}

/// Returns the index of a key among the uncertain numbers; std::nullopt and a finding if it is not one of them.
std::optional<int> find_place(const std::string& key, const std::vector<std::string>& keys, const std::string& path,
                              Findings& findings) {
  const auto at = std::find(keys.begin(), keys.end(), key);
  if (at != keys.end()) return static_cast<int>(at - keys.begin());
  const std::string near = find_nearest(key, keys);
  findings.add(path, "'{}' is the key of no [[study.random]]{}", key,
               near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
  return std::nullopt;
}

void check_correlations(const Sampling& sampling, Findings& findings) {
  const std::vector<std::string> keys = list_keys(sampling);
  const std::size_t size = keys.size();
  std::vector<double> matrix(size * size);
  for (std::size_t i = 0; i < size; ++i) matrix[i * size + i] = 1;
  std::set<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < sampling.correlations.size(); ++i) {
    const Correlation& c = sampling.correlations[i];
    const std::string path = fmt::format("study.correlation.{}", i);
    if (!findings.is_sound(path)) continue;
    if (c.keys.size() != 2 || c.keys[0] == c.keys[1]) {
      findings.add(path + ".keys", "a correlation is that of two different keys");
      continue;
    }
    const auto a = find_place(c.keys[0], keys, path + ".keys.0", findings);
    const auto b = find_place(c.keys[1], keys, path + ".keys.1", findings);
    if (!a || !b) continue;
    if (!pairs.insert(std::minmax(*a, *b)).second)
      findings.add(path + ".keys", "there are two correlations of '{}' and '{}'", c.keys[0], c.keys[1]);
    const auto row = static_cast<std::size_t>(*a), column = static_cast<std::size_t>(*b);
    matrix[row * size + column] = matrix[column * size + row] = c.coefficient;
  }
  if (!findings.is_sound("study.correlation") || sampling.correlations.empty()) return;
  if (!factorise(matrix, static_cast<int>(size)))
    findings.add("study.correlation",
                 "the correlations contradict one another: no numbers have all of these coefficients (their matrix is "
                 "not positive definite)");
}

}  // namespace

void check_sampling(const Case& data, Findings& findings) {
  const Study& study = data.study;
  check_mode(study, findings);
  check_method(data, findings);
  check_no_partial_factors(data, findings);
  std::set<std::string> keys;
  for (std::size_t i = 0; i < study.sampling.numbers.size(); ++i)
    if (const std::string path = fmt::format("study.random.{}.key", i);
        findings.is_sound(path) && !keys.insert(study.sampling.numbers[i].key).second)
      findings.add(path, "there are two uncertain numbers of the key '{}'", study.sampling.numbers[i].key);
  if (findings.is_sound("study.random")) check_correlations(study.sampling, findings);
  if (study.extrapolate.empty() || !findings.is_sound("study.vary") || !findings.is_sound("study.extrapolate")) return;
  if (std::none_of(study.vary.begin(), study.vary.end(), [&](const Vary& v) { return v.key == study.extrapolate; }))
    findings.add("study.extrapolate", "'{}' is extrapolated, but no [[study.vary]] varies it", study.extrapolate);
}

}  // namespace talus::input
