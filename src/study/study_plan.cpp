// SPDX-License-Identifier: MIT
#include "study/study_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/text.hpp"
#include "base/user_file.hpp"
#include "input/echo.hpp"
#include "run/run_case.hpp"
#include "study/sampled_numbers.hpp"

namespace talus::study {
namespace {

/// A grid of more variants is usually a typing error: reading them alone would take minutes.
constexpr std::size_t most_variants = 10000;
/// Longest text of one value in the name of a folder.
constexpr std::size_t longest_name = 40;

/// Removes the quotation marks of a TOML string.
std::string strip_quotes(const std::string& text) {
  if (text.size() < 2 || (text.front() != '"' && text.front() != '\'') || text.back() != text.front()) return text;
  return text.substr(1, text.size() - 2);
}

std::string name_part(const std::string& text) {
  return make_file_name(text, "empty", longest_name);
}

/// A combination of values: for every key the index of its value; nullopt for that of the base case.
using Choice = std::vector<std::optional<std::size_t>>;

std::vector<Choice> list_choices(const input::Study& study) {
  std::vector<Choice> choices{Choice(study.vary.size())};
  if (study.mode == input::StudyMode::one_at_a_time) {
    for (std::size_t k = 0; k < study.vary.size(); ++k)
      for (std::size_t j = 0; j < study.vary[k].values.size(); ++j) {
        choices.emplace_back(study.vary.size());
        choices.back()[k] = j;
      }
    return choices;
  }
  if (study.mode == input::StudyMode::together) {
    for (std::size_t j = 0; j < study.vary.front().values.size(); ++j) choices.emplace_back(study.vary.size(), j);
    return choices;
  }
  std::vector<Choice> grid{Choice(study.vary.size())};
  for (std::size_t k = 0; k < study.vary.size(); ++k) {
    std::vector<Choice> longer;
    for (const Choice& choice : grid)
      for (std::size_t j = 0; j < study.vary[k].values.size(); ++j) {
        longer.push_back(choice);
        longer.back()[k] = j;
      }
    grid = std::move(longer);
  }
  choices.insert(choices.end(), grid.begin(), grid.end());
  return choices;
}

/// Returns true if the values of a key have no names, but those of another key with mode = "together" name the
/// variants.
bool is_unnamed(const input::Study& study, std::size_t key) {
  const auto has_names = [](const input::Vary& v) { return !v.names.empty(); };
  return study.mode == input::StudyMode::together && study.vary[key].names.empty() &&
         std::any_of(study.vary.begin(), study.vary.end(), has_names);
}

void check_study(const input::LoadedCase& base) {
  const input::Study& study = base.data.study;
  const auto fail = [&](const std::string& path, const std::string& sentence) {
    const input::Place place = base.places.find(path);
    throw InputError({{place.file, place.line, place.column, sentence}});
  };
  if (study.vary.empty()) fail("study", "there is nothing to vary: add a [[study.vary]] with a key and its values");
  const auto is_extrapolated = [&](const input::Vary& v) { return v.key == study.extrapolate; };
  if (!study.extrapolate.empty() && std::none_of(study.vary.begin(), study.vary.end(), is_extrapolated))
    fail("study.extrapolate",
         fmt::format("'{}' is not varied; 'extrapolate' names one of the keys of [[study.vary]]", study.extrapolate));
  std::size_t count = 1;
  for (std::size_t k = 0; k < study.vary.size(); ++k) {
    const input::Vary& v = study.vary[k];
    if (!v.names.empty() && v.names.size() != v.values.size())
      fail(fmt::format("study.vary.{}.names", k),
           fmt::format("there are {} names for {} values", v.names.size(), v.values.size()));
    if (study.mode == input::StudyMode::together && v.values.size() != study.vary.front().values.size())
      fail(fmt::format("study.vary.{}.values", k),
           fmt::format("'{}' has {} values and '{}' has {}; with mode = \"together\" all keys have as many", v.key,
                       v.values.size(), study.vary.front().key, study.vary.front().values.size()));
    if (study.mode != input::StudyMode::grid) continue;
    count *= v.values.size();
    if (count > most_variants)
      fail("study.mode", fmt::format("the grid has more than {} variants; vary fewer keys or values", most_variants));
  }
}

/// Sets name and label of a variant, and its changes of the case.
Variant name_variant(const input::Study& study, const std::vector<std::string>& keys, const Choice& choice,
                     std::vector<input::Override>& changes) {
  Variant variant;
  changes.push_back({"study", "{}"});
  for (std::size_t k = 0; k < study.vary.size(); ++k) {
    if (!choice[k]) continue;
    const std::string& value = study.vary[k].values[*choice[k]];
    const std::vector<std::string>& titles = study.vary[k].names;
    changes.push_back({study.vary[k].key, value});
    if (is_unnamed(study, k)) continue;
    const std::string title =
        titles.empty() ? fmt::format("{} = {}", keys[k], strip_quotes(value)) : strip_quotes(titles[*choice[k]]);
    const std::string name =
        titles.empty() ? name_part(keys[k]) + "_" + name_part(strip_quotes(value)) : name_part(title);
    variant.name += (variant.name.empty() ? "" : "__") + name;
    variant.label += (variant.label.empty() ? "" : ", ") + title;
  }
  variant.name = make_file_name(variant.name, "base");
  variant.label = make_printable(variant.label.empty() ? study.base_name : variant.label);
  return variant;
}

}  // namespace

results::StudyResult begin_study(const input::LoadedCase& base) {
  results::StudyResult result;
  result.title = base.data.title;
  result.case_file = base.file;
  result.mode = input::find_key(base.echo, "study.mode")->text;
  result.units = {base.data.output.displacement_unit, base.data.output.length_unit, std::nullopt};
  return result;
}

StudyPlan plan_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides) {
  check_study(base);
  const input::Study& study = base.data.study;
  StudyPlan plan;
  plan.summary = begin_study(base);
  plan.factors = study.factors;
  if (base.data.analysis == input::AnalysisKind::run)
    for (const input::Monitor& m : base.data.output.monitors) plan.monitors.push_back(m.name);
  std::vector<std::string> paths;
  for (const input::Vary& v : study.vary) paths.push_back(v.key);
  for (const std::string& path : paths) {
    if (path == study.extrapolate && !plan.extrapolated) plan.extrapolated = plan.names.size();
    plan.summary.vary.push_back({path, "", {}});
    plan.names.push_back(shorten_path(path, paths));
  }

  const input::Place place = base.places.find("study.vary.0");
  std::vector<Diagnostic> faults;
  std::set<std::string> known_faults, names;
  std::map<std::string, std::string> known_cases;  // echo of what is calculated → label
  std::map<std::string, std::size_t> numbers;      // label or folder → number of the variant
  for (const Choice& choice : list_choices(study)) {
    std::vector<input::Override> changes = overrides;
    Variant variant = name_variant(study, plan.names, choice, changes);
    try {
      variant.loaded = input::read_case_text(base.text, base.file, changes);
    } catch (const InputError& error) {
      for (const Diagnostic& d : error.diagnostics())
        if (known_faults.insert(to_string(d)).second)
          faults.push_back(
              {place.file, place.line, place.column, fmt::format("variant '{}': {}", variant.label, d.sentence)});
      continue;
    }
    const auto [same, is_new] = known_cases.try_emplace(input::write_calculated(variant.loaded.echo), variant.label);
    if (!is_new) {
      plan.summary.notes.push_back(fmt::format("{} is the same case as {}.", variant.label, same->second));
      numbers[variant.label] = numbers[variant.name] = numbers.at(same->second);
      continue;
    }
    const std::string name = variant.name;
    for (int i = 2; !names.insert(variant.name).second; ++i) variant.name = fmt::format("{}_{}", name, i);
    for (std::size_t k = 0; k < study.vary.size(); ++k) {
      const auto key = input::find_key(variant.loaded.echo, study.vary[k].key);
      if (key && !key->unit.empty()) plan.summary.vary[k].unit = key->unit;
      const std::string text = choice[k] ? strip_quotes(study.vary[k].values[*choice[k]]) : "";
      variant.values.push_back(key ? key->text : text);
    }
    variant.changes = std::move(changes);
    variant.input_hash = input::hash_input(variant.loaded.echo, variant.loaded.data);
    numbers[variant.label] = numbers[variant.name] = plan.variants.size();
    plan.variants.push_back(std::move(variant));
  }
  const auto has_curve = [](const Variant& v) {
    const input::Case& data = v.loaded.data;
    return data.analysis == input::AnalysisKind::strength_reduction && data.strength_reduction.curve.enabled;
  };
  if (faults.empty() && !study.factors.empty() && std::none_of(plan.variants.begin(), plan.variants.end(), has_curve)) {
    const input::Place at = base.places.find("study.factors");
    faults.push_back(
        {at.file, at.line, at.column, "'factors' needs a displacement curve, and no variant calculates one"});
  }
  if (const auto found = numbers.find(make_printable(study.reference)); found != numbers.end()) {
    plan.reference = found->second;
  } else if (faults.empty()) {
    const input::Place at = base.places.find("study.reference");
    std::string labels;
    for (const Variant& v : plan.variants) labels += (labels.empty() ? "'" : ", '") + v.label + "'";
    faults.push_back({at.file, at.line, at.column,
                      fmt::format("the study has no variant '{}'; it has {}", study.reference, labels)});
  }
  if (!faults.empty()) throw InputError(faults);
  return plan;
}

}  // namespace talus::study
