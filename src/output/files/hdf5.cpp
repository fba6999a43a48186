// SPDX-License-Identifier: MIT
#include "output/files/hdf5.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <utility>

#include "base/user_file.hpp"

namespace talus::output::hdf5 {
namespace {

std::recursive_mutex& library() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// Size of a chunk, about 256 KiB: small frames remain small, and large ones compress well.
constexpr std::size_t chunk_bytes = 256 * 1024;
/// After the byte shuffle, higher gzip levels cost time and reduce floating-point fields by a few per cent only.
constexpr unsigned gzip_level = 1;

template <class T>
hid_t type_of();
template <>
hid_t type_of<double>() {
  return H5T_IEEE_F64LE;
}
template <>
hid_t type_of<std::int64_t>() {
  return H5T_STD_I64LE;
}
template <>
hid_t type_of<int>() {
  return H5T_STD_I32LE;
}
template <>
hid_t type_of<std::uint8_t>() {
  return H5T_STD_U8LE;
}
static_assert(sizeof(int) == 4);

void require(herr_t status, const std::string& what) {
  if (status < 0) throw Failure(what);
}

Handle make_space(std::span<const hsize_t> extent, const hsize_t* largest = nullptr) {
  return {H5Screate_simple(static_cast<int>(extent.size()), extent.data(), largest), H5Sclose, "a dataspace"};
}

std::vector<hsize_t> extent_of(std::size_t rows, std::size_t columns) {
  std::vector<hsize_t> extent{rows};
  if (columns != 1) extent.push_back(columns);
  return extent;
}

Handle make_text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text type");
  require(H5Tset_size(type, std::max<std::size_t>(length, 1)), "the length of a text");
  require(H5Tset_strpad(type, H5T_STR_NULLPAD), "the padding of a text");
  return type;
}

/// Makes the missing groups in a path.
void make_groups_above(hid_t place, const std::string& name) {
  for (std::size_t slash = name.find('/', 1); slash != std::string::npos; slash = name.find('/', slash + 1))
    if (const std::string group = name.substr(0, slash); !has(place, group)) make_group(place, group);
}

template <class T>
Handle make_dataset(hid_t place, const std::string& name, std::size_t rows, std::size_t columns, bool compress,
                    bool extendable) {
  const std::vector<hsize_t> extent = extent_of(rows, columns);
  std::vector<hsize_t> largest = extent;
  if (extendable) largest[0] = H5S_UNLIMITED;
  const Handle space = make_space(extent, largest.data());
  make_groups_above(place, name);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "a property list");
  require(H5Pset_obj_track_times(properties, false), name);
  if (rows > 0 && columns > 0) {
    std::vector<hsize_t> chunk = extent;
    chunk[0] = std::clamp<std::size_t>(chunk_bytes / (sizeof(T) * columns), 1,
                                       extendable ? std::max<std::size_t>(rows, 64) : rows);
    require(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), name);
    // H5Pset_deflate() makes the filter optional: it would be skipped if its memory cannot be allocated.
    const auto filter = [&](H5Z_filter_t kind, std::span<const unsigned> numbers) {
      require(H5Pset_filter(properties, kind, H5Z_FLAG_MANDATORY, numbers.size(), numbers.data()), name);
    };
    if (compress && sizeof(T) > 1) filter(H5Z_FILTER_SHUFFLE, {});
    if (compress) filter(H5Z_FILTER_DEFLATE, std::span(&gzip_level, 1));
    require(H5Pset_fletcher32(properties), name);
  } else if (extendable) {
    throw Failure(name + " (an extendable dataset needs a first row)");
  }
  return {H5Dcreate2(place, name.c_str(), type_of<T>(), space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose, name};
}

Handle open_dataset(hid_t place, const std::string& name) {
  return {H5Dopen2(place, name.c_str(), H5P_DEFAULT), H5Dclose, name};
}

/// Closes a dataset. The library writes its remaining data then, so a full disk may be detected only here.
void close_written(Handle& dataset, const std::string& name) {
  if (!dataset.close()) throw Failure(name);
}

