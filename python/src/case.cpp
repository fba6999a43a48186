// SPDX-License-Identifier: MIT
// Bindings that read and check a case, and list the declarations of all keys.

#include <nlohmann/json.hpp>

#include "input/catalogue.hpp"
#include "input/read.hpp"

#include "bind.hpp"

namespace talus::python {
namespace {

using nlohmann::json;

const char* to_word(input::BlockKind kind) {
  switch (kind) {
    case input::BlockKind::table:
      return "table";
    case input::BlockKind::list:
      return "list";
    case input::BlockKind::named:
      return "named";
    case input::BlockKind::entries:
      return "entries";
  }
  return "table";
}

json write_key(const input::KeyEntry& key) {
  return {{"name", key.name},
          {"type", key.type},
          {"meaning", key.meaning},
          {"range", key.spec.write_range()},
          {"default", key.default_text},
          {"required", key.spec.is_required},
          {"condition", key.spec.condition ? json(input::write_condition(*key.spec.condition)) : json("")},
          {"needed", key.spec.condition && key.spec.condition->required},
          {"words", key.words}};
}

json write_block(const input::BlockEntry& block) {
  json keys = json::array(), blocks = json::array();
  for (const input::KeyEntry& key : block.keys) keys.push_back(write_key(key));
  for (const input::BlockEntry& inner : block.blocks) blocks.push_back(write_block(inner));
  return {{"kind", to_word(block.kind)}, {"key", block.key}, {"header", block.name.empty() ? "" : block.write_header()},
          {"meaning", block.meaning},    {"keys", keys},     {"blocks", blocks}};
}

}  // namespace

void bind_case(py::module_& module) {
  py::class_<input::LoadedCase>(module, "LoadedCase").def_property_readonly("echo", [](const input::LoadedCase& c) {
    return to_python(c.echo.get());
  });
  module.def("read_case", [](const std::string& path) { return input::read_case(path); });
  module.def("read_case_text",
             [](const std::string& text, const std::string& name) { return input::read_case_text(text, name); });
  module.def("get_catalogue", [] { return to_python(write_block(input::collect_catalogue())); });
}

}  // namespace talus::python
