// SPDX-License-Identifier: MIT
#include "output/files/examine.hpp"

#include <fmt/format.h>

#include <new>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "output/files/hdf5.hpp"

namespace talus::output {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_damaged(const fs::path& path, const std::string& what) {
  throw Error(
      ExitCode::wrong_input,
      fmt::format("cannot read '{}': the file is damaged or no file of this program ({})", path.string(), what));
}

/// What a child process does. It is a copy of this one, and this one holds the library: no Guard is needed there.
void look_at(const fs::path& path, Depth depth) {
  try {
    const hdf5::Handle file = hdf5::open(path);
    hdf5::look_at_all(file, static_cast<std::size_t>(fs::file_size(path)), depth == Depth::values);
  } catch (const hdf5::Failure& failure) {
    throw_damaged(path, failure.what());
  } catch (const std::bad_alloc&) {  // a size in the file is wrong
    throw_damaged(path, "it asks for more memory than there is");
  }
}

/// The processor's time that no look at whole files takes [s]: HDF5 goes round in circles in some that are damaged.
double find_longest_look(const std::vector<fs::path>& files) {
  double bytes = 0;
  for (const fs::path& path : files) bytes += static_cast<double>(fs::file_size(path));
  return 10 + bytes / 1e6;
}

void look_in_child(const std::vector<fs::path>& files, Depth depth) {
  const double longest = find_longest_look(files);
  do_in_child("the results were examined", [&](ByteWriter&) {
    limit_processor_time(longest);
    for (const fs::path& path : files) look_at(path, depth);
  });
}

}  // namespace

void examine(const std::vector<fs::path>& files, Depth depth) {
  std::vector<fs::path> there;
  for (const fs::path& path : files)
    if (fs::is_regular_file(path)) there.push_back(path);
  if (there.empty()) return;
  const hdf5::Guard guard;
  try {
    look_in_child(there, depth);
  } catch (const ChildCrash& first) {
    const auto refuse = [](const fs::path& path, const ChildCrash& crash) {
      throw_damaged(path, fmt::format("HDF5 cannot read it: {}", crash.what()));
    };
    if (there.size() == 1) refuse(there.front(), first);
    for (const fs::path& path : there) {
      try {
        look_in_child({path}, depth);
      } catch (const ChildCrash& crash) {
        refuse(path, crash);
      }
    }
  }
}

}  // namespace talus::output