Shape shape_of(const Handle& dataset, const std::string& name) {
  const Handle space(H5Dget_space(dataset), H5Sclose, name);
  hsize_t extent[2] = {0, 1};
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1 || rank > 2) throw Failure(name + " (neither one- nor two-dimensional)");
  require(H5Sget_simple_extent_dims(space, extent, nullptr), name);
  return {static_cast<std::size_t>(extent[0]), static_cast<std::size_t>(extent[1])};
}

void write_attribute_value(hid_t place, const std::string& object, const std::string& name, hid_t type,
                           const Handle& space, const void* value) {
  const Handle attribute(
      H5Acreate_by_name(place, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, object + "@" + name);
  require(H5Awrite(attribute, type, value), object + "@" + name);
}

Handle open_attribute(hid_t place, const std::string& object, const std::string& name) {
  return {H5Aopen_by_name(place, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
          object + "@" + name};
}

/// Disables time stamps, so that the files of two runs of a case are bitwise identical.
Handle make_file_properties() {
  Handle properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "a property list");
  require(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), "the order of names");
  require(H5Pset_obj_track_times(properties, false), "the times of names");
  return properties;
}

/// Requires the file format of HDF5 1.10, whose structures all have checksums, so that damage is detected.
Handle make_file_access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "a property list");
  require(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST), "the version of the format");
  return access;
}

/// Largest compression ratio of gzip; a file that declares more values is damaged.
constexpr std::size_t most_compression = 1032;

/// Throws Failure if a dataset is declared larger than its `stored` bytes can contain.
void check_size(const Shape& shape, std::size_t value_bytes, std::size_t stored, const std::string& name) {
  const double bytes =
      static_cast<double>(shape.rows) * static_cast<double>(shape.columns) * static_cast<double>(value_bytes);
  if (bytes > static_cast<double>(most_compression) * static_cast<double>(stored))
    throw Failure(name + " (larger than what is stored)");
}

/// Returns the stored bytes of a dataset; for a view those of the whole file.
std::size_t find_stored(const Handle& dataset, const std::string& name) {
  const Handle properties(H5Dget_create_plist(dataset), H5Pclose, name);
  if (H5Pget_layout(properties) != H5D_VIRTUAL) return static_cast<std::size_t>(H5Dget_storage_size(dataset));
  const Handle file(H5Iget_file_id(dataset), H5Fclose, name);
  hsize_t size = 0;
  require(H5Fget_filesize(file, &size), name);
  return static_cast<std::size_t>(size);
}

/// Throws Failure if a chunk of the dataset extends beyond the file.
void look_at_chunks(const Handle& dataset, std::size_t bytes, const std::string& name) {
  const Handle properties(H5Dget_create_plist(dataset), H5Pclose, name);
  if (H5Pget_layout(properties) != H5D_CHUNKED) return;
  const Handle space(H5Dget_space(dataset), H5Sclose, name);
  hsize_t count = 0;
  require(H5Dget_num_chunks(dataset, space, &count), name);
  for (hsize_t i = 0; i < count; ++i) {
    hsize_t offset[H5S_MAX_RANK] = {}, size = 0;
    haddr_t address = 0;
    unsigned filters = 0;
    require(H5Dget_chunk_info(dataset, space, i, offset, &filters, &address, &size), name);
    if (address > bytes || size > bytes - address) throw Failure(name + " (outside of the file)");
  }
}

void look_at_attributes(const Handle& object, const std::string& name) {
  H5O_info_t info;
  require(H5Oget_info1(object, &info), name);
  for (hsize_t i = 0; i < info.num_attrs; ++i)
    const Handle attribute(H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, name);
}

}  // namespace

Guard::Guard() : lock_(library()) {
  // A file that could not be flushed (full disk) remains open in the library, which would retry at exit and print
  // errors to stderr after the program has reported the failure and removed the temporary file.
  static const bool quiet_end = H5dont_atexit() >= 0;
  static_cast<void>(quiet_end);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // the setting is per thread
  errno = 0;
}

Failure::Failure(const std::string& what) : std::runtime_error(what), reason(errno) {
  if (reason == ENOMEM) throw std::bad_alloc();
  refuse_full_file_table(reason);
}

