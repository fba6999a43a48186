#include "report/content/asked_methods.hpp"

#include <algorithm>

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

bool asks_for(const json& summary, const std::string& method) {
  const json* asked = &find_list(summary, {"methods", "asked"});
  // A run that failed before the methods gave an answer has the echo of its input only.
  if (asked->empty()) asked = &find_list(summary, {"input", "analysis", "methods", "value"});
  return asked->empty() ? method == "mpm" : std::find(asked->begin(), asked->end(), method) != asked->end();
}

}  // namespace talus::report
