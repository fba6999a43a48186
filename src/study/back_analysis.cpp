// SPDX-License-Identifier: MIT
#include "study/back_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "base/folder_lock.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"
#include "input/case/result_names.hpp"
#include "input/case/uncertain_number.hpp"
#include "input/catalogue.hpp"
#include "input/echo.hpp"
#include "results/interval.hpp"
#include "results/named.hpp"
#include "run/common/head.hpp"
#include "study/back_analysis_text.hpp"
#include "study/root_search.hpp"
#include "study/sampled_numbers.hpp"
#include "study/study_table.hpp"

namespace talus::study {

using results::BackAnalysis;
using results::BackAnalysisEnd;
using results::BackAnalysisRun;
using results::BackAnalysisTarget;

namespace {

constexpr const char *factor_word = "factor", *main_factor = "main_factor";
/// The expansion starts with a step of this fraction of the present value.
constexpr double first_step = 0.5;

/// Reads a number in `unit`, or one with another unit. Throws Error (wrong_input).
double read_amount(const std::string& text, const std::string& unit, const std::string& what) {
  double value = 0;
  const char *first = text.data(), *last = first + text.size();
  if (parse_number(first, last, value) == last && std::isfinite(value)) return value;
  return units::parse_as_si(text, unit, what) / (unit.empty() ? 1 : units::get_si_factor(unit));
}

/// Returns result, title, unit and target. Throws Error (wrong_input).
BackAnalysisTarget read_target(const std::string& text, const input::LoadedCase& base) {
  const auto sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
    fail_input("--target is '{}'; write NAME=VALUE, such as --target factor=1.0", text);
  const std::string word = text.substr(0, sign), name = word == factor_word ? main_factor : word;
  const auto result = input::find_result_name(base.data, name);
  if (!result || input::find_point_result_name(name))
    fail_input("--target: the case yields no result '{}'; {}", word, input::suggest_result(base.data, name));
  BackAnalysisTarget target;
  target.result = name, target.title = result->title, target.result_unit = result->unit;
  target.column = find_result_column(name);
  target.target = read_amount(text.substr(sign + 1), result->unit, "--target " + word);
  return target;
}

/// One target with what its search has found.
struct Goal {
  BackAnalysisTarget target;
  RootFinding found;
  std::vector<double> resolutions;        ///< of the results of the runs
  std::map<double, std::string> sources;  ///< of the intervals of the results, by the value of the key
};

input::Override make_override(const std::string& key, double value, const std::string& unit) {
  const std::string number = write_shortest(value);
  return {key, unit.empty() ? number : fmt::format("\"{} {}\"", number, unit)};
}

/// Finds the number at the key. Throws InputError with a suggestion for a key that does not exist.
input::EchoedNumber find_key_number(const std::string& key, const input::LoadedCase& base,
                                    const std::vector<input::Override>& overrides) {
  try {
    return input::find_number(base.echo.get(), key);
  } catch (const Error&) {
    if (input::find_key(base.echo, key)) throw;
    std::vector<input::Override> changes = overrides;
    changes.push_back({key, "1"});
    input::read_case_text(base.text, base.file, changes);  // throws for an unknown key
    throw;
  }
}

/// Counts of a slope, which a design chooses. Other whole numbers are settings of a method: a result that reaches its
/// target by them is an error of the method.
bool is_designed(const std::string& key) {
  return key.starts_with("support.");
}

/// Throws Error (wrong_input) for a range of whole numbers with another end.
void check_whole(const std::string& option, double value, const std::string& key) {
  if (value != std::floor(value)) fail_input("{} is {:g}, and '{}' is a whole number", option, value, key);
}

/// Returns the range of the search and its start. Throws Error (wrong_input).
RootOptions plan_search(const BackAnalysisRequest& request, const input::EchoedNumber& present,
                        const std::optional<input::KeyEntry>& entry, const std::string& unit) {
  RootOptions options;
  options.tolerance = request.tolerance;
  options.start = present.value;
  if (entry && entry->spec.low)
    options.range.low = entry->spec.low->value, options.range.low_open = entry->spec.low->open;
  if (entry && entry->spec.high)
    options.range.high = entry->spec.high->value, options.range.high_open = entry->spec.high->open;
  if (request.from.empty() != request.to.empty())
    fail_input("--from and --to belong together: give both ends of the range of '{}', or neither", request.key);
  if (!request.from.empty()) {
    const double low = read_amount(request.from, unit, "--from"), high = read_amount(request.to, unit, "--to");
    if (!(low < high)) fail_input("--from is {} and --to is {}; --from is the smaller one", request.from, request.to);
    for (const auto& [option, value] : {std::pair{"--from", low}, std::pair{"--to", high}})
      if (!options.range.holds(value))
        fail_input("{} is {}, outside of the range of '{}': {}", option, write_amount(value, unit), request.key,
                   entry->spec.write_range());
      else if (entry && entry->is_whole_number())
        check_whole(option, value, request.key);
    options.range = {low, high, false, false};
    options.is_given = true;
    return options;
  }
  if (!present.value) fail_input("'{}' has no value in the case to start from; give --from and --to", request.key);
  options.step = first_step * std::abs(*present.value);
  if (options.step > 0) return options;
  const auto& usual = entry ? entry->spec.usual_range : std::nullopt;
  if (!usual) fail_input("'{}' is 0, which gives no scale for the search; give --from and --to", request.key);
  options.step = usual->high / 8;
  return options;
}

class KeySearch {
 public:
  KeySearch(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
            const BackAnalysisRequest& request, const StudyOptions& options)
      : base_(base), overrides_(overrides), options_(options) {
    finding_.key = request.key;
    const input::EchoedNumber present = find_key_number(request.key, base, overrides);
    const auto entry = input::find_key_entry(request.key);
    finding_.is_whole = entry && entry->is_whole_number();
    if (finding_.is_whole && !is_designed(request.key))
      fail_input(
          "'{}' is a whole number that sets a method, not the slope: a target that it reaches is an error of the "
          "method; `talus study` varies it",
          request.key);
    finding_.unit = present.unit;
    finding_.present = present.value;
    finding_.tolerance = request.tolerance;
    goals_.push_back({read_target(request.target, base), {}, {}, {}});
    for (const std::string& target : request.further) goals_.push_back({read_target(target, base), {}, {}, {}});
    search_ = plan_search(request, present, entry, present.unit);
    plan_.summary = begin_study(base);
    plan_.summary.mode = "back_analysis";
    plan_.summary.vary.push_back({request.key, present.unit, {}});
    plan_.names.push_back(shorten_path(request.key, {request.key}));
    if (search_.is_given) check_ends();
  }

