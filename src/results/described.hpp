// SPDX-License-Identifier: MIT
#pragma once
// Types of results as values, so that a visitor of described structs is an ordinary class that is compiled once. A
// description passes each member by its address and by the Type that tells what stands there.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/json_tree.hpp"
#include "results/about.hpp"

namespace talus::results {

class Visitor;

enum class Shape { boolean, integer, number, text, word, tree, optional, list, array, map, structure };

/// Describes a type to visitors. Functions that belong to another shape are null.
struct Type {
  Shape shape = Shape::structure;
  std::string_view name;        ///< of a word or a structure, without its namespace
  const Type* inner = nullptr;  ///< of what an optional, a list, an array or a map holds

  // integer
  bool is_signed = true;
  std::int64_t (*get_integer)(const void*) = nullptr;  ///< the same bits if it is unsigned
  void (*set_integer)(void*, std::int64_t) = nullptr;

  // word
  const char* const* words = nullptr;
  std::size_t word_count = 0;
  std::size_t (*get_word)(const void*) = nullptr;  ///< position in `words`
  void (*set_word)(void*, std::size_t) = nullptr;

  // optional
  void* (*get_held)(void*) = nullptr;  ///< null if it is empty
  void* (*emplace)(void*) = nullptr;
  void (*reset)(void*) = nullptr;

  // list and array
  std::size_t (*get_size)(const void*) = nullptr;
  void* (*get_entry)(void*, std::size_t) = nullptr;
  void (*resize)(void*, std::size_t) = nullptr;  ///< to as many default entries; null for an array

  // map
  void (*for_each)(void*, const std::function<void(const std::string&, void*)>&) = nullptr;
  void* (*insert)(void*, const std::string&) = nullptr;
  void (*clear)(void*) = nullptr;

  // structure
  void (*describe)(Visitor&, void*) = nullptr;
  std::shared_ptr<void> (*make)() = nullptr;  ///< makes one in its default state

  /// Returns true for a value without parts.
  bool is_plain() const { return shape <= Shape::word; }
};

/// Address and type of a value. A visitor that only reads does not change what stands at the address, which may be
/// const.
struct Value {
  void* at;
  const Type* type;

  bool is_null() const { return at == nullptr; }
  Shape shape() const { return type->shape; }
  bool get_boolean() const { return *static_cast<const bool*>(at); }
  double& get_number() const { return *static_cast<double*>(at); }
  std::string& get_text() const { return *static_cast<std::string*>(at); }
  std::int64_t get_integer() const { return type->get_integer(at); }
  /// Returns the word of an enumerator.
  const char* get_word() const {
    const std::size_t i = type->get_word(at);
    return i < type->word_count ? type->words[i] : "";
  }
  /// Returns the value of an optional; null if there is none.
  Value get_held() const { return {type->get_held(at), type->inner}; }
  std::size_t get_size() const { return type->get_size(at); }
  Value get_entry(std::size_t i) const { return {type->get_entry(at, i), type->inner}; }
  void describe(Visitor& v) const { type->describe(v, at); }
};

template <class T>
consteval Type make_type();

/// The type of T, one object in the whole program.
template <class T>
inline constexpr Type type = make_type<T>();

template <class T>
Value make_value(const T& value) {
  return {const_cast<T*>(&value), &type<T>};
}

/// A visitor of described structs. Descriptions call key(), maybe(), derived() and merge().
class Visitor {
 public:
  virtual ~Visitor() = default;

  template <class T>
  void key(const char* name, const T& member, const About& about) {
    visit({name, about, Presence::always}, make_value(member));
  }
  template <class T>
  void maybe(const char* name, const std::optional<T>& member, const About& about) {
    visit({name, about, Presence::if_given}, make_value(member));
  }
  /// A value that follows from other members; readers ignore it.
  template <class T>
  void derived(const char* name, const T& value, const About& about) {
    visit({name, about, Presence::derived}, make_value(value));
  }
  /// Visits the keys of a block beside those of its owner.
  template <class T>
  void merge(const char* sign, const std::optional<T>& block) {
    visit_merged(sign, make_value(block));
  }

