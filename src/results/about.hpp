// SPDX-License-Identifier: MIT
#pragma once
// Descriptions of results: units, titles, the words of enumerations. Each struct of results/ has one function
//
// void describe(Visitor& v, Runout& r) {
//   v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
//   v.maybe("failure_time", r.failure_time, {"s", "time of failure"});
// }
//
// which lists key, unit and title of each member once. The writer and the reader of JSON, the JSON Schema, the table of
// the manual and the names of [[compare]] are visitors of that function. `key` is always written, as null for an empty
// optional; `maybe` is omitted for an empty optional; `merge` writes the keys of a block beside those of its owner, and
// the reader detects the block by the key `sign`.

#include <array>
#include <optional>
#include <string_view>

namespace talus::results {

// NOLINTNEXTLINE(bugprone-forward-declaration-namespace): that of input/ has the same name
class Visitor;  // results/described.hpp

/// Unit and title of a key.
struct About {
  const char* unit = "";    ///< UDUNITS symbol of the stored number; empty if dimensionless or not a number
  const char* title = "";   ///< name in tables, [[compare]] and Python
  bool can_be_nan = false;  ///< NaN is a value of a finished run, so readers of the JSON must expect null
};
inline constexpr bool can_be_nan = true;

/// The words of the enumeration E in result files, in the order of its enumerators, which count from 0; specialised
/// beside the definition of E.
template <class E>
inline constexpr auto words = nullptr;

/// Returns the word of an enumerator.
template <class E>
const char* to_word(E value) {
  const auto i = static_cast<std::size_t>(value);
  return i < words<E>.size() ? words<E>[i] : "";
}

/// Returns the enumerator of a word, or nullopt for an unknown word.
template <class E>
std::optional<E> from_word(std::string_view word) {
  for (std::size_t i = 0; i < words<E>.size(); ++i)
    if (words<E>[i] == word) return static_cast<E>(i);
  return std::nullopt;
}

/// Version of the format of summary.json, study.json, point.json and calibration.json. A file of another version
/// is refused. Increase it when a reader of the old files would misread the new ones or miss a key.
inline constexpr int result_format = 2;

using Point = std::array<double, 2>;  ///< point of a plane section [m]

}  // namespace talus::results
