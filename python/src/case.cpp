// Reading and checking a case, and the declarations of all keys.

#include "model/catalogue.hpp"
#include "model/read.hpp"

#include "bind.hpp"

namespace talus::python {
namespace {

using nlohmann::json;

const char* to_word(model::BlockKind kind) {
  switch (kind) {
    case model::BlockKind::table:
      return "table";
    case model::BlockKind::list:
      return "list";
    case model::BlockKind::named:
      return "named";
    case model::BlockKind::entries:
      return "entries";
  }
  return "table";
}

json write_key(const model::KeyEntry& key) {
  return {{"name", key.name},
          {"type", key.type},
          {"meaning", key.meaning},
          {"range", key.spec.write_range()},
          {"default", key.default_text},
          {"required", key.spec.is_required},
          {"condition", key.spec.condition ? json(model::write_condition(*key.spec.condition)) : json("")},
          {"needed", key.spec.condition && key.spec.condition->required},
          {"words", key.words}};
}

json write_block(const model::BlockEntry& block) {
  json keys = json::array(), blocks = json::array();
  for (const model::KeyEntry& key : block.keys) keys.push_back(write_key(key));
  for (const model::BlockEntry& inner : block.blocks) blocks.push_back(write_block(inner));
  return {{"kind", to_word(block.kind)}, {"key", block.key}, {"header", block.name.empty() ? "" : block.write_header()},
          {"meaning", block.meaning},    {"keys", keys},     {"blocks", blocks}};
}

}  // namespace

void bind_case(py::module_& module) {
  py::class_<model::LoadedCase>(module, "LoadedCase").def_property_readonly("echo", [](const model::LoadedCase& c) {
    return to_python(c.echo);
  });
  module.def("read_case", [](const std::string& path) { return model::read_case(path); });
  module.def("read_case_text",
             [](const std::string& text, const std::string& name) { return model::read_case_text(text, name); });
  module.def("get_catalogue", [] { return to_python(write_block(model::collect_catalogue())); });
}

}  // namespace talus::python
