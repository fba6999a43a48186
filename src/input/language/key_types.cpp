// SPDX-License-Identifier: MIT
// The conversions behind the codecs: one table for each type of key.
#include "input/language/codec_types.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

std::vector<std::string> list_words(const KeyType& type) {
  std::vector<std::string> words;
  for (const WordTable::Word& word : type.words.list()) words.emplace_back(word.word);
  return words;
}

bool decode_enumeration(const KeyType& self, const Decoding& in, void* out) {
  std::vector<std::size_t> positions(1);
  const bool is_good = self.words.is_list ? decode_words(in, list_words(self), positions)
                                          : decode_word(in, list_words(self), positions.front());
  if (is_good) self.words.set(out, positions);
  return is_good;
}

json encode_enumeration(const KeyType& self, const void* value, const Spec& /*spec*/) {
  const std::vector<std::string> words = list_words(self);
  json list = json::array();
  for (const std::size_t i : self.words.get(value)) list.push_back(i < words.size() ? words[i] : "");
  return self.words.is_list ? list : list.front();
}

json write_enumeration_schema(const KeyType& self, const Spec& /*spec*/) {
  const json word = {{"enum", list_words(self)}};
  return self.words.is_list ? write_array_schema(word, 0, -1) : word;
}

template <class T>
struct NumberAt {
  static constexpr bool is_number = false, is_per_cent = false;
};
template <>
struct NumberAt<double> {
  static constexpr bool is_number = true, is_per_cent = false;
  static double& get(double& value) { return value; }
};
template <class T>
struct NumberAt<PerCent<T>> {
  static constexpr bool is_number = true, is_per_cent = true;
  static T& get(PerCent<T>& value) { return value.value; }
};

template <class T>
KeyType make_key_type() {
  KeyType made{
      [](const KeyType&, const Decoding& in, void* out) { return Codec<T>::decode(in, *static_cast<T*>(out)); },
      [](const KeyType&, const void* value, const Spec& spec) {
        return json(Codec<T>::encode(*static_cast<const T*>(value), spec));
      },
      [](const KeyType&, const Spec& spec) { return std::string(Codec<T>::name(spec)); },
      [](const KeyType&, const Spec& spec) { return json(Codec<T>::schema(spec)); }};
  if constexpr (NumberAt<T>::is_number) {
    made.get_number = [](const void* at) -> std::optional<double> {
      return NumberAt<T>::get(*static_cast<T*>(const_cast<void*>(at)));
    };
    made.set_number = [](void* at, double number) { NumberAt<T>::get(*static_cast<T*>(at)) = number; };
    made.is_per_cent = NumberAt<T>::is_per_cent;
  }
  return made;
}

}  // namespace

const KeyType word_type{
    decode_enumeration, encode_enumeration,
    [](const KeyType& self, const Spec&) -> std::string { return self.words.is_list ? "list of words" : "word"; },
    write_enumeration_schema};

const KeyType optional_type{
    [](const KeyType& self, const Decoding& in, void* out) {
      return self.inner->decode(*self.inner, in, self.emplace(out));
    },
    [](const KeyType& self, const void* value, const Spec& spec) {
      const void* held = self.get_held(value);
      return held != nullptr ? self.inner->encode(*self.inner, held, spec) : json();
    },
    [](const KeyType& self, const Spec& spec) { return self.inner->name(*self.inner, spec); },
    [](const KeyType& self, const Spec& spec) { return self.inner->schema(*self.inner, spec); }};

template <class T>
const KeyType& find_key_type() {
  static const KeyType type = make_key_type<T>();
  return type;
}

#define TALUS_KEY_TYPE(...) template const KeyType& find_key_type<__VA_ARGS__>();
TALUS_KEY_TYPE(bool)
TALUS_KEY_TYPE(int)
TALUS_KEY_TYPE(std::uint64_t)
TALUS_KEY_TYPE(double)
TALUS_KEY_TYPE(std::string)
TALUS_KEY_TYPE(std::vector<double>)
TALUS_KEY_TYPE(std::vector<std::string>)
TALUS_KEY_TYPE(std::array<double, 2>)
TALUS_KEY_TYPE(std::array<double, 3>)
TALUS_KEY_TYPE(std::array<double, 4>)
TALUS_KEY_TYPE(std::vector<std::array<double, 2>>)
TALUS_KEY_TYPE(Corners)
TALUS_KEY_TYPE(TimeTable)
TALUS_KEY_TYPE(Series)
TALUS_KEY_TYPE(SurveyPoints)
TALUS_KEY_TYPE(SuctionCurve)
TALUS_KEY_TYPE(ShareTable)
TALUS_KEY_TYPE(Date)
TALUS_KEY_TYPE(std::vector<Date>)
TALUS_KEY_TYPE(Amount)
TALUS_KEY_TYPE(TomlText)
TALUS_KEY_TYPE(TomlTexts)
TALUS_KEY_TYPE(PerCent<double>)
TALUS_KEY_TYPE(PerCent<std::optional<double>>)
TALUS_KEY_TYPE(Turns)
TALUS_KEY_TYPE(std::vector<PointSetting>)
#undef TALUS_KEY_TYPE

}  // namespace talus::input
