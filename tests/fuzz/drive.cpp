// SPDX-License-Identifier: MIT
// Drives a target without libFuzzer, with every given file and then with mutated copies, which are the same on every
// machine for the same number n.
//
// Usage: fuzz_NAME [-runs=N] [-from=N] [-artifact_prefix=PATH] FILE_OR_FOLDER …
//
// The input that ends the process is in PATHcrash. Options in common with libFuzzer have its names.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "target.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;
namespace fs = std::filesystem;

Bytes current;
std::string keep = "crash";

void keep_and_die(int signal) {
  if (std::FILE* file = std::fopen(keep.c_str(), "wb")) {
    std::fwrite(current.data(), 1, current.size(), file);
    std::fclose(file);
    std::fprintf(stderr, "signal %d; the input is in %s\n", signal, keep.c_str());
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

Bytes read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Numbers below `count`, equal on every machine: the distributions of the library are not.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  std::size_t below(std::size_t count) { return count == 0 ? 0 : engine_() % count; }

 private:
  std::mt19937_64 engine_;
};

/// Texts and numbers that readers often fail on.
const std::vector<std::string> words{"-1",
                                     "1e999",
                                     "nan",
                                     "inf",
                                     "0",
                                     "1e-300",
                                     "99999999999999999999",
                                     "\"",
                                     "[",
                                     "]",
                                     "{",
                                     "}",
                                     "=",
                                     "\n",
                                     "\xff",
                                     "''''",
                                     "a.b.c",
                                     "null",
                                     "-0.0",
                                     ",",
                                     ";",
                                     "#",
                                     std::string(8, '\0'),
                                     std::string(8, '\xff')};

void change(Bytes& bytes, const std::vector<Bytes>& all, Chance& chance) {
  const std::size_t at = chance.below(bytes.size() + 1),
                    count = 1 + chance.below(std::min<std::size_t>(64, bytes.size() + 1));
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  const std::size_t here = std::min(count, bytes.size() - at);
  switch (chance.below(6)) {
    case 0:
      if (at < bytes.size()) bytes[at] ^= static_cast<std::uint8_t>(1u << chance.below(8));
      break;
    case 1:
      if (at < bytes.size()) bytes[at] = static_cast<std::uint8_t>(chance.below(256));
      break;
    case 2:
      bytes.erase(place, place + static_cast<std::ptrdiff_t>(here));
      break;
    case 3: {  // repeats the bytes at this place
      const Bytes part(place, place + static_cast<std::ptrdiff_t>(here));
      bytes.insert(place, part.begin(), part.end());
      break;
    }
    case 4: {
      const std::string& word = words[chance.below(words.size())];
      bytes.insert(place, word.begin(), word.end());
      break;
    }
    default: {  // the rest of another file
      const Bytes& other = all[chance.below(all.size())];
      const auto from = static_cast<std::ptrdiff_t>(chance.below(other.size() + 1));
      bytes.erase(place, bytes.end());
      bytes.insert(bytes.end(), other.begin() + from, other.end());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t runs = 0, from = 0;
  std::vector<fs::path> paths;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.rfind("-runs=", 0) == 0)
      runs = std::stoull(word.substr(6));
    else if (word.rfind("-from=", 0) == 0)
      from = std::stoull(word.substr(6));
    else if (word.rfind("-artifact_prefix=", 0) == 0)
      keep = word.substr(17) + "crash";
    else if (fs::is_directory(word))
      for (const auto& entry : fs::recursive_directory_iterator(word)) {
        if (entry.is_regular_file()) paths.push_back(entry.path());
      }
    else
      paths.emplace_back(word);
  }
  std::sort(paths.begin(), paths.end());
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, keep_and_die);
  std::vector<Bytes> all;
  for (const fs::path& path : paths) {
    all.push_back(current = read(path));
    LLVMFuzzerTestOneInput(current.data(), current.size());
  }
  if (all.empty()) all.emplace_back();
  for (std::uint64_t n = from; n < from + runs; ++n) {
    Chance chance(n);
    current = all[chance.below(all.size())];
    for (std::size_t changes = 1 + chance.below(6); changes > 0; --changes) change(current, all, chance);
    LLVMFuzzerTestOneInput(current.data(), current.size());
  }
  std::printf("%zu files and %llu changed ones\n", paths.size(), static_cast<unsigned long long>(runs));
  return 0;
}
