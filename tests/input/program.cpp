// SPDX-License-Identifier: MIT
// The program as a command: its output streams and exit codes.

#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "methods_slope.hpp"
#include "support/child.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

using support::Outcome;
using support::read_text;
using support::run_program;

std::string write_file(const std::string& name, const std::string& text) {
  const std::string path = support::name_scratch(name).string();
  std::ofstream(path) << text;
  return path;
}

TEST(Program, ChecksItsOwnTemplate) {
  const Outcome made = run_program("template");
  EXPECT_EQ(made.code, 0);
  const std::string path = write_file("talus_template.toml", made.text);
  const Outcome checked = run_program("check " + path);
  EXPECT_EQ(checked.code, 0) << checked.text;
  EXPECT_EQ(checked.text.rfind(path + ": no errors\n", 0), 0u) << checked.text;
  EXPECT_EQ(std::count(checked.text.begin(), checked.text.end(), '\n'), 4);
  EXPECT_NE(checked.text.find("\n    about 3,070 elements, "), std::string::npos) << checked.text;
}

TEST(Program, WithoutItsModulesSaysWhichIsMissing) {
  const std::filesystem::path alone = support::name_scratch("alone");
  std::filesystem::create_directories(alone);
  std::filesystem::copy_file(TALUS_PROGRAM, alone / "talus", std::filesystem::copy_options::overwrite_existing);
  const std::string path = write_file("talus_modules.toml", all_three);
  const auto run = [&](const std::string& more) {
    return support::run_command((alone / "talus").string() + " run " + path + " -o " + (alone / "results").string() +
                                " " + more);
  };
  const Outcome meshless = run("");
  EXPECT_NE(meshless.code, 0);
  EXPECT_NE(meshless.text.find("libtalus_gmsh.so"), std::string::npos) << meshless.text;
  const Outcome emulated = run("--device emulated");
  EXPECT_EQ(emulated.code, 2);
  EXPECT_NE(emulated.text.find("built without the emulated device, which `make test` builds"), std::string::npos)
      << emulated.text;
}

TEST(Program, PrintsWhatEachMethodCalculates) {
  const std::string path = write_file("talus_methods.toml", all_three +
                                                                "[lem]\nmethods = [\"bishop\", \"spencer\"]\n"
                                                                "[partial_factors]\nset = \"DA1-2\"\n");
  const Outcome checked = run_program("check " + path);
  EXPECT_EQ(checked.code, 0) << checked.text;
  for (const char* line :
       {"\n  limit equilibrium: Bishop simplified, Spencer; circles between entries and exits, then polylines\n",
        "\n  FEM: strength reduction with elements of 0.75 m and of 1.5 m, ψ as given\n",
        "\n  MPM, run: 2 stages, together at most 13 s\n", "\n  with partial factors DA1-2\n"})
    EXPECT_NE(checked.text.find(line), std::string::npos) << line << checked.text;
  const Outcome slices = run_program("check --set 'analysis.methods=[\"lem\"]' " + path);
  EXPECT_EQ(slices.text.find("stages"), std::string::npos) << "nothing moves: " << slices.text;
  const Outcome in_feet = run_program("check --set 'mesh.size=\"3 ft\"' --set output.length_unit=ft " + path);
  EXPECT_NE(in_feet.text.find("strength reduction with elements of 3 ft and of 6 ft, "), std::string::npos)
      << in_feet.text;
}

TEST(Program, ReportsEveryFaultAndExitsWithTwo) {
  const std::string path =
      write_file("talus_faults.toml", change(change(slope, "size = 0.75", "size = -1"), "title", "titel"));
  const Outcome checked = run_program("check " + path);
  EXPECT_EQ(checked.code, 2);
  EXPECT_NE(checked.text.find(path + ":1:1: error: unknown key 'titel'"), std::string::npos) << checked.text;
  EXPECT_NE(checked.text.find(path + ":16:8: error: 'size' is -1 m"), std::string::npos) << checked.text;
}

