// SPDX-License-Identifier: MIT
#include "report/content/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.hpp"
#include "base/user_file.hpp"
#include "input/echo.hpp"
#include "report/content/sequence.hpp"
#include "report/folder/numbers.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Returns a percentage such as "2.4 %", "0.031 %" or "0".
std::string show_share(double share) {
  return share == 0 ? "0" : show_number(100 * share, 2) + " %";
}

}  // namespace

void format_sampling(const results::Sampling& sampling, const ShownUnit& length, std::vector<std::string>& sentences) {
  if (const auto& failure = sampling.failure)
    sentences.push_back(
        fmt::format("The probability of failure is {}, between {} and {} with {:g} % confidence{}.",
                    show_share(failure->share.probability), show_share(failure->share.lower),
                    show_share(failure->share.upper), 100 * failure->confidence,
                    failure->index ? fmt::format("; the reliability index is {:.2f}", *failure->index) : ""));
  if (const auto& factor = sampling.factor)
    sentences.push_back(fmt::format(
        "The factor of safety of {} samples has the mean {:.3f} and the standard deviation {:.3f}; {:.3f} is the "
        "smallest, {:.3f} the largest.",
        factor->count, keep_finite(factor->mean), keep_finite(factor->deviation), keep_finite(factor->smallest),
        keep_finite(factor->largest)));
  if (sampling.runout)
    for (const results::Exceedance& e : sampling.runout->exceedance)
      sentences.push_back(fmt::format("The soil comes farther than {} with a probability of {} ({} to {}).",
                                      show(e.distance, length), show_share(e.share.probability),
                                      show_share(e.share.lower), show_share(e.share.upper)));
  if (const auto& t = sampling.failure_time; t && t->count > 0)
    sentences.push_back(fmt::format("The {} samples that fail do so after {} to {} days, {} in the mean.", t->count,
                                    show_number(t->smallest), show_number(t->largest), show_number(t->mean)));
  if (sampling.tornado && !sampling.tornado->empty()) {
    std::string name = sampling.tornado->front().name;
    std::replace(name.begin(), name.end(), '_', ' ');
    sentences.push_back(fmt::format("The factor depends most on the {}.", name));
  }
  sentences.push_back(fmt::format("{} samples by {}{}{}, seed {}; {} s.", sampling.samples,
                                  sampling.plan == results::SampleDraw::random ? "random drawing" : "Latin hypercube",
                                  sampling.method_title.empty() ? "" : ", ", sampling.method_title, sampling.seed,
                                  show_number(sampling.seconds)));
}

using nlohmann::json;

namespace {

/// Further variants are omitted: their pictures would be too small, and their data would displace those of the others.
constexpr std::size_t most_sources = 12;
/// Number of frames of a variant besides those shown side by side.
constexpr std::size_t most_frames = 13;

struct Choice {
  SequencePlan plan;
  std::vector<double> clock;
  std::vector<std::size_t> pictures;
  std::size_t points = 0;
};

/// Returns the frames from the start of the clock, without the earlier of two at the same time.
std::optional<Choice> choose(const PictureSource& source, std::size_t number) {
  const std::optional<results::Clock>& clock = source.folder.run.clock;
  if (!clock || !source.folder.frames) return std::nullopt;
  const output::ResultsReader& reader = *source.folder.frames;
  std::vector<int> indices;
  std::vector<double> times;
  for (int i = 0; i < reader.size(); ++i) {
    const double time = reader.times()[static_cast<std::size_t>(i)];
    if (!times.empty() && times.back() == time) {
      indices.back() = i;
      continue;
    }
    indices.push_back(i);
    times.push_back(time);
  }
  const std::vector<std::size_t> shown = choose_shown(times, *clock);
  if (shown.empty()) return std::nullopt;
  std::vector<std::size_t> chosen = shown;
  const std::size_t first = shown.front();
  for (const std::size_t i : choose_frames(times.size() - first, most_frames)) chosen.push_back(first + i);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Choice choice;
  choice.plan = {SequenceKind::variant, fmt::format("variant_{}", number), source.title, {}, {}};
  choice.plan.fields = {"displacement",  "deviatoric_strain", "plastic_strain",           "volume",
                        "pore_pressure", "saturation",        "preconsolidation_pressure"};
  for (const std::size_t i : chosen) {
    const double time = times[i] - clock->start;
    if (std::find(shown.begin(), shown.end(), i) != shown.end()) choice.pictures.push_back(choice.clock.size());
    choice.clock.push_back(time);
    choice.plan.frames.push_back({source.folder.frames, indices[i], std::nullopt, fmt::format("t = {:.4g} s", time),
                                  clock->resets && time == 0});
  }
  choice.points = static_cast<std::size_t>(reader.read(indices[first]).point_count());
  return choice.points > 0 ? std::optional(choice) : std::nullopt;
}

}  // namespace

