// SPDX-License-Identifier: MIT
// A case from its echo, for readers that have the results of a run but not its file.

#include <toml++/toml.h>
#include <nlohmann/json.hpp>

#include "input/case/case.hpp"
#include "input/case/complete.hpp"
#include "input/echo.hpp"
#include "input/language/codecs.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

/// A JSON value as TOML has it; nothing for null.
void append(toml::array& list, const json& value);

toml::array to_array(const json& values) {
  toml::array list;
  for (const json& value : values) append(list, value);
  return list;
}

/// Calls `take` with the TOML value of a JSON value; not for null and objects, which no leaf of an echo has.
template <class Take>
void with_toml(const json& value, const Take& take) {
  if (value.is_boolean()) return take(toml::value<bool>(value.get<bool>()));
  if (value.is_number_integer()) return take(toml::value<std::int64_t>(value.get<std::int64_t>()));
  if (value.is_number()) return take(toml::value<double>(value.get<double>()));
  if (value.is_string()) return take(toml::value<std::string>(value.get<std::string>()));
  if (value.is_array()) return take(to_array(value));
}

void append(toml::array& list, const json& value) {
  with_toml(value, [&](auto&& node) { list.push_back(std::forward<decltype(node)>(node)); });
}

/// The visitor that reads the structs from an echo. A key that is missing, or whose form has changed, keeps its
/// default: the results may be those of another version.
class EchoReader {
 public:
  EchoReader(const json& object, Findings& findings) : object_(object), findings_(findings) {}

  template <class T>
  void key(const std::string& name, T&& member, const Spec& spec, const char* /*meaning*/) {
    const json& leaf = look_up(name);
    if (!leaf.is_object() || !leaf.contains("value")) return;
    decode(leaf.at("value"), name, spec, member);
  }

  template <class T>
  void table(const std::string& name, T&& block, const char* /*meaning*/) {
    read_block(look_up(name), block);
  }

  template <class T>
  void optional_table(const std::string& name, std::optional<T>& block, const char* /*meaning*/) {
    if (look_up(name).is_object()) read_block(look_up(name), block.emplace());
  }

  template <class T>
  void tables(const std::string& name, std::vector<T>& blocks, int /*samples*/, const char* /*meaning*/) {
    const json& list = look_up(name);
    if (!list.is_array()) return;
    blocks.resize(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) read_block(list[i], blocks[i]);
  }

  template <class T>
  void named(const std::string& name, std::map<std::string, T>& blocks, const char* /*sample*/,
             const char* /*meaning*/) {
    if (!look_up(name).is_object()) return;
    for (const auto& [label, block] : look_up(name).items()) read_block(block, blocks[label]);
  }

  template <class T>
  void entries(const std::string& name, std::map<std::string, T>& values, const char* /*sample*/, int /*samples*/,
               const Spec& spec, const char* meaning) {
    if (!look_up(name).is_object()) return;
    EchoReader inner(look_up(name), findings_);
    for (const auto& [label, leaf] : look_up(name).items()) inner.key(label, values[label], spec, meaning);
  }

 private:
  const json& look_up(const std::string& name) const {
    static const json nothing;
    return object_.is_object() && object_.contains(name) ? object_.at(name) : nothing;
  }

  template <class T>
  void read_block(const json& object, T& block) {
    EchoReader inner(object, findings_);
    describe(inner, block);
  }

  template <class T>
  void decode(const json& value, const std::string& name, const Spec& spec, T& member) {
    using Value = std::remove_cvref_t<T>;
    // JSON has no infinity: it is written as null.
    if constexpr (std::is_same_v<Value, double>)
      if (value.is_null() && spec.allows_infinity) return void(member = std::numeric_limits<double>::infinity());
    with_toml(value, [&](const toml::node& node) {
      Codec<Value>::decode(Decoding{spec, name, findings_}, node, name, member);
    });
  }

  const json& object_;
  Findings& findings_;
};

}  // namespace

Case read_echo(const JsonTree& echo) {
  Places places("");
  Findings findings(places);
  Case data;
  EchoReader reader(echo.get(), findings);
  describe(reader, data);
  complete_porosities(data);
  normalise_directions(data);
  return data;
}

}  // namespace talus::input
