// SPDX-License-Identifier: MIT
#pragma once
// Container of a checkpoint: named arrays that are restored bit by bit. Files with errors are rejected with a message
// that states the reason.

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace talus::output {

using ArchiveValue = std::variant<std::vector<double>, std::vector<int>, std::vector<std::int64_t>, std::string>;

/// Collects named arrays and writes them to one file. Names are unique; a '/' in a name makes groups.
class ArchiveWriter {
 public:
  void put(const std::string& name, std::span<const double> values);
  void put(const std::string& name, std::span<const int> values);
  void put(const std::string& name, std::span<const std::int64_t> values);
  void put(const std::string& name, const std::string& text);
  /// Writes the file atomically; the previous archive remains until then. The arrays are freed during the write, so
  /// that they are in memory only once. Throws Error (cannot_write) with the file and the reason.
  void write(const std::filesystem::path& path);

 private:
  void add(const std::string& name, ArchiveValue value);
  std::map<std::string, ArchiveValue> values_;
};

/// Reads a whole archive and verifies its checksum.
class ArchiveReader {
 public:
  /// Throws Error (wrong_input) if the file is absent, damaged (even by one bit), or of another version of the format.
  explicit ArchiveReader(const std::filesystem::path& path);

  bool has(const std::string& name) const { return values_.contains(name); }
  /// These throw Error (wrong_input) if the name is absent or has another type.
  const std::vector<double>& reals(const std::string& name) const { return get<std::vector<double>>(name); }
  const std::vector<int>& integers(const std::string& name) const { return get<std::vector<int>>(name); }
  const std::vector<std::int64_t>& long_integers(const std::string& name) const {
    return get<std::vector<std::int64_t>>(name);
  }
  const std::string& text(const std::string& name) const { return get<std::string>(name); }

 private:
  template <class T>
  const T& get(const std::string& name) const;
  std::string path_;
  std::map<std::string, ArchiveValue> values_;
};

}  // namespace talus::output
