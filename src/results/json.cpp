// SPDX-License-Identifier: MIT
#include "results/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/user_file.hpp"

namespace talus::results {

using nlohmann::json;

namespace {

json write_members(Value structure);

/// Writes a struct as an object.
class JsonWriter : public Visitor {
 public:
  json object = json::object();

 protected:
  void visit(const Key& key, Value value) override {
    if (key.presence == Presence::if_given) value = value.get_held();
    if (!value.is_null()) object[key.name] = write_json(value);
  }
  void visit_merged(const char* /*sign*/, Value block) override {
    if (const Value held = block.get_held(); !held.is_null()) held.describe(*this);
  }
};

json write_members(Value structure) {
  JsonWriter writer;
  structure.describe(writer);
  return std::move(writer.object);
}

json write_integer(Value value) {
  const std::int64_t bits = value.get_integer();
  return value.type->is_signed ? json(bits) : json(static_cast<std::uint64_t>(bits));
}

json write_list(Value list) {
  json::array_t entries;
  const std::size_t size = list.get_size();
  entries.reserve(size);
  for (std::size_t i = 0; i < size; ++i) entries.push_back(write_json(list.get_entry(i)));
  return entries;
}

}  // namespace

json write_json(Value value) {
  switch (value.shape()) {
    case Shape::boolean:
      return value.get_boolean();
    case Shape::integer:
      return write_integer(value);
    case Shape::number:
      return value.get_number();
    case Shape::text:
      return value.get_text();
    case Shape::word:
      return value.get_word();
    case Shape::tree:
      return static_cast<const JsonTree*>(value.at)->get();
    case Shape::optional: {
      const Value held = value.get_held();
      return held.is_null() ? json() : write_json(held);
    }
    case Shape::list:
    case Shape::array:
      return write_list(value);
    case Shape::map: {
      json object = json::object();
      value.type->for_each(value.at, [&](const std::string& name, void* entry) {
        object[name] = write_json({entry, value.type->inner});
      });
      return object;
    }
    case Shape::structure:
      return write_members(value);
  }
  return {};
}

namespace {

/// Position of a value as a chain of keys up to the file. It is formatted only for an error message.
class JsonPlace {
 public:
  explicit JsonPlace(const std::string& file) : key_(file) {}
  JsonPlace(const JsonPlace& owner, std::string_view key) : owner_(&owner), key_(key) {}
  JsonPlace(const JsonPlace& owner, std::size_t index) : owner_(&owner), index_(index) {}

  /// Throws if the value is not as `expected`.
  void require(bool is_right, const char* expected) const {
    if (!is_right) fail_input("{} should be {}: it is not as this version writes it", write(), expected);
  }

 private:
  /// Returns a position such as "summary.json: fem.runs[0].factor".
  std::string write() const {
    if (owner_ == nullptr) return std::string(key_);
    if (key_.empty()) return fmt::format("{}[{}]", owner_->write(), index_);
    return fmt::format("{}{}{}", owner_->write(), owner_->owner_ == nullptr ? ": " : ".", key_);
  }

  const JsonPlace* owner_ = nullptr;
  std::string_view key_;
  std::size_t index_ = 0;
};

void read_value(const json& node, Value out, const JsonPlace& place);

/// Reads a struct from an object.
class JsonReader : public Visitor {
 public:
  JsonReader(const json& object, const JsonPlace& place) : object_(object), place_(place) {}

 protected:
  void visit(const Key& key, Value value) override {
    if (key.presence == Presence::derived) return;
    const auto found = object_.find(key.name);
    if (found != object_.end()) read_value(*found, value, JsonPlace(place_, std::string_view(key.name)));
  }
  void visit_merged(const char* sign, Value block) override {
    if (object_.contains(sign)) block.type->inner->describe(*this, block.type->emplace(block.at));
  }

