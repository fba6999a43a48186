// SPDX-License-Identifier: MIT
#pragma once
// The visitor that reads a TOML table into the structs and reports unknown, missing and invalid keys.

#include <toml++/toml.h>

#include <set>
#include <string>
#include <vector>

#include "input/language/findings.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

class Reader : public Visitor {
 public:
  Reader(const toml::table& root, Findings& findings);

  /// Sets the blocks at the top level that may be absent.
  void leave_out(const std::set<std::string>& blocks) { left_out_ = blocks; }

  /// Sets the methods of the case: a key that none of them needs is not required.
  void ask_methods(const std::set<std::string>& words) { methods_ = words; }

  /// Reports undeclared keys at the top level.
  void finish() { leave(); }

 protected:
  void visit_key(const std::string& name, Member member, const Spec& spec, const char* meaning) override;
  void visit_table(const std::string& name, const Blocks& block, const char* meaning) override;
  void visit_optional_table(const std::string& name, const Blocks& block, const char* meaning) override;
  void visit_tables(const std::string& name, const Blocks& blocks, int samples, const char* meaning) override;
  void visit_named(const std::string& name, const Blocks& blocks, const char* sample, int samples,
                   const char* meaning) override;
  void visit_entries(const std::string& name, const Entries& values, const char* sample, int samples, const Spec& spec,
                     const char* meaning) override;

 private:
  /// A key that a table lacks.
  struct MissingKey {
    std::string name;
    std::string example;    ///< a value; may be empty
    std::string needed_by;  ///< the choice that requires it: `fix = "plane"`; may be empty
    std::string instead;    ///< a key that may stand for it; may be empty
  };

  struct Scope {
    const toml::table* table;
    std::string path;    ///< with indices of list entries: stage.0
    std::string name;    ///< as in the file: materials.sand
    std::string header;  ///< as in messages: [materials.sand], [[stage]]
    bool is_broken;      ///< not a table: only that fault is reported, no consequential ones
    std::vector<std::string> known;
    std::vector<MissingKey> missing;
  };

  static std::string write_missing(const std::string& place, const std::vector<MissingKey>& keys);
  /// Reports the missing keys of a table in one sentence.
  void report_missing(const Scope& scope);

  bool is_left_out(const std::string& name) const {
    return scopes_.size() == 1 && left_out_.count(name) != 0 && !scopes_.back().table->contains(name);
  }
  std::string write_path(const std::string& name) const;
  std::string write_name(const std::string& name) const;
  /// Returns the node of a key of the current table; nullptr if it is not given or rejected.
  const toml::node* find_key(const std::string& name, const Spec& spec);
  /// Returns true if the current table has the key; marks the key as known.
  bool is_given(const std::string& name);
  /// Returns the table `name`; an empty one if it is not given, nullptr if the key is not a table.
  const toml::table* find_table(const std::string& name);
  std::vector<const toml::table*> find_tables(const std::string& name);
  /// Returns false and adds a fault at `path` if a case has more tables of one kind than allowed.
  bool is_countable(std::size_t size, const std::string& path);
  /// Enters a table with user-defined keys and returns them in the order of the file.
  std::vector<std::string> enter_names(const std::string& name);
  /// Enters a block. `step` is what the block adds to the path; `name` is its full name.
  void enter(const std::string& step, const toml::table* table, const std::string& name, bool is_list);
  void leave();
  void record(const toml::node& node, const std::string& path);

  Findings& findings_;
  std::vector<Scope> scopes_;
  std::set<std::string> left_out_;
  std::set<std::string> methods_{"mpm"};
};

}  // namespace talus::input