Handle::Handle(hid_t id, Close closer, const std::string& what) : id_(id), close_(closer) {
  if (id < 0) throw Failure(what);
}
Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
Handle& Handle::operator=(Handle&& other) noexcept {
  if (this != &other) {
    close();
    id_ = std::exchange(other.id_, -1);
    close_ = other.close_;
  }
  return *this;
}
bool Handle::close() {
  const hid_t id = std::exchange(id_, -1);
  return id < 0 || close_(id) >= 0;
}

/// Memory of a file, which the library passes to the callback when it closes the file. H5Fget_file_image() would give
/// it before, but resets a flag without an update of its checksum (1.10.8).
struct MemoryFile::Image {
  void* bytes = nullptr;
  ~Image() { std::free(bytes); }

  static void* resize(void* bytes, std::size_t size, H5FD_file_image_op_t, void*) { return std::realloc(bytes, size); }
  static herr_t keep(void* bytes, H5FD_file_image_op_t when, void* image) {
    if (when == H5FD_FILE_IMAGE_OP_FILE_CLOSE)
      static_cast<Image*>(image)->bytes = bytes;
    else
      std::free(bytes);
    return 0;
  }
  static void* share(void* image) { return image; }
  static herr_t forget(void*) { return 0; }
};

MemoryFile::MemoryFile() : image_(std::make_unique<Image>()) {
  const Handle access = make_file_access();
  require(H5Pset_fapl_core(access, 1 << 20, false), "the memory driver");
  H5FD_file_image_callbacks_t calls{};
  calls.image_realloc = Image::resize;
  calls.image_free = Image::keep;
  calls.udata_copy = Image::share;
  calls.udata_free = Image::forget;
  calls.udata = image_.get();
  require(H5Pset_file_image_callbacks(access, &calls), "the memory driver");
  // The library requires a name; no file of this name is written.
  file_ = {H5Fcreate("talus-memory.h5", H5F_ACC_TRUNC, make_file_properties(), access), H5Fclose, "a file in memory"};
}

MemoryFile::~MemoryFile() {
  file_.close();
}

FileImage MemoryFile::take() {
  require(H5Fflush(file_, H5F_SCOPE_GLOBAL), "a file in memory");
  const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
  if (size < 0 || !file_.close() || image_->bytes == nullptr) throw Failure("a file in memory");
  return {std::exchange(image_->bytes, nullptr), static_cast<std::size_t>(size)};
}

Handle create(const std::filesystem::path& path) {
  const Handle access = make_file_access();
  require(H5Pset_file_locking(access, false, true), "the file's locks");
  static_cast<void>(::unlink(path.c_str()));  // a link would be followed; if it remains, the creation reports it
  return {H5Fcreate(path.c_str(), H5F_ACC_EXCL, make_file_properties(), access), H5Fclose, "the file itself"};
}

Handle open(const std::filesystem::path& path) {
  if (const auto fault = find_file_fault(path, largest_file::any)) throw Failure(fault->why);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "a property list");
  require(H5Pset_file_locking(access, false, true), "the file's locks");
  hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  // If this process has already opened the file, as h5py may have done in Python, the lock settings must be the same.
  if (file < 0) file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  return {file, H5Fclose, "the file itself"};
}

