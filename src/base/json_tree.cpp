#include "base/json_tree.hpp"

#include <nlohmann/json.hpp>

namespace talus {

JsonTree::JsonTree(nlohmann::json tree) : tree_(std::make_shared<const nlohmann::json>(std::move(tree))) {}

const nlohmann::json& JsonTree::get() const {
  static const nlohmann::json nothing = nlohmann::json::object();
  return tree_ ? *tree_ : nothing;
}

std::string JsonTree::write() const {
  return get().dump();
}

}  // namespace talus
