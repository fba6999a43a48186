// SPDX-License-Identifier: MIT
// Every key that names a file, and the case file itself, with something that is no regular file: an endless device, a
// pipe without a writer, a folder, a file of 5 GB, a blocking system file. The program reports each in bounded time and
// memory.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

const std::string head = R"(title = "block"
[[boundary]]
on = "bottom"
fix = "full"
[[stage]]
name = "weight"
duration = 0.5
damping = 0.3
)";
const std::string section = R"([geometry]
box = [[0, 0], [4, 3]]
[[geometry.polygon]]
name = "soil"
points = [[0, 0], [4, 0], [4, 2], [0, 2]]
[mesh]
size = 1
[regions]
soil = "clay"
)";
const std::string soil_text = R"([materials.clay]
model = "mohr_coulomb"
cohesion = 5
friction_angle = 30
young_modulus = "5 MPa"
poisson_ratio = 0.3
dilatancy_angle = 0
tensile_strength = 0
grain_density = 2700
porosity = 0.37
)";

/// A key that names a file, in a case with FILE in place of the name, and the name that the file must have.
struct Key {
  const char* what;
  std::string text;
  const char* name;
  const char* command = "check";
};

std::vector<Key> list_keys() {
  const std::string test = R"([[test]]
name = "t"
material = "clay"
kind = "drained_triaxial"
confining_pressure = 100
axial_strain = [10]
)";
  return {
      {"mesh", head + "[mesh]\nfile = \"FILE\"\npoints_per_element = 1\n[regions]\nsoil = \"clay\"\n" + soil_text,
       "slope.msh"},
      {"series",
       "[[hydraulic]]\non = \"top\"\ncondition = \"rain\"\nrate = { file = \"FILE\", column = \"rain\" }\n" + head +
           section + soil_text,
       "rain.csv"},
      {"curve",
       head + section + soil_text + test +
           "[calibration]\n[[calibration.parameter]]\nkey = \"materials.clay.cohesion\"\nmin = 1\nmax = 10\n"
           "[[calibration.curve]]\ntest = \"t\"\nx = \"axial_strain\"\ny = \"q\"\nfile = \"FILE\"\n",
       "curve.csv"},
      {"library",
       head + section +
           "[materials.clay]\nmodel = \"external\"\nlibrary = \"FILE\"\nsymbol = \"umat_\"\nconstants = [0]\n"
           "constrained_modulus = \"8 MPa\"\ngrain_density = 2700\nporosity = 0.37\n",
       "soil.so"},
      {"result", head + section + soil_text + "[initial]\nresult = \"before\"\n", "before/end_state.h5"},
      {"case", "", "case.toml"},
      {"results of a run", "", "summary.json", "report"},
      {"frames", "", "results.vtkhdf", "collect"},
  };
}

struct Kind {
  const char* what;
  void (*make)(const fs::path&);
  const char* sentence;
};

constexpr std::array kinds{
    Kind{"a device", [](const fs::path& path) { fs::create_symlink("/dev/zero", path); }, "a device"},
    Kind{"a pipe", [](const fs::path& path) { ASSERT_EQ(mkfifo(path.c_str(), 0600), 0); }, "a pipe"},
    Kind{"a folder", [](const fs::path& path) { fs::create_directories(path); }, "a folder"},
    Kind{"5 GB",
         [](const fs::path& path) {
           std::ofstream(path).close();
           fs::resize_file(path, 5'000'000'000);
         },
         "5000 MB"},
    Kind{"an entry of the system", [](const fs::path& path) { fs::create_symlink("/proc/kmsg", path); },
         "an entry of the system"},
};

struct Answer {
  int code = -1;
  std::string text;
  double megabytes = 0;  ///< the largest memory of the program
};

/// Processor's seconds and address space are bounded as well: what never ends fails here.
Answer run_on_hostile_file(const std::string& folder, const std::string& arguments) {
  Answer answer;
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit seconds{30, 30};
    setrlimit(RLIMIT_CPU, &seconds);
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    const std::string command = "cd '" + folder + "' && exec '" TALUS_PROGRAM "' " + arguments;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  close(ends[1]);
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = read(ends[0], buffer.data(), buffer.size())) > 0;)
    answer.text.append(buffer.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  answer.megabytes = static_cast<double>(used.ru_maxrss) / 1e3;
  return answer;
}

class HostileFiles : public testing::Test {
 protected:
  const fs::path folder_ = support::make_scratch("hostile");
};

TEST_F(HostileFiles, EveryKeyThatNamesAFileAnswersWithASentence) {
  constexpr double most_megabytes = 300;
  for (const Key& key : list_keys())
    for (const Kind& kind : kinds) {
      SCOPED_TRACE(std::string(key.what) + " is " + kind.what);
      const bool is_folder_of_results = std::string(key.command) != "check";
      const fs::path folder = folder_ / "now", file = folder / key.name;
      fs::remove_all(folder);
      fs::create_directories(file.parent_path());
      kind.make(file);
      std::string text = key.text;
      if (const std::size_t at = text.find("FILE"); at != std::string::npos) text.replace(at, 4, key.name);
      if (!text.empty()) std::ofstream(folder / "case.toml") << text;
      const Answer answer =
          run_on_hostile_file(folder.string(), std::string(key.command) + (is_folder_of_results ? " ." : " case.toml"));
      EXPECT_EQ(answer.code, 2) << answer.text;
      EXPECT_NE(answer.text, "");
      EXPECT_LT(answer.megabytes, most_megabytes);

      // Files in HDF5 are not read whole: there a large one is damaged.
      const bool is_hdf5 = std::string(key.name).ends_with(".h5") || std::string(key.name).ends_with(".vtkhdf");
      const std::string expected = is_hdf5 && std::string(kind.what) == "5 GB" ? "damaged" : kind.sentence;
      EXPECT_NE(answer.text.find(expected), std::string::npos) << answer.text;
    }
}

}  // namespace
}  // namespace talus
