// SPDX-License-Identifier: MIT
#include "base/json_tree.hpp"

#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace talus {

JsonTree::JsonTree(nlohmann::json tree) : tree_(std::make_shared<const nlohmann::json>(std::move(tree))) {}

JsonTree JsonTree::parse(const std::string& text) {
  nlohmann::json tree = nlohmann::json::parse(text, nullptr, false);
  if (tree.is_discarded()) fail_input("an input that was stored is damaged: it is no JSON");
  return JsonTree(std::move(tree));
}

const nlohmann::json& JsonTree::get() const {
  static const nlohmann::json nothing = nlohmann::json::object();
  return tree_ ? *tree_ : nothing;
}

std::string JsonTree::write() const {
  return get().dump();
}

}  // namespace talus
