// SPDX-License-Identifier: MIT
#pragma once
// The only file that knows the HDF5 library: handles that close themselves, arrays in and out, errors as sentences.
// Included by .cpp files of this floor only, so that users of the library need no HDF5 headers.

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace talus::output::hdf5 {

/// Debian's HDF5 is not thread-safe: one Guard is held, as the first local variable, wherever the library is used.
/// It also keeps the library's error stack off stderr. Guards may nest in one thread.
class Guard {
 public:
  Guard();

 private:
  std::lock_guard<std::recursive_mutex> lock_;
};

/// An HDF5 identifier, closed when it goes.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  /// Takes over `id`; throws Failure(what) when it is negative.
  Handle(hid_t id, Close close, const std::string& what);
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle() { close(); }
  operator hid_t() const { return id_; }
  /// False when the library could not flush what it held.
  bool close();

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// A refusal of the library; callers turn it into an Error that names the file. `reason` is errno, or 0. Where memory
/// has ended, std::bad_alloc is thrown instead.
struct Failure : std::runtime_error {
  explicit Failure(const std::string& what);
  int reason;
};

/// The bytes of a file.
class FileImage {
 public:
  FileImage() = default;
  /// Takes over what std::malloc gave.
  FileImage(void* bytes, std::size_t size) : bytes_(bytes, std::free), size_(size) {}
  std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(bytes_.get()), size_}; }

 private:
  std::unique_ptr<void, void (*)(void*)> bytes_{nullptr, std::free};
  std::size_t size_ = 0;
};

/// A new file in memory that never touches the disk.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  operator hid_t() const { return file_; }
  /// Closes the file and gives its bytes.
  FileImage take();

 private:
  struct Image;
  std::unique_ptr<Image> image_;
  Handle file_;
};
/// A new file on disk, for what may not fit into memory.
Handle create(const std::filesystem::path& path);
/// An existing file, for reading, without locks: published files never change.
Handle open(const std::filesystem::path& path);

/// T below is double, std::int64_t, int or std::uint8_t, stored as itself (little-endian), bit for bit, with a
/// checksum. A one-dimensional dataset, or one with rows of `columns` values; missing groups of `name` are made.
template <class T>
void write(hid_t place, const std::string& name, std::span<const T> values, std::size_t columns = 1,
           bool compress = true);
/// Adds rows at the end of a compressed dataset, which is made when it is not there.
template <class T>
void append(hid_t place, const std::string& name, std::span<const T> values, std::size_t columns = 1);
/// Rows [first, first + rows) of a dataset; throws Failure when they are not all there.
template <class T>
std::vector<T> read(hid_t place, const std::string& name, std::size_t first, std::size_t rows);
template <class T>
std::vector<T> read(hid_t place, const std::string& name);

/// A dataset `name` without values of its own: it shows rows [first, first + rows) of the dataset `source`.
void write_view(hid_t place, const std::string& name, const std::string& source, std::size_t first, std::size_t rows);

/// Rows and values per row of a dataset (1 when it is one-dimensional).
struct Shape {
  std::size_t rows = 0;
  std::size_t columns = 1;
};
Shape shape(hid_t place, const std::string& name);
bool holds_integers(hid_t place, const std::string& name);

/// Opens every group, data set and attribute of a file of `bytes` bytes, finds where the values stand and, with
/// `with_values`, reads them. Throws Failure; the library may also crash where the file is damaged.
void look_at_all(hid_t file, std::size_t bytes, bool with_values);

void write_text(hid_t place, const std::string& name, const std::string& text);
std::string read_text(hid_t place, const std::string& name);
/// Attributes of the object `object` ("." for `place` itself).
void write_attribute(hid_t place, const std::string& object, const std::string& name, const std::string& text);
void write_attribute(hid_t place, const std::string& object, const std::string& name,
                     std::span<const std::int64_t> values);
void write_attribute(hid_t place, const std::string& object, const std::string& name, double value);
std::string read_text_attribute(hid_t place, const std::string& object, const std::string& name);
std::int64_t read_integer_attribute(hid_t place, const std::string& object, const std::string& name);
double read_real_attribute(hid_t place, const std::string& object, const std::string& name);

void make_group(hid_t place, const std::string& name);
bool has(hid_t place, const std::string& name);
/// Names of the datasets and groups directly in the group `name`, in the order in which they were made.
std::vector<std::string> list(hid_t place, const std::string& name);

}  // namespace talus::output::hdf5
