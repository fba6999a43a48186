// SPDX-License-Identifier: MIT
#pragma once
// Plain values, texts and arrays one after the other in memory: what one process of this program hands to another.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace talus {

/// Writes values in order. The reader must ask for the same types in the same order.
class ByteWriter {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(&value, sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(static_cast<std::uint64_t>(values.size()));
    add(values.data(), values.size() * sizeof(T));
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    add(text.data(), text.size());
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  void add(const void* data, std::size_t size) {
    const std::byte* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::byte> bytes_;
};

/// Reads what a ByteWriter wrote. Throws std::out_of_range where the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}
  template <class T>
  T take() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    std::memcpy(&value, take_bytes(1, sizeof value), sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> take_array() {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t count = take<std::uint64_t>();
    const std::byte* first = take_bytes(count, sizeof(T));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), first, count * sizeof(T));
    return values;
  }
  std::string take_text() {
    const std::vector<char> letters = take_array<char>();
    return {letters.begin(), letters.end()};
  }
  bool is_empty() const { return rest_.empty(); }

 private:
  const std::byte* take_bytes(std::uint64_t count, std::size_t size) {
    if (count > rest_.size() / size) throw std::out_of_range("the bytes end too early");
    const std::byte* first = rest_.data();
    rest_ = rest_.subspan(count * size);
    return first;
  }
  std::span<const std::byte> rest_;
};

}  // namespace talus
