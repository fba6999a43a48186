// SPDX-License-Identifier: MIT
#pragma once
// A JSON tree that is carried along and written out, such as the echo of a case. Code that reads it includes json.hpp.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace talus {

class JsonTree {
 public:
  /// Nothing.
  JsonTree() = default;
  explicit JsonTree(nlohmann::json tree);

  /// From a text that was written by write(). Throws Error (wrong_input) when it is no JSON.
  static JsonTree parse(const std::string& text);

  bool is_empty() const { return tree_ == nullptr; }
  /// The tree; an empty object where there is none.
  const nlohmann::json& get() const;
  /// On one line.
  std::string write() const;

 private:
  std::shared_ptr<const nlohmann::json> tree_;
};

}  // namespace talus
