// SPDX-License-Identifier: MIT
// The list of the files that a run wrote is complete at any moment, and no other file is removed or replaced.
#include "base/file_list.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "output/files/history.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

class ListOfFiles : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  void put(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  /// The sentence with which the check of all files ends; empty when all are there.
  std::string check() const {
    try {
      check_listed(folder_, [](const std::string&) { return true; });
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::wrong_input);
      return error.what();
    }
    return "";
  }

  std::vector<std::string> list(const std::vector<fs::path> SortedFiles::*which) const {
    const SortedFiles files = sort_files(folder_, Compared::contents);
    std::vector<std::string> names;
    for (const fs::path& file : files.*which) names.push_back(file.generic_string());
    return names;
  }

  using Names = std::vector<std::string>;
  const fs::path folder_ = support::name_scratch("list");
};

TEST_F(ListOfFiles, HoldsWhatIsWrittenAndNothingElse) {
  write_atomically(folder_ / "before.csv", "1");
  {
    const FileList files(folder_);
    write_atomically(folder_ / "a.csv", "1");
    write_atomically(folder_ / "a.csv", "12");
    make_folder(folder_ / "in/ner");
    write_atomically(folder_ / "in/ner/b\n\\n.csv", "3");
    write_atomically(folder_ / "gone.csv", "4");
    remove_file(folder_ / "gone.csv");
  }
  write_atomically(folder_ / "after.csv", "1");
  EXPECT_EQ(list(&SortedFiles::own), (Names{"a.csv", "in/ner/b\n\\n.csv"}));
  EXPECT_EQ(list(&SortedFiles::foreign), (Names{"after.csv", "before.csv"}));
  EXPECT_EQ(list(&SortedFiles::folders), (Names{"in", "in/ner"}));
  EXPECT_EQ(check(), "");
}

TEST_F(ListOfFiles, ReportsMissingAndChangedFiles) {
  {
    const FileList files(folder_);
    write_atomically(folder_ / "a.csv", "1234567890");
  }
  put("a.csv", "1234567809");
  EXPECT_NE(check().find("a.csv' is not as the run wrote it"), std::string::npos) << check();
  EXPECT_EQ(list(&SortedFiles::foreign), Names{"a.csv"});
  fs::remove(folder_ / "a.csv");
  EXPECT_NE(check().find("a.csv' is missing"), std::string::npos) << check();
  fs::create_symlink("/etc/hostname", folder_ / "a.csv");
  EXPECT_NE(check().find("a.csv' is not as the run wrote it"), std::string::npos) << check();
  EXPECT_EQ(list(&SortedFiles::foreign), Names{"a.csv"});
}

TEST_F(ListOfFiles, OfATableThatGrowsHasTheRowsThatWereKept) {
  const std::vector<output::Column> columns{{"time", "s"}, {"x", "m"}};
  {
    const FileList files(folder_);
    auto table = output::History::start(folder_ / "table.csv", columns);
    table.append(std::vector<double>{0, 1});
    table.keep();
    table.append(std::vector<double>{1, 2});
    // As a kill would leave it, with a row more.
    EXPECT_EQ(check(), "");
    EXPECT_EQ(list(&SortedFiles::own), Names{"table.csv"});
    table.truncate_after(0);
    table.append(std::vector<double>{1, 3});
  }
  EXPECT_EQ(check(), "");
  std::ofstream(folder_ / "table.csv", std::ios::app) << "2,4\n";
  EXPECT_NE(check(), "") << "of a run that has ended nothing grows";
}

