// SPDX-License-Identifier: MIT
#pragma once
// The visitor of the blocks of a case. Each block has one function
//
// void describe(Visitor& v, Surcharge& s) {
//   v.key("pressure", s.pressure, quantity("kPa").at_least(0).required().example("10"), "Pressure on the ground.");
// }
//
// which declares each key once. The reader, the manual, the JSON Schema, the template and the echo are visitors of that
// function. A member is passed by its address, with what converts its type (codec.hpp).

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "input/language/spec.hpp"

namespace talus::input {

struct Decoding;
class Visitor;

/// The words of an enumeration for a key that holds one or a list of them.
struct WordTable {
  struct Word {
    const char *word, *meaning;
  };
  std::vector<Word> (*list)();
  std::vector<std::size_t> (*get)(const void* value);  ///< positions of the words of a value
  void (*set)(void* value, const std::vector<std::size_t>& positions);
  bool is_list;
};

/// How the values of one type of key are converted; `self` is the conversion itself.
struct KeyType {
  /// Reads a TOML node into the value (SI units, radians); returns false and adds a finding if it cannot.
  bool (*decode)(const KeyType& self, const Decoding& in, void* out);
  /// Returns the value as JSON in the unit of the manual.
  nlohmann::json (*encode)(const KeyType& self, const void* value, const Spec& spec);
  /// Describes the notation: "number", "number [kPa] or text with unit".
  std::string (*name)(const KeyType& self, const Spec& spec);
  /// Returns the JSON Schema of the notation.
  nlohmann::json (*schema)(const KeyType& self, const Spec& spec);

  WordTable words{};  ///< of an enumeration; null for other types

  // A value that may be absent.
  const KeyType* inner = nullptr;
  const void* (*get_held)(const void*) = nullptr;  ///< null if it is absent
  void* (*emplace)(void*) = nullptr;

  // A single number, which a study can vary.
  std::optional<double> (*get_number)(const void*) = nullptr;
  void (*set_number)(void*, double) = nullptr;
  bool is_per_cent = false;  ///< stored in per cent, whatever the unit
};

/// Returns the conversion of a type that has a Codec (codec.hpp, codec_types.hpp), where the list of these types is.
template <class T>
const KeyType& find_key_type();

/// The value of a key.
struct Member {
  void* at;
  const KeyType& type;

  bool decode(const Decoding& in) const { return type.decode(type, in, at); }
};

/// Blocks of one name: one, one or none, a list, or one for each name that the user chooses. Functions that do not
/// apply are null.
struct Blocks {
  void* at;
  void (*describe)(Visitor&, void* block);
  std::shared_ptr<void> (*make)();       ///< makes a block in its default state
  std::size_t (*get_size)(const void*);  ///< 0 or 1 for one or none
  void (*resize)(void*, std::size_t);    ///< keeps no block of one or none
  void* (*get)(void*, std::size_t i);
  std::vector<std::string> (*list_names)(const void*);
  void* (*find)(void*, const std::string& name);  ///< adds the block of a new name
};

/// Values under names that the user chooses.
struct Entries {
  void* at;
  const KeyType& type;
  std::shared_ptr<void> (*make)();
  std::vector<std::string> (*list_names)(const void*);
  void* (*find)(void*, const std::string& name);  ///< adds the value of a new name
  void (*set)(void*, const std::string& name, const void* value);
};

template <class T>
const KeyType& get_key_type();

class Visitor {
 public:
  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;
  virtual ~Visitor() = default;

  template <class T>
  void key(const char* name, T&& member, const Spec& spec, const char* meaning) {
    visit_key(name, {&member, get_key_type<std::remove_cvref_t<T>>()}, spec, meaning);
  }
  /// A block that is always there.
  template <class T>
  void table(const char* name, T&& block, const char* meaning) {
    using B = std::remove_cvref_t<T>;
    visit_table(name, make_blocks<B>(&block), meaning);
  }
  template <class T>
  void optional_table(const char* name, std::optional<T>& block, const char* meaning) {
    Blocks blocks = make_blocks<T>(&block);
    blocks.get_size = [](const void* at) -> std::size_t {
      return static_cast<const std::optional<T>*>(at)->has_value();
    };
    blocks.resize = [](void* at, std::size_t size) {
      auto& held = *static_cast<std::optional<T>*>(at);
      held.reset();
      if (size > 0) held.emplace();
    };
    blocks.get = [](void* at, std::size_t) -> void* { return &**static_cast<std::optional<T>*>(at); };
    visit_optional_table(name, blocks, meaning);
  }
  /// A list of blocks, with as many in the template as `samples`.
  template <class T>
  void tables(const char* name, std::vector<T>& list, int samples, const char* meaning) {
    Blocks blocks = make_blocks<T>(&list);
    blocks.get_size = [](const void* at) { return static_cast<const std::vector<T>*>(at)->size(); };
    blocks.resize = [](void* at, std::size_t size) { static_cast<std::vector<T>*>(at)->resize(size); };
    blocks.get = [](void* at, std::size_t i) -> void* { return &(*static_cast<std::vector<T>*>(at))[i]; };
    visit_tables(name, blocks, samples, meaning);
  }
  /// Blocks under names that the user chooses; `sample` is the name in the template.
  template <class T>
  void named(const char* name, std::map<std::string, T>& map, const char* sample, int samples, const char* meaning) {
    Blocks blocks = make_blocks<T>(&map);
    blocks.list_names = list_names<T>;
    blocks.find = find<T>;
    visit_named(name, blocks, sample, samples, meaning);
  }
  template <class T>
  void entries(const char* name, std::map<std::string, T>& values, const char* sample, int samples, const Spec& spec,
               const char* meaning) {
    const auto make = []() -> std::shared_ptr<void> { return std::make_shared<T>(); };
    const auto set = [](void* at, const std::string& label, const void* value) {
      (*static_cast<std::map<std::string, T>*>(at))[label] = *static_cast<const T*>(value);
    };
    visit_entries(name, {&values, get_key_type<T>(), make, list_names<T>, find<T>, set}, sample, samples, spec,
                  meaning);
  }

