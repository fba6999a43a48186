// SPDX-License-Identifier: MIT
// A study in jobs is bitwise identical to the study in one process, also with failed or repeated jobs; errors of the
// user are reported before any file is written.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cases/sampling_slope.hpp"
#include "input/read.hpp"
#include "results/json.hpp"
#include "study/jobs.hpp"
#include "study_slope.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string slice_samples =
    sampling_slope::write_case("[study]\nmode = \"sample\"\nsamples = 60\n" + sampling_slope::deviations);

/// The same run by FEM, three times.
const std::string element_samples = slice_samples + R"(
[fem]
size = 2.5
resolution = 0.05
)";
const std::vector<input::Override> by_elements{{"study.samples", "3"},
                                               {"study.method", "fem"},
                                               {"analysis.methods", R"(["fem"])"},
                                               {"materials.soil.young_modulus", "\"20 MPa\""},
                                               {"materials.soil.poisson_ratio", "0.3"},
                                               {"materials.soil.dilatancy_angle", "0"},
                                               {"materials.soil.tensile_strength", "0"},
                                               {"materials.soil.pore_pressure_ratio", "0"}};

input::LoadedCase read(const std::string& text, const std::vector<input::Override>& changes = {}) {
  return input::read_case_text(text, "slope.toml", changes);
}

void prepare(const std::string& text, const fs::path& folder, int jobs,
             const std::vector<input::Override>& changes = {}, bool resume = false) {
  prepare_jobs(read(text, changes), changes, {write_to(folder, resume), jobs});
}

/// study.json without what differs from one calculation to the next: times, and the machine's clock.
json read_timeless(const fs::path& folder) {
  json study = results::to_json(*results::read_file<results::StudyResult>(folder / "study.json"));
  if (study.contains("sampling")) study["sampling"].erase("seconds");
  if (study.contains("provenance")) study["provenance"].erase("started");
  std::erase_if(study["columns"].get_ref<json::array_t&>(),
                [](const json& column) { return column.at("name") == "wall time"; });
  return study;
}

struct ProgramEnd {
  int code = -1;
  std::string text;  ///< both output streams
};

ProgramEnd run_study_program(const std::string& arguments) {
  ProgramEnd outcome;
  FILE* pipe = popen(("'" TALUS_PROGRAM "' study " + arguments + " 2>&1").c_str(), "r");
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) outcome.text.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
  return outcome;
}

