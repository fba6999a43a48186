// SPDX-License-Identifier: MIT
// A disk that becomes full during a run: one message, its exit code, and no truncated file under a final name.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "output/files/archive.hpp"
#include "output/files/frames_reader.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// `talus run` on a coarse dry slope in a child whose files may not grow beyond `limit` bytes, which to the program
/// looks like a full disk. Returns its exit code; its output goes to `folder`/messages.txt.
int run_with_limit(const fs::path& folder, rlim_t limit) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit bound{limit, limit};
    setrlimit(RLIMIT_FSIZE, &bound);
    const std::string path = (folder / "messages.txt").string(), out = (folder / "results").string();
    const std::string input = std::string(TALUS_SOURCE_DIR) + "/examples/dry_slope/case.toml";
    if (!freopen(path.c_str(), "w", stderr)) _exit(126);
    execl(TALUS_PROGRAM, "talus", "run", input.c_str(), "-o", out.c_str(), "-q", "--set", "mesh.size=1.5", "--set",
          "analysis.kind=run", "--set", "output.frame_interval=0.5", nullptr);
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(FullDisk, IsOneSentenceAndLeavesWholeFilesOnly) {
  const fs::path folder = support::name_scratch("full_disk");
  for (const rlim_t limit : {3000, 20000, 60000, 200000}) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const int code = run_with_limit(folder, limit);
    ASSERT_EQ(code, 6) << "limit " << limit;
    std::ifstream file(folder / "messages.txt");
    const std::string message{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(message.find("cannot write"), std::string::npos) << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << "one sentence, not:\n" << message;
    // Whatever has a final name can be read.
    if (fs::exists(folder / "results" / "checkpoint.h5")) output::ArchiveReader(folder / "results" / "checkpoint.h5");
    if (fs::exists(folder / "results" / "frames") && !fs::is_empty(folder / "results" / "frames")) {
      const output::ResultsReader reader(folder / "results");
      for (int i = 0; i < reader.size(); ++i) reader.read(i);
    }
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace talus
