// SPDX-License-Identifier: MIT
#pragma once
// Interface to the HDF5 library: RAII handles, input and output of arrays, errors as exceptions. Only .cpp files of
// this module include it, so that users of the module need no HDF5 headers.

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

/// HDF5 of Debian is not thread-safe. A Guard, as the first local variable, is required wherever the library is used.
/// It also disables the output of the library to stderr. Guards may be nested in one thread.
class Guard {
 public:
  Guard();

 private:
  std::lock_guard<std::recursive_mutex> lock_;
};

/// An HDF5 identifier that is closed by the destructor.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  /// Takes ownership of `id`; throws Failure(what) if it is negative.
  Handle(hid_t id, Close close, const std::string& what);
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle() { close(); }
  operator hid_t() const { return id_; }
  /// Returns false if the library could not flush its data.
  bool close();

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// An error of the library, which callers convert to an Error with the name of the file. `reason` is errno, or 0. If
/// memory is exhausted, std::bad_alloc is thrown instead.
struct Failure : std::runtime_error {
  explicit Failure(const std::string& what);
  int reason;
};

class FileImage {
 public:
  FileImage() = default;
  /// Takes ownership of memory from std::malloc.
  FileImage(void* bytes, std::size_t size) : bytes_(bytes, std::free), size_(size) {}
  std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(bytes_.get()), size_}; }

 private:
  std::unique_ptr<void, void (*)(void*)> bytes_{nullptr, std::free};
  std::size_t size_ = 0;
};

/// A new file in memory, never written to disk.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  operator hid_t() const { return file_; }
  /// Closes the file and returns its bytes.
  FileImage take();

 private:
  struct Image;
  std::unique_ptr<Image> image_;
  Handle file_;
};
/// Creates a file on disk, for content that may exceed the memory.
Handle create(const std::filesystem::path& path);
/// Opens a file for reading without locks, since published files never change.
Handle open(const std::filesystem::path& path);

/// Writes a dataset, one-dimensional or with rows of `columns` values, and makes the missing groups of `name`. T is
/// double, std::int64_t, int or std::uint8_t, here and below; values are stored exactly, little-endian and with a
/// checksum.
template <class T>
void write(hid_t place, const std::string& name, std::span<const T> values, std::size_t columns = 1,
           bool compress = true);
/// Appends rows to a compressed dataset, which is made if it does not exist.
template <class T>
void append(hid_t place, const std::string& name, std::span<const T> values, std::size_t columns = 1);
/// Reads the rows [first, first + rows) of a dataset; throws Failure if it has fewer.
template <class T>
std::vector<T> read(hid_t place, const std::string& name, std::size_t first, std::size_t rows);
template <class T>
std::vector<T> read(hid_t place, const std::string& name);

/// Makes a virtual dataset `name` of the rows [first, first + rows) of the dataset `source`.
void write_view(hid_t place, const std::string& name, const std::string& source, std::size_t first, std::size_t rows);

/// Number of rows, and of values per row (1 for a one-dimensional dataset).
struct Shape {
  std::size_t rows = 0;
  std::size_t columns = 1;
};
Shape shape(hid_t place, const std::string& name);
bool holds_integers(hid_t place, const std::string& name);

/// Opens every group, dataset and attribute of a file of `bytes` bytes, checks the positions of the values and, with
/// `with_values`, reads them. Throws Failure; the library may also crash on a damaged file.
void look_at_all(hid_t file, std::size_t bytes, bool with_values);

void write_text(hid_t place, const std::string& name, const std::string& text);
std::string read_text(hid_t place, const std::string& name);
/// Write and read attributes of `object` ("." for `place` itself).
void write_attribute(hid_t place, const std::string& object, const std::string& name, const std::string& text);
void write_attribute(hid_t place, const std::string& object, const std::string& name,
                     std::span<const std::int64_t> values);
void write_attribute(hid_t place, const std::string& object, const std::string& name, double value);
std::string read_text_attribute(hid_t place, const std::string& object, const std::string& name);
std::int64_t read_integer_attribute(hid_t place, const std::string& object, const std::string& name);
double read_real_attribute(hid_t place, const std::string& object, const std::string& name);

void make_group(hid_t place, const std::string& name);
bool has(hid_t place, const std::string& name);
/// Returns the names of the datasets and groups in the group `name`, in order of their creation.
std::vector<std::string> list(hid_t place, const std::string& name);

}  // namespace talus::output::hdf5
