// SPDX-License-Identifier: MIT
// A checkpoint is restored bit by bit, or rejected with a reason.

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "output/files/archive.hpp"
#include "support/scratch.hpp"

namespace {

namespace fs = std::filesystem;
using namespace talus;
using output::ArchiveReader;
using output::ArchiveWriter;

class Archive : public testing::Test {
 protected:
  std::string read_sentence() const {
    try {
      ArchiveReader reader(path_);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::wrong_input);
      return error.what();
    }
    return "no error";
  }
  const fs::path folder_ = support::make_scratch("archive"), path_ = folder_ / "checkpoint.h5";
};

std::vector<std::uint64_t> to_bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double v : values) bits.push_back(std::bit_cast<std::uint64_t>(v));
  return bits;
}

const std::vector<double> odd_values{std::bit_cast<double>(0x7ff8dead00beef01ull),  // a NaN with a payload
                                     std::bit_cast<double>(0xfff0000000000001ull),  // a signalling one
                                     -0.0,
                                     std::numeric_limits<double>::denorm_min(),
                                     -std::numeric_limits<double>::infinity(),
                                     0.1,
                                     1.0 / 3};

void write_sample(const fs::path& path) {
  ArchiveWriter writer;
  writer.put("points/stress", odd_values);
  writer.put("points/ids", std::vector<int>{3, -1, std::numeric_limits<int>::min()});
  writer.put("step", std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::max()});
  writer.put("case", std::string("title = \"ü\"\0\n", 13));
  writer.put("nothing", std::vector<double>{});
  writer.put("silence", std::string());
  writer.write(path);
}

TEST_F(Archive, ComesBackBitForBit) {
  write_sample(path_);
  const ArchiveReader reader(path_);
  EXPECT_EQ(to_bits(reader.reals("points/stress")), to_bits(odd_values));
  EXPECT_EQ(reader.integers("points/ids"), (std::vector<int>{3, -1, std::numeric_limits<int>::min()}));
  EXPECT_EQ(reader.long_integers("step"), (std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::max()}));
  EXPECT_EQ(reader.text("case"), std::string("title = \"ü\"\0\n", 13));
  EXPECT_TRUE(reader.reals("nothing").empty());
  EXPECT_EQ(reader.text("silence"), "");
  EXPECT_FALSE(reader.has("elsewhere"));
  EXPECT_THROW(reader.reals("elsewhere"), Error);
  EXPECT_THROW(reader.reals("step"), Error);
}

TEST_F(Archive, WithOneBitChangedInItsDataIsRefused) {
  ArchiveWriter writer;
  const std::vector<double> values(1000, 1234.5);
  writer.put("values", values);
  writer.write(path_);
  std::string bytes(fs::file_size(path_), '\0');
  std::ifstream(path_, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const std::string pattern(reinterpret_cast<const char*>(values.data()), 8 * values.size());
  const std::size_t data = bytes.find(pattern);
  ASSERT_NE(data, std::string::npos);
  bytes[data + 4321] = static_cast<char>(bytes[data + 4321] ^ 1);
  std::ofstream(path_, std::ios::binary) << bytes;
  EXPECT_NE(read_sentence().find("cannot read '" + path_.string() + "': the file is damaged"), std::string::npos)
      << read_sentence();
}

// The library crashes on some damaged files; then the sentence must come all the same.
TEST_F(Archive, WithAnyByteChangedIsTheSameOrRefused) {
  write_sample(path_);
  std::string bytes(fs::file_size(path_), '\0');
  std::ifstream(path_, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  constexpr std::size_t stride = 23;
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); i += stride) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    std::ofstream(path_, std::ios::binary) << damaged;
    try {
      const ArchiveReader reader(path_);
      EXPECT_EQ(to_bits(reader.reals("points/stress")), to_bits(odd_values)) << "byte " << i;
      EXPECT_EQ(reader.text("case"), std::string("title = \"ü\"\0\n", 13)) << "byte " << i;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::wrong_input) << "byte " << i << ": " << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 10);
}

TEST_F(Archive, ThatIsCutOffOrNoArchiveOrAbsentIsRefused) {
  EXPECT_EQ(read_sentence(), "cannot read '" + path_.string() + "': there is no such file");
  write_sample(path_);
  fs::resize_file(path_, fs::file_size(path_) * 2 / 3);
  EXPECT_NE(read_sentence().find("the file is damaged or no file of this program"), std::string::npos)
      << read_sentence();
  std::ofstream(path_) << "a text";
  EXPECT_NE(read_sentence().find("the file is damaged or no file of this program"), std::string::npos)
      << read_sentence();
}

TEST_F(Archive, OfAnotherVersionIsRefused) {
  write_sample(path_);
  const std::string script =
      "/usr/bin/python3 -c \"import h5py; h5py.File('" + path_.string() + "', 'r+').attrs['version'] = 2\" 2>&1";
  if (std::system(script.c_str()) != 0) GTEST_SKIP() << "python3-h5py is not installed: the case was NOT tested";
  EXPECT_EQ(read_sentence(),
            "cannot read '" + path_.string() + "': its format has version 2, and this program reads version 1 only");
}

TEST_F(Archive, ThatCannotBeWrittenLeavesTheOneBefore) {
  write_sample(path_);
  fs::create_directory(path_.string() + ".part");  // the temporary name is taken by a folder
  EXPECT_THROW(write_sample(path_), Error);
  EXPECT_EQ(ArchiveReader(path_).reals("points/stress").size(), odd_values.size());
}

}  // namespace
