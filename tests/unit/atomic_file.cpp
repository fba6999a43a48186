// SPDX-License-Identifier: MIT
// Atomic replacement of a file acts on its name: a link in its place, or under its temporary name, is not followed.
#include "base/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

class ReplacedFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::ofstream(other) << "precious";
  }
  void TearDown() override {
    EXPECT_EQ(support::read_text(other), "precious");
    fs::remove_all(folder);
  }
  const fs::path folder = support::make_scratch("replaced_file");
  const fs::path other = folder / "precious.txt", file = folder / "summary.json";
};

TEST_F(ReplacedFile, FollowsNoLinkUnderItsNameOrItsTemporaryOne) {
  fs::create_symlink("precious.txt", file);
  fs::create_symlink("precious.txt", temporary_name(file));
  write_atomically(file, "new");
  EXPECT_FALSE(fs::is_symlink(file));
  EXPECT_EQ(support::read_text(file), "new");
  EXPECT_FALSE(fs::exists(fs::symlink_status(temporary_name(file))));
}

TEST_F(ReplacedFile, FollowsNoHardLink) {
  fs::create_hard_link(other, temporary_name(file));
  write_atomically(file, "new");
  EXPECT_EQ(support::read_text(file), "new");
}

/// root could replace /dev/null.
TEST_F(ReplacedFile, ReplacesNoPipe) {
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  try {
    write_atomically(file, "new");
    FAIL() << "it was replaced";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("is a device, a pipe or a socket, not a file"), std::string::npos);
  }
  EXPECT_TRUE(fs::is_fifo(file));
  EXPECT_FALSE(fs::exists(temporary_name(file)));
}

TEST_F(ReplacedFile, HistoriesAndFilesInHdf5FollowNoneEither) {
  const fs::path history = folder / "history.csv", heavy = folder / "results.vtkhdf";
  fs::create_symlink("precious.txt", history);
  EXPECT_THROW(output::History::resume(history, {{"time", "s"}}), Error);
  output::History::start(history, {{"time", "s"}}).append(std::array{1.0});
  EXPECT_EQ(support::read_text(history), "time [s]\n1\n");
  output::ResultsWriter writer = output::ResultsWriter::start(folder);
  writer.write({0, 0, "weight", {0, 0, 0, 1, 0, 0}, {0, 1}, {0, 0}, {}, {}});
  fs::create_symlink("precious.txt", temporary_name(heavy));
  writer.finish();
  EXPECT_TRUE(fs::is_regular_file(heavy));
  EXPECT_FALSE(fs::is_symlink(heavy));
}

}  // namespace
}  // namespace talus