 protected:
  enum class Presence { always, if_given, derived };
  struct Key {
    const char* name;
    const About& about;
    Presence presence;
  };

  virtual void visit(const Key& key, Value value) = 0;
  virtual void visit_merged(const char* sign, Value block) = 0;
};

// How types are made.

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t N>
inline constexpr bool is_array<std::array<T, N>> = true;
template <class T>
inline constexpr bool is_map = false;
template <class T>
inline constexpr bool is_map<std::map<std::string, T>> = true;

/// Returns the name of the type T without its namespace.
template <class T>
consteval std::string_view name_type() {
  const std::string_view text = __PRETTY_FUNCTION__;  // "… [with T = talus::results::Circle; …]"
  const std::size_t from = text.find("T = ") + 4;
  const std::string_view name = text.substr(from, text.find_first_of(";]", from) - from);
  return name.substr(name.rfind(':') + 1);
}

template <class T>
consteval Type make_type() {
  Type made;
  if constexpr (std::is_same_v<T, JsonTree>) {
    made.shape = Shape::tree;
  } else if constexpr (std::is_same_v<T, bool>) {
    made.shape = Shape::boolean;
  } else if constexpr (std::is_integral_v<T>) {
    made.shape = Shape::integer;
    made.is_signed = std::is_signed_v<T>;
    made.get_integer = [](const void* at) { return static_cast<std::int64_t>(*static_cast<const T*>(at)); };
    made.set_integer = [](void* at, std::int64_t value) { *static_cast<T*>(at) = static_cast<T>(value); };
  } else if constexpr (std::is_same_v<T, double>) {
    made.shape = Shape::number;
  } else if constexpr (std::is_same_v<T, std::string>) {
    made.shape = Shape::text;
  } else if constexpr (std::is_enum_v<T>) {
    made.shape = Shape::word;
    made.name = name_type<T>();
    made.words = words<T>.data();
    made.word_count = words<T>.size();
    made.get_word = [](const void* at) { return static_cast<std::size_t>(*static_cast<const T*>(at)); };
    made.set_word = [](void* at, std::size_t i) { *static_cast<T*>(at) = static_cast<T>(i); };
  } else if constexpr (is_optional<T>) {
    made.shape = Shape::optional;
    made.inner = &type<typename T::value_type>;
    made.get_held = [](void* at) -> void* {
      T& value = *static_cast<T*>(at);
      return value ? &*value : nullptr;
    };
    made.emplace = [](void* at) -> void* { return &static_cast<T*>(at)->emplace(); };
    made.reset = [](void* at) { static_cast<T*>(at)->reset(); };
  } else if constexpr (is_vector<T> || is_array<T>) {
    made.shape = is_vector<T> ? Shape::list : Shape::array;
    made.inner = &type<typename T::value_type>;
    if constexpr (is_array<T>)
      made.get_size = [](const void* /*at*/) { return std::tuple_size_v<T>; };
    else
      made.get_size = [](const void* at) { return static_cast<const T*>(at)->size(); };
    made.get_entry = [](void* at, std::size_t i) -> void* { return &(*static_cast<T*>(at))[i]; };
    if constexpr (is_vector<T>) made.resize = [](void* at, std::size_t size) { *static_cast<T*>(at) = T(size); };
  } else if constexpr (is_map<T>) {
    made.shape = Shape::map;
    made.inner = &type<typename T::mapped_type>;
    made.for_each = [](void* at, const std::function<void(const std::string&, void*)>& act) {
      for (auto& [name, entry] : *static_cast<T*>(at)) act(name, &entry);
    };
    made.insert = [](void* at, const std::string& name) -> void* { return &(*static_cast<T*>(at))[name]; };
    made.clear = [](void* at) { static_cast<T*>(at)->clear(); };
  } else {
    static_assert(std::is_class_v<T>, "a result is of a type that has a Shape");
    made.shape = Shape::structure;
    made.name = name_type<T>();
    made.describe = [](Visitor& v, void* at) { describe(v, *static_cast<T*>(at)); };
    made.make = []() -> std::shared_ptr<void> { return std::make_shared<T>(); };
  }
  return made;
}

}  // namespace talus::results
