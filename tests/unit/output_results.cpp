// SPDX-License-Identifier: MIT
// The frames of a run: none is lost, the files satisfy VTKHDF and XDMF, and a full disk gives one message.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "output/files/frames_reader.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace {

namespace fs = std::filesystem;
using namespace talus;
using output::Frame;
using output::ResultsReader;
using output::ResultsWriter;

class Results : public testing::Test {
 protected:
  void TearDown() override { fs::permissions(folder_, fs::perms::owner_all); }
  const fs::path folder_ = support::make_scratch("results");
};

/// Frame k has 10 - k points (points leave), and every value encodes its frame, point and component.
Frame make_frame(int k, bool with_mesh = false) {
  Frame frame;
  frame.time = 0.1 * k;
  frame.step = 100 * k;
  frame.stage = k < 3 ? "gravity" : "failure";
  output::Field strain{"deviatoric_strain", "-", 1, {}}, stress{"stress", "Pa", 6, {}},
      velocity{"velocity", "m/s", 3, {}};
  for (int p = 0; p < 10 - k; ++p) {
    for (int d = 0; d < 3; ++d) frame.positions.push_back(p + 0.1 * k + 100 * d);
    frame.ids.push_back(p + k);
    frame.materials.push_back(p % 2);
    strain.values.push_back(std::sin(k + 0.1 * p));
    for (int c = 0; c < 6; ++c) stress.values.push_back(1000 * k + 10 * p + c + 1.0 / 3);
    for (int d = 0; d < 3; ++d) velocity.values.push_back(-k - 0.01 * p - 0.001 * d);
  }
  frame.point_fields = {strain, stress, velocity};
  if (with_mesh)
    frame.mesh = output::MeshFrame{3,
                                   {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
                                   {0, 1, 2, 0, 2, 3},
                                   {{"points_in_element", "-", 1, {1.0 * k, 2.0 * k}}},
                                   {{"mass", "kg", 1, {1, 2, 3, 4.0 + k}}}};
  return frame;
}

void expect_equal(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.stage, b.stage);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.ids, b.ids);
  EXPECT_EQ(a.materials, b.materials);
  ASSERT_EQ(a.point_fields.size(), b.point_fields.size());
  for (std::size_t i = 0; i < a.point_fields.size(); ++i) {
    EXPECT_EQ(a.point_fields[i].name, b.point_fields[i].name);
    EXPECT_EQ(a.point_fields[i].unit, b.point_fields[i].unit);
    EXPECT_EQ(a.point_fields[i].components, b.point_fields[i].components);
    EXPECT_EQ(a.point_fields[i].values, b.point_fields[i].values);
  }
  ASSERT_EQ(a.mesh.has_value(), b.mesh.has_value());
  if (!a.mesh) return;
  EXPECT_EQ(a.mesh->nodes, b.mesh->nodes);
  EXPECT_EQ(a.mesh->elements, b.mesh->elements);
  EXPECT_EQ(a.mesh->element_fields.at(0).values, b.mesh->element_fields.at(0).values);
  EXPECT_EQ(a.mesh->node_fields.at(0).values, b.mesh->node_fields.at(0).values);
}

int run_script(const std::string& script, const fs::path& argument) {
  const std::string command =
      std::string("/usr/bin/python3 " TALUS_SOURCE_DIR "/tests/output/") + script + " '" + argument.string() + "'";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Runs `act` in a child in which no file may grow beyond `bytes`, as on a full disk; returns what it wrote to stderr
/// and the sentence of the Error, whose code must be cannot_write.
template <class Act>
std::pair<std::string, std::string> run_with_full_disk(const fs::path& folder, rlim_t bytes, Act act) {
  const fs::path answer = folder.string() + ".answer", errors = folder.string() + ".stderr";
  const pid_t child = fork();
  if (child == 0) {
    // The result is written before the limit is reached: both files are opened and short.
    std::signal(SIGXFSZ, SIG_IGN);
    if (std::freopen(errors.c_str(), "w", stderr) == nullptr) _exit(9);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    int code = 8;
    try {
      act();
      code = 7;
    } catch (const Error& error) {
      std::ofstream(answer) << error.what();
      code = error.code() == ExitCode::cannot_write ? 0 : 6;
    }
    std::exit(code);  // with the library's own ending: it must stay silent too
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
  const std::pair<std::string, std::string> result{support::read_text(errors), support::read_text(answer)};
  fs::remove(answer);
  fs::remove(errors);
  return result;
}

std::vector<std::string> list_files(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder).string());
  std::ranges::sort(names);
  return names;
}