  BackAnalysisOutcome run() {
    check_folder(base_, plan_, options_,
                 "give another one with -o, replace it with --overwrite, or continue with --resume");
    FolderLock lock(options_.folder);
    lock.take_existing();
    lock.take();
    files_ = open_folder(plan_, options_);
    BackAnalysisOutcome outcome;
    try {
      for (Goal& goal : goals_) search(goal);
      conclude();
    } catch (const Error& error) {
      if (error.code() != ExitCode::interrupted || rows_.empty()) throw;
      gather();
      finding_.end = goals_.front().target.end = BackAnalysisEnd::interrupted;
      finding_.sentences = describe_outcome(finding_, {}, {});
      outcome.failure = Error(ExitCode::interrupted, finding_.sentences.front());
    }
    write_tables();
    if (options_.progress) options_.progress->clear();
    const results::StudyResult study = describe_study(plan_, rows_);
    outcome.tables = write_study_markdown(plan_, rows_, study);
    outcome.finding = finding_;
    for (const Goal& goal : goals_)
      if (const BackAnalysisEnd end = goal.target.end;
          !outcome.failure && end != BackAnalysisEnd::found && end != BackAnalysisEnd::jump)
        outcome.failure = Error(ExitCode::wrong_input, describe(goal).front());
    return outcome;
  }

 private:
  /// Throws InputError if the case does not permit an end of the given range.
  void check_ends() const {
    for (const double x : {search_.range.low, search_.range.high}) make_variant(x);
  }

  Variant make_variant(double x) const {
    Variant variant = name_variant(x);
    variant.changes.push_back({"study", "{}"});
    variant.changes.push_back(make_override(finding_.key, x, finding_.unit));
    variant.loaded = input::read_case_text(base_.text, base_.file, variant.changes);
    variant.input_hash = input::hash_input(variant.loaded.echo, variant.loaded.data);
    return variant;
  }

  Variant name_variant(double x) const {
    const std::string number = write_shortest(x);
    Variant variant;
    variant.name = make_file_name(fmt::format("{}_{}", plan_.names.front(), number), "run");
    variant.label =
        fmt::format("{} = {}{}{}", plan_.names.front(), number, finding_.unit.empty() ? "" : " ", finding_.unit);
    variant.values.push_back(number);
    variant.changes = overrides_;
    return variant;
  }

  /// Searches the value of one target; runs of earlier targets are not repeated.
  void search(Goal& goal) {
    RootOptions options = search_;
    options.target = goal.target.target;
    const auto search = finding_.is_whole ? search_whole_number : search_root;
    goal.found = search(options, [&](double x) { return make_sample(goal, calculate(x)); });
    goal.target.end = goal.found.end;
    goal.target.value = goal.found.x;
    goal.target.low = goal.found.low, goal.target.high = goal.found.high;
    if (goal.found.bracket) goal.target.interval_of = goal.sources[goal.found.bracket->low];
  }

  static Sample make_sample(const Goal& goal, std::size_t row) {
    const BackAnalysisRun& run = goal.target.runs[row];
    return {run.value, run.result, run.lower, run.upper, goal.resolutions[row]};
  }

