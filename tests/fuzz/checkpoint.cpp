// SPDX-License-Identifier: MIT
// Fuzz target: the archive of a checkpoint.
#include "output/files/archive.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto& path = talus::fuzz::as_file({data, size}, "checkpoint.h5");
  talus::fuzz::try_to([&] { const talus::output::ArchiveReader archive(path); });
  return 0;
}
