// SPDX-License-Identifier: MIT
// The lock that admits one run at a time in a folder.
#include "base/folder_lock.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "base/error.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string make_folder(const std::string& name) {
  const fs::path folder = support::name_scratch(name);
  fs::remove_all(folder);
  return folder.string();
}

std::string catch_lock(const fs::path& folder) {
  try {
    FolderLock(folder).take();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::folder_exists);
    return error.what();
  }
  return "";
}

TEST(FolderLock, LetsOneRunIn) {
  const fs::path folder = make_folder("one");
  {
    FolderLock lock(folder);
    lock.take_existing();
    EXPECT_FALSE(fs::exists(folder)) << "nothing is made before it must";
    lock.take();
    lock.take();
    EXPECT_TRUE(holds_nothing(folder)) << "the lock is no result";
    const std::string sentence = catch_lock(folder);
    EXPECT_NE(sentence.find("is in use by process " + std::to_string(getpid()) + " on '"), std::string::npos)
        << sentence;
  }
  EXPECT_FALSE(fs::exists(folder / lock_file));
  EXPECT_EQ(catch_lock(folder), "");
}

TEST(FolderLock, EndsWithItsProcess) {
  const fs::path folder = make_folder("killed");
  const pid_t child = fork();
  if (child == 0) {
    FolderLock lock(folder);
    lock.take();
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(fs::exists(folder / lock_file)) << "it stays, and names its holder";
  EXPECT_EQ(catch_lock(folder), "");
}

/// A process that a killed one had started keeps its files open until it ends too.
TEST(FolderLock, WaitsForWhatAKilledProcessStarted) {
  const fs::path folder = make_folder("orphan");
  std::array<int, 2> gate{};
  ASSERT_EQ(pipe(gate.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    FolderLock lock(folder);
    lock.take();
    if (fork() == 0) {
      close(gate[1]);
      char end = 0;
      _exit(read(gate[0], &end, 1) == 0 ? 0 : 1);
    }
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  std::thread opener([&] { close(gate[1]); });
  EXPECT_EQ(catch_lock(folder), "");
  opener.join();
  close(gate[0]);
}

/// A link or a pipe in place of the lock does not lead to a file that is written to.
TEST(FolderLock, WritesToNoOtherFile) {
  const fs::path folder = make_folder("links"), lock = folder / lock_file, other = folder / "precious.txt";
  fs::create_directories(folder);
  std::ofstream(other) << "precious";
  const auto expect_refusal = [&](const char* what) {
    try {
      FolderLock(folder).take();
      ADD_FAILURE() << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::cannot_write);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
    EXPECT_TRUE(fs::exists(fs::symlink_status(lock))) << "it is not this program's to remove";
    std::ifstream file(other);
    std::string text;
    std::getline(file, text);
    EXPECT_EQ(text, "precious");
    fs::remove(lock);
  };
  fs::create_symlink("precious.txt", lock);
  expect_refusal("a symbolic link");
  fs::create_symlink("/nowhere/at/all", lock);
  expect_refusal("a symbolic link");
  fs::create_hard_link(other, lock);
  expect_refusal("a link to another file");
  ASSERT_EQ(mkfifo(lock.c_str(), 0600), 0);
  expect_refusal("no file");
  EXPECT_EQ(catch_lock(folder), "");
}

}  // namespace
}  // namespace talus