std::string catch_message(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(StudyJobs, SamplesByLemAreBitwiseIdenticalToOneProcess) {
  const fs::path folder = make_test_folder();
  calculate_study(read(slice_samples), {}, write_to(folder / "one"));
  prepare(slice_samples, folder / "jobs", 7);
  for (const int job : {3, 6, 0, 3, 5, 1, 4, 2, 0}) EXPECT_FALSE(calculate_job(folder / "jobs", job, 1, nullptr));
  const StudyOutcome outcome = collect_jobs(write_to(folder / "jobs"));
  EXPECT_FALSE(outcome.failure);
  EXPECT_EQ(read_text(folder / "jobs/samples.csv"), read_text(folder / "one/samples.csv"));
  EXPECT_EQ(read_timeless(folder / "jobs"), read_timeless(folder / "one"));
  EXPECT_GT(read_timeless(folder / "jobs")["sampling"]["surfaces"].get<int>(), 20);
}

/// A key of the section: there are no surfaces to keep, every sample is searched for itself.
TEST(StudyJobs, SearchedSamplesAreBitwiseIdenticalToOneProcess) {
  const std::string text = sampling_slope::write_case(R"(
[study]
mode = "sample"
samples = 4
[[study.random]]
key = "lem.tension_crack.depth"
distribution = "uniform"
lowest = "0.5 m"
highest = "3 m"
)");
  const std::vector<input::Override> coarse{{"lem.entry_exit.exits", "7"}, {"lem.entry_exit.entries", "7"}};
  const fs::path folder = make_test_folder();
  calculate_study(read(text, coarse), coarse, write_to(folder / "one"));
  prepare(text, folder / "jobs", 2, coarse);
  for (const int job : {1, 0}) EXPECT_FALSE(calculate_job(folder / "jobs", job, 1, nullptr));
  EXPECT_FALSE(collect_jobs(write_to(folder / "jobs")).failure);
  EXPECT_EQ(read_text(folder / "jobs/samples.csv"), read_text(folder / "one/samples.csv"));
  EXPECT_EQ(read_timeless(folder / "jobs"), read_timeless(folder / "one"));
}

TEST(StudyJobs, VariantsHaveTheTableOfOneProcess) {
  const fs::path folder = make_test_folder();
  calculate_study(read(cohesion_study), {}, write_to(folder / "one"));
  prepare(cohesion_study, folder / "jobs", 0);
  ASSERT_EQ(list_jobs(folder / "jobs").count, 3);
  for (const int job : {2, 0, 1}) EXPECT_FALSE(calculate_job(folder / "jobs", job, 1, nullptr));
  EXPECT_FALSE(collect_jobs(write_to(folder / "jobs")).failure);
  EXPECT_EQ(read_timeless(folder / "jobs"), read_timeless(folder / "one"));
  EXPECT_EQ(read_text(folder / "jobs/study.svg"), read_text(folder / "one/study.svg"));
}

TEST(StudyJobs, SamplesByRunsAreBitwiseIdenticalToOneProcess) {
  const fs::path folder = make_test_folder();
  calculate_study(read(element_samples, by_elements), by_elements, write_to(folder / "one"));
  prepare(element_samples, folder / "jobs", 2, by_elements);
  for (const int job : {1, 0}) EXPECT_FALSE(calculate_job(folder / "jobs", job, 1, nullptr));
  EXPECT_FALSE(collect_jobs(write_to(folder / "jobs")).failure);
  EXPECT_EQ(read_text(folder / "jobs/samples.csv"), read_text(folder / "one/samples.csv"));
  EXPECT_EQ(read_timeless(folder / "jobs"), read_timeless(folder / "one"));
}

/// Missing, cut short, or of another study: each such job is named, and calculating it again gives the whole.
TEST(StudyJobs, WhatIsNotWholeIsMissing) {
  const fs::path folder = make_test_folder(), jobs = folder / "jobs";
  prepare(slice_samples, jobs, 6);
  EXPECT_NE(catch_message([&] { collect_jobs(write_to(jobs)); }).find("none of the 6 jobs has ended"),
            std::string::npos);
  for (int job = 0; job < 6; ++job) calculate_job(jobs, job, 1, nullptr);
  const std::string whole = read_text(jobs / "jobs/4/result.json");
  fs::remove(jobs / "jobs/1/result.json");
  std::ofstream(jobs / "jobs/1/result.json.part") << whole;  // killed before the file had its name
  std::ofstream(jobs / "jobs/1" / list_file, std::ios::app) << "begin result.json\n";
  std::ofstream(jobs / "jobs/3/result.json") << whole.substr(0, whole.size() / 2);
  std::string of_another = whole;
  of_another.replace(of_another.find("\"study\":\"") + 9, 4, "0000");
  std::ofstream(jobs / "jobs/4/result.json") << of_another;
  EXPECT_EQ(list_jobs(jobs).missing, (std::vector<int>{1, 3, 4}));
  const std::string message = catch_message([&] { collect_jobs(write_to(jobs)); });
  EXPECT_NE(message.find("3 of 6 jobs are missing: 1,3-4"), std::string::npos) << message;
  EXPECT_NE(message.find("sbatch --array=1,3-4 jobs.slurm"), std::string::npos) << message;
  EXPECT_FALSE(fs::exists(jobs / "study.json"));
  for (const int job : {1, 3, 4}) calculate_job(jobs, job, 1, nullptr);
  EXPECT_FALSE(collect_jobs(write_to(jobs)).failure);
  // A job with failed samples: its result records the failure, there are no statistics of the others, and it can be
  // repeated.
  const std::string samples = read_text(jobs / "samples.csv");
  auto failed = *results::read_file<results::JobResult>(jobs / "jobs/2/result.json");
  failed.code = static_cast<int>(ExitCode::wrong_input);
  failed.reason = "sample 25 is no possible case";
  failed.factors.clear();
  results::write_file(jobs / "jobs/2/result.json", failed);
  EXPECT_EQ(list_jobs(jobs).failed, std::vector<int>{2});
  EXPECT_EQ(catch_message([&] { collect_jobs(write_to(jobs)); }),
            "1 of 6 jobs failed:\n  job 2: sample 25 is no possible case");
  EXPECT_FALSE(calculate_job(jobs, 2, 1, nullptr));
  EXPECT_FALSE(collect_jobs(write_to(jobs)).failure);
  EXPECT_EQ(read_text(jobs / "samples.csv"), samples);
}

/// Swapped results are not accepted, whatever the jobs calculate.
TEST(StudyJobs, AResultOfAnotherJobIsNamed) {
  for (const std::string& text : {slice_samples, cohesion_study}) {
    const fs::path folder = make_test_folder(), jobs = folder / "jobs";
    prepare(text, jobs, 3);
    for (int job = 0; job < 3; ++job) EXPECT_FALSE(calculate_job(jobs, job, 1, nullptr));
    fs::rename(jobs / "jobs/0/result.json", jobs / "aside");
    fs::rename(jobs / "jobs/1/result.json", jobs / "jobs/0/result.json");
    fs::rename(jobs / "aside", jobs / "jobs/1/result.json");
    const auto collect = [&]() -> std::string {
      return catch_message([&] {
        const StudyOutcome outcome = collect_jobs(write_to(jobs));
        if (outcome.failure) throw Error(*outcome.failure);
      });
    };
    const std::string message = collect();
    EXPECT_NE(message.find("2 of 3 jobs are missing: 0-1"), std::string::npos) << message;
    EXPECT_NE(message.find("jobs/0/result.json' is the result of job 1 and was not taken"), std::string::npos)
        << message;
    for (const int job : {0, 1}) EXPECT_FALSE(calculate_job(jobs, job, 1, nullptr));
    EXPECT_EQ(collect(), "");
  }
}

/// The runs of two jobs are swapped, and a file of a third is lost.
TEST(StudyJobs, RunsThatAreSwappedOrNotWholeAreFailures) {
  const fs::path folder = make_test_folder(), jobs = folder / "jobs";
  prepare(cohesion_study, jobs, 0);
  for (int job = 0; job < 3; ++job) EXPECT_FALSE(calculate_job(jobs, job, 1, nullptr));
  fs::rename(jobs / "cohesion_4_kPa", jobs / "aside");
  fs::rename(jobs / "cohesion_8", jobs / "cohesion_4_kPa");
  fs::rename(jobs / "aside", jobs / "cohesion_8");
  fs::remove(jobs / "base/history.csv");
  const StudyOutcome outcome = collect_jobs(write_to(jobs));
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code(), ExitCode::wrong_input);
  const std::string message = outcome.failure->what();
  EXPECT_NE(message.find("3 of 3 variants did not finish"), std::string::npos) << message;
  EXPECT_NE(message.find("base/history.csv' is missing"), std::string::npos) << message;
  EXPECT_NE(message.find("cohesion_8/summary.json' is missing or of another run"), std::string::npos) << message;
}

