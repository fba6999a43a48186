// SPDX-License-Identifier: MIT
#include "study/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "input/case/uncertain_number.hpp"
#include "input/echo.hpp"
#include "results/json.hpp"
#include "run/bounds/referee.hpp"
#include "run/common/head.hpp"
#include "run/run_case.hpp"
#include "study/distributions.hpp"
#include "study/sampling_table.hpp"
#include "study/slice_factor.hpp"
#include "study/study_table.hpp"

namespace talus::study {

namespace {

/// From `enough_samples` on the samples consist of this number of independent hypercubes, whose scatter gives the
/// standard error.
constexpr int hypercubes = 10, enough_samples = 1000;

}  // namespace

std::vector<double> SampleSet::get_sample(std::size_t i) const {
  std::vector<double> sample;
  for (const auto& column : values) sample.push_back(column[i]);
  return sample;
}

SampleSet draw_samples(const input::LoadedCase& base) {
  const input::Sampling& sampling = base.data.study.sampling;
  SampleSet set;
  set.sampled = read_sampled_numbers(base);
  const bool is_latin = sampling.plan == input::SamplePlan::latin_hypercube;
  const int replicates = is_latin && sampling.samples >= enough_samples ? hypercubes : 1;
  set.plan = {sampling.samples,       static_cast<int>(set.sampled.numbers.size()), sampling.seed, is_latin, replicates,
              set.sampled.correlation};
  set.scores = draw_scores(set.plan);
  for (std::size_t j = 0; j < set.scores.size(); ++j) {
    std::vector<double>& values = set.values.emplace_back();
    for (const double z : set.scores[j]) values.push_back(set.sampled.marginals[j].find_value(z));
    const results::SampledValues found = find_moments(values);
    set.sampled.numbers[j].sampled = {found.mean, found.deviation, found.smallest, found.largest};
  }
  set.summary.samples = sampling.samples;
  set.summary.seed = sampling.seed;
  set.summary.plan = is_latin ? results::SampleDraw::latin_hypercube : results::SampleDraw::random;
  set.summary.replicates = replicates;
  set.summary.method = input::find_method(sampling.method);
  set.summary.numbers = set.sampled.numbers;
  set.summary.notes = set.sampled.notes;
  return set;
}

Error refuse_sample(const std::string& label, const InputError& error) {
  return {ExitCode::wrong_input,
          fmt::format("{} is no possible case: {}; cut or correlate the distributions so that it cannot come up", label,
                      error.diagnostics().front().sentence)};
}

bool is_by_slices(const input::LoadedCase& base) {
  return input::find_method(base.data.study.sampling.method) == Method::lem && !base.data.timeline;
}

results::StudyResult begin_sampling(const input::LoadedCase& base, int threads) {
  results::StudyResult study = begin_study(base);
  study.units.stress = base.data.output.stress_unit;
  study.project = run::make_project(base.data);
  study.provenance = run::make_provenance(base, input::hash_input(base.echo, base.data), threads);
  study.input = base.echo;
  return study;
}

void write_sampling(const input::LoadedCase& base, const std::filesystem::path& folder, SampleSet& set,
                    SamplingResult& result) {
  make_samples_result(base.data.study.sampling, set);
  result.study.sampling = set.summary;
  write_atomically(folder / "samples.csv", write_samples(set));
  results::write_file(folder / "study.json", result.study);
  result.markdown = write_sampling_markdown(base.data.title, set.summary, base.data.units().length);
  write_atomically(folder / "study.md", make_printable(result.markdown, true));
}

SamplingResult run_sampling(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                            const StudyOptions& options) {
  SampleSet set = draw_samples(base);
  check_folder(base, {}, options, "give another one with -o, or replace it with --overwrite");
  FolderLock lock(options.folder);
  std::unique_ptr<FileList> files;
  SamplingResult result;
  if (is_by_slices(base)) {
    lock.take_existing();
    result.study = begin_sampling(base, options.threads);
    calculate_slices(base, overrides, options, set);
    lock.take();
    files = open_folder({}, options);
  } else {
    const auto start = std::chrono::steady_clock::now();
    const StudyPlan plan = plan_samples(base, overrides, set);
    const std::vector<StudyRow> rows = run_study(plan, options);  // run_study() takes the lock itself
    result.failure = find_failure(rows);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    result.study = make_runs_result(base, plan, rows, passed.count(), set);
    lock.take();
    files = std::make_unique<FileList>(options.folder);
  }
  write_sampling(base, options.folder, set, result);
  return result;
}

// The following functions sample by runs of the case: FEM, MPM with its runout, or LEM in time.

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Returns the first of `names` under which a run has a result.
std::string find_name(const std::vector<StudyRow>& rows, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    for (const StudyRow& row : rows)
      if (row.result && run::find_result(*row.result, name)) return name;
  return "";
}

/// Names of the factor by a method, in order of preference.
std::vector<std::string> list_factors(Method method) {
  if (method == Method::lem) return {"timeline.least"};
  if (method == Method::fem) return {"fem.factor", "fem.associated.factor"};
  return {"factor_of_safety.frozen", "factor_of_safety.bilinear", "factor_of_safety.displacement"};
}

/// Returns the result `name` of every sample; the first row is the case at the means.
std::vector<double> take(const std::vector<StudyRow>& rows, const std::string& name) {
  std::vector<double> values;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool ended = rows[i].summary.status == results::VariantStatus::finished && rows[i].result;
    values.push_back(ended ? run::find_result(*rows[i].result, name).value_or(none) : none);
  }
  return values;
}

