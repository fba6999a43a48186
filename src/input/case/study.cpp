// SPDX-License-Identifier: MIT
// Checks of [study] with mode = "sample" that do not depend on numbers of the case. The others are in read.cpp.
#include "input/case/study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "input/case/checks.hpp"
#include "input/case/uncertain_number.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, RandomNumber& r) {
  using D = Distribution;
  const auto by_mean = {D::normal, D::lognormal};
  v.key("key", r.key, plain().required().example(R"("materials.sand.cohesion")"),
        "The key whose number is uncertain, written as for --set.");
  v.key("distribution", r.distribution, plain(), "How its values are distributed.");
  TomlText mean{r.mean}, deviation{r.deviation}, lowest{r.lowest}, mode{r.mode}, highest{r.highest};
  v.key("mean", mean, plain().allowed_with("distribution", r.distribution, by_mean).example(R"("10 kPa")"),
        "Mean, in the unit of the key or with a unit; if not given, the value of the key.");
  v.key("deviation", deviation, plain().allowed_with("distribution", r.distribution, by_mean).example("2"),
        "Standard deviation. Either this or `variation` is needed.");
  v.key("variation", r.variation, plain().above(0).allowed_with("distribution", r.distribution, by_mean).example("0.2"),
        "Coefficient of variation instead: standard deviation over mean.");
  v.key("lowest", lowest, plain().example("5"),
        "Lowest value; needed by triangular and uniform, and cuts the others off where it is given.");
  v.key("mode", mode, plain().allowed_with("distribution", r.distribution, D::triangular).example("10"),
        "The likeliest value; if not given, the value of the key.");
  v.key("highest", highest, plain().example("15"), "Highest value, like the lowest.");
}

void describe(Visitor& v, Correlation& c) {
  v.key("keys", c.keys, plain().required().example(R"(["materials.sand.cohesion", "materials.sand.friction_angle"])"),
        "Keys of two of the [[study.random]].");
  v.key("coefficient", c.coefficient, plain().above(-1).below(1).required().example("-0.5"),
        "Coefficient of correlation of the two, measured on their normal scores.");
}

namespace {

void describe_sampling(Visitor& v, Study& s) {
  const auto sample = StudyMode::sample;
  Sampling& a = s.sampling;
  v.key("samples", a.samples, plain().at_least(2).allowed_with("mode", s.mode, sample), "Samples.");
  v.key("seed", a.seed, plain().allowed_with("mode", s.mode, sample),
        "Seed of the random numbers; the same seed brings the same samples.");
  v.key("plan", a.plan, plain().allowed_with("mode", s.mode, sample), "How samples are drawn.");
  v.key("method", a.method, plain().allowed_with("mode", s.mode, sample), "What calculates each sample.");
  v.key("confidence", a.confidence, plain().above(0).below(1).allowed_with("mode", s.mode, sample),
        "Confidence level of the interval of the probability of failure.");
  v.key("runout", a.runout, quantity("m").at_least(0).allowed_with("mode", s.mode, sample).example("[2, 5, 10]"),
        "For MPM: distances whose probability of exceedance is computed; empty: chosen from the samples.");
}

}  // namespace

void describe(Visitor& v, Vary& w) {
  v.key("key", w.key, plain().required().example(R"("materials.sand.cohesion")"),
        "The key to vary, written as for --set.");
  TomlTexts values{w.values};
  v.key("values", values, plain().required().example("[5, 10, \"15 kPa\"]"), "Its values.");
  TomlTexts names{w.names};
  v.key("names", names, plain().example("[\"weak\", \"as tested\", \"strong\"]"),
        "Names of the variants with these values, for tables, charts and folders; if not given, \"cohesion = 5\".");
}

void describe(Visitor& v, Study& s) {
  v.key("mode", s.mode, plain(), "How the values of several keys are combined.");
  v.key("factors", s.factors, plain().above(0).example("[1.2, 1.4]"),
        "Strength reduction factors whose displacement the table of the study lists.");
  v.key("base_name", s.base_name, plain(), "Name of the case as the file has it.");
  v.key("reference", s.reference, plain(),
        "The variant that the displacements of the monitors are divided by: its name in the table, such as \"content = "
        "0.51\", or that of its folder.");
  v.key("extrapolate", s.extrapolate, plain().example(R"("mesh.size")"),
        "One of the varied keys, to whose value zero the factors of safety are extrapolated (Richardson).");
  describe_sampling(v, s);
  v.tables("vary", s.vary, 0, "A key and the values it takes in `talus study`.");
  v.tables("random", s.sampling.numbers, 0, "An uncertain number, for mode = \"sample\".");
  v.tables("correlation", s.sampling.correlations, 0, "Two of these numbers that go together.");
}

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