TEST_F(ListOfFiles, OfAKilledProcessNamesAllThatItLeft) {
  // The child is killed within the n-th file: before it is begun, with a part of it, and when it has its name.
  for (int moment = 0; moment < 3; ++moment) {
    SetUp();
    const pid_t child = fork();
    if (child == 0) {
      const FileList files(folder_);
      write_atomically(folder_ / "first.csv", "1");
      if (moment == 0) list_content(folder_ / "second.csv", std::as_bytes(std::span("2", 1)));
      if (moment == 1) std::ofstream(begin_file(folder_ / "second.csv")) << "2";
      if (moment == 2) {
        std::ofstream(begin_file(folder_ / "second.csv")) << "2";
        list_content(folder_ / "second.csv", temporary_name(folder_ / "second.csv"));
        fs::rename(temporary_name(folder_ / "second.csv"), folder_ / "second.csv");
      }
      raise(SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(check(), "") << "what was never whole is not missing";
    EXPECT_EQ(list(&SortedFiles::foreign), Names{}) << moment;
    {
      const FileList files(folder_);
      write_atomically(folder_ / "second.csv", "22");
    }
    EXPECT_EQ(list(&SortedFiles::own), (Names{"first.csv", "second.csv"}));
  }
}

TEST_F(ListOfFiles, OutlivesALineThatWasCutOff) {
  {
    const FileList files(folder_);
    write_atomically(folder_ / "a.csv", "1");
  }
  std::ofstream(folder_ / list_file, std::ios::app) << "write 12 00ab b.c";
  EXPECT_EQ(check(), "");
  {
    const FileList files(folder_);
    write_atomically(folder_ / "c.csv", "3");
  }
  EXPECT_EQ(list(&SortedFiles::own), (Names{"a.csv", "c.csv"}));
  put(list_file, "something else\n");
  EXPECT_NE(check().find("it is no list"), std::string::npos) << check();
}

TEST_F(ListOfFiles, RefusesToReplaceAFileOfTheUser) {
  put("mine.csv", "mine");
  put("other.csv.part", "mine");
  const FileList files(folder_);
  for (const char* name : {"mine.csv", "other.csv"}) {
    try {
      write_atomically(folder_ / name, "new");
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::folder_exists) << error.what();
    }
  }
  remove_file(folder_ / "mine.csv");
  EXPECT_EQ(list(&SortedFiles::foreign), (Names{"mine.csv", "other.csv.part"}));
}

TEST_F(ListOfFiles, IsThatOfTheInnermostFolder) {
  {
    const FileList files(folder_);
    make_folder(folder_ / "run");
    const FileList inner(folder_ / "run");
    write_atomically(folder_ / "run/a.csv", "1");
    write_atomically(folder_ / "b.csv", "2");
  }
  put("run/notes.txt", "mine");
  put("copy/a.csv", "1");
  fs::copy_file(folder_ / "run" / list_file, folder_ / "copy" / list_file);
  EXPECT_EQ(list(&SortedFiles::lists), (Names{"", "run"}));
  EXPECT_EQ(list(&SortedFiles::own), (Names{"b.csv", "run/a.csv"}));
  remove_own(sort_files(folder_, Compared::contents));
  EXPECT_EQ(list(&SortedFiles::own), Names{});
  EXPECT_EQ(list(&SortedFiles::foreign), (Names{"copy/a.csv", "copy/talus.files", "run/notes.txt"}));
  EXPECT_EQ(list(&SortedFiles::lists), Names{""});
}

TEST_F(ListOfFiles, NamesNothingOutsideItsFolder) {
  put("../talus_list_outside.csv", "mine");
  put(list_file, "Talus files 1\nwrite 4 0 ../talus_list_outside.csv\nfolder ..\n");
  remove_own(sort_files(folder_, Compared::contents));
  EXPECT_TRUE(fs::exists(folder_ / "../talus_list_outside.csv"));
  fs::remove(folder_ / "../talus_list_outside.csv");
}

TEST(ContentHash, DoesNotDependOnThePieces) {
  std::vector<std::byte> bytes(1000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7919 >> 3);
  const auto find = [](const std::vector<std::span<const std::byte>>& pieces) {
    ContentHash hash;
    for (const auto& piece : pieces) hash.add(piece);
    return hash.value();
  };
  const std::span<const std::byte> all(bytes);
  const std::uint64_t whole = find({all});
  for (std::size_t cut = 0; cut <= 40; ++cut)
    EXPECT_EQ(find({all.first(cut), all.subspan(cut, 3), all.subspan(cut + 3)}), whole) << cut;
  EXPECT_NE(find({all.first(999)}), whole);
  EXPECT_NE(find({}), find({std::as_bytes(std::span("", 1))})) << "a byte of zero counts";
  bytes[517] ^= std::byte{1};
  EXPECT_NE(find({all}), whole);
}

}  // namespace
}  // namespace talus