/// Returns the time at which the factor of each sample first falls below the target [s].
std::vector<double> take_failure_times(const std::vector<StudyRow>& rows) {
  std::vector<double> times;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    times.push_back(none);
    if (rows[i].summary.status != results::VariantStatus::finished || !rows[i].result || !rows[i].result->timeline)
      continue;
    const results::Timeline& timeline = *rows[i].result->timeline;
    if (timeline.fails_from_start) times.back() = 0;
    if (timeline.failure) times.back() = timeline.failure->to;
  }
  return times;
}

}  // namespace

StudyPlan plan_samples(const input::LoadedCase& base, const std::vector<input::Override>& given, const SampleSet& set) {
  std::vector<input::Override> overrides = given;
  overrides.push_back({"analysis.methods", fmt::format(R"(["{}"])", results::to_word(set.summary.method))});
  // The scatter of the samples exceeds the mesh effect, and a second mesh would be run for each of them.
  if (set.summary.method == Method::mpm) overrides.push_back({"output.runout_meshes", "1"});
  StudyPlan plan;
  plan.summary = begin_study(base);
  for (const results::UncertainNumber& n : set.sampled.numbers) {
    plan.summary.vary.push_back({n.key, n.unit, {}});
    plan.names.push_back(n.name);
  }
  const std::size_t digits = std::to_string(set.size()).size();
  const auto add = [&](const std::string& name, const std::string& label, const std::vector<double>& values) {
    Variant variant;
    variant.name = name;
    variant.label = label;
    for (const double value : values) variant.values.push_back(fmt::format("{:.6g}", value));
    try {
      variant.changes = set_values(overrides, set.sampled, values);
      variant.loaded = input::read_case_text(base.text, base.file, variant.changes);
    } catch (const InputError& error) {
      throw refuse_sample(label, error);
    }
    variant.input_hash = input::hash_input(variant.loaded.echo, variant.loaded.data);
    plan.variants.push_back(std::move(variant));
  };
  add("means", "at the means", set.sampled.means);
  for (std::size_t i = 0; i < set.size(); ++i)
    add(fmt::format("sample_{:0{}}", i + 1, digits), fmt::format("sample {}", i + 1), set.get_sample(i));
  return plan;
}