template <class T>
void write(hid_t place, const std::string& name, std::span<const T> values, std::size_t columns, bool compress) {
  Handle dataset = make_dataset<T>(place, name, values.size() / columns, columns, compress, false);
  if (!values.empty()) require(H5Dwrite(dataset, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  close_written(dataset, name);
}

template <class T>
void append(hid_t place, const std::string& name, std::span<const T> values, std::size_t columns) {
  const std::size_t rows = values.size() / columns;
  if (!has(place, name)) {
    if (rows == 0) {  // chunked, so that rows can be appended
      const std::vector<T> row(columns);
      append<T>(place, name, row, columns);
      const Handle made = open_dataset(place, name);
      const std::vector<hsize_t> empty = extent_of(0, columns);
      require(H5Dset_extent(made, empty.data()), name);
      return;
    }
    Handle dataset = make_dataset<T>(place, name, rows, columns, true, true);
    require(H5Dwrite(dataset, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
    close_written(dataset, name);
    return;
  }
  if (rows == 0) return;
  Handle dataset = open_dataset(place, name);
  const Shape old = shape_of(dataset, name);
  if (old.columns != columns) throw Failure(name + " (another number of components)");
  const std::vector<hsize_t> extent = extent_of(old.rows + rows, columns), count = extent_of(rows, columns);
  require(H5Dset_extent(dataset, extent.data()), name);
  const Handle file_space(H5Dget_space(dataset), H5Sclose, name);
  const hsize_t start[2] = {old.rows, 0};
  require(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start, nullptr, count.data(), nullptr), name);
  const Handle memory_space = make_space(count);
  require(H5Dwrite(dataset, type_of<T>(), memory_space, file_space, H5P_DEFAULT, values.data()), name);
  close_written(dataset, name);
}

template <class T>
std::vector<T> read(hid_t place, const std::string& name, std::size_t first, std::size_t rows) {
  const Handle dataset = open_dataset(place, name);
  const Shape whole = shape_of(dataset, name);
  if (first > whole.rows || rows > whole.rows - first) throw Failure(name + " (shorter than expected)");
  check_size({rows, whole.columns}, sizeof(T), find_stored(dataset, name), name);
  std::vector<T> values(rows * whole.columns);
  if (values.empty()) return values;
  const Handle file_space(H5Dget_space(dataset), H5Sclose, name);
  const std::vector<hsize_t> count{rows, whole.columns};
  const hsize_t start[2] = {first, 0};
  require(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start, nullptr, count.data(), nullptr), name);
  const Handle memory_space = make_space(std::vector<hsize_t>{rows * whole.columns});
  require(H5Dread(dataset, type_of<T>(), memory_space, file_space, H5P_DEFAULT, values.data()), name);
  return values;
}

template <class T>
std::vector<T> read(hid_t place, const std::string& name) {
  return read<T>(place, name, 0, shape(place, name).rows);
}

#define TALUS_STORED(T)                                                                     \
  template void write<T>(hid_t, const std::string&, std::span<const T>, std::size_t, bool); \
  template void append<T>(hid_t, const std::string&, std::span<const T>, std::size_t);      \
  template std::vector<T> read<T>(hid_t, const std::string&, std::size_t, std::size_t);     \
  template std::vector<T> read<T>(hid_t, const std::string&);
TALUS_STORED(double)
TALUS_STORED(std::int64_t)
TALUS_STORED(int)
TALUS_STORED(std::uint8_t)
#undef TALUS_STORED

void write_view(hid_t place, const std::string& name, const std::string& source, std::size_t first, std::size_t rows) {
  const Handle original = open_dataset(place, source);
  const Handle type(H5Dget_type(original), H5Tclose, source);
  const Handle source_space(H5Dget_space(original), H5Sclose, source);
  const std::vector<hsize_t> extent = extent_of(rows, shape_of(original, source).columns);
  const hsize_t start[2] = {first, 0};
  require(H5Sselect_hyperslab(source_space, H5S_SELECT_SET, start, nullptr, extent.data(), nullptr), source);
  const Handle space = make_space(extent);
  make_groups_above(place, name);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "a property list");
  require(H5Pset_obj_track_times(properties, false), name);
  require(H5Pset_virtual(properties, space, ".", source.c_str(), source_space), name);
  Handle view(H5Dcreate2(place, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose, name);
  close_written(view, name);
}

Shape shape(hid_t place, const std::string& name) {
  return shape_of(open_dataset(place, name), name);
}

void look_at_all(hid_t place, std::size_t bytes, bool with_values) {
  for (const std::string& name : list(place, ".")) {
    const Handle object(H5Oopen(place, name.c_str(), H5P_DEFAULT), H5Oclose, name);
    look_at_attributes(object, name);
    if (H5Iget_type(object) == H5I_GROUP) look_at_all(object, bytes, with_values);
    if (H5Iget_type(object) != H5I_DATASET) continue;
    const Handle dataset = open_dataset(place, name);
    look_at_chunks(dataset, bytes, name);
    const Handle type(H5Dget_type(dataset), H5Tclose, name);
    const std::size_t value_bytes = H5Tget_size(type);
    const Shape shape = shape_of(dataset, name);
    check_size(shape, value_bytes, find_stored(dataset, name), name);
    if (!with_values) continue;
    std::vector<std::byte> values(shape.rows * shape.columns * value_bytes);
    require(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  }
}

bool holds_integers(hid_t place, const std::string& name) {
  const Handle type(H5Dget_type(open_dataset(place, name)), H5Tclose, name);
  return H5Tget_class(type) == H5T_INTEGER;
}

void write_text(hid_t place, const std::string& name, const std::string& text) {
  // Texts are stored as bytes: an HDF5 string cannot contain every byte, and an empty one equals a missing one.
  write<std::uint8_t>(place, name, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, 1, false);
}

std::string read_text(hid_t place, const std::string& name) {
  const std::vector<std::uint8_t> bytes = read<std::uint8_t>(place, name);
  return {bytes.begin(), bytes.end()};
}

void write_attribute(hid_t place, const std::string& object, const std::string& name, const std::string& text) {
  const Handle type = make_text_type(text.size());
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "a dataspace");
  const std::string padded = text.empty() ? std::string(1, '\0') : text;
  write_attribute_value(place, object, name, type, scalar, padded.data());
}

void write_attribute(hid_t place, const std::string& object, const std::string& name,
                     std::span<const std::int64_t> values) {
  const std::vector<hsize_t> extent{values.size()};
  const Handle space = values.size() == 1 ? Handle(H5Screate(H5S_SCALAR), H5Sclose, "a dataspace") : make_space(extent);
  write_attribute_value(place, object, name, H5T_STD_I64LE, space, values.data());
}

void write_attribute(hid_t place, const std::string& object, const std::string& name, double value) {
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "a dataspace");
  write_attribute_value(place, object, name, H5T_IEEE_F64LE, scalar, &value);
}

std::string read_text_attribute(hid_t place, const std::string& object, const std::string& name) {
  const Handle attribute = open_attribute(place, object, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) throw Failure(name + " (not a text)");
  std::string text(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, text.data()), name);
  text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  return text;
}

