// SPDX-License-Identifier: MIT
#pragma once
// Serialisation of messages between processes of this program.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace talus {

using Bytes = std::vector<std::byte>;

/// A message between processes on machines of one kind. Values are read in the order in which they were written; get()
/// throws std::out_of_range if there are too few bytes.
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
  void put(const auto& value) { put(&value, 1); }
  template <class T>
  void put_list(const std::vector<T>& values) {
    put(values.size());
    put(values.data(), values.size());
  }
  template <class T>
  void get(T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    check_rest(count, sizeof(T));
    if (count > 0) std::memcpy(values, bytes_.data() + read_, count * sizeof(T));
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
    std::vector<T> values(get_count(sizeof(T)));
    get(values.data(), values.size());
    return values;
  }
  void put_text(const std::string& text) {
    put(text.size());
    put(text.data(), text.size());
  }
  std::string get_text() {
    std::string text(get_count(1), ' ');
    get(text.data(), text.size());
    return text;
  }
  bool is_read() const { return read_ == bytes_.size(); }
  const Bytes& bytes() const { return bytes_; }
  Bytes take() { return std::exchange(bytes_, {}); }

 private:
  void check_rest(std::size_t count, std::size_t size) const {
    if (count > (bytes_.size() - read_) / size) throw std::out_of_range("the bytes end too early");
  }
  /// The count is checked before memory is allocated for it.
  std::size_t get_count(std::size_t size) {
    const auto count = get<std::size_t>();
    check_rest(count, size);
    return count;
  }

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
