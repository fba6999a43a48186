// SPDX-License-Identifier: MIT
#pragma once
// How a result describes itself. Each struct of results/ has one function
//
//   template <class V, As<Runout> R>
//   void describe(V& v, R& r) {
//     v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
//     v.maybe("failure_time", r.failure_time, {"s", "time of failure"});
//   }
//
// which names key, unit and title once. The writer and the reader of JSON, its schema, the manual's table and the names
// of [[compare]] visit that function. `key` is always there, and null where an optional holds nothing; `maybe` is left
// out where there is nothing to say; `merge` puts the keys of a block beside those of its owner, and knows by the key
// `sign` whether the block is there.

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace talus::results {

/// R is T, const for writers and not const for readers: one description serves both.
template <class R, class T>
concept As = std::same_as<std::remove_const_t<R>, T>;

/// Unit and title of a key.
struct About {
  const char* unit = "";   ///< of the stored number, as UDUNITS writes it; empty: dimensionless, or no number
  const char* title = "";  ///< as tables, [[compare]] and Python call it
};

/// One enumerator and its word in the files.
template <class E>
struct Word {
  E value;
  const char* word;
};
template <class E>
Word(E, const char*) -> Word<E>;  // clang 14 does not deduce it for an aggregate

/// The words of the enumeration E; specialised beside it.
template <class E>
inline constexpr auto words = nullptr;

/// The word of an enumerator.
template <class E>
const char* to_word(E value) {
  for (const auto& w : words<E>)
    if (w.value == value) return w.word;
  return "";
}

/// The enumerator of a word; nothing where there is none.
template <class E>
std::optional<E> from_word(std::string_view word) {
  for (const auto& w : words<E>)
    if (w.word == word) return w.value;
  return std::nullopt;
}

using Point = std::array<double, 2>;  ///< of a section [m]

}  // namespace talus::results
