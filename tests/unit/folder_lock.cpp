// SPDX-License-Identifier: MIT
// One run at a time in a folder.
#include "base/folder_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "base/error.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string make_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("talus_lock_" + name);
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
  EXPECT_TRUE(fs::exists(folder / lock_file)) << "it stays, and says who held it";
  EXPECT_EQ(catch_lock(folder), "");
}

}  // namespace
}  // namespace talus
