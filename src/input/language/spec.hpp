// SPDX-License-Identifier: MIT
#pragma once
// What a declaration says about a key besides its name, place and meaning.

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace talus::input {

/// One word of a choice and what it means.
template <class E>
struct Choice {
  E value;
  const char* word;
  const char* meaning;
};

template <class E>
Choice(E, const char*, const char*) -> Choice<E>;  // clang 14 does not deduce it for an aggregate

/// The words of the enumeration E, in the order of the manual; specialised beside the block that uses E.
template <class E>
inline constexpr auto choices = nullptr;

/// The word of an enumerator in the case file.
template <class E>
const char* get_word(E value) {
  for (const auto& choice : choices<E>)
    if (choice.value == value) return choice.word;
  return "";
}

/// A limit of a range, in the unit of the manual.
struct Limit {
  double value = 0;
  bool open = false;  ///< the limit itself is not allowed
};

/// What another key must be for a key to have a meaning.
struct Alternative {
  std::string key;       ///< the other key; with a dot: a path from the top of the file
  std::string value;     ///< the TOML text it must have; empty: the other key must not be given
  bool holds = true;     ///< in the case that is being visited
  bool differs = false;  ///< anything but `value`
};

/// A unit in which a number is often meant where it was not asked for.
struct Slip {
  const char* unit = "";
  double factor = 1;  ///< what one of it is in the unit of the manual
};

/// The range of real soils, in the unit of the manual. Values beyond it are allowed, with a warning.
struct UsualRange {
  double low = 0, high = 0;
  std::vector<Slip> slips;
  bool or_zero = false;      ///< zero is usual too: the soil has none of it
  bool either_sign = false;  ///< the sign is a direction

  bool holds(double value) const {
    const double size = either_sign && value < 0 ? -value : value;
    return (low <= size && size <= high) || (or_zero && value == 0);
  }
};

/// A key that has a meaning only with (or without) another key of the same table.
struct Condition {
  std::vector<Alternative> any;  ///< one of them is enough
  bool required = false;         ///< the key must be given where the condition holds

  bool holds() const;
  /// Whether it asks that another key is not given.
  bool is_absence() const { return any.front().value.empty(); }
};

/// "; with the methods fem or mpm, unless unit_weight is given": what else a required key depends on; empty for most.
struct Spec;
std::string write_waivers(const Spec& spec);

/// Writes `fix = "plane"`, `curve = "a" or "b" or law = "c"`, `retention other than "dry"` or `file is not given`.
std::string write_condition(const Condition& condition);

/// Unit, range, presence and examples of a key. Built as a sentence: quantity("kPa").at_least(0).required().
struct Spec {
  std::string unit;  ///< unit of plain numbers in the file, as UDUNITS writes it; empty: dimensionless, or no number
  std::optional<Limit> low, high;
  std::optional<UsualRange> usual_range;
  bool is_required = false;
  bool allows_infinity = false;
  std::optional<Condition> condition;
  std::vector<std::string> methods;    ///< of [analysis]: only with one of these is the key required; empty: with any
  std::optional<Alternative> instead;  ///< where this other key is given, the key is not required
  std::vector<std::string> examples;   ///< TOML texts; one for each sample of a list, the last one for the rest

  Spec at_least(double value) &&;
  Spec above(double value) &&;
  Spec at_most(double value) &&;
  Spec below(double value) &&;
  /// Numbers of real soils lie here; `slips` are units in which other numbers may have been meant.
  Spec usual(double least, double most, std::vector<Slip> slips = {}) &&;
  /// The same, and zero.
  Spec usual_or_zero(double least, double most, std::vector<Slip> slips = {}) &&;
  /// The usual range is that of the amount.
  Spec of_either_sign() &&;
  /// `inf` may be given.
  Spec or_infinite() &&;
  Spec required() &&;
  Spec example(const char* text) &&;
  /// One example for each sample of a list (see tables() of the visitors).
  Spec example_each(std::vector<std::string> texts) &&;
  /// The key is required where `other` has `value`, and has no meaning elsewhere.
  template <class T>
  Spec needed_with(const char* key, const T& other, const T& value) && {
    return std::move(*this).depend(key, write_value(value), other == value, true);
  }
  /// The key may be given where `other` has `value`, and has no meaning elsewhere.
  template <class T>
  Spec allowed_with(const char* key, const T& other, const T& value) && {
    return std::move(*this).depend(key, write_value(value), other == value, false);
  }
  /// The same for each of several values.
  template <class T>
  Spec needed_with(const char* key, const T& other, std::initializer_list<T> values) && {
    return std::move(*this).depend_on_any(list_values(key, other, values), true);
  }
  template <class T>
  Spec allowed_with(const char* key, const T& other, std::initializer_list<T> values) && {
    return std::move(*this).depend_on_any(list_values(key, other, values), false);
  }
  /// Or where `other` has `value`; after one of those above.
  template <class T>
  Spec or_with(const char* key, const T& other, const T& value) && {
    return std::move(*this).or_depend({key, write_value(value), other == value});
  }
  /// The key may be given where `other` has another value than `value`, and has no meaning elsewhere.
  template <class T>
  Spec allowed_unless(const char* key, const T& other, const T& value) && {
    return std::move(*this).depend_on_any({{key, write_value(value), other != value, true}}, false);
  }
  /// The key is required where `key` is not given, and has no meaning elsewhere.
  Spec needed_without(const char* key, bool other_is_given) &&;
  /// The key is not required where none of these methods is asked for, but may be given.
  Spec by_methods(std::vector<std::string> words) &&;
  /// The key is not required where `key` is given, but may be given.
  Spec unless_given(const char* key, bool other_is_given) &&;
  /// The key may be given where `key` is not given, and has no meaning elsewhere.
  Spec allowed_without(const char* key, bool other_is_given) &&;

  /// Whether the key must be given somewhere.
  bool may_be_required() const { return is_required || (condition && condition->required); }
  /// Whether the key is not required with these methods, or another key replaces it.
  bool is_waived(const std::set<std::string>& asked_methods) const;
  /// "at least 0", "above -1 and below 0.5"; empty without limits.
  std::string write_range() const;
  /// "10 to 28 kN/m3", "5 to 50 deg, or 0"; empty without one.
  std::string write_usual_range() const;
  /// What is odd about `value`, in the unit of the manual, of the key `path`; empty where nothing is. `is_plain`: it
  /// was written without a unit.
  std::string find_oddity(const std::string& path, double value, bool is_plain) const;
  /// Whether `value`, in the unit of the manual, is within the limits.
  bool allows(double value) const;

  // Compiled once, in spec.cpp: every visitor of the case makes a Spec for each of its keys.
  Spec();
  Spec(const Spec&);
  Spec(Spec&&) noexcept;
  Spec& operator=(const Spec&);
  Spec& operator=(Spec&&) noexcept;
  ~Spec();

 private:
  Spec depend(const char* key, std::string value, bool holds, bool required) &&;
  Spec depend_on_any(std::vector<Alternative> others, bool required) &&;
  Spec or_depend(Alternative other) &&;

  static std::string write_value(int value);
  static std::string write_value(const char* word);
  template <class E>
  static std::string write_value(E value) {
    return write_value(get_word(value));
  }
  template <class T>
  static std::vector<Alternative> list_values(const char* key, const T& other, std::initializer_list<T> values) {
    std::vector<Alternative> any;
    for (const T& value : values) any.push_back({key, write_value(value), other == value});
    return any;
  }
};

/// A number in `unit`, or a text with a unit.
Spec quantity(const char* unit);

/// A dimensionless number, a text, a word or a truth value: whatever has no unit.
Spec plain();

}  // namespace talus::input