TEST(Program, RefusesWhatNeedsMoreMemoryThanIsFree) {
  const std::string path = write_file("talus_fine.toml", slope);
  const std::string folder = support::name_scratch("talus_fine").string();
  for (const std::string& command : {std::string("check "), "run -o '" + folder + "' "}) {
    const Outcome refused = run_program(command + "--set mesh.size=0.0003 " + path);
    EXPECT_EQ(refused.code, 2) << refused.text;
    EXPECT_NE(refused.text.find("--set mesh.size: error: MPM with elements of 0.0003 m needs about "),
              std::string::npos)
        << refused.text;
    EXPECT_NE(refused.text.find(" m would fit"), std::string::npos) << refused.text;
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
  const Outcome hopeless = run_program("check --set mesh.size=1e-300 " + path);
  EXPECT_EQ(hopeless.code, 2) << hopeless.text;
  EXPECT_NE(hopeless.text.find("needs more memory than any machine has"), std::string::npos) << hopeless.text;
}

TEST(Program, PrintsItsWarningsBeforeARunAndKeepsThem) {
  const std::string path = write_file("talus_warned.toml", slices_alone),
                    folder = support::name_scratch("talus_warned").string();
  std::filesystem::remove_all(folder);
  const std::string sentence = "'materials.soil.friction_angle' is 0.44 deg; the usual range is 5 to 50 deg, or 0";
  const Outcome ran = run_program(
      "run --no-report --overwrite --set lem.noncircular=false --set lem.entry_exit.depths=3 "
      "--set materials.soil.friction_angle=0.44 -o " +
      folder + " " + path);
  EXPECT_EQ(ran.code, 0) << ran.text;
  EXPECT_EQ(ran.text.rfind("--set materials.soil.friction_angle: warning: " + sentence, 0), 0u) << ran.text;
  std::ifstream file(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary.at("warnings").dump().find(sentence) == std::string::npos, false) << summary.at("warnings");
}

/// Starts the program in its own process, with its errors written to the file `said`.
pid_t start_program(std::vector<const char*> arguments, const std::string& message) {
  const pid_t child = fork();
  if (child != 0) return child;
  if (std::freopen(message.c_str(), "w", stderr) == nullptr) _exit(126);
  arguments.insert(arguments.begin(), "talus");
  arguments.push_back(nullptr);
  execv(TALUS_PROGRAM, const_cast<char**>(arguments.data()));
  _exit(127);
}

/// SIGTERM ends the program, before it has calculated for `most` seconds, with code 5, the sentence and nothing
/// written.
void expect_end_by_signal(pid_t child, double most, const std::string& message, const std::string& sentence,
                          const std::string& folder) {
  kill(child, SIGTERM);
  int status = 0;
  rusage used{};
  ASSERT_EQ(wait4(child, &status, 0, &used), child);
  EXPECT_EQ(WEXITSTATUS(status), 5);
  EXPECT_EQ(read_text(message), "talus: error: " + sentence + "\n");
  EXPECT_LT(static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec), most);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(Program, EndsMeshingSoonAfterASignal) {
  // This mesh takes half a minute and more; it is ended after four seconds of work.
  const std::string path = write_file("talus_signal.toml", slope),
                    folder = support::name_scratch("talus_signal").string(),
                    message = support::name_scratch("talus_signal.txt").string();
  const pid_t child =
      start_program({"run", "-q", "--set", "mesh.size=0.04", "-o", folder.c_str(), path.c_str()}, message);
  // Gmsh works in a process of its own, which the program waits for.
  const pid_t mesher = support::find_child(child);
  ASSERT_GT(mesher, 0) << read_text(message);
  constexpr double work = 4;
  support::wait_for_seconds(mesher, work);
  expect_end_by_signal(child, work + 3, message, "interrupted while the mesh was made", folder);
}

TEST(Program, EndsASearchOfSlicesSoonAfterASignal) {
  // So many circles take half a minute and more on a fast machine.
  const std::string folder = support::name_scratch("talus_search").string(),
                    message = support::name_scratch("talus_search.txt").string();
  std::filesystem::remove_all(folder);
  const pid_t child = start_program({"run", "-q", "--threads", "1", "--set", "analysis.methods=[\"lem\"]", "--set",
                                     "lem.entry_exit={ exits = 200, entries = 200, depths = 20 }", "-o", folder.c_str(),
                                     TALUS_SOURCE_DIR "/tests/data/misleading/clay_over_rock.toml"},
                                    message);
  constexpr double work = 1;
  support::wait_for_work(child, work);
  expect_end_by_signal(child, work + 3, message, "interrupted while slip surfaces were searched", folder);
}

TEST(Program, PrintsItsVersionEitherWay) {
  const Outcome command = run_program("version"), option = run_program("--version");
  EXPECT_EQ(option.code, 0);
  EXPECT_EQ(option.text, command.text);
  EXPECT_EQ(option.text.rfind("talus ", 0), 0u) << option.text;
}

TEST(Program, ChecksWhatIsUnstableByInspection) {
  // A face of 1:0.5 in sand without cohesion.
  const std::string path = write_file(
      "talus_steep.toml", change(change(slices_alone, "cohesion = 3", "cohesion = 0"), "[30, 25]", "[40, 25]"));
  const Outcome checked = run_program("check " + path);
  EXPECT_EQ(checked.code, 0) << checked.text;
  EXPECT_NE(checked.text.find("warning: The ground between (40, 25) and (50, 35) rises at 45.0°, more than φ = 19.6°"),
            std::string::npos)
      << checked.text;
  EXPECT_NE(checked.text.find(path + ": no errors, 1 warning\n"), std::string::npos) << checked.text;
}

TEST(Program, TakesChangesBeforeAndAfterTheFile) {
  const std::string path = write_file("talus_slope.toml", slope);
  const Outcome good = run_program("check --set mesh.size=0.5 " + path + " --set 'mesh.algorithm=delaunay'");
  EXPECT_EQ(good.code, 0) << good.text;
  EXPECT_NE(good.text.find("elements of 0.5 m"), std::string::npos) << good.text;
  const Outcome bad = run_program("check --set mesh.size=0 " + path);
  EXPECT_EQ(bad.code, 2);
  EXPECT_EQ(bad.text.rfind("--set mesh.size: error: 'size' is 0 m", 0), 0u) << bad.text;
}

TEST(Program, RefusesAWrongCommandLineWithTwo) {
  for (const char* arguments : {"", "check", "check --sett a=b x.toml", "check no_such_file.toml", "template extra"}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find("error: "), std::string::npos) << arguments << "\n" << outcome.text;
  }
  EXPECT_EQ(run_program("chek x.toml").text, "talus: error: there is no command 'chek'; did you mean 'check'?\n");
  EXPECT_EQ(run_program("--help").code, 0);
  EXPECT_EQ(run_program("check --help").code, 0);
}