results::StudyResult make_runs_result(const input::LoadedCase& base, const StudyPlan& plan,
                                      const std::vector<StudyRow>& rows, double seconds, SampleSet& set) {
  const Method method = set.summary.method;
  const std::string factor = find_name(rows, list_factors(method));
  if (!factor.empty()) set.factor = take(rows, factor);
  if (method == Method::lem) set.failure_time = take_failure_times(rows);
  if (method == Method::mpm) {
    std::vector<std::string> names{"runout.toe_distance"};
    for (const double f : base.data.strength_reduction.curve.runout)
      names.push_back(fmt::format("runout[{:g}].toe_distance", f));
    if (const std::string name = find_name(rows, names); !name.empty()) {
      set.runout = take(rows, name);
      set.summary.runout.emplace().name = name;
    }
  }
  set.summary.method_title = method == Method::fem   ? "FEM"
                             : method == Method::lem ? "LEM, the least factor in time"
                                                     : "MPM";
  set.summary.method_title += ", a run for every sample" + (factor.empty() ? "" : ", " + factor);
  if (set.factor.empty() && set.runout.empty())
    set.summary.notes.push_back("No run has come to a factor of safety or a runout.");
  set.summary.seconds = seconds;
  return describe_study(plan, rows);
}

// The following functions sample by LEM.

namespace {

/// Samples per task of a thread.
constexpr std::size_t piece = 25;
/// Samples that are also searched individually: drawn at random, and nearest to failure.
constexpr std::size_t random_checks = 20, critical_checks = 12;
/// Random stream for the choice among the samples; those of the numbers count from 0.
constexpr std::uint64_t check_stream = ~0ULL;
/// Largest relative excess of a factor on the stored surfaces; above it the surfaces of the searches are added, at
/// most `most_rounds` times.
constexpr double good_enough = 0.003, worth_keeping = 1e-4;
constexpr int most_rounds = 2;

/// Returns the factor of sample i; NaN if there is none.
double find_one(const SliceFactor& slices, const SampleSet& set, std::size_t i, SliceFactor::Workspace& work) {
  try {
    return slices.find(set.get_sample(i), work).value_or(std::numeric_limits<double>::quiet_NaN());
  } catch (const InputError& error) {
    throw refuse_sample(fmt::format("sample {}", i + 1), error);
  }
}

class SliceSampling {
 public:
  SliceSampling(SliceFactor& slices, const StudyOptions& options, SampleSet& set)
      : slices_(slices), options_(options), set_(set) {}

  void calculate() { set_.factor = find_factors(slices_, set_, 0, set_.size(), options_); }

  /// Searches some samples individually. If a search finds a lower factor, its surfaces are added and all samples are
  /// computed again.
  void check() {
    for (int round = 0;; ++round) {
      const std::vector<std::size_t> chosen = choose(round);
      if (chosen.empty()) return;
      std::vector<std::optional<SliceFactor::Searched>> searched(chosen.size());
      parallel_tasks(static_cast<int>(chosen.size()), options_.threads, [&](int k) {
        const auto at = static_cast<std::size_t>(k);
        if (!is_interrupted()) searched[at] = slices_.search(set_.get_sample(chosen[at]));
      });
      if (is_interrupted()) throw Error(ExitCode::interrupted, "interrupted while samples were searched");
      results::SurfaceCheck check;
      std::vector<lem::Surface> better;
      double sum = 0;
      for (std::size_t k = 0; k < chosen.size(); ++k) {
        if (!searched[k]) continue;
        const double excess = set_.factor[chosen[k]] / searched[k]->factor - 1;
        check.largest = check.samples == 0 ? excess : std::max(check.largest, excess);
        sum += excess;
        ++check.samples;
        if (excess > worth_keeping)
          better.insert(better.end(), searched[k]->surfaces.begin(), searched[k]->surfaces.end());
      }
      if (check.samples > 0) check.mean = sum / check.samples;
      set_.summary.check = check;
      if (check.largest <= good_enough || round == most_rounds) return;
      slices_.add(better);
      calculate();
    }
  }