TEST_F(Results, FramesComeBackBitForBitBeforeAndAfterAssembly) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  for (int k = 0; k < 5; ++k) writer.write(make_frame(k, true));
  for (const bool assembled : {false, true}) {
    if (assembled) writer.finish();
    const ResultsReader reader(folder_);
    ASSERT_EQ(reader.size(), 5);
    EXPECT_EQ(reader.field_names(), (std::vector<std::string>{"deviatoric_strain", "stress", "velocity"}));
    EXPECT_EQ(reader.stages()[2], "gravity");
    EXPECT_EQ(reader.stages()[3], "failure");
    for (int k = 0; k < 5; ++k) expect_equal(reader.read(k), make_frame(k, true));
    EXPECT_EQ(reader.find_nearest(0.21), 2);
  }
  EXPECT_EQ(list_files(folder_),
            (std::vector<std::string>{"mesh.vtkhdf", "mesh.xdmf", "results.vtkhdf", "results.xdmf"}));
}

TEST_F(Results, HoldToTheSpecificationOfVtkHdf) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  for (int k = 0; k < 5; ++k) writer.write(make_frame(k, true));
  writer.finish();
  const int code = run_script("read_with_h5py.py", folder_ / "results.vtkhdf");
  if (code == 77) GTEST_SKIP() << "python3-h5py is not installed: the layout was NOT checked";
  EXPECT_EQ(code, 0);
  EXPECT_EQ(run_script("read_with_h5py.py", folder_ / "mesh.vtkhdf"), 0);
}

TEST_F(Results, OpenInParaViewWithTheirTimesPointsAndValues) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  for (int k = 0; k < 5; ++k) writer.write(make_frame(k, true));
  writer.finish();
  const int code = run_script("open_in_paraview.py", folder_);
  if (code == 77) GTEST_SKIP() << "ParaView is not installed: the XDMF file was NOT opened";
  EXPECT_EQ(code, 0);
}

TEST_F(Results, SurviveAKillInTheMiddleOfARun) {
  const pid_t child = fork();
  if (child == 0) {
    ResultsWriter writer = ResultsWriter::start(folder_);
    for (int k = 0; k < 4; ++k) writer.write(make_frame(k));
    std::ofstream(folder_ / "frames" / "000004.h5.part") << "half a frame";
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(ResultsReader(folder_).size(), 4);
  EXPECT_EQ(output::collect(folder_), 4);
  EXPECT_EQ(list_files(folder_), (std::vector<std::string>{"results.vtkhdf", "results.xdmf"}));
  for (int k = 0; k < 4; ++k) expect_equal(ResultsReader(folder_).read(k), make_frame(k));
}

TEST_F(Results, ResumeFromACheckpointWithoutTheFramesAfterIt) {
  ResultsWriter first = ResultsWriter::start(folder_);
  for (int k = 0; k < 4; ++k) first.write(make_frame(k));
  first.finish();
  ResultsWriter second = ResultsWriter::resume(folder_, 0.15);  // frames 0 and 1 stay
  EXPECT_EQ(second.frame_count(), 2);
  for (int k : {2, 4, 6}) second.write(make_frame(k));
  const std::vector<int> expected{0, 1, 2, 4, 6};
  for (const bool assembled : {false, true}) {
    if (assembled) second.finish();
    const ResultsReader reader(folder_);
    ASSERT_EQ(reader.size(), 5);
    for (int i = 0; i < 5; ++i) expect_equal(reader.read(i), make_frame(expected[static_cast<std::size_t>(i)]));
  }
}

TEST_F(Results, FillAFieldThatAFrameLacksWithNotANumber) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  Frame first = make_frame(0), second = make_frame(1);
  first.point_fields.erase(first.point_fields.begin());  // the strain appears later,
  second.point_fields.pop_back();                        // the velocity goes
  writer.write(first);
  writer.write(second);
  writer.finish();
  const ResultsReader reader(folder_);
  const Frame a = reader.read(0), b = reader.read(1);
  EXPECT_TRUE(std::isnan(output::find(a.point_fields, "deviatoric_strain")->values.at(9)));
  EXPECT_EQ(output::find(b.point_fields, "deviatoric_strain")->values, make_frame(1).point_fields[0].values);
  EXPECT_TRUE(std::isnan(output::find(b.point_fields, "velocity")->values.at(26)));
  EXPECT_EQ(output::find(a.point_fields, "velocity")->values, make_frame(0).point_fields[2].values);
}

TEST_F(Results, OfTwoRunsAreTheSameBytes) {
  std::string contents[2];
  for (std::string& content : contents) {
    ResultsWriter writer = ResultsWriter::start(folder_ / "run");
    for (int k = 0; k < 3; ++k) writer.write(make_frame(k));
    writer.finish();
    content = support::read_text(folder_ / "run" / "results.vtkhdf");
    output::remove_results(folder_ / "run");
  }
  EXPECT_FALSE(contents[0].empty());
  EXPECT_EQ(contents[0], contents[1]);
}