 protected:
  virtual void visit_key(const std::string& name, Member member, const Spec& spec, const char* meaning) = 0;
  virtual void visit_table(const std::string& name, const Blocks& block, const char* meaning) = 0;
  virtual void visit_optional_table(const std::string& name, const Blocks& block, const char* meaning) = 0;
  virtual void visit_tables(const std::string& name, const Blocks& blocks, int samples, const char* meaning) = 0;
  virtual void visit_named(const std::string& name, const Blocks& blocks, const char* sample, int samples,
                           const char* meaning) = 0;
  virtual void visit_entries(const std::string& name, const Entries& values, const char* sample, int samples,
                             const Spec& spec, const char* meaning) = 0;

 private:
  template <class T>
  static Blocks make_blocks(void* at) {
    const auto describe_block = [](Visitor& v, void* block) { describe(v, *static_cast<T*>(block)); };
    const auto make = []() -> std::shared_ptr<void> {
      if constexpr (std::is_default_constructible_v<T>)
        return std::make_shared<T>();
      else
        return nullptr;  // a view of members of several structs, which is always there
    };
    return {at, describe_block, make, nullptr, nullptr, nullptr, nullptr, nullptr};
  }
  template <class T>
  static std::vector<std::string> list_names(const void* at) {
    std::vector<std::string> names;
    for (const auto& [name, value] : *static_cast<const std::map<std::string, T>*>(at)) names.push_back(name);
    return names;
  }
  template <class T>
  static void* find(void* at, const std::string& name) {
    return &(*static_cast<std::map<std::string, T>*>(at))[name];
  }
};

// Conversions of enumerations, of lists of their words, and of values that may be absent.

extern const KeyType word_type;      ///< of an enumeration, without its words
extern const KeyType optional_type;  ///< of an absent value, without its inner type

/// One word or a list of words.
template <class E, class T>
KeyType make_word_type() {
  KeyType made = word_type;
  made.words.list = [] {
    std::vector<WordTable::Word> list;
    for (const auto& choice : choices<E>) list.push_back({choice.word, choice.meaning});
    return list;
  };
  made.words.is_list = !std::is_same_v<E, T>;
  made.words.get = [](const void* value) {
    std::vector<std::size_t> positions;
    const auto add = [&](E word) {
      std::size_t i = 0;
      while (i < std::size(choices<E>) && choices<E>[i].value != word) ++i;
      positions.push_back(i);
    };
    if constexpr (std::is_same_v<E, T>)
      add(*static_cast<const T*>(value));
    else
      for (const E word : *static_cast<const T*>(value)) add(word);
    return positions;
  };
  made.words.set = [](void* value, const std::vector<std::size_t>& positions) {
    if constexpr (std::is_same_v<E, T>) {
      *static_cast<T*>(value) = choices<E>[positions.front()].value;
    } else {
      static_cast<T*>(value)->clear();
      for (const std::size_t i : positions) static_cast<T*>(value)->push_back(choices<E>[i].value);
    }
  };
  return made;
}

template <class T>
KeyType make_optional_type() {
  KeyType made = optional_type;
  made.inner = &get_key_type<T>();
  made.get_held = [](const void* at) -> const void* {
    const auto& value = *static_cast<const std::optional<T>*>(at);
    return value ? &*value : nullptr;
  };
  made.emplace = [](void* at) -> void* { return &static_cast<std::optional<T>*>(at)->emplace(); };
  if constexpr (std::is_same_v<T, double>) {
    made.get_number = [](const void* at) { return *static_cast<const std::optional<double>*>(at); };
    made.set_number = [](void* at, double value) { *static_cast<std::optional<double>*>(at) = value; };
  }
  return made;
}

/// The element of an optional or a list T; void for other types.
template <class T>
struct ElementOf {
  using Type = void;
  static constexpr bool is_optional = false;
};
template <class T>
struct ElementOf<std::optional<T>> {
  using Type = T;
  static constexpr bool is_optional = true;
};
template <class T>
struct ElementOf<std::vector<T>> {
  using Type = T;
  static constexpr bool is_optional = false;
};

template <class T>
const KeyType& get_key_type() {
  using Element = typename ElementOf<T>::Type;
  if constexpr (std::is_enum_v<T>) {
    static const KeyType type = make_word_type<T, T>();
    return type;
  } else if constexpr (std::is_enum_v<Element>) {
    if constexpr (ElementOf<T>::is_optional) {
      static const KeyType type = make_optional_type<Element>();
      return type;
    } else {
      static const KeyType type = make_word_type<Element, T>();
      return type;
    }
  } else if constexpr (ElementOf<T>::is_optional) {
    static const KeyType type = make_optional_type<Element>();
    return type;
  } else {
    return find_key_type<T>();
  }
}

}  // namespace talus::input
