// SPDX-License-Identifier: MIT
// The history of a run: every row is in the file, every number is read back exactly, and a resumed run continues
// seamlessly.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "output/files/history.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace {

namespace fs = std::filesystem;
using namespace talus;
using output::History;

const std::vector<output::Column> columns{{"time", "s"}, {"kinetic_energy", "J"}};

class HistoryFile : public testing::Test {
 protected:
  std::string read() const { return support::read_text(path_); }
  const fs::path folder_ = support::make_scratch("history"), path_ = folder_ / "history.csv";
};

TEST_F(HistoryFile, HasEachRowAtOnceInTheShortestDigits) {
  History history = History::start(path_, columns);
  EXPECT_EQ(read(), "time [s],kinetic_energy [J]\n");
  history.append(std::vector<double>{0.1, 1e-300});
  EXPECT_EQ(read(), "time [s],kinetic_energy [J]\n0.1,1e-300\n");
}

TEST_F(HistoryFile, GivesEveryNumberBackExactly) {
  const std::vector<double> values{0.1 + 0.2, 1.0 / 3, std::nextafter(1.0, 2.0), 5e-324, 1.7976931348623157e308, -0.0};
  History history = History::start(path_, columns);
  for (const double v : values) history.append(std::vector<double>{v, -v});
  history.append(
      std::vector<double>{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()});
  const output::HistoryTable table = output::read_history(path_);
  EXPECT_EQ(table.columns.at(1).name, "kinetic_energy");
  EXPECT_EQ(table.columns.at(1).unit, "J");
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(table.values[0].at(i), values[i]);
    EXPECT_EQ(std::signbit(table.values[1].at(i)), !std::signbit(values[i]));
  }
  EXPECT_TRUE(std::isnan(table.values[0].back()));
  EXPECT_TRUE(std::isinf(table.values[1].back()));
}

TEST_F(HistoryFile, OfAResumedRunIsThatOfOneThatNeverStopped) {
  std::string expected;
  {
    History history = History::start(path_, columns);
    for (int i = 0; i < 6; ++i) history.append(std::vector<double>{0.1 * i, 1.0 * i});
    expected = read();
  }
  std::ofstream(path_, std::ios::app) << "0.7,1.2";  // killed while writing
  History history = History::resume(path_, columns);
  history.truncate_after(0.1 * 2);
  for (int i = 3; i < 6; ++i) history.append(std::vector<double>{0.1 * i, 1.0 * i});
  EXPECT_EQ(read(), expected);
}

TEST_F(HistoryFile, WithOtherColumnsIsNotContinued) {
  History::start(path_, columns);
  EXPECT_THROW(History::resume(path_, {{"time", "s"}, {"force", "N"}}), Error);
}

TEST_F(HistoryFile, KeepsItsWholeRowsOnAFullDisk) {
  History history = History::start(path_, columns);
  history.append(std::vector<double>{0.125, 1});
  const std::string before = read();
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{before.size() + 5, before.size() + 5};  // half a row fits
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      history.append(std::vector<double>{0.25, 1.0 / 3});
    } catch (const Error& error) {
      _exit(error.code() == ExitCode::cannot_write ? 0 : 1);
    }
    _exit(2);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read(), before);
}

TEST_F(HistoryFile, NextToItAnyTextIsReplacedInOneGo) {
  const fs::path summary = folder_ / "summary.json";
  write_atomically(summary, std::string("{}"));
  fs::create_directory(temporary_name(summary));
  EXPECT_THROW(write_atomically(summary, std::string("{\"a\":1}")), Error);
  EXPECT_EQ(fs::file_size(summary), 2u);
}

}  // namespace
