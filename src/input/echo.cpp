// SPDX-License-Identifier: MIT
#include "input/echo.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/numbers.hpp"
#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/case/material.hpp"
#include "input/case/support.hpp"
#include "input/language/codec_types.hpp"
#include "input/language/parse.hpp"

namespace talus::input {

namespace {

using nlohmann::json;

/// The visitor that writes the structs as JSON.
class Echo : public Visitor {
 public:
  Echo(const Places& places, const std::set<std::string>& methods) : Echo(places, methods, "") {}

  json take() { return std::move(object_); }

 protected:
  void visit_key(const std::string& name, Member member, const Spec& spec, const char* /*meaning*/) override {
    if (spec.condition && !spec.condition->holds()) return;
    // A key that no method requires and that was not given has no value.
    if (!spec.methods.empty() && spec.is_waived(methods_) && !places_.is_given(write_path(name))) return;
    json entry = {{"value", member.type.encode(member.type, member.at, spec)},
                  {"given", places_.is_given(write_path(name))}};
    if (!spec.unit.empty()) entry["unit"] = spec.unit;
    object_[name] = std::move(entry);
  }
  void visit_table(const std::string& name, const Blocks& block, const char* /*meaning*/) override {
    object_[name] = write_block(write_path(name), block, block.at);
  }
  void visit_optional_table(const std::string& name, const Blocks& block, const char* /*meaning*/) override {
    if (block.get_size(block.at) > 0) object_[name] = write_block(write_path(name), block, block.get(block.at, 0));
  }
  void visit_tables(const std::string& name, const Blocks& blocks, int /*samples*/, const char* /*meaning*/) override {
    json list = json::array();
    for (std::size_t i = 0; i < blocks.get_size(blocks.at); ++i)
      list.push_back(write_block(write_path(name) + "." + std::to_string(i), blocks, blocks.get(blocks.at, i)));
    object_[name] = std::move(list);
  }
  void visit_named(const std::string& name, const Blocks& blocks, const char* /*sample*/, int /*samples*/,
                   const char* /*meaning*/) override {
    json list = json::object();
    for (const std::string& label : blocks.list_names(blocks.at))
      list[label] = write_block(write_path(name) + "." + label, blocks, blocks.find(blocks.at, label));
    object_[name] = std::move(list);
  }
  void visit_entries(const std::string& name, const Entries& values, const char* /*sample*/, int /*samples*/,
                     const Spec& spec, const char* meaning) override {
    Echo inner(places_, methods_, write_path(name));
    for (const std::string& label : values.list_names(values.at))
      inner.visit_key(label, {values.find(values.at, label), values.type}, spec, meaning);
    object_[name] = inner.take();
  }

 private:
  Echo(const Places& places, const std::set<std::string>& methods, std::string path)
      : places_(places), methods_(methods), path_(std::move(path)) {}

  json write_block(const std::string& path, const Blocks& blocks, void* block) {
    Echo inner(places_, methods_, path);
    blocks.describe(inner, block);
    return inner.take();
  }

  std::string write_path(const std::string& name) const { return path_.empty() ? name : path_ + "." + name; }