std::vector<Pictures> pack_pictures(const std::vector<PictureSource>& sources, Packer& packer) {
  std::vector<Pictures> pictures(sources.size());
  std::vector<std::optional<Choice>> choices;
  std::vector<std::size_t> needs;
  for (std::size_t k = 0; k < std::min(sources.size(), most_sources); ++k) {
    choices.push_back(choose(sources[k], k));
    needs.push_back(choices[k] ? choices[k]->points * choices[k]->plan.frames.size() : 0);
  }
  if (choices.empty()) return pictures;
  const std::size_t dimension = get_dimension(sources[0].folder.run);
  const std::vector<std::size_t> shares = share_out(needs, find_most_point_frames(dimension));
  for (std::size_t k = 0; k < choices.size(); ++k) {
    if (!choices[k]) continue;
    Budget budget;
    budget.point_frames = shares[k];
    const ShownUnits units = read_units(sources[k].folder.run);
    pictures[k].sequence = JsonTree(pack_sequence(choices[k]->plan, dimension, units, budget, packer));
    pictures[k].frames =
        JsonTree({{"sequence", choices[k]->plan.id}, {"clock", choices[k]->clock}, {"pictures", choices[k]->pictures}});
  }
  return pictures;
}

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Returns a number in full precision; nullopt for a word or an empty cell. "25" may also be the name of a variant.
std::optional<double> read_number(const results::StudyColumn& column, const results::StudyCell& cell) {
  const std::string& text = cell.full;
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = failure == std::errc() && end == text.data() + text.size() && !text.empty();
  return whole && column.name != "variant" ? std::optional(value) : std::nullopt;
}

/// Replaces the symbol, since the page uses F for the factor of safety: "FoS, Spencer" → "F, Spencer".
std::string use_symbol(const std::string& title) {
  constexpr std::string_view written = "FoS";
  return title.starts_with(written) ? "F" + title.substr(written.size()) : title;
}

/// Returns the unit of display of the case for stresses and lengths, otherwise the declared unit of the key.
ShownUnit choose_unit(const std::string& unit, const ShownUnits& units) {
  constexpr double kilo = 1e3;
  if (unit == "kPa") return {units.stress.name, units.stress.si / kilo};
  if (unit == "m") return units.length;
  return {unit, 1};
}

json make_column(const results::StudyColumn& column, const ShownUnits& units) {
  const ShownUnit unit = choose_unit(column.unit, units);
  const bool is_same = unit.name == column.unit;
  json shown = json::array(), values = json::array();
  for (const results::StudyCell& cell : column.cells) {
    const std::optional<double> number = read_number(column, cell);
    shown.push_back(is_same || !number ? cell.shown : fmt::format("{:.5g}", *number / unit.si));
    values.push_back(number ? json(*number / unit.si) : json());
  }
  return {{"name", column.name},
          {"title", use_symbol(column.title)},
          {"unit", unit.name},
          {"shown", shown},
          {"values", values}};
}

/// Returns the `StudyGoal`s of web/src/contract/: targets and values of a back-analysis in the units of the columns.
json make_goals(const results::BackAnalysis& finding, const ShownUnits& units) {
  const double key = choose_unit(finding.unit, units).si;
  json goals = json::array();
  const auto add = [&](const auto& target) {
    const auto convert = [&](const std::optional<double>& value) {
      return value && std::isfinite(*value) ? json(*value / key) : json();
    };
    goals.push_back({{"key", finding.key},
                     {"result", target.column},
                     {"target", keep_finite(target.target) / choose_unit(target.result_unit, units).si},
                     {"value", convert(target.value)},
                     {"low", convert(target.low)},
                     {"high", convert(target.high)}});
  };
  add(finding);
  for (const results::BackAnalysisTarget& further : finding.further) add(further);
  return goals;
}

/// Returns true if the column of one method equals the governing column.
bool is_told_by_method(const results::StudyColumn& governing, const std::vector<results::StudyColumn>& columns) {
  const auto is_same = [](const results::StudyCell& a, const results::StudyCell& b) { return a.full == b.full; };
  return std::any_of(columns.begin(), columns.end(), [&](const results::StudyColumn& c) {
    return c.kind == results::ColumnKind::factor &&
           std::equal(c.cells.begin(), c.cells.end(), governing.cells.begin(), governing.cells.end(), is_same);
  });
}

