// SPDX-License-Identifier: MIT
// Fuzz target: the frames of a run, which are examined in a child process and read.
#include "output/files/frames_reader.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto& path = talus::fuzz::as_file({data, size}, "results.vtkhdf");
  talus::fuzz::try_to([&] {
    const talus::output::ResultsReader reader(path.parent_path());
    reader.read(reader.size() - 1);
  });
  return 0;
}