 private:
  std::vector<std::size_t> choose(int round) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < set_.size(); ++i)
      if (std::isfinite(set_.factor[i])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(set_.factor[a] - 1) < std::abs(set_.factor[b] - 1);
    });
    // The samples nearest to failure come first; the others are drawn from the rest. A further round takes other
    // samples, as the factors of those searched are exact.
    RandomStream random(set_.summary.seed, check_stream - static_cast<std::uint64_t>(round));
    const std::size_t skipped = std::min(order.size(), critical_checks * static_cast<std::size_t>(round));
    order.erase(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(skipped));
    const std::size_t count = std::min(order.size(), critical_checks + random_checks);
    for (std::size_t k = critical_checks; k < count; ++k)
      std::swap(order[k], order[k + random.draw_below(order.size() - k)]);
    order.resize(count);
    return order;
  }

  SliceFactor& slices_;
  const StudyOptions& options_;
  SampleSet& set_;
};

/// Describes the interval of limit analysis for these values, and the factor of the samples there.
std::string describe_referee(const char* where, const results::Referee& referee, double factor) {
  if (referee.why_not || !referee.is_interval())
    return fmt::format("Limit analysis cannot judge the factor {}: {}.", where,
                       referee.why_not.value_or(referee.no_lower.empty() ? referee.no_upper : referee.no_lower));
  const results::Verdict verdict = referee.judge(factor);
  return fmt::format(
      "Limit analysis proves that the factor {} lies between {:.3f} and {:.3f}; the samples have {:.3f}{}.", where,
      results::show_lower(*referee.lower), results::show_upper(*referee.upper), factor,
      verdict == results::Verdict::too_low    ? ", which is too low: the probability of failure is too high"
      : verdict == results::Verdict::too_high ? ", which is too high: the probability of failure is too low"
                                              : "");
}

/// Compares the factors at the means and at the design point with limit analysis, but not that of every sample.
void note_referee(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                  const StudyOptions& options, const SliceFactor& slices, SampleSet& set) {
  if (!base.data.lem.referee) return;
  run::RunOptions quiet;
  quiet.threads = options.threads;
  SliceFactor::Workspace work;
  const auto judge = [&](const char* where, const std::vector<double>& values) {
    const std::optional<double> factor = slices.find(values, work);
    if (!factor) return;
    const input::LoadedCase sample = read_sample(base, overrides, set.sampled, values);
    set.summary.notes.push_back(
        describe_referee(where, run::search_referee_interval(sample.data, factor, quiet), *factor));
  };
  judge("at the means", set.sampled.means);
  if (!set.summary.design_point) return;
  std::vector<double> values;
  for (const results::DesignPointValue& v : set.summary.design_point->values) values.push_back(v.value);
  judge("at the design point", values);
}

}  // namespace

std::vector<double> find_factors(const SliceFactor& slices, const SampleSet& set, std::size_t first, std::size_t end,
                                 const StudyOptions& options) {
  const std::size_t count = end - first;
  std::vector<double> factors(count, std::numeric_limits<double>::quiet_NaN());
  std::atomic<std::size_t> done = 0;
  const auto pieces = static_cast<int>((count + piece - 1) / piece);
  parallel_tasks(pieces, options.threads, [&](int p) {
    const std::size_t begin = static_cast<std::size_t>(p) * piece, last = std::min(begin + piece, count);
    SliceFactor::Workspace work;
    for (std::size_t i = begin; i < last && !is_interrupted(); ++i) factors[i] = find_one(slices, set, first + i, work);
    done += last - begin;
    if (options.progress != nullptr && options.progress->is_due())
      options.progress->show(fmt::format("{} of {} samples calculated", done.load(), count),
                             {.method = "study",
                              .series = "samples",
                              .done = static_cast<int>(done.load()),
                              .total = static_cast<int>(count)});
  });
  if (options.progress != nullptr) options.progress->clear();
  if (is_interrupted()) throw Error(ExitCode::interrupted, "interrupted while the samples were calculated");
  return factors;
}