/// Adds sentences such as "The factor of safety (frozen) lies between 1.39 and 1.45 over 12 variants."
void format_ranges(const std::vector<results::StudyColumn>& columns, std::vector<std::string>& sentences) {
  for (const results::StudyColumn& c : columns) {
    if (c.kind == results::ColumnKind::other) continue;
    if (c.kind == results::ColumnKind::governing && is_told_by_method(c, columns)) continue;
    std::vector<double> values;
    for (const results::StudyCell& cell : c.cells)
      if (const auto value = read_number(c, cell); value && std::isfinite(*value)) values.push_back(*value);
    if (values.empty()) continue;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const std::string unit = c.unit.empty() ? "" : " " + c.unit;
    const std::string title = c.kind == results::ColumnKind::governing ? "The factor of safety that governs"
                              : c.kind == results::ColumnKind::factor  ? fmt::format("The factor of safety ({})", c.by)
                                                                       : "The " + c.title;
    const std::string lowest = show_number(*low, 4) + unit, highest = show_number(*high, 4) + unit;
    if (values.size() == 1)
      sentences.push_back(fmt::format("{} is {} in the one variant that has it.", title, lowest));
    else if (*low == *high)
      sentences.push_back(fmt::format("{} is {} in all {} variants that have it.", title, lowest, values.size()));
    else
      sentences.push_back(
          fmt::format("{} lies between {} and {} over {} variants.", title, lowest, highest, values.size()));
  }
}

/// Returns the factors that vary with the size; those of methods without a mesh do not.
std::vector<results::ExtrapolatedFactor> list_varying(const results::StudyExtrapolation& extrapolation) {
  std::vector<results::ExtrapolatedFactor> varying;
  for (const results::ExtrapolatedFactor& f : extrapolation.factors)
    if (std::adjacent_find(f.factors.begin(), f.factors.end(), std::not_equal_to<>()) != f.factors.end())
      varying.push_back(f);
  return varying;
}

/// Limit for sentences; larger studies are described by the table only.
constexpr std::size_t most_extrapolated = 4;

void format_extrapolation(const results::StudyExtrapolation& extrapolation, std::vector<std::string>& sentences) {
  const std::vector<results::ExtrapolatedFactor> factors = list_varying(extrapolation);
  if (factors.empty() || factors.size() > most_extrapolated) return;
  std::vector<std::string> parts;
  for (const results::ExtrapolatedFactor& f : factors) {
    parts.push_back(fmt::format("{:.3f}{} ({}{})", f.linear,
                                f.standard_error ? fmt::format(" ± {:.3f}", *f.standard_error) : "", f.by,
                                f.variant.empty() ? "" : "; " + f.variant));
  }
  sentences.push_back(
      fmt::format("Extrapolated to {} = 0, the factor of safety is {}.", extrapolation.key, join_words(parts)));
}

/// Limit for sentences; larger studies are described by the table only.
constexpr std::size_t most_motions = 6;

/// Returns the first variant that has a summary, or the head of a study without variants.
ResultFolder take_first(std::vector<std::optional<ResultFolder>>& runs, const results::StudyResult& study) {
  ResultFolder first;
  const auto found = std::find_if(runs.begin(), runs.end(), [](const auto& run) { return run.has_value(); });
  if (found != runs.end()) {
    first = **found;
  } else {
    first.run.project = study.project.value_or(results::Project{});
    first.run.provenance = study.provenance.value_or(results::Provenance{});
    first.run.units = {study.units.length, study.units.displacement, study.units.stress.value_or("kPa")};
    first.run.input = study.input.value_or(JsonTree());
    first.data = input::read_echo(first.run.input);
  }
  if (!study.title.empty()) first.run.title = study.title;
  return first;
}

/// Returns finished if all variants are. A study of LEM samples has no variants; it has finished if its samples are
/// there.
results::Status find_status(const results::StudyResult& study) {
  using results::Status;
  using results::VariantStatus;
  // A run without a result may be part of a search that has ended.
  if (study.back_analysis)
    return study.back_analysis->end == results::BackAnalysisEnd::interrupted ? Status::interrupted : Status::finished;
  const auto has = [&](VariantStatus status) {
    return std::any_of(study.variants.begin(), study.variants.end(), [&](const auto& v) { return v.status == status; });
  };
  const bool finished = study.variants.empty()
                            ? study.sampling.has_value()
                            : std::all_of(study.variants.begin(), study.variants.end(),
                                          [](const auto& v) { return v.status == VariantStatus::finished; });
  return finished                          ? Status::finished
         : has(VariantStatus::interrupted) ? Status::interrupted
         : has(VariantStatus::not_started) ? Status::unfinished
         : has(VariantStatus::unstable)    ? Status::unstable
                                           : Status::failed;
}