TEST(StudyJobs, TheTableOfRunsShowsThoseThatHaveEnded) {
  const fs::path folder = make_test_folder(), jobs = folder / "jobs";
  prepare(cohesion_study, jobs, 0);
  calculate_job(jobs, 1, 1, nullptr);
  const StudyOutcome outcome = collect_jobs(write_to(jobs));
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code(), ExitCode::interrupted);
  EXPECT_NE(std::string(outcome.failure->what()).find("2 of 3 jobs are missing: 0,2"), std::string::npos);
  const auto study = results::read_file<results::StudyResult>(jobs / "study.json");
  EXPECT_EQ(study->variants[0].status, results::VariantStatus::not_started);
  EXPECT_EQ(study->variants[1].status, results::VariantStatus::finished);
}

/// One of the two runs becomes unstable: it is a failure of its job, and the job can be repeated.
TEST(StudyJobs, AFailureIsKeptAndRepeated) {
  const std::string text = coarse_slope + "\n[[study.vary]]\nkey = \"gravity.acceleration\"\nvalues = [1e9]\n";
  const fs::path folder = make_test_folder(), jobs = folder / "jobs";
  prepare(text, jobs, 0);
  EXPECT_FALSE(calculate_job(jobs, 0, 1, nullptr));
  const auto failure = calculate_job(jobs, 1, 1, nullptr);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code(), ExitCode::unstable);
  EXPECT_EQ(list_jobs(jobs).failed, std::vector<int>{1});
  EXPECT_TRUE(list_jobs(jobs).missing.empty());
  const StudyOutcome outcome = collect_jobs(write_to(jobs));
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code(), ExitCode::unstable);
  EXPECT_NE(std::string(outcome.failure->what()).find("sbatch --array=1 jobs.slurm"), std::string::npos)
      << outcome.failure->what();
  const auto kept = fs::last_write_time(jobs / "jobs/1/result.json");
  EXPECT_TRUE(calculate_job(jobs, 1, 1, nullptr));
  EXPECT_NE(fs::last_write_time(jobs / "jobs/1/result.json"), kept);
}

