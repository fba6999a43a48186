// SPDX-License-Identifier: MIT
#include "input/echo.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "input/case/case.hpp"
#include "input/language/codecs.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

/// The visitor that writes the structs as JSON.
class Echo {
 public:
  Echo(const Places& places, const std::set<std::string>& methods) : Echo(places, methods, "") {}

  template <class T>
  void key(const std::string& name, T&& member, const Spec& spec, const char* /*meaning*/) {
    if (spec.condition && !spec.condition->holds()) return;
    // A key that no method needs and that was not given has no value.
    if (!spec.methods.empty() && spec.is_waived(methods_) && !places_.is_given(write_path(name))) return;
    json entry = {{"value", Codec<std::remove_cvref_t<T>>::encode(member, spec)},
                  {"given", places_.is_given(write_path(name))}};
    if (!spec.unit.empty()) entry["unit"] = spec.unit;
    object_[name] = std::move(entry);
  }

  template <class T>
  void table(const std::string& name, T&& block, const char* /*meaning*/) {
    object_[name] = write_block(write_path(name), block);
  }

  template <class T>
  void optional_table(const std::string& name, std::optional<T>& block, const char* meaning) {
    if (block) table(name, *block, meaning);
  }

  template <class T>
  void tables(const std::string& name, std::vector<T>& blocks, int /*samples*/, const char* /*meaning*/) {
    json list = json::array();
    for (std::size_t i = 0; i < blocks.size(); ++i)
      list.push_back(write_block(write_path(name) + "." + std::to_string(i), blocks[i]));
    object_[name] = std::move(list);
  }

  template <class T>
  void named(const std::string& name, std::map<std::string, T>& blocks, const char* /*sample*/,
             const char* /*meaning*/) {
    json list = json::object();
    for (auto& [label, block] : blocks) list[label] = write_block(write_path(name) + "." + label, block);
    object_[name] = std::move(list);
  }

  template <class T>
  void entries(const std::string& name, std::map<std::string, T>& values, const char* /*sample*/, int /*samples*/,
               const Spec& spec, const char* meaning) {
    Echo inner(places_, methods_, write_path(name));
    for (auto& [label, value] : values) inner.key(label, value, spec, meaning);
    object_[name] = std::move(inner.object_);
  }

  json take() { return std::move(object_); }

 private:
  Echo(const Places& places, const std::set<std::string>& methods, std::string path)
      : places_(places), methods_(methods), path_(std::move(path)) {}

  template <class T>
  json write_block(const std::string& path, T& block) {
    Echo inner(places_, methods_, path);
    describe(inner, block);
    return std::move(inner.object_);
  }

  std::string write_path(const std::string& name) const { return path_.empty() ? name : path_ + "." + name; }

  const Places& places_;
  const std::set<std::string>& methods_;
  std::string path_;
  json object_ = json::object();
};

}  // namespace

json echo(const Case& data, const Places& places) {
  Case copy = data;  // one declaration serves readers and writers, so it takes what it may change
  std::set<std::string> methods;
  for (const Method method : data.methods) methods.insert(get_word(method));
  if (!data.tests.empty()) methods.insert("fem");
  Echo visitor(places, methods);
  describe(visitor, copy);
  return visitor.take();
}

}  // namespace talus::input