  const Places& places_;
  const std::set<std::string>& methods_;
  std::string path_;
  json object_ = json::object();
};

}  // namespace

json echo(const Case& data, const Places& places) {
  Case copy = data;  // describe() takes a mutable case, because readers use the same declaration
  std::set<std::string> methods;
  for (const Method method : data.methods) methods.insert(get_word(method));
  if (!data.tests.empty()) methods.insert("fem");
  Echo visitor(places, methods);
  describe(visitor, copy);
  return visitor.take();
}

// Queries of an echo without conversion to a case: comparison of two echoes and labels.

namespace {

json strip_marks(json node) {
  if (node.is_object()) node.erase("given");
  if (node.is_structured())
    for (json& inner : node) inner = strip_marks(inner);
  return node;
}

/// Returns the keys that determine the mesh.
json describe_mesh_input(const json& echo) {
  json mesh = strip_marks(echo.at("mesh"));
  mesh.erase("points_per_element");
  // The path of an external mesh depends on the working directory, so only the file name is compared.
  if (mesh.contains("file"))
    mesh["file"] = std::filesystem::path(mesh["file"].at("value").get<std::string>()).filename().string();
  return {strip_marks(echo.at("geometry")), mesh};
}

}  // namespace

std::string hash_input(const JsonTree& tree, const Case& data) {
  json echo = tree.get();
  for (const char* block : {"output", "project", "compare"}) echo.erase(block);
  const std::function<void(json&)> strip = [&](json& node) {
    if (node.is_object()) node.erase("courant");
    if (node.is_structured()) std::for_each(node.begin(), node.end(), strip);
  };
  strip(echo);
  std::string text = echo.dump();
  if (const auto& field = data.initial.water.field)
    for (std::size_t i = 0; i < field->values().size(); ++i)
      text += fmt::format("{:a},{:a},{:a};", field->triangles().nodes[i][0], field->triangles().nodes[i][1],
                          field->values()[i]);
  return hash_text(text);
}

bool has_same_mesh_input(const JsonTree& a, const JsonTree& b) {
  return describe_mesh_input(a.get()) == describe_mesh_input(b.get());
}

JsonTree replace_mesh_input(const JsonTree& echo, const JsonTree& other) {
  json replaced = echo.get();
  for (const char* block : {"geometry", "mesh"}) replaced[block] = other.get().at(block);
  return JsonTree(std::move(replaced));
}

std::vector<MaterialModel> list_material_models(const JsonTree& echo, const std::string& source) {
  std::vector<MaterialModel> models;
  for (const auto& [name, material] : echo.get().at("materials").items()) {
    const std::string word = material.at("model").at("value");
    const auto& words = choices<MaterialModel>;
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& c) { return c.word == word; });
    if (found == words.end())
      fail_input("the result '{}' has a material of the model '{}', which this version does not know", source, word);
    // The points of soil whose cohesion grows have the law with a cohesion of their own.
    const auto growth = material.find("cohesion_gradient");
    const bool grows = growth != material.end() && growth->at("value").is_number() && growth->at("value") != 0.0;
    models.push_back(found->value == material::model_of<material::MohrCoulomb> && grows
                         ? material::model_of<material::RootedMohrCoulomb>
                         : found->value);
  }
  return models;
}

// Look-up of keys by their paths in an echo.

namespace {

std::string write_value(const json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_number_float()) return value.dump();
  return write_shortest(value.get<double>());
}

}  // namespace

std::optional<EchoedKey> find_key(const JsonTree& echo, const std::string& path) {
  const json* at = &echo.get();
  for (const std::string& step : split_path(path)) {
    if (at->is_array())
      at = find_entry(*at, step);
    else
      at = at->is_object() && at->contains(step) ? &(*at)[step] : nullptr;
    if (at == nullptr) return std::nullopt;
  }
  if (!at->is_object() || !at->contains("value")) return std::nullopt;
  return EchoedKey{write_value(at->at("value")), at->value("unit", "")};
}

namespace {

void add_keys(const json& node, const std::string& path, std::vector<ListedKey>& keys) {
  if (node.is_object() && node.contains("value") && node.contains("given")) {
    ListedKey key{path, std::nullopt, "", node.value("unit", ""), node.at("given").get<bool>()};
    const json& value = node.at("value");
    if (value.is_number())
      key.number = value.get<double>();
    else if (value.is_string())
      key.text = value.get<std::string>();
    else if (!value.is_null())
      key.text = value.dump();
    keys.push_back(std::move(key));
    return;
  }
  std::size_t i = 0;
  for (const auto& [name, inner] : node.items()) {
    const std::string step = node.is_array() ? std::to_string(i++) : name;
    if (inner.is_structured()) add_keys(inner, path.empty() ? step : fmt::format("{}.{}", path, step), keys);
  }
}

}  // namespace

std::vector<ListedKey> list_keys(const JsonTree& echo) {
  std::vector<ListedKey> keys;
  add_keys(echo.get(), "", keys);
  return keys;
}

std::string write_calculated(const JsonTree& echo) {
  return strip_marks(echo.get()).dump();
}

// Conversion of an echo to a case, for results whose case file is not available.