/// A list of jobs may come from anybody: what it names stays in its folder, and is none of the study's own files.
TEST(StudyJobs, NamesInTheListOfJobsStayInItsFolder) {
  const fs::path folder = make_test_folder(), jobs = folder / "jobs";
  prepare(cohesion_study, jobs, 0);
  const auto result = *results::read_file<results::StudyJobs>(jobs / "jobs.json");
  const auto refusal = [&](const std::function<void(results::StudyJobs&)>& change) {
    results::StudyJobs changed = result;
    change(changed);
    results::write_file(jobs / "jobs.json", changed);
    return catch_message([&] { calculate_job(jobs, 1, 1, nullptr); });
  };
  for (const char* name : {"../../x", "..", "/tmp/x", "", "report.html", "jobs"}) {
    const std::string message = refusal([&](results::StudyJobs& j) { j.variants[1].folder = name; });
    EXPECT_NE(message.find("names the folder '" + std::string(name) + "' for a run"), std::string::npos) << message;
  }
  EXPECT_NE(refusal([](results::StudyJobs& j) { j.files[0].name = "../../case.toml"; }).find("'..' cannot be a name"),
            std::string::npos);
  EXPECT_NE(refusal([](results::StudyJobs& j) { j.files.clear(); }).find("names no copy of the case"),
            std::string::npos);
  EXPECT_NE(refusal([](results::StudyJobs& j) {
              j.jobs[1] = {1, 100};
            }).find("has a job of the runs 1 to 99"),
            std::string::npos);
  EXPECT_EQ(fs::exists(folder / "x"), false);
  EXPECT_EQ(refusal([](results::StudyJobs&) {}), "");
}