std::unique_ptr<SliceFactor> begin_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                                          const StudyOptions& options, SampleSet& set) {
  if (options.progress != nullptr) options.progress->show("searching for the critical surfaces");
  auto slices = std::make_unique<SliceFactor>(base, overrides, set.sampled, options.threads);
  results::Sampling& result = set.summary;
  SliceFactor::Workspace work;
  const FactorOf factor = [&](const std::vector<double>& values) { return slices->find(values, work); };
  estimate_first_order(set.sampled, factor, result);
  // With a search for every sample the iteration would take too long.
  if (!slices->is_full()) result.design_point = find_design_point(set.sampled, factor);
  if (result.design_point) {
    // The surface that fails first need not be critical at the means, so a search is made at the design point.
    std::vector<double> values;
    for (const results::DesignPointValue& v : result.design_point->values) values.push_back(v.value);
    if (const auto searched = slices->search(values)) slices->add(searched->surfaces);
    result.design_point = find_design_point(set.sampled, factor);
  }
  return slices;
}

void calculate_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                      const StudyOptions& options, SampleSet& set, const KnownFactors* known) {
  const auto start = std::chrono::steady_clock::now();
  const std::unique_ptr<SliceFactor> found = begin_slices(base, overrides, options, set);
  SliceFactor& slices = *found;
  results::Sampling& result = set.summary;
  SliceSampling sampling(slices, options, set);
  if (known != nullptr)
    set.factor = known->factors;
  else
    sampling.calculate();
  if (!set.factor.empty() &&
      std::none_of(set.factor.begin(), set.factor.end(), [](double f) { return std::isfinite(f); }))
    fail_input("no sample of [study] has a factor of safety; `talus run` shows why the means have one or none");
  const bool is_checked = !slices.is_full() && base.data.lem.search != input::SurfaceSearch::none;
  if (is_checked) sampling.check();
  result.surfaces = slices.count_surfaces();
  const std::string title = get_title(slices.method());
  result.method_title = slices.is_full() ? fmt::format("{}, a search for every sample", title)
                                         : fmt::format("{} on {} surfaces", title, result.surfaces);
  for (const std::string& note : slices.numbers().notes()) result.notes.push_back(note);
  if (!slices.numbers().idle_keys().empty())
    result.notes.push_back(
        fmt::format("LEM does not use {}: it has no effect here.", fmt::join(slices.numbers().idle_keys(), ", ")));
  if (slices.is_full()) {
    result.notes.push_back(fmt::format(
        "{} changes the geometry, the water or a strength law, so the critical surface was searched anew for every "
        "sample.",
        fmt::join(slices.numbers().section_keys(), ", ")));
  } else if (is_checked) {
    if (result.check)
      result.notes.push_back(
          fmt::format("Every sample was evaluated on {} surfaces from searches at the means, at {} other combinations "
                      "of values and near failure. Searches for {} samples themselves gave factors lower by {:.2f} % "
                      "at most, {:.2f} % on average.",
                      result.surfaces, slices.count_corners(), result.check->samples,
                      100 * std::max(0.0, result.check->largest), 100 * result.check->mean));
  } else {
    result.notes.push_back("Only the surfaces that the case gives were evaluated.");
  }
  if (!result.first_order)
    result.notes.push_back(
        "Within one deviation of the means some values have no factor: there is no first-order estimate and no "
        "tornado.");
  if (result.design_point && !result.design_point->converged)
    result.notes.push_back(
        "The search for the most probable failure did not converge: its index is only an indication.");
  note_referee(base, overrides, options, slices, set);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (known != nullptr) result.seconds += known->seconds;
}

}  // namespace talus::study