TEST_F(Results, AreNotMixedWithThoseOfAnotherRun) {
  ResultsWriter::start(folder_).write(make_frame(0));
  try {
    ResultsWriter::start(folder_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::folder_exists);
  }
  EXPECT_EQ(ResultsReader(folder_).size(), 1);
}

/// A frame too large for the limit, of numbers that do not compress.
Frame make_large_frame(double time) {
  Frame frame;
  frame.time = time;
  std::uint64_t state = 88172645463325252ull;  // xorshift64
  for (int p = 0; p < 50000; ++p) {
    for (int d = 0; d < 3; ++d) {
      state ^= state << 13, state ^= state >> 7, state ^= state << 17;
      frame.positions.push_back(static_cast<double>(state) * 1e-19);
    }
    frame.ids.push_back(p);
    frame.materials.push_back(0);
  }
  return frame;
}

TEST_F(Results, OnAFullDiskKeepWhatWasWrittenWithOneMessage) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  writer.write(make_frame(0));
  writer.write(make_frame(1));
  const auto [errors, sentence] = run_with_full_disk(folder_, 200 * 1024, [&] { writer.write(make_large_frame(0.5)); });
  EXPECT_EQ(errors, "");
  EXPECT_EQ(sentence, "cannot write '" + (folder_ / "frames/000002.h5").string() +
                          "': File too large; the 2 frames written before are whole");
  EXPECT_EQ(list_files(folder_), (std::vector<std::string>{"frames/000000.h5", "frames/000001.h5"}));
  EXPECT_EQ(output::collect(folder_), 2);
}

TEST_F(Results, OnAFullDiskDuringAssemblyKeepEveryFrame) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  for (int k = 0; k < 3; ++k) writer.write(make_large_frame(0.1 * k));
  const std::vector<std::string> before = list_files(folder_);
  // From nothing at all, over the middle of the data, to the last bytes of the file's tables.
  writer.finish();
  const rlim_t whole = fs::file_size(folder_ / "results.vtkhdf");
  output::remove_results(folder_);
  writer = ResultsWriter::start(folder_);
  for (int k = 0; k < 3; ++k) writer.write(make_large_frame(0.1 * k));
  for (const rlim_t bytes : {rlim_t{1024}, whole / 2, whole - 4096, whole - 1}) {
    const auto [errors, sentence] = run_with_full_disk(folder_, bytes, [&] { writer.finish(); });
    EXPECT_EQ(errors, "") << bytes;
    EXPECT_EQ(sentence, "cannot write '" + (folder_ / "results.vtkhdf").string() +
                            "': File too large; the 3 frames written before are whole")
        << bytes;
    EXPECT_EQ(list_files(folder_), before) << bytes;
  }
  EXPECT_EQ(output::collect(folder_), 3);
}

TEST_F(Results, InAFolderThatCannotBeMadeAreOneSentence) {
  std::ofstream(folder_ / "file") << "no folder";
  try {
    ResultsWriter::start(folder_ / "file" / "run");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::cannot_write);
    EXPECT_EQ(std::string(error.what()),
              "cannot write '" + (folder_ / "file/run/frames").string() + "': Not a directory");
  }
}

TEST_F(Results, InAReadOnlyFolderAreOneSentence) {
  fs::permissions(folder_, fs::perms(0555));
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && setuid(65534) != 0) _exit(3);  // the super-user may write everywhere
    try {
      ResultsWriter::start(folder_);
    } catch (const Error& error) {
      const std::string expected = "cannot write '" + (folder_ / "frames").string() + "': Permission denied";
      _exit(error.code() == ExitCode::cannot_write && error.what() == expected ? 0 : 1);
    }
    _exit(2);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(Results, ThatAreDamagedAreNamed) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  writer.write(make_frame(0));
  writer.finish();
  fs::resize_file(folder_ / "results.vtkhdf", fs::file_size(folder_ / "results.vtkhdf") / 2);
  try {
    ResultsReader reader(folder_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("results.vtkhdf': the file is damaged"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(ResultsReader(folder_ / "nowhere"), Error);
}

TEST_F(Results, WithAnyByteChangedAreTheSameOrRefused) {
  ResultsWriter writer = ResultsWriter::start(folder_);
  for (int k = 0; k < 3; ++k) writer.write(make_frame(k));
  writer.finish();
  const fs::path path = folder_ / "results.vtkhdf";
  std::string bytes(fs::file_size(path), '\0');
  std::ifstream(path, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const std::size_t stride = bytes.size() / 200 | 1;
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); i += stride) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    std::ofstream(path, std::ios::binary) << damaged;
    try {
      const ResultsReader reader(folder_);
      ASSERT_EQ(reader.size(), 3) << "byte " << i;
      for (int k = 0; k < 3; ++k) expect_equal(reader.read(k), make_frame(k));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::wrong_input) << "byte " << i << ": " << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 20);
}

}  // namespace