TEST(StudyJobs, PreparingAgainKeepsTheSameJobsAndRefusesOthers) {
  const fs::path folder = make_test_folder(), jobs = folder / "jobs";
  prepare(slice_samples, jobs, 6);
  calculate_job(jobs, 2, 1, nullptr);
  EXPECT_NE(catch_message([&] { prepare(slice_samples, jobs, 6); }).find("is not empty"), std::string::npos);
  prepare(slice_samples, jobs, 6, {}, true);
  EXPECT_EQ(list_jobs(jobs).missing.size(), 5u);
  EXPECT_NE(catch_message([&] { prepare(slice_samples, jobs, 5, {}, true); }).find("holds the jobs of another"),
            std::string::npos);
  EXPECT_NE(catch_message([&] {
              prepare(slice_samples, jobs, 6, {{"study.seed", "2"}}, true);
            }).find("holds the jobs of another"),
            std::string::npos);
  StudyOptions anew = write_to(jobs);
  anew.overwrite = true;
  prepare_jobs(read(slice_samples), {}, {anew, 5});
  EXPECT_EQ(list_jobs(jobs).missing.size(), 5u);
}

/// The copies have the relative paths of the files; the jobs no longer need the originals.
TEST(StudyJobs, TheFolderHoldsTheFilesOfTheCase) {
  const fs::path folder = make_test_folder(), examples = fs::path(TALUS_SOURCE_DIR) / "examples";
  fs::create_directories(folder / "site/data");
  fs::create_directories(folder / "site/cases");
  fs::copy_file(examples / "data/dry_slope_h075.msh", folder / "site/data/dry_slope_h075.msh");
  fs::copy_file(examples / "dry_slope/same_mesh_as_independent_code.toml", folder / "site/cases/slope.toml");
  const std::string file = (folder / "site/cases/slope.toml").string();
  const std::vector<input::Override> changes{
      {"analysis", "{ kind = 'run' }"},
      {"strength_reduction", "{}"},
      {"stage", "[{ name = 'gravity', duration = 0.01 }]"},
      {"study", "{ vary = [{ key = 'materials.sand.cohesion', values = [8] }] }"}};
  prepare_jobs(input::read_case(file, changes), changes, {write_to(folder / "jobs"), 0});
  fs::rename(folder / "site", folder / "gone");
  EXPECT_TRUE(fs::exists(folder / "jobs/case/data/dry_slope_h075.msh"));
  for (const int job : {0, 1}) EXPECT_FALSE(calculate_job(folder / "jobs", job, 1, nullptr));
  EXPECT_FALSE(collect_jobs(write_to(folder / "jobs")).failure);
  EXPECT_EQ(read_timeless(folder / "jobs")["case_file"], file);
}

TEST(StudyJobs, FilesOfACaseAreFoundByTheirKeys) {
  const std::string text = R"(
title = "file"
[mesh]
file = "a.msh"
[initial]
result = "../gravity"
[materials.clay]
library = "clay.so"
[[hydraulic]]
on = "crest"
rate = { file = "weather.csv", column = "rain" }
[[hydraulic]]
on = "toe"
rate = { file = "weather.csv", column = "rain", minus = "file" }
[study]
vary = [{ key = "mesh.file", values = ["b.msh"] }]
)";
  EXPECT_EQ(input::list_files(text, {{"mesh.file", "b.msh"}}),
            (std::vector<std::string>{"weather.csv", "../gravity", "clay.so", "b.msh"}));
}

