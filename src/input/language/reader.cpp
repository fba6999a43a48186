// SPDX-License-Identifier: MIT
#include "input/language/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "input/language/codec.hpp"

namespace talus::input {
namespace {

const toml::table empty_table;

std::string write_place(const std::string& header) {
  return header.empty() ? "at the top of the file" : "in " + header;
}

/// Writes a list: "'a'", "'a' and 'b'", "'a', 'b' and 'c'".
std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

}  // namespace

Reader::Reader(const toml::table& root, Findings& findings) : findings_(findings) {
  scopes_.push_back({&root, "", "", "", false, {}, {}});
}

void Reader::visit_key(const std::string& name, Member member, const Spec& spec, const char* /*meaning*/) {
  if (const toml::node* node = find_key(name, spec)) member.decode({spec, name, findings_, *node, write_path(name)});
}

void Reader::visit_table(const std::string& name, const Blocks& block, const char* /*meaning*/) {
  if (is_left_out(name)) return;
  enter(name, find_table(name), write_name(name), false);
  block.describe(*this, block.at);
  leave();
}

void Reader::visit_optional_table(const std::string& name, const Blocks& block, const char* /*meaning*/) {
  if (!is_given(name)) return;
  enter(name, find_table(name), write_name(name), false);
  block.resize(block.at, 1);
  block.describe(*this, block.get(block.at, 0));
  leave();
}

void Reader::visit_tables(const std::string& name, const Blocks& blocks, int /*samples*/, const char* /*meaning*/) {
  const std::vector<const toml::table*> list = find_tables(name);
  blocks.resize(blocks.at, list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    enter(name + "." + std::to_string(i), list[i], write_name(name), true);
    blocks.describe(*this, blocks.get(blocks.at, i));
    leave();
  }
}

void Reader::visit_named(const std::string& name, const Blocks& blocks, const char* /*sample*/, int /*samples*/,
                         const char* /*meaning*/) {
  for (const std::string& label : enter_names(name)) {
    enter(label, find_table(label), write_name(label), false);
    blocks.describe(*this, blocks.find(blocks.at, label));
    leave();
  }
  scopes_.pop_back();
}

void Reader::visit_entries(const std::string& name, const Entries& values, const char* /*sample*/, int /*samples*/,
                           const Spec& spec, const char* /*meaning*/) {
  for (const std::string& label : enter_names(name)) {
    const std::shared_ptr<void> value = values.make();
    const toml::node* node = find_key(label, spec);
    if (node == nullptr) continue;
    if (Member{value.get(), values.type}.decode({spec, label, findings_, *node, write_path(label)}))
      values.set(values.at, label, value.get());
  }
  scopes_.pop_back();
}

std::string Reader::write_path(const std::string& name) const {
  return scopes_.back().path.empty() ? name : scopes_.back().path + "." + name;
}

std::string Reader::write_name(const std::string& name) const {
  return scopes_.back().name.empty() ? name : scopes_.back().name + "." + name;
}

void Reader::record(const toml::node& node, const std::string& path) {
  const toml::source_position at = node.source().begin;
  findings_.places.record(path, static_cast<int>(at.line), static_cast<int>(at.column));
}

const toml::node* Reader::find_key(const std::string& name, const Spec& spec) {
  Scope& scope = scopes_.back();
  if (scope.is_broken) return nullptr;
  scope.known.push_back(name);
  const std::string path = write_path(name);
  const toml::node* node = scope.table->get(name);
  if (node != nullptr) record(*node, path);
  bool is_required = spec.is_required;
  MissingKey missing{name, spec.examples.empty() ? "" : spec.examples[0], "", ""};
  if (spec.condition) {
    const Condition& condition = *spec.condition;
    // If the other key is wrong or missing, it is undecided whether this key is allowed.
    for (const Alternative& other : condition.any)
      if (!findings_.is_sound(other.key.find('.') == std::string::npos ? write_path(other.key) : other.key))
        return node;
    if (!condition.holds() && node != nullptr) {
      findings_.add(path, condition.is_absence() ? fmt::format("'{}' {} has no meaning where '{}' is given", name,
                                                               write_place(scope.header), condition.any.front().key)
                                                 : fmt::format("'{}' {} has a meaning only with {}", name,
                                                               write_place(scope.header), write_condition(condition)));
      return nullptr;
    }
    is_required = condition.required && condition.holds();
    Condition reasons;
    for (const Alternative& other : condition.any)
      if (other.holds) reasons.any.push_back(other);
    if (is_required && condition.is_absence())
      missing.instead = condition.any.front().key;
    else if (is_required)
      missing.needed_by = write_condition(reasons);
  }
  if (missing.needed_by.empty() && missing.instead.empty() && spec.instead) missing.instead = spec.instead->key;
  if (node == nullptr && is_required && !spec.is_waived(methods_)) {
    findings_.add_at({}, path, "");
    scope.missing.push_back(std::move(missing));
  }
  return node;
}

bool Reader::is_given(const std::string& name) {
  Scope& scope = scopes_.back();
  scope.known.push_back(name);
  return !scope.is_broken && scope.table->contains(name);
}

const toml::table* Reader::find_table(const std::string& name) {
  Scope& scope = scopes_.back();
  if (scope.is_broken) return nullptr;
  scope.known.push_back(name);
  const toml::node* node = scope.table->get(name);
  if (node == nullptr) return &empty_table;
  record(*node, write_path(name));
  if (const toml::table* table = node->as_table()) return table;
  findings_.add(
      write_path(name),
      node->is_array()
          ? fmt::format("'{0}' is one table, not a list of tables; write [{0}] instead of [[{0}]]", write_name(name))
          : fmt::format("'{0}' must be a table; write [{0}]", write_name(name)));
  return nullptr;
}

std::vector<const toml::table*> Reader::find_tables(const std::string& name) {
  Scope& scope = scopes_.back();
  scope.known.push_back(name);
  const toml::node* node = scope.table->get(name);
  if (node == nullptr) return {};
  const std::string path = write_path(name);
  record(*node, path);
  const std::string advice = fmt::format("'{0}' is a list of tables; write [[{0}]]", write_name(name));
  std::vector<const toml::table*> list;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    findings_.add(path, advice + (node->is_table() ? fmt::format(" instead of [{}]", write_name(name)) : ""));
    return {};
  }
  if (!is_countable(array->size(), path)) return {};
  for (const toml::node& item : *array) {
    const std::string item_path = path + "." + std::to_string(list.size());
    record(item, item_path);
    list.push_back(item.as_table());
    if (list.back() == nullptr) findings_.add(item_path, advice);
  }
  return list;
}