TEST(Program, StartsWhateverTheWaitPolicyIs) {
  // Without a policy the program starts itself again; it must do so once and keep its arguments.
  for (const char* environment : {"env -u OMP_WAIT_POLICY", "env OMP_WAIT_POLICY=active"}) {
    const Outcome outcome = run_program("version", environment);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.text.rfind("talus ", 0), 0u) << outcome.text;
  }
}

TEST(Program, PrintsASchemaThatIsJson) {
  const auto schema = nlohmann::json::parse(run_program("schema").text);
  EXPECT_TRUE(schema["properties"].contains("materials"));
}

TEST(Program, RequiresAWholeNumberOfThreads) {
  const std::string path = write_file("talus_threads.toml", slices_alone);
  for (const char* given : {"0", "-1", "1.5", "x"}) {
    const Outcome outcome = run_program("run --threads " + std::string(given) + " " + path);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.text.find("--threads: '" + std::string(given) + "' must be a whole number of at least 1"),
              std::string::npos)
        << outcome.text;
  }
}

/// Each rank of a launcher may run a job of its own.
TEST(Program, RunsAJobUnderALauncherAndNoStudy) {
  const std::string path = write_file(
      "talus_ranks.toml", slices_alone + "[[study.vary]]\nkey = \"materials.soil.cohesion\"\nvalues = [3, 4]\n");
  const Outcome study = run_program("study " + path, "PMI_SIZE=4");
  EXPECT_EQ(study.code, 2);
  EXPECT_NE(study.text.find("a study does not run on 4 ranks"), std::string::npos) << study.text;
  const Outcome job = run_program("study '" + support::make_scratch("study").string() + "' --job 0", "PMI_SIZE=4");
  EXPECT_EQ(job.text.find("ranks"), std::string::npos) << job.text;
}

/// ACADS 1(a) has 0.99 to 1.00 with characteristic values.
TEST(Program, PrintsTheCheckOfADesignSetFirst) {
  const std::string folder = support::name_scratch("talus_design").string();
  std::filesystem::remove_all(folder);
  for (const auto& [cohesion, part] :
       {std::pair{"3", "below 1: the slope is NOT verified"}, {"30", "at least 1: verified"}}) {
    const std::string path =
        write_file("talus_design.toml", change(slices_alone, "cohesion = 3", fmt::format("cohesion = {}", cohesion)) +
                                            "[lem]\nmethods = [\"bishop\"]\nnoncircular = false\nreferee = false\n"
                                            "[partial_factors]\nset = \"DA2\"\n");
    const std::string message = run_program("run --overwrite --no-report -o " + folder + " " + path).text;
    const auto check = message.find("Check with DA2: F/γ_R = "), factor = message.find("\nFactor of safety ");
    ASSERT_NE(check, std::string::npos) << message;
    ASSERT_LT(check, factor) << message;
    EXPECT_NE(message.substr(check, factor - check).find(part), std::string::npos) << message;
    EXPECT_NEAR(std::stod(message.substr(factor + 18)), 1.1 * std::stod(message.substr(check + 25)), 2e-3) << message;
  }
}

}  // namespace
}  // namespace talus::input
