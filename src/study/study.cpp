// SPDX-License-Identifier: MIT
#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "base/atomic_file.hpp"
#include "base/folder_lock.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/user_file.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"
#include "run/common/run_folder.hpp"
#include "run/forecast/forecast.hpp"
#include "run/run_case.hpp"
#include "study/sampling.hpp"
#include "study/study_table.hpp"

namespace talus::study {

namespace {

namespace fs = std::filesystem;
using results::VariantStatus;

class VariantRuns {
 public:
  VariantRuns(const StudyPlan& plan, const StudyOptions& options,
              const std::function<void(const std::vector<StudyRow>&)>& renew)
      : plan_(plan), options_(options), renew_(renew), rows_(begin_rows(plan)) {}

  std::vector<StudyRow> run() {
    parallel_tasks(static_cast<int>(rows_.size()), options_.threads,
                   [this](int i) { run_one(static_cast<std::size_t>(i)); });
    if (options_.progress) options_.progress->clear();
    return std::move(rows_);
  }

 private:
  void run_one(std::size_t i) {
    if (is_interrupted()) return;
    const Variant& variant = plan_.variants[i];
    StudyRow row = options_.resume ? load_row(variant, options_) : rows_[i];
    if (!row.kept) {
      begin(variant.label);
      calculate_row(variant, options_, {}, row);
    }
    end(i, std::move(row));
  }

  void begin(const std::string& label) {
    const std::lock_guard lock(mutex_);
    running_.push_back(label);
    show();
  }

  void end(std::size_t i, StudyRow row) {
    const std::lock_guard lock(mutex_);
    if (!row.kept) running_.erase(std::find(running_.begin(), running_.end(), plan_.variants[i].label));
    rows_[i] = std::move(row);
    ++done_;
    renew_(rows_);
    show(i);
  }