bool Reader::is_countable(std::size_t size, const std::string& path) {
  constexpr std::size_t most_tables = 1000;
  if (size > most_tables)
    findings_.add(path, "there are {} of [{}], and a case has at most {}", size, path, most_tables);
  return size <= most_tables;
}

std::vector<std::string> Reader::enter_names(const std::string& name) {
  const toml::table* table = find_table(name);
  enter(name, table, write_name(name), false);
  if (table == nullptr || !is_countable(table->size(), scopes_.back().path)) return {};
  std::vector<std::string> names;
  for (const auto& [key, node] : *table) {
    names.emplace_back(key.str());
    if (names.back().find_first_of("\n\r") != std::string::npos)
      findings_.add(write_path(names.back()), "a name {} must be one line", write_place(scopes_.back().header));
  }
  return names;
}

void Reader::enter(const std::string& step, const toml::table* table, const std::string& name, bool is_list) {
  const std::string header = is_list ? "[[" + name + "]]" : "[" + name + "]";
  scopes_.push_back(
      {table == nullptr ? &empty_table : table, write_path(step), name, header, table == nullptr, {}, {}});
}

std::string Reader::write_missing(const std::string& place, const std::vector<MissingKey>& keys) {
  const bool is_one = keys.size() == 1;
  std::vector<std::string> names, examples, others, choices;
  std::map<std::string, std::vector<std::string>> needs;
  for (const MissingKey& key : keys) {
    names.push_back("'" + key.name + "'");
    if (!key.example.empty()) examples.push_back(key.name + " = " + key.example);
    if (!key.needed_by.empty()) {
      if (!needs.contains(key.needed_by)) choices.push_back(key.needed_by);
      needs[key.needed_by].push_back(names.back());
    } else if (!key.instead.empty()) {
      others.push_back(fmt::format("'{}'{}", key.instead, is_one ? "" : " instead of " + names.back()));
    }
  }
  std::string text = fmt::format("missing key{} {} {}", is_one ? "" : "s", join(names), place);
  if (!examples.empty()) text += ", for example " + join(examples);
  for (const std::string& choice : choices)
    text += fmt::format("; {} needs {}", choice,
                        is_one                                 ? "it"
                        : needs[choice].size() == names.size() ? "them"
                                                               : join(needs[choice]));
  return others.empty() ? text : fmt::format("{}{} or give {}", text, is_one ? "," : ";", fmt::join(others, " or "));
}

void Reader::report_missing(const Scope& scope) {
  if (scope.missing.empty()) return;
  const std::string& first = scope.missing.front().name;
  findings_.add(scope.path.empty() ? first : scope.path + "." + first,
                write_missing(write_place(scope.header), scope.missing));
}

namespace {

/// Returns why a key that users expect here is refused; nullptr for any other key.
const char* find_reserved(const std::string& path, const std::string& name) {
  struct Reserved {
    const char *block, *key, *why;
  };
  constexpr Reserved list[] = {
      {"support.", "stage", "supports come and go by their names in 'add' and 'remove' of [[construction]]"}};
  for (const Reserved& r : list)
    if (name == r.key && path.starts_with(r.block)) return r.why;
  return nullptr;
}

}  // namespace

void Reader::leave() {
  const Scope scope = std::move(scopes_.back());
  scopes_.pop_back();
  report_missing(scope);
  constexpr std::size_t most_unknown = 1000;
  std::size_t unknown = 0;
  for (const auto& [key, node] : *scope.table) {
    const std::string name(key.str());
    if (std::find(scope.known.begin(), scope.known.end(), name) != scope.known.end()) continue;
    if (++unknown > most_unknown) continue;
    const std::string near = find_nearest(name, scope.known);
    const std::string owners =
        near.empty() && findings_.describe_owners ? findings_.describe_owners(name) : std::string();
    const std::string path = scope.path.empty() ? name : scope.path + "." + name;
    const char* reserved = find_reserved(scope.path, name);
    const toml::source_position at = key.source().begin;
    findings_.add_unknown_key(
        findings_.places.locate(path, static_cast<int>(at.line), static_cast<int>(at.column)), path,
        reserved != nullptr
            ? fmt::format("'{}' {}: {}", name, write_place(scope.header), reserved)
            : fmt::format("unknown key '{}' {}; {}", name, write_place(scope.header),
                          !near.empty()     ? fmt::format("did you mean '{}'?", near)
                          : !owners.empty() ? owners
                                            : fmt::format("known are '{}'", fmt::join(scope.known, "', '"))));
  }
  if (unknown > most_unknown)
    findings_.add(scope.path, "{} more unknown keys {}", unknown - most_unknown, write_place(scope.header));
}

}  // namespace talus::input
