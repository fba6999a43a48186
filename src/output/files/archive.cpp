// SPDX-License-Identifier: MIT
#include "output/files/archive.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/hdf5.hpp"

namespace talus::output {
namespace {

namespace fs = std::filesystem;

const std::string archive_format = "talus archive";
constexpr std::int64_t archive_version = 1;

/// Checksum of names and arrays, each as a sequence of 64-bit words.
class Checksum {
 public:
  void add(const void* data, std::size_t size) {
    const char* bytes = static_cast<const char*>(data);
    for (; size >= 8; size -= 8, bytes += 8) add_word(bytes, 8);
    if (size > 0) add_word(bytes, size);
  }
  void add(const std::string& name, const ArchiveValue& value) {
    add(name.data(), name.size());
    const std::uint64_t kind = value.index();
    add(&kind, sizeof kind);
    std::visit(
        [this](const auto& v) {
          const std::uint64_t size = v.size();
          add(&size, sizeof size);
          add(v.data(), v.size() * sizeof v[0]);
        },
        value);
  }
  std::int64_t value() const { return std::bit_cast<std::int64_t>(state_); }

 private:
  void add_word(const char* bytes, std::size_t size) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, size);
    state_ = mix_word(state_, word);
  }
  std::uint64_t state_ = first_mix;
};

std::int64_t compute_checksum(const std::map<std::string, ArchiveValue>& values) {
  Checksum sum;
  for (const auto& [name, value] : values) sum.add(name, value);
  return sum.value();
}

template <class T>
void store(hid_t file, const std::string& name, const std::vector<T>& v) {
  hdf5::write<T>(file, name, v, 1, false);
}
void store(hid_t file, const std::string& name, const std::string& v) {
  hdf5::write_text(file, name, v);
}

ArchiveValue load(hid_t file, const std::string& name, char kind) {
  if (kind == '0') return hdf5::read<double>(file, name);
  if (kind == '1') return hdf5::read<int>(file, name);
  if (kind == '2') return hdf5::read<std::int64_t>(file, name);
  if (kind == '3') return hdf5::read_text(file, name);
  throw hdf5::Failure("its list of contents");
}

[[noreturn]] void throw_unreadable(const std::string& path, const std::string& why) {
  fail_input("cannot read '{}': {}", path, why);
}

}  // namespace

void ArchiveWriter::add(const std::string& name, ArchiveValue value) {
  if (name.empty() || name.find('\n') != std::string::npos || !values_.emplace(name, std::move(value)).second)
    throw Error(ExitCode::internal_error, "'{}' cannot be put into an archive (again)", name);
}

void ArchiveWriter::put(const std::string& name, std::span<const double> values) {
  add(name, std::vector<double>(values.begin(), values.end()));
}
void ArchiveWriter::put(const std::string& name, std::span<const int> values) {
  add(name, std::vector<int>(values.begin(), values.end()));
}
void ArchiveWriter::put(const std::string& name, std::span<const std::int64_t> values) {
  add(name, std::vector<std::int64_t>(values.begin(), values.end()));
}
void ArchiveWriter::put(const std::string& name, const std::string& text) {
  add(name, text);
}

void ArchiveWriter::write(const fs::path& path) {
  hdf5::FileImage image;
  try {
    const hdf5::Guard guard;
    hdf5::MemoryFile file;
    hdf5::write_attribute(file, ".", "format", archive_format);
    hdf5::write_attribute(file, ".", "version", std::span(&archive_version, 1));
    const std::int64_t checksum = compute_checksum(values_);
    std::string contents;  // one line per array: kind and name
    for (auto& [name, value] : values_) {
      contents += static_cast<char>('0' + static_cast<int>(value.index())) + name + "\n";
      std::visit([&file, &n = name](const auto& v) { store(file, "data/" + n, v); }, value);
      value = ArchiveValue();
    }
    values_.clear();
    hdf5::write_text(file, "contents", contents);
    hdf5::write_attribute(file, ".", "checksum", std::span(&checksum, 1));
    image = file.take();
  } catch (const hdf5::Failure& failure) {
    throw Error(ExitCode::no_memory, "cannot write '{}': HDF5 refused {}, as it does where memory ends", path.string(),
                failure.what());
  }
  write_atomically(path, image.bytes(), fs::exists(path) ? "the one written before is whole" : "");
}

ArchiveReader::ArchiveReader(const fs::path& path) : path_(path.string()) {
  if (!fs::exists(path)) throw_unreadable(path_, "there is no such file");
  examine({path});
  try {
    const hdf5::Guard guard;
    const hdf5::Handle file = hdf5::open(path);
    if (hdf5::read_text_attribute(file, ".", "format") != archive_format)
      throw_unreadable(path_, "it is no checkpoint of this program");
    const std::int64_t version = hdf5::read_integer_attribute(file, ".", "version");
    if (version != archive_version)
      throw_unreadable(path_, fmt::format("its format has version {}, and this program reads version {} only", version,
                                          archive_version));
    const std::string contents = hdf5::read_text(file, "contents");
    for (std::size_t begin = 0; begin < contents.size();) {
      const std::size_t end = std::min(contents.find('\n', begin), contents.size());
      const std::string name = contents.substr(begin + 1, end - begin - 1);
      values_.emplace(name, load(file, "data/" + name, contents[begin]));
      begin = end + 1;
    }
    if (compute_checksum(values_) != hdf5::read_integer_attribute(file, ".", "checksum"))
      throw_unreadable(path_, "its checksum does not fit its contents, the file is damaged");
  } catch (const hdf5::Failure& failure) {
    throw_unreadable(path_, fmt::format("the file is damaged or no checkpoint of this program ({})", failure.what()));
  }
}

template <class T>
const T& ArchiveReader::get(const std::string& name) const {
  const auto it = values_.find(name);
  if (it == values_.end()) throw_unreadable(path_, fmt::format("it holds no '{}'", name));
  const T* value = std::get_if<T>(&it->second);
  if (value == nullptr) throw_unreadable(path_, fmt::format("its '{}' has another type than expected", name));
  return *value;
}
template const std::vector<double>& ArchiveReader::get(const std::string&) const;
template const std::vector<int>& ArchiveReader::get(const std::string&) const;
template const std::vector<std::int64_t>& ArchiveReader::get(const std::string&) const;
template const std::string& ArchiveReader::get(const std::string&) const;

}  // namespace talus::output