std::int64_t read_integer_attribute(hid_t place, const std::string& object, const std::string& name) {
  const Handle attribute = open_attribute(place, object, name);
  const Handle space(H5Aget_space(attribute), H5Sclose, name);
  if (H5Sget_simple_extent_npoints(space) != 1) throw Failure(name + " (not one number)");
  std::int64_t value = 0;
  require(H5Aread(attribute, H5T_NATIVE_INT64, &value), name);
  return value;
}

double read_real_attribute(hid_t place, const std::string& object, const std::string& name) {
  const Handle attribute = open_attribute(place, object, name);
  const Handle space(H5Aget_space(attribute), H5Sclose, name);
  if (H5Sget_simple_extent_npoints(space) != 1) throw Failure(name + " (not one number)");
  double value = 0;
  require(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), name);
  return value;
}

void make_group(hid_t place, const std::string& name) {
  const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "a property list");
  require(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), name);
  require(H5Pset_obj_track_times(properties, false), name);
  const Handle group(H5Gcreate2(place, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose, name);
}

bool has(hid_t place, const std::string& name) {
  // H5Lexists requires that all groups in the path exist.
  for (std::size_t slash = name.find('/', 1); slash != std::string::npos; slash = name.find('/', slash + 1))
    if (H5Lexists(place, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  return H5Lexists(place, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> list(hid_t place, const std::string& name) {
  const Handle group(H5Gopen2(place, name.c_str(), H5P_DEFAULT), H5Gclose, name);
  H5G_info_t info;
  require(H5Gget_info(group, &info), name);
  // Files of other programs may lack the creation order.
  const Handle properties(H5Gget_create_plist(group), H5Pclose, name);
  unsigned order = 0;
  require(H5Pget_link_creation_order(properties, &order), name);
  const H5_index_t index = (order & H5P_CRT_ORDER_INDEXED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::array<char, 1024> text{};
    if (H5Lget_name_by_idx(group, ".", index, H5_ITER_INC, i, text.data(), text.size(), H5P_DEFAULT) < 0)
      throw Failure(name);
    names.emplace_back(text.data());
  }
  return names;
}

}  // namespace talus::output::hdf5