  /// Returns the number of the run with one value, which is calculated, or read if it is kept. Throws Error for
  /// failures that would recur with any value.
  std::size_t calculate(double x) {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (goals_.front().target.runs[i].value == x) return i;
    throw_if_interrupted();
    StudyRow row;
    try {
      plan_.variants.push_back(make_variant(x));
      row = calculate(plan_.variants.back());
    } catch (const InputError& error) {
      plan_.variants.push_back(name_variant(x));
      row = begin_row(plan_.variants.back());
      row.code = error.code();
      row.summary.status = results::VariantStatus::failed;
      row.summary.reason = error.diagnostics().front().sentence;
    }
    for (Goal& goal : goals_) add_run(x, row, goal);
    const ExitCode code = row.code;
    const std::string reason = row.summary.reason;
    rows_.push_back(std::move(row));
    write_tables();
    if (code == ExitCode::interrupted || code == ExitCode::cannot_write || code == ExitCode::no_memory ||
        code == ExitCode::folder_exists)
      throw Error(code, reason);
    return rows_.size() - 1;
  }

  /// Adds the result of a run to those of a target.
  static void add_run(double x, StudyRow& row, Goal& goal) {
    BackAnalysisRun& run = goal.target.runs.emplace_back();
    double& resolution = goal.resolutions.emplace_back(0);
    run.value = x;
    if (!row.result || row.summary.status != results::VariantStatus::finished) return;
    const std::string& name = goal.target.result;
    run.result = run::find_result(*row.result, name);
    const results::ResultInterval interval = results::find_interval(*row.result, name);
    run.lower = interval.lower, run.upper = interval.upper, resolution = interval.resolution;
    goal.sources[x] = interval.source;
    if (name == main_factor) run.by = results::name_main_method(*row.result);
    if (!run.result && row.summary.reason.empty()) row.summary.reason = "the run has no such result";
  }

  StudyRow calculate(const Variant& variant) {
    if (!options_.overwrite) {
      const auto earlier = load_variant(join_name(options_.folder, variant.name));
      if (earlier && earlier->provenance.input_hash != variant.input_hash)
        fail_input(
            "in '{}' the results of '{}' belong to another input; resume with the same case, or start anew with "
            "--overwrite",
            options_.folder.string(), variant.name);
    }
    StudyRow row = options_.resume ? load_row(variant, options_) : begin_row(variant);
    // A damaged run must not steer the search.
    if (row.kept && row.code != ExitCode::success) throw Error(row.code, row.summary.reason);
    if (row.kept) return row;
    files_->add_folder(variant.name);
    const std::string label = fmt::format("[{}: {}] ", rows_.size() + 1, variant.label);
    if (options_.progress) options_.progress->show(label);
    calculate_row(variant, options_, {options_.threads, options_.progress, label}, row);
    return row;
  }

  /// Returns the finding with one target as its only one.
  BackAnalysis view(const Goal& goal) const {
    BackAnalysis seen = finding_;
    const BackAnalysisTarget& t = goal.target;
    seen.result = t.result, seen.title = t.title, seen.result_unit = t.result_unit, seen.column = t.column;
    seen.target = t.target;
    seen.end = t.end;
    seen.value = t.value;
    seen.low = t.low, seen.high = t.high;
    seen.interval_of = t.interval_of;
    seen.bracket = goal.found.bracket;
    seen.others = goal.found.others;
    seen.runs = t.runs;
    return seen;
  }

  std::vector<std::string> describe(const Goal& goal) const {
    const bool is_first = &goal == &goals_.front();
    return describe_outcome(view(goal), goal.found.largest_reversal,
                            is_first ? list_missing() : std::vector<MissingResult>{});
  }

  /// Takes what was found for all targets, in their order.
  void conclude() {
    gather();
    finding_.sentences.clear();
    for (const Goal& goal : goals_)
      for (std::string& sentence : describe(goal)) finding_.sentences.push_back(std::move(sentence));
  }

  void gather() {
    finding_ = view(goals_.front());
    finding_.further.clear();
    for (std::size_t i = 1; i < goals_.size(); ++i) finding_.further.push_back(goals_[i].target);
  }

  std::vector<MissingResult> list_missing() const {
    std::vector<MissingResult> missing;
    const std::vector<BackAnalysisRun>& runs = goals_.front().target.runs;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!runs[i].result) missing.push_back({runs[i].value, rows_[i].summary.reason});
    return missing;
  }

  void write_tables() {
    gather();
    plan_.summary.back_analysis = finding_;
    write_study_tables(plan_, rows_, options_.folder);
  }

  const input::LoadedCase& base_;
  const std::vector<input::Override>& overrides_;
  const StudyOptions& options_;
  RootOptions search_;
  BackAnalysis finding_;
  std::vector<Goal> goals_;
  StudyPlan plan_;
  std::vector<StudyRow> rows_;
  std::unique_ptr<FileList> files_;
};

}  // namespace

BackAnalysisOutcome search_key(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                               const BackAnalysisRequest& request, const StudyOptions& options) {
  if (!(request.tolerance > 0 && request.tolerance < 1))
    fail_input("--tolerance is {:g}; it is above 0 and below 1, relative to the value of the key", request.tolerance);
  return KeySearch(base, overrides, request, options).run();
}

}  // namespace talus::study