  /// `ended`: number of a variant that has just ended.
  void show(std::optional<std::size_t> ended = std::nullopt) {
    if (!options_.progress) return;
    ProgressValues values{.method = "study", .done = static_cast<int>(done_), .total = static_cast<int>(rows_.size())};
    if (ended) {
      values.series = plan_.variants[*ended].label;
      if (rows_[*ended].result) values.factor = results::find_main_factor(*rows_[*ended].result);
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    std::string line =
        fmt::format("{} of {} variants done after {}", done_, rows_.size(), format_duration(passed.count()));
    for (std::size_t i = 0; i < running_.size(); ++i) line += (i == 0 ? "; now " : " | ") + running_[i];
    options_.progress->show(line, std::move(values));
  }

  const StudyPlan& plan_;
  const StudyOptions& options_;
  const std::function<void(const std::vector<StudyRow>&)>& renew_;
  std::vector<StudyRow> rows_;
  std::mutex mutex_;
  std::vector<std::string> running_;
  std::size_t done_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Returns true for paths, relative to the folder of the study, that the study or one of its runs writes.
bool is_of_study(const StudyPlan& plan, const fs::path& file) {
  const std::string first = file.begin()->string(), name = file.filename().string();
  for (const char* own : {"jobs.json", "surfaces.json", "jobs.slurm", "study.json", "study.csv", "study.md",
                          "study.svg", "study.gp", "samples.csv", "report.html"})
    if (first == own) return true;
  const fs::path end = file.extension();
  if (first.starts_with("displacement_") && (end == ".svg" || end == ".gp")) return true;  // of a monitor
  if (first == "jobs") return first == name || name == "result.json";
  if (first == "case") return first == name || name == "case.toml";
  const auto variant =
      std::find_if(plan.variants.begin(), plan.variants.end(), [&](const Variant& v) { return v.name == first; });
  if (variant == plan.variants.end()) return false;
  // A list other than that of the study belongs to a run of the user in that folder.
  return first == name || name == list_file || run::is_of_run(variant->loaded.data, file.lexically_relative(first));
}

/// Severity of an exit code; a larger number is more serious.
int rank(ExitCode code) {
  switch (code) {
    case ExitCode::interrupted:
      return 4;
    case ExitCode::cannot_write:
      return 3;
    case ExitCode::internal_error:
      return 2;
    case ExitCode::success:
      return 0;
    default:
      return 1;
  }
}

}  // namespace

void check_folder(const input::LoadedCase& base, const StudyPlan& plan, const StudyOptions& options,
                  const std::string& ways) {
  use_folder(options.folder, [&] {
    if (!fs::exists(options.folder)) return;
    const std::string folder = options.folder.string();
    if (!fs::is_directory(options.folder))
      throw Error(ExitCode::folder_exists, "'{}' is a file; a study needs a folder", folder);
    if (options.overwrite)
      return run::check_replaced(base, options.folder, [&](const fs::path& file) { return is_of_study(plan, file); });
    if (holds_nothing(options.folder)) return;
    if (options.resume) return run::require_list(options.folder);
    throw Error(ExitCode::folder_exists, "the folder '{}' is not empty; {}", folder, ways);
  });
}

std::unique_ptr<FileList> open_folder(const StudyPlan& plan, const StudyOptions& options) {
  if (options.overwrite)
    run::replace_folder(
        options.folder, [&](const fs::path& file) { return is_of_study(plan, file); }, options.progress);
  auto files = std::make_unique<FileList>(options.folder);
  for (const Variant& v : plan.variants) {
    files->add_folder(v.name);
    const fs::path folder = join_name(options.folder, v.name);
    if (!options.overwrite || !fs::is_directory(folder)) continue;
    if (has_list(folder))
      throw Error(ExitCode::folder_exists,
                  "'{}' holds results that this study did not write; move them away, or give another folder",
                  folder.string());
    FileList{folder};  // the folder holds files of the user: they are left alone, and files of the run are listed
  }
  return files;
}

std::optional<results::RunResult> load_variant(const fs::path& folder) try {
  return results::read_file<results::RunResult>(folder / "summary.json");
} catch (const Error&) {
  return std::nullopt;
}

void check_row(const fs::path& folder, StudyRow& row) try {
  if (!row.result)
    fail_input("'{}' is missing or of another run: put it back, or repeat the job", (folder / "summary.json").string());
  run::require_list(folder);
  run::check_kept(folder);
  row.summary.status = VariantStatus::finished;
} catch (const Error& error) {
  row.code = error.code();
  row.summary.reason = error.what();
  row.summary.status = VariantStatus::failed;
}

StudyRow begin_row(const Variant& variant) {
  StudyRow row;
  row.summary.name = variant.label;
  row.summary.folder = variant.name;
  return row;
}

StudyRow load_row(const Variant& variant, const StudyOptions& options) {
  const fs::path folder = join_name(options.folder, variant.name);
  StudyRow row = begin_row(variant);
  row.result = load_variant(folder);
  row.kept = row.result && row.result->status == results::Status::finished;
  if (row.kept) check_row(folder, row);
  return row;
}

void calculate_row(const Variant& variant, const StudyOptions& options, const RowRun& how, StudyRow& row) {
  run::RunOptions run;
  run.folder = join_name(options.folder, variant.name);
  run.resume = options.resume;
  run.overwrite = options.overwrite;
  run.threads = how.threads;
  run.progress = how.progress;
  run.label = how.label;
  try {
    row.result = run::run_case(variant.loaded, run);
    row.summary.status = VariantStatus::finished;
    return;
  } catch (...) {  // not even a program error in one variant may lose the results of the others
    const Failure failure = explain_failure(std::current_exception());
    row.code = failure.code;
    row.summary.reason = failure.sentence;
    row.summary.status = row.code == ExitCode::unstable      ? VariantStatus::unstable
                         : row.code == ExitCode::interrupted ? VariantStatus::interrupted
                                                             : VariantStatus::failed;
  }
  row.result = load_variant(run.folder);
  if (row.result && row.result->provenance.input_hash != variant.input_hash) row.result.reset();
}

void check_variants(const StudyPlan& plan, const StudyOptions& options) {
  if (options.overwrite) return;
  std::string changed;
  for (const Variant& v : plan.variants) {
    const auto result = load_variant(join_name(options.folder, v.name));
    if (result && result->provenance.input_hash != v.input_hash)
      changed += (changed.empty() ? "'" : ", '") + v.name + "'";
  }
  if (!changed.empty())
    fail_input(
        "in '{}' the results of {} belong to another input; resume with the same case, or start anew with --overwrite",
        options.folder.string(), changed);
}

std::vector<StudyRow> begin_rows(const StudyPlan& plan) {
  std::vector<StudyRow> rows;
  for (const Variant& variant : plan.variants) rows.push_back(begin_row(variant));
  return rows;
}

std::vector<StudyRow> run_variants(const StudyPlan& plan, const StudyOptions& options,
                                   const std::function<void(const std::vector<StudyRow>&)>& renew) {
  return VariantRuns(plan, options, renew).run();
}

std::vector<StudyRow> run_study(const StudyPlan& plan, const StudyOptions& options) {
  check_folder(plan.variants.front().loaded, plan, options,
               "give another one with -o, replace it with --overwrite, or continue with --resume");
  FolderLock lock(options.folder);
  lock.take_existing();
  check_variants(plan, options);
  lock.take();
  const auto files = open_folder(plan, options);
  const auto renew = [&](const std::vector<StudyRow>& rows) { write_study_tables(plan, rows, options.folder); };
  std::vector<StudyRow> rows = run_variants(plan, options, renew);
  write_study(plan, rows, options.folder);
  return rows;
}

std::optional<Error> find_failure(const std::vector<StudyRow>& rows) {
  ExitCode code = ExitCode::success;
  std::string reasons;
  std::size_t finished = 0;
  for (const StudyRow& row : rows) {
    if (row.summary.status == VariantStatus::finished) {
      ++finished;
      continue;
    }
    // A variant that was not started has no error of its own: only an interruption prevents the start.
    const ExitCode own = row.summary.status == VariantStatus::not_started ? ExitCode::interrupted : row.code;
    if (rank(own) > rank(code)) code = own;
    if (own != ExitCode::interrupted) reasons += fmt::format("\n  {}: {}", row.summary.folder, row.summary.reason);
  }
  if (finished == rows.size()) return std::nullopt;
  const std::string what =
      code == ExitCode::interrupted
          ? fmt::format("interrupted with {} of {} variants finished; --resume continues with the others", finished,
                        rows.size())
          : fmt::format("{} of {} variants did not finish", rows.size() - finished, rows.size());
  return Error(code, what + (reasons.empty() ? "" : ":") + reasons);
}

namespace {

/// Largest number of variants in a forecast, evenly distributed among all, because MPM is timed for each.
constexpr std::size_t most_forecasts = 6;
/// Searches before LEM samples: at the means, and for first-order estimate and design point.
constexpr double searches = 4;

std::string count(double n, const char* one, const char* many) {
  return fmt::format("{:.0f} {}", n, n == 1 ? one : many);
}

double find_seconds(const input::Case& data) {
  double seconds = 0;
  for (const run::MethodForecast& f : run::forecast(data, true)) seconds += f.seconds;
  return seconds;
}

/// Returns ", about 10 minutes"; empty for an unknown time.
std::string add_time(double seconds) {
  return seconds > 0 ? ", about " + run::write_time(seconds) : "";
}

std::string describe_samples(const input::LoadedCase& base) {
  const input::Sampling& sampling = base.data.study.sampling;
  const double samples = sampling.samples;
  const double seconds = is_by_slices(base)
                             ? searches * find_seconds(base.data) + samples * run::find_sample_seconds(base.data.lem)
                             : (samples + 1) * find_seconds(base.data);
  return fmt::format("  a study draws {} of {}{}\n", count(samples, "sample", "samples"),
                     count(static_cast<double>(sampling.numbers.size()), "uncertain number", "uncertain numbers"),
                     add_time(seconds));
}

}  // namespace

StudyOutcome calculate_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                             const StudyOptions& options) {
  if (base.data.study.mode == input::StudyMode::sample) {
    SamplingResult result = run_sampling(base, overrides, options);
    return {std::move(result.markdown), std::move(result.failure)};
  }
  const StudyPlan plan = plan_study(base, overrides);
  const std::vector<StudyRow> rows = run_study(plan, options);
  return {write_study_markdown(plan, rows, describe_study(plan, rows)), find_failure(rows)};
}

std::string forecast_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides) {
  const input::Study& study = base.data.study;
  if (study.mode == input::StudyMode::sample) return describe_samples(base);
  if (study.vary.empty()) return "";
  const StudyPlan plan = plan_study(base, overrides);
  const std::size_t runs = plan.variants.size(), forecasts = std::min(runs, most_forecasts);
  double seconds = 0;
  for (std::size_t i = 0; i < forecasts; ++i) seconds += find_seconds(plan.variants[i * runs / forecasts].loaded.data);
  seconds *= static_cast<double>(runs) / static_cast<double>(forecasts);
  return fmt::format("  a study varies {}: {}{}\n", count(static_cast<double>(study.vary.size()), "key", "keys"),
                     count(static_cast<double>(runs), "run", "runs"), add_time(seconds));
}

}  // namespace talus::study
