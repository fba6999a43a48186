// SPDX-License-Identifier: MIT
#pragma once
// Arrays aligned to a cache line, for loads and stores of whole packs and node rows. Only those pages of a large array
// that were written use memory and are copied, so a rank may allocate arrays of the whole body for its part of it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace talus {

/// Allocates zeroed bytes at a cache line. Throws std::bad_alloc.
void* allocate_zeros(std::size_t bytes);
void free_zeros(void* start, std::size_t bytes);
/// From now on, arrays are in small pages. A rank writes only parts of the arrays of the whole body, and a huge page
/// takes its memory with the first of its bytes that is written.
void avoid_huge_pages();
/// Copies the non-zero pages to memory that is zero.
void copy_to_zeros(void* to, const void* from, std::size_t bytes);

/// A subset of std::vector for trivially copyable types.
template <class T>
class AlignedVector {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;
  using iterator = T*;
  using const_iterator = const T*;

  AlignedVector() = default;
  explicit AlignedVector(std::size_t size) { resize(size); }
  AlignedVector(std::size_t size, const T& value) { resize(size, value); }
  AlignedVector(const AlignedVector& other) { append_copy(other); }
  AlignedVector(AlignedVector&& other) noexcept { swap(other); }
  AlignedVector& operator=(const AlignedVector& other) {
    if (this == &other) return *this;
    AlignedVector().swap(*this);  // releases the old memory before new memory is allocated
    append_copy(other);
    return *this;
  }
  AlignedVector& operator=(AlignedVector&& other) noexcept {
    AlignedVector(std::move(other)).swap(*this);
    return *this;
  }
  ~AlignedVector() {
    if (data_ != nullptr) free_zeros(data_, capacity_ * sizeof(T));
  }
  void swap(AlignedVector& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(written_, other.written_);
    std::swap(capacity_, other.capacity_);
  }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  const T* begin() const { return data_; }
  T* end() { return data_ + size_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& front() { return data_[0]; }
  const T& front() const { return data_[0]; }
  T& back() { return data_[size_ - 1]; }
  const T& back() const { return data_[size_ - 1]; }

  bool operator==(const AlignedVector& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

  void clear() { size_ = 0; }
  /// New values are zero; pages that were never written are not touched.
  void resize(std::size_t size) {
    grow(size);
    if (size > size_) std::fill(data_ + size_, data_ + std::max(size_, std::min(size, written_)), T{});
    size_ = size;
    written_ = std::max(written_, size_);
  }
  void resize(std::size_t size, const T& value) {
    const std::size_t before = size_;
    resize(size);
    std::array<std::byte, sizeof(T)> image{}, zero{};  // compares bytes, since -0.0 must be written
    std::memcpy(image.data(), &value, sizeof(T));
    if (size > before && image != zero) std::fill(data_ + before, data_ + size, value);
  }
  void assign(std::size_t size, const T& value) {
    clear();
    resize(size, value);
  }

 private:
  void grow(std::size_t size) {
    if (size <= capacity_) return;
    if (size > SIZE_MAX / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t capacity = data_ == nullptr ? size : std::max(size, 2 * capacity_);
    AlignedVector larger;
    larger.data_ = static_cast<T*>(allocate_zeros(capacity * sizeof(T)));
    larger.capacity_ = capacity;
    larger.size_ = larger.written_ = size_;
    if (size_ > 0) copy_to_zeros(larger.data_, data_, size_ * sizeof(T));
    swap(larger);
  }
  void append_copy(const AlignedVector& other) {
    if (other.empty()) return;
    resize(other.size_);
    copy_to_zeros(data_, other.data_, size_ * sizeof(T));
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t written_ = 0;  ///< all values from here on are zero
  std::size_t capacity_ = 0;
};

}  // namespace talus