namespace {

/// Appends the TOML equivalent of a JSON value; null is skipped.
void append(toml::array& list, const json& value);

toml::array to_array(const json& values) {
  toml::array list;
  for (const json& value : values) append(list, value);
  return list;
}

/// Calls `take` with the TOML equivalent of a JSON value, except null and objects, which do not occur as leaves.
void with_toml(const json& value, const auto& take) {
  if (value.is_boolean()) return take(toml::value<bool>(value.get<bool>()));
  if (value.is_number_integer()) return take(toml::value<std::int64_t>(value.get<std::int64_t>()));
  if (value.is_number()) return take(toml::value<double>(value.get<double>()));
  if (value.is_string()) return take(toml::value<std::string>(value.get<std::string>()));
  if (value.is_array()) return take(to_array(value));
}

void append(toml::array& list, const json& value) {
  with_toml(value, [&](auto&& node) { list.push_back(std::forward<decltype(node)>(node)); });
}

/// The visitor that reads the structs from an echo. A key that is missing or has another form keeps its default,
/// because the results may be from another version.
class EchoReader : public Visitor {
 public:
  EchoReader(const json& object, Findings& findings) : object_(object), findings_(findings) {}

 protected:
  void visit_key(const std::string& name, Member member, const Spec& spec, const char* /*meaning*/) override {
    const json& leaf = look_up(name);
    if (!leaf.is_object() || !leaf.contains("value")) return;
    const json& value = leaf.at("value");
    // JSON has no infinity, so it is written as null.
    if (value.is_null() && spec.allows_infinity && &member.type == &get_key_type<double>())
      return member.type.set_number(member.at, std::numeric_limits<double>::infinity());
    with_toml(value, [&](const toml::node& node) { member.decode({spec, name, findings_, node, name}); });
  }
  void visit_table(const std::string& name, const Blocks& block, const char* /*meaning*/) override {
    read_block(look_up(name), block, block.at);
  }
  void visit_optional_table(const std::string& name, const Blocks& block, const char* /*meaning*/) override {
    if (!look_up(name).is_object()) return;
    block.resize(block.at, 1);
    read_block(look_up(name), block, block.get(block.at, 0));
  }
  void visit_tables(const std::string& name, const Blocks& blocks, int /*samples*/, const char* /*meaning*/) override {
    const json& list = look_up(name);
    if (!list.is_array()) return;
    blocks.resize(blocks.at, list.size());
    for (std::size_t i = 0; i < list.size(); ++i) read_block(list[i], blocks, blocks.get(blocks.at, i));
  }
  void visit_named(const std::string& name, const Blocks& blocks, const char* /*sample*/, int /*samples*/,
                   const char* /*meaning*/) override {
    if (!look_up(name).is_object()) return;
    for (const auto& [label, block] : look_up(name).items()) read_block(block, blocks, blocks.find(blocks.at, label));
  }
  void visit_entries(const std::string& name, const Entries& values, const char* /*sample*/, int /*samples*/,
                     const Spec& spec, const char* meaning) override {
    if (!look_up(name).is_object()) return;
    EchoReader inner(look_up(name), findings_);
    for (const auto& [label, leaf] : look_up(name).items())
      inner.visit_key(label, {values.find(values.at, label), values.type}, spec, meaning);
  }

 private:
  const json& look_up(const std::string& name) const {
    static const json nothing;
    return object_.is_object() && object_.contains(name) ? object_.at(name) : nothing;
  }

  void read_block(const json& object, const Blocks& blocks, void* block) {
    EchoReader inner(object, findings_);
    blocks.describe(inner, block);
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

JsonTree drop_absent(const JsonTree& echo, const Case& data) {
  nlohmann::json left = echo.get();
  const auto keep = [](nlohmann::json& list, const auto& objects) {
    nlohmann::json kept = nlohmann::json::array();
    for (const nlohmann::json& entry : list)
      if (std::any_of(objects.begin(), objects.end(),
                      [&](const auto& object) { return entry.at("name").at("value") == object.name; }))
        kept.push_back(entry);
    list = std::move(kept);
  };
  keep(left["geometry"]["polygon"], data.mesh.polygons);
  keep(left["surcharge"], data.surcharges);
  keep(left["vertical_drains"], data.drains);
  nlohmann::json& supports = left["support"];
  for (auto entry = supports.begin(); entry != supports.end();)
    entry = data.supports.contains(entry.key()) ? std::next(entry) : supports.erase(entry);
  for (const auto& [region, soil] : data.regions)
    if (left["regions"].contains(region)) left["regions"][region]["value"] = soil;
  left["construction"] = nlohmann::json::array();
  return JsonTree(std::move(left));
}

}  // namespace talus::input
