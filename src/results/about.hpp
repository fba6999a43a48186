// SPDX-License-Identifier: MIT
#pragma once
// Descriptions of results: units, titles, the words of enumerations. Each struct of results/ has one function
//
// template <class V, As<Runout> R>
// void describe(V& v, R& r) {
//   v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
//   v.maybe("failure_time", r.failure_time, {"s", "time of failure"});
// }
//
// which lists key, unit and title of each member once. The writer and the reader of JSON, the JSON Schema, the table of
// the manual and the names of [[compare]] are visitors of that function. `key` is always written, as null for an empty
// optional; `maybe` is omitted for an empty optional; `merge` writes the keys of a block beside those of its owner, and
// the reader detects the block by the key `sign`.

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace talus::results {

/// Matches T and const T, so that one description serves writers (const) and readers.
template <class R, class T>
concept As = std::same_as<std::remove_const_t<R>, T>;

/// Unit and title of a key.
struct About {
  const char* unit = "";    ///< UDUNITS symbol of the stored number; empty if dimensionless or not a number
  const char* title = "";   ///< name in tables, [[compare]] and Python
  bool can_be_nan = false;  ///< NaN is a value of a finished run, so readers of the JSON must expect null
};
inline constexpr bool can_be_nan = true;

/// One enumerator and its word in result files.
template <class E>
struct Word {
  E value;
  const char* word;
};
template <class E>
Word(E, const char*) -> Word<E>;  // clang 14 does not deduce the arguments of an aggregate

/// The words of the enumeration E; each enumeration specialises it beside its definition.
template <class E>
inline constexpr auto words = nullptr;

/// Returns the word of an enumerator.
template <class E>
const char* to_word(E value) {
  for (const auto& w : words<E>)
    if (w.value == value) return w.word;
  return "";
}

/// Returns the enumerator of a word, or nullopt for an unknown word.
template <class E>
std::optional<E> from_word(std::string_view word) {
  for (const auto& w : words<E>)
    if (w.word == word) return w.value;
  return std::nullopt;
}

/// Version of the format of summary.json, study.json, point.json and calibration.json. A file of another version
/// is refused. Increase it when a reader of the old files would misread the new ones or miss a key.
inline constexpr int result_format = 2;

using Point = std::array<double, 2>;  ///< point of a plane section [m]

}  // namespace talus::results
