// SPDX-License-Identifier: MIT
#pragma once
// The checkpoint's container: named arrays that come back bit for bit, or a sentence that says why they cannot.

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace talus::output {

using ArchiveValue = std::variant<std::vector<double>, std::vector<int>, std::vector<std::int64_t>, std::string>;

/// Collects named arrays and writes them as one file. Names are unique; a '/' in a name makes groups.
class ArchiveWriter {
 public:
  void put(const std::string& name, std::span<const double> values);
  void put(const std::string& name, std::span<const int> values);
  void put(const std::string& name, std::span<const std::int64_t> values);
  void put(const std::string& name, const std::string& text);
  /// Writes the file whole or not at all, and lets the arrays go on the way: they are in memory once. The archive that
  /// was there stays until then. Throws Error (cannot_write) naming the file and the reason.
  void write(const std::filesystem::path& path);

 private:
  void add(const std::string& name, ArchiveValue value);
  std::map<std::string, ArchiveValue> values_;
};

/// Reads an archive whole and checks it.
class ArchiveReader {
 public:
  /// Throws Error (wrong_input) with one sentence when the file is absent, damaged (also by one bit), or of another
  /// version of the format.
  explicit ArchiveReader(const std::filesystem::path& path);

  bool has(const std::string& name) const { return values_.contains(name); }
  /// Throw Error (wrong_input) when there is no such name or it holds another type.
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
