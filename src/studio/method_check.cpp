// SPDX-License-Identifier: MIT
#include "studio/method_check.hpp"

#include <exception>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/user_file.hpp"
#include "input/read.hpp"
#include "run/check_case.hpp"
#include "run/forecast/forecast.hpp"
#include "studio/messages.hpp"

namespace talus::studio {
namespace {

using nlohmann::json;

json list_faults(const std::string& text, const std::string& name) {
  json messages = json::array();
  const input::Examination found = input::examine_text(text, name);
  if (!found.loaded || !found.faults.empty() || !found.loaded->is_whole) return messages;
  const MessageWriter writer(text, found.sketch);
  try {
    run::check_ready_mesh(*found.loaded);
    run::refuse_above_memory(*found.loaded);
    run::check_methods(found.loaded->data);
  } catch (const InputError& error) {
    for (const Diagnostic& fault : error.diagnostics()) writer.add("error", fault, messages);
  } catch (const Error& error) {
    writer.add("error", {"", 0, 0, error.what()}, messages);
  }
  return messages;
}

}  // namespace

std::string check_methods(const std::string& text, const std::string& name) {
  json answer;
  try {
    if (text.size() > largest_file::case_file) fail_input("the text is larger than a case file may be");
    answer["messages"] = list_faults(text, name);
  } catch (...) {
    answer = {{"error", explain_failure(std::current_exception()).sentence}};
  }
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace talus::studio