TEST(StudyJobsProgram, MistakesAreASentenceEach) {
  const fs::path folder = make_test_folder();
  fs::create_directories(folder);
  const std::string file = (folder / "slope.toml").string(), plain = (folder / "plain.toml").string(),
                    jobs = (folder / "jobs").string();
  std::ofstream(file) << slice_samples;
  std::ofstream(plain) << coarse_slope;
  const auto refuse = [&](const std::string& arguments, int code, const std::string& sentence) {
    const ProgramEnd outcome = run_study_program(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.text;
    EXPECT_EQ(std::count(outcome.text.begin(), outcome.text.end(), '\n'), 1) << outcome.text;
    EXPECT_NE(outcome.text.find(sentence), std::string::npos) << outcome.text;
  };
  refuse(plain + " --prepare " + jobs, 2, "there is nothing to vary");
  EXPECT_FALSE(fs::exists(jobs));
  ASSERT_EQ(run_study_program(file + " --prepare " + jobs + " --jobs 4").code, 0);
  refuse(file + " --prepare " + jobs, 3, "is not empty");
  refuse(jobs + " --job 4", 2, "there is no job 4");
  refuse(jobs + " --job -1", 2, "its jobs are 0 to 3");
  refuse(jobs + " --job 1 --overwrite", 2, "--overwrite excludes --job");
  refuse(jobs + " --job 1 --set mesh.size=1", 2, "--set has no meaning with --job");
  refuse(jobs + " --collect --job 1", 2, "excludes");
  refuse(jobs + " --collect", 5, "none of the 4 jobs has ended");
  refuse(jobs, 2, "--job K to run a job");
  refuse(file + " --jobs 4", 2, "--prepare");
  refuse(file + " --job 1", 2, "needs the folder that talus study CASE --prepare DIR has written");
  refuse(folder.string() + " --job 1", 2, "it has no jobs.json");
  refuse(folder.string() + " --collect", 2, "it has no jobs.json");
  const std::string list = read_text(folder / "jobs/jobs.json");
  std::string older = list;
  older.replace(older.find("\"commit\": \"") + 11, 1, "X");
  std::ofstream(folder / "jobs/jobs.json") << older;
  refuse(jobs + " --job 1", 2, "were prepared by Talus");
  std::ofstream(folder / "jobs/jobs.json") << list.substr(0, 100);
  refuse(jobs + " --job 1", 2, "cannot read");
  std::ofstream(folder / "jobs/jobs.json") << list;
  std::ofstream(folder / "jobs/case/case.toml", std::ios::app) << "# another word\n";
  refuse(jobs + " --job 1", 2, "is not as it was when the jobs were prepared");
}

/// Runs the script as Slurm does, with the number of the task, in the folder of the jobs.
TEST(StudyJobsProgram, TheScriptCalculatesTheJobOfItsTask) {
  const fs::path folder = make_test_folder();
  fs::create_directories(folder);
  std::ofstream(folder / "slope.toml") << slice_samples;
  const std::string jobs = (folder / "jobs").string();
  ASSERT_EQ(run_study_program((folder / "slope.toml").string() + " --prepare " + jobs + " --jobs 3").code, 0);
  EXPECT_NE(read_text(folder / "jobs/jobs.slurm").find("#SBATCH --array=0-2%100"), std::string::npos);
  for (const char* task : {"0", "1", "2"})
    EXPECT_EQ(std::system(("cd '" + jobs + "' && TALUS='" TALUS_PROGRAM "' SLURM_ARRAY_TASK_ID=" + task +
                           " bash jobs.slurm > log")
                              .c_str()),
              0);
  const ProgramEnd outcome = run_study_program(jobs + " --collect");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("probability"), std::string::npos) << outcome.text;
  EXPECT_TRUE(fs::exists(folder / "jobs/report.html"));
}

/// The same job by four processes at once: some may find it taken, none harms it.
TEST(StudyJobsProgram, TheSameJobAtOnceDoesNoHarm) {
  const fs::path folder = make_test_folder(), jobs = folder / "jobs";
  prepare(cohesion_study, jobs, 1);
  const std::string one =
      "'" TALUS_PROGRAM "' study '" + jobs.string() + "' --job 0 --threads 1; test $? -eq 0 -o $? -eq 3";
  const std::string all = "(" + one + ") & (" + one + ") & (" + one + ") & wait; " + one;
  EXPECT_EQ(std::system(("(" + all + ") > /dev/null 2>&1").c_str()), 0);
  EXPECT_TRUE(list_jobs(jobs).missing.empty());
  EXPECT_FALSE(collect_jobs(write_to(jobs)).failure);
}

}  // namespace
}  // namespace talus::study
