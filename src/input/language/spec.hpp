// SPDX-License-Identifier: MIT
#pragma once
// Specification of a key: unit, range, conditions, requirement and examples.

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace talus::input {

// NOLINTNEXTLINE(bugprone-forward-declaration-namespace): that of results/ has the same name
class Visitor;  // visitor.hpp

/// One word of a choice and its meaning.
template <class E>
struct Choice {
  E value;
  const char* word;
  const char* meaning;
};

template <class E>
Choice(E, const char*, const char*) -> Choice<E>;  // clang 14 does not deduce this for an aggregate

/// The words of the enumeration E in the order of the manual; specialised beside the block that uses E.
template <class E>
inline constexpr auto choices = nullptr;

/// Returns the word of an enumerator in the case file.
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

/// One condition on another key.
struct Alternative {
  std::string key;       ///< the other key; a path from the top of the file if it has a dot
  std::string value;     ///< the TOML text that it must have; empty: the other key must not be given
  bool holds = true;     ///< true in the case that is being visited
  bool differs = false;  ///< any value except `value`
};

/// A unit that is often used by mistake.
struct Slip {
  const char* unit = "";
  double factor = 1;  ///< one such unit in the unit of the manual
};

/// Usual range of soils, in the unit of the manual. Values beyond it cause a warning.
struct UsualRange {
  double low = 0, high = 0;
  std::vector<Slip> slips;
  bool or_zero = false;      ///< zero is usual too: the soil lacks the property
  bool either_sign = false;  ///< the sign is a direction; the range applies to the magnitude

  bool holds(double value) const {
    const double size = either_sign && value < 0 ? -value : value;
    return (low <= size && size <= high) || (or_zero && value == 0);
  }
};

/// Condition of a key that applies only with (or without) another key of the same table.
struct Condition {
  std::vector<Alternative> any;  ///< at least one must hold
  bool required = false;         ///< the key is required where the condition holds

  bool holds() const;
  /// Returns true if the condition is that another key is not given.
  bool is_absence() const { return any.front().value.empty(); }
};

/// Writes further conditions of a requirement: "; with the methods fem or mpm, unless unit_weight is given"; usually
/// empty.
struct Spec;
std::string write_waivers(const Spec& spec);

/// Writes `fix = "plane"`, `curve = "a" or "b" or law = "c"`, `retention other than "dry"` or `file is not given`.
std::string write_condition(const Condition& condition);

/// Unit, range, requirement and examples of a key, built by chained calls: quantity("kPa").at_least(0).required().
struct Spec {
  std::string unit;  ///< unit of plain numbers in the file, in UDUNITS notation; empty: dimensionless, or not a number
  std::optional<Limit> low, high;
  std::optional<UsualRange> usual_range;
  bool is_required = false;
  bool allows_infinity = false;
  std::optional<Condition> condition;
  std::vector<std::string> methods;    ///< methods of [analysis] with which the key is required; empty: any
  std::optional<Alternative> instead;  ///< the key is not required if this other key is given
  std::vector<std::string>
      examples;  ///< TOML texts; one for each sample of a list, the last one for all further samples

  Spec at_least(double value) &&;
  Spec above(double value) &&;
  Spec at_most(double value) &&;
  Spec below(double value) &&;
  /// Sets the usual range of soils; `slips` are units that may explain values beyond it.
  Spec usual(double least, double most, std::vector<Slip> slips = {}) &&;
  /// Sets the usual range and includes zero.
  Spec usual_or_zero(double least, double most, std::vector<Slip> slips = {}) &&;
  /// Applies the usual range to the magnitude.
  Spec of_either_sign() &&;
  /// Allows `inf`.
  Spec or_infinite() &&;
  Spec required() &&;
  Spec example(const char* text) &&;
  /// Sets one example for each sample of a list (see tables() of the visitors).
  Spec example_each(std::vector<std::string> texts) &&;
  /// The key is required if `other` has `value`, and rejected otherwise.
  template <class T>
  Spec needed_with(const char* key, const T& other, const T& value) && {
    return std::move(*this).depend(key, write_value(value), other == value, true);
  }
  /// The key is allowed if `other` has `value`, and rejected otherwise.
  template <class T>
  Spec allowed_with(const char* key, const T& other, const T& value) && {
    return std::move(*this).depend(key, write_value(value), other == value, false);
  }
  /// The key is required if `other` has one of `values`, and rejected otherwise.
  template <class T>
  Spec needed_with(const char* key, const T& other, std::initializer_list<T> values) && {
    return std::move(*this).depend_on_any(list_values(key, other, values), true);
  }
  template <class T>
  Spec allowed_with(const char* key, const T& other, std::initializer_list<T> values) && {
    return std::move(*this).depend_on_any(list_values(key, other, values), false);
  }
  /// Adds an alternative to the preceding condition: `other` has `value`.
  template <class T>
  Spec or_with(const char* key, const T& other, const T& value) && {
    return std::move(*this).or_depend({key, write_value(value), other == value});
  }
  /// The key is allowed unless `other` has `value`.
  template <class T>
  Spec allowed_unless(const char* key, const T& other, const T& value) && {
    return std::move(*this).depend_on_any({{key, write_value(value), other != value, true}}, false);
  }
  /// The key is required if `key` is not given, and rejected otherwise.
  Spec needed_without(const char* key, bool other_is_given) &&;
  /// The key is required only with one of these methods; it is always allowed.
  Spec by_methods(std::vector<std::string> words) &&;
  /// The key is required only if `key` is not given; it is always allowed.
  Spec unless_given(const char* key, bool other_is_given) &&;
  /// The key is allowed if `key` is not given, and rejected otherwise.
  Spec allowed_without(const char* key, bool other_is_given) &&;

  /// Returns true if the key is required in some cases.
  bool may_be_required() const { return is_required || (condition && condition->required); }
  /// Returns true if the key is not required with these methods, or if another key replaces it.
  bool is_waived(const std::set<std::string>& asked_methods) const;
  /// Writes the range: "at least 0", "above -1 and below 0.5"; empty without limits.
  std::string write_range() const;
  /// Writes the usual range: "10 to 28 kN/m3", "5 to 50 deg, or 0"; empty if there is none.
  std::string write_usual_range() const;
  /// Returns a sentence if `value` of the key `path`, in the unit of the manual, is unusual; empty otherwise.
  /// `is_plain`: the value was written without a unit.
  std::string find_oddity(const std::string& path, double value, bool is_plain) const;
  /// Returns true if `value`, in the unit of the manual, is within the limits.
  bool allows(double value) const;

 private:
  Spec depend(const char* key, std::string value, bool holds, bool required) &&;
  Spec depend_on_any(std::vector<Alternative> others, bool required) &&;
  Spec or_depend(Alternative other) &&;

  static std::string write_value(int value);
  static std::string write_value(const char* word);
  static std::string write_value(auto value) { return write_value(get_word(value)); }
  template <class T>
  static std::vector<Alternative> list_values(const char* key, const T& other, std::initializer_list<T> values) {
    std::vector<Alternative> any;
    for (const T& value : values) any.push_back({key, write_value(value), other == value});
    return any;
  }
};

/// Specifies a number in `unit`, or a text with a unit.
Spec quantity(const char* unit);

/// Specifies a key without unit: a dimensionless number, a text, a word or a Boolean.
Spec plain();

}  // namespace talus::input
