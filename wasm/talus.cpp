// SPDX-License-Identifier: MIT
// The functions of the studio's engine for JavaScript (src/studio/engine.hpp): texts in, JSON texts out.
#include <emscripten/bind.h>

#include <string>

#include "studio/engine.hpp"

namespace {

std::string check(const std::string& text) {
  return talus::studio::check(text);
}
std::string solve(const std::string& text, const std::string& options) {
  return talus::studio::solve(text, options);
}

}  // namespace

EMSCRIPTEN_BINDINGS(talus) {
  emscripten::function("check", &check);
  emscripten::function("solve", &solve);
  emscripten::function("schema", &talus::studio::schema);
  emscripten::function("template", &talus::studio::template_text);
}
