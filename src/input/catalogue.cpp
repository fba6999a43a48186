// SPDX-License-Identifier: MIT
#include "input/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <type_traits>

#include "input/case/case.hpp"
#include "input/language/codecs.hpp"

namespace talus::input {
namespace {

constexpr std::string_view within_name = ".NAME.";  ///< in the name of a block within a block of the user's name

/// The visitor that collects the declarations; defaults are what a default-constructed struct holds.
class Collector {
 public:
  explicit Collector(BlockEntry& block) : block_(block) {}

  template <class T>
  void key(const char* name, T&& member, const Spec& spec, const char* meaning) {
    using Value = std::remove_cvref_t<T>;
    KeyEntry entry{name, spec, Codec<Value>::name(spec), meaning, "", {}, JsonTree(Codec<Value>::schema(spec))};
    const bool must_be_given = spec.may_be_required();
    const nlohmann::json value = Codec<Value>::encode(member, spec);
    if (!must_be_given && !value.is_null()) entry.default_text = write_toml(value);
    if constexpr (std::is_enum_v<WordOf<Value>>)
      for (const auto& choice : choices<WordOf<Value>>) entry.words.emplace_back(choice.word, choice.meaning);
    block_.keys.push_back(std::move(entry));
  }

  template <class T>
  void table(const char* name, T&& block, const char* meaning) {
    collect(add(BlockKind::table, name, "", 1, meaning), block);
  }

  template <class T>
  void optional_table(const char* name, std::optional<T>&, const char* meaning) {
    T block{};
    collect(add(BlockKind::table, name, "", 0, meaning), block);
  }

  template <class T>
  void tables(const char* name, std::vector<T>&, int samples, const char* meaning) {
    T block{};
    collect(add(BlockKind::list, name, "", samples, meaning), block);
  }

  template <class T>
  void named(const char* name, std::map<std::string, T>&, const char* sample, const char* meaning) {
    T block{};
    collect(add(BlockKind::named, name, sample, 1, meaning), block);
  }

  template <class T>
  void entries(const char* name, std::map<std::string, T>&, const char* sample, int samples, const Spec& spec,
               const char* meaning) {
    T value{};
    BlockEntry entry = add(BlockKind::entries, name, sample, samples, meaning);
    Collector(entry).key("NAME", value, spec, meaning);
    block_.blocks.push_back(std::move(entry));
  }

 private:
  BlockEntry add(BlockKind kind, const std::string& name, const char* sample, int samples, const char* meaning) const {
    const std::string within = block_.kind == BlockKind::named ? block_.name + ".NAME" : block_.name;
    // The name of the user's choice goes on into the blocks within.
    const bool goes_on = block_.name.find(".NAME") != std::string::npos || block_.kind == BlockKind::named;
    return {kind, name, within.empty() ? name : within + "." + name, goes_on ? block_.sample : sample, samples, meaning,
            {},   {}};
  }

  template <class T>
  void collect(BlockEntry entry, T& block) {
    Collector inner(entry);
    describe(inner, block);
    block_.blocks.push_back(std::move(entry));
  }

  BlockEntry& block_;
};

/// Adds a phrase for each key, block and choice of `block` and the blocks within that is called `word`.
void gather_owners(const BlockEntry& block, const std::string& word, std::vector<std::string>& phrases) {
  const std::string header = block.name.empty() ? "the top of the file" : block.write_header();
  for (const KeyEntry& key : block.keys) {
    if (key.name == word && block.kind != BlockKind::entries) phrases.push_back("it is a key of " + header);
    for (const auto& choice : key.words)
      if (choice.first == word) phrases.push_back(fmt::format("it belongs to '{}' in {}", key.name, header));
  }
  for (const BlockEntry& inner : block.blocks) {
    if (inner.key == word && !block.name.empty()) phrases.push_back("write " + inner.write_header());
    gather_owners(inner, word, phrases);
  }
}

}  // namespace

const std::string& KeyEntry::get_example(std::size_t i) const {
  return spec.examples.empty() ? default_text : spec.examples[std::min(i, spec.examples.size() - 1)];
}

std::string BlockEntry::write_header(const std::string& chosen_name) const {
  if (const auto at = name.find(within_name); at != std::string::npos) {
    std::string chosen = name;
    return "[" + chosen.replace(at + 1, within_name.size() - 2, chosen_name) + "]";
  }
  if (kind == BlockKind::list) return "[[" + name + "]]";
  if (kind == BlockKind::named) return "[" + name + "." + chosen_name + "]";
  return "[" + name + "]";
}

std::string describe_owners(const std::string& word) {
  std::vector<std::string> phrases;
  gather_owners(collect_catalogue(), word, phrases);
  if (phrases.empty() || phrases.size() > 2) return "";
  return phrases.size() == 1 ? phrases[0] : phrases[0] + ", or " + phrases[1];
}

BlockEntry collect_catalogue() {
  BlockEntry root;
  Case data;
  Collector visitor(root);
  describe(visitor, data);
  return root;
}

}  // namespace talus::input
