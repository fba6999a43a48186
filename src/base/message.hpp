// SPDX-License-Identifier: MIT
#pragma once
// Serialisation of messages between processes of this program.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace talus {

// Byte streams of plain values, texts and arrays, for processes on the same machine.

/// Writes values in order. The reader must read the same types in the same order.
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

/// Reads the bytes of a ByteWriter. Throws std::out_of_range if there are too few.
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

using Bytes = std::vector<std::byte>;

/// A message between ranks; values are read in the order in which they were written.
class Message {
 public:
  Message() = default;
  explicit Message(Bytes bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  void put(const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* from = reinterpret_cast<const std::byte*>(values);
    bytes_.insert(bytes_.end(), from, from + count * sizeof(T));
  }
  template <class T>
  void put(const T& value) {
    put(&value, 1);
  }
  template <class T>
  void put_list(const std::vector<T>& values) {
    put(values.size());
    put(values.data(), values.size());
  }
  template <class T>
  void get(T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(values, bytes_.data() + read_, count * sizeof(T));
    read_ += count * sizeof(T);
  }
  template <class T>
  T get() {
    T value;
    get(&value, 1);
    return value;
  }
  template <class T>
  std::vector<T> get_list() {
    std::vector<T> values(get<std::size_t>());
    get(values.data(), values.size());
    return values;
  }
  void put_text(const std::string& text) {
    put(text.size());
    put(text.data(), text.size());
  }
  std::string get_text() {
    std::string text(get<std::size_t>(), ' ');
    get(text.data(), text.size());
    return text;
  }
  bool is_read() const { return read_ == bytes_.size(); }
  const Bytes& bytes() const { return bytes_; }
  Bytes take() { return std::exchange(bytes_, {}); }

 private:
  Bytes bytes_;
  std::size_t read_ = 0;
};

// Structs are serialised by one list of their members for both directions:
//   template <class Visit> void visit_members(Visit&& visit, Like<MyStruct> auto& s) { visit(s.a, s.b); }
// visit_members() is declared beside the struct. Putting and Taking are visitors; trivially copyable types need no
// list.

template <class T, class Struct>
concept Like = std::is_same_v<std::remove_const_t<T>, Struct>;

class Putting {
 public:
  explicit Putting(Message& message) : message_(message) {}
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      message_.put(value);
    else
      visit_members(*this, value);
  }
  void put(const std::string& text) { message_.put_text(text); }
  template <class T, class A>
  void put(const std::vector<T, A>& list) {
    message_.put(list.size());
    if constexpr (std::is_trivially_copyable_v<T>)
      message_.put(list.data(), list.size());
    else
      for (const T& item : list) put(item);
  }

  Message& message_;
};

class Taking {
 public:
  explicit Taking(Message& message) : message_(message) {}
  template <class... T>
  void operator()(T&... values) {
    (take(values), ...);
  }

 private:
  template <class T>
  void take(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      message_.get(&value, 1);
    else
      visit_members(*this, value);
  }
  void take(std::string& text) { text = message_.get_text(); }
  template <class T, class A>
  void take(std::vector<T, A>& list) {
    list.resize(message_.get<std::size_t>());
    if constexpr (std::is_trivially_copyable_v<T>)
      message_.get(list.data(), list.size());
    else
      for (T& item : list) take(item);
  }

  Message& message_;
};

}  // namespace talus