 private:
  const json& object_;
  const JsonPlace& place_;
};

void read_integer(const json& node, Value out) {
  const auto bits =
      out.type->is_signed ? node.get<std::int64_t>() : static_cast<std::int64_t>(node.get<std::uint64_t>());
  out.type->set_integer(out.at, bits);
}

void read_word(const json& node, Value out, const JsonPlace& place) {
  place.require(node.is_string(), "a word");
  const auto& text = node.get_ref<const std::string&>();
  std::size_t i = 0;
  while (i < out.type->word_count && out.type->words[i] != text) ++i;
  place.require(i < out.type->word_count, "a word that this version knows");
  out.type->set_word(out.at, i);
}

void read_value(const json& node, Value out, const JsonPlace& place) {
  const Type& type = *out.type;
  switch (type.shape) {
    case Shape::boolean:
      place.require(node.is_boolean(), "true or false");
      *static_cast<bool*>(out.at) = node.get<bool>();
      return;
    case Shape::integer:
      place.require(node.is_number(), "a whole number");
      return read_integer(node, out);
    case Shape::number:
      place.require(node.is_number() || node.is_null(), "a number");
      out.get_number() = node.is_null() ? std::nan("") : node.get<double>();  // non-finite numbers are stored as null
      return;
    case Shape::text:
      place.require(node.is_string(), "a text");
      out.get_text() = node.get<std::string>();
      return;
    case Shape::word:
      return read_word(node, out, place);
    case Shape::tree:
      place.require(node.is_object(), "an object");
      *static_cast<JsonTree*>(out.at) = JsonTree(node);
      return;
    case Shape::optional:
      if (node.is_null()) return type.reset(out.at);
      return read_value(node, {type.emplace(out.at), type.inner}, place);
    case Shape::list:
      place.require(node.is_array(), "a list");
      type.resize(out.at, node.size());
      break;
    case Shape::array:
      place.require(node.is_array() && node.size() == out.get_size(), "a list of as many numbers");
      break;
    case Shape::map:
      place.require(node.is_object(), "an object");
      type.clear(out.at);
      for (const auto& [name, entry] : node.items())
        read_value(entry, {type.insert(out.at, name), type.inner}, JsonPlace(place, name));
      return;
    case Shape::structure: {
      place.require(node.is_object(), "an object");
      JsonReader reader(node, place);
      return out.describe(reader);
    }
  }
  for (std::size_t i = 0; i < node.size(); ++i) read_value(node[i], out.get_entry(i), JsonPlace(place, i));
}

}  // namespace

void read_json(const json& tree, Value out, const std::string& file) {
  read_value(tree, out, JsonPlace(file));
}

bool read_file(const std::filesystem::path& path, bool has_format, Value out) {
  std::string text;
  if (const auto fault = try_user_file(path, largest_file::result, text)) {
    if (fault->is_missing) return false;
    fail_input("cannot read '{}': {}", path.string(), fault->why);
  }
  json tree;
  try {
    tree = json::parse(text);
  } catch (const json::exception& error) {
    fail_input("cannot read '{}': {}", path.string(), error.what());
  }
  if (out.type->shape != Shape::list && !tree.is_object())
    fail_input("'{}' is no result of Talus: it should hold one JSON object", path.string());
  if (has_format)
    if (const auto found = tree.find("format"); found == tree.end() || *found != result_format)
      fail_input("'{}' was written by another version of Talus (result format {}, this is {}): run the case again",
                 path.string(), found == tree.end() ? std::string("1") : found->dump(), result_format);
  read_json(tree, out, path.string());
  return true;
}

bool find_file(const std::filesystem::path& path, bool has_format, Value out) {
  try {
    return read_file(path, has_format, out);
  } catch (const Error&) {
    return false;
  }
}

void write_file(const std::filesystem::path& path, Value value, int indent, const std::string& safe) {
  write_atomically(path, write_json(value).dump(indent) + "\n", safe);
}

}  // namespace talus::results
