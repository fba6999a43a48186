// SPDX-License-Identifier: MIT
#pragma once
// A JSON tree without the header of the JSON library, for code that only stores or writes it, such as the echo of a
// case. Code that reads it includes json.hpp.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace talus {

class JsonTree {
 public:
  /// Makes an empty tree.
  JsonTree() = default;
  explicit JsonTree(nlohmann::json tree);

  /// Parses a text written by write(). Throws Error (wrong_input) if it is not JSON.
  static JsonTree parse(const std::string& text);

  bool is_empty() const { return tree_ == nullptr; }
  /// Returns the tree; an empty object if there is none.
  const nlohmann::json& get() const;
  /// Writes the tree on one line.
  std::string write() const;

 private:
  std::shared_ptr<const nlohmann::json> tree_;
};

}  // namespace talus