/// Returns `StudyRow` of web/src/contract/: what the page shows of the results of a variant.
json make_row(const results::StudyVariant& variant, const std::optional<ResultFolder>& folder,
              std::vector<std::string>& said) {
  const std::vector<std::string> own = folder ? folder->run.warnings : std::vector<std::string>{};
  json row{{"warnings", own}};
  json warnings = json::array();
  if (folder) {
    if (folder->run.curve) row["curve"] = results::to_json(*folder->run.curve);
    if (folder->run.motion) row["motion"] = results::to_json(*folder->run.motion);
    if (json paths = make_paths(*folder, warnings); !paths.is_null()) row["paths"] = std::move(paths);
    if (json sections = make_sections(*folder, warnings); !sections.empty()) row["sections"] = std::move(sections);
  }
  if (!variant.reason.empty()) said.push_back(fmt::format("{}: {}", variant.name, variant.reason));
  for (const std::string& warning : own) said.push_back(fmt::format("{}: {}", variant.name, warning));
  for (const json& w : warnings) said.push_back(w.get<std::string>());
  return row;
}

}  // namespace

StudyContent read_study(const ResultFolder& folder, Packer& packer) {
  const results::StudyResult& study = *folder.study_result;
  StudyContent content;
  json rows = json::array(), columns = json::array();
  std::vector<std::optional<ResultFolder>> runs;
  std::vector<PictureSource> sources;
  std::vector<std::size_t> rows_of_sources;
  std::vector<std::string> motions;
  for (const results::StudyVariant& v : study.variants) {
    const fs::path path = join_name(folder.path, v.folder.empty() ? v.name : v.folder);
    const std::optional<ResultFolder>& run = runs.emplace_back(open_run(path));
    rows.push_back(make_row(v, run, content.warnings));
    if (!run) continue;
    if (run->run.motion) motions.push_back(fmt::format("{}: {}", v.name, run->run.motion->sentence));
    if (run->run.motion || run->run.sections) {
      try {
        sources.push_back({v.name, open_folder(path)});
        runs.back()->frames = sources.back().folder.frames;
        rows_of_sources.push_back(rows.size() - 1);
      } catch (const Error& error) {
        content.warnings.push_back(fmt::format("{}: no pictures: {}", v.name, error.what()));
      }
    }
    if (const auto& timing = run->run.timing) {
      content.wall += timing->wall;
      content.cpu += timing->cpu.value_or(0);
    }
  }
  std::vector<std::string> keys;
  for (const results::StudyKey& k : study.vary) keys.push_back(k.key);
  // The unit of stress is that of the first variant with a summary.
  const auto ran = std::find_if(runs.begin(), runs.end(), [](const auto& run) { return run.has_value(); });
  results::RunResult head;
  head.units = {study.units.length, study.units.displacement,
                study.units.stress.value_or(ran == runs.end() ? "kPa" : (*ran)->run.units.stress)};
  const ShownUnits units = read_units(head);
  for (const results::StudyColumn& c : study.columns) columns.push_back(make_column(c, units));

  std::vector<Pictures> pictures = pack_pictures(sources, packer);
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    if (pictures[k].sequence.is_empty()) continue;
    content.sequences.push_back(pictures[k].sequence);
    rows[rows_of_sources[k]]["frames"] = pictures[k].frames.get();
  }

  content.first = take_first(runs, study);
  content.status = find_status(study);
  std::vector<std::string>& sentences = content.sentences;
  if (study.back_analysis) sentences = study.back_analysis->sentences;
  if (study.sampling) format_sampling(*study.sampling, units.length, sentences);
  if (study.extrapolation) format_extrapolation(*study.extrapolation, sentences);
  format_ranges(study.columns, sentences);
  if (!rows.empty()) {
    const auto finished = std::count_if(study.variants.begin(), study.variants.end(),
                                        [](const auto& v) { return v.status == results::VariantStatus::finished; });
    sentences.push_back(fmt::format(
        "A study of {} variant{} of one case{}; {} finished.", rows.size(), rows.size() == 1 ? "" : "s",
        keys.empty() ? "" : ", which differ in " + join_words(keys),
        finished == static_cast<std::ptrdiff_t>(rows.size()) ? std::string("all") : std::to_string(finished)));
  }
  if (rows.size() <= most_motions) sentences.insert(sentences.end(), motions.begin(), motions.end());
  if (study.sampling && content.wall == 0) content.wall = study.sampling->seconds;
  json table{{"columns", columns}, {"rows", rows}};
  if (study.back_analysis) table["goals"] = make_goals(*study.back_analysis, units);
  content.table = JsonTree(std::move(table));
  return content;
}

}  // namespace talus::report
