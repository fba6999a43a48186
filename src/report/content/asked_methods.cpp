// SPDX-License-Identifier: MIT
#include "report/content/asked_methods.hpp"

#include <algorithm>

namespace talus::report {

bool asks_for(const ResultFolder& folder, Method method) {
  if (folder.run.methods && !folder.run.methods->asked.empty()) {
    const std::vector<Method>& asked = folder.run.methods->asked;
    return std::find(asked.begin(), asked.end(), method) != asked.end();
  }
  // A run that failed before the methods gave an answer has the echo of its input only.
  switch (method) {
    case Method::lem:
      return input::uses(folder.data, input::Method::lem);
    case Method::fem:
      return input::uses(folder.data, input::Method::fem);
    case Method::bounds:
      return input::uses(folder.data, input::Method::bounds);
    default:
      return input::uses(folder.data, input::Method::mpm);
  }
}

bool asks_for_others(const ResultFolder& folder) {
  return asks_for(folder, Method::lem) || asks_for(folder, Method::fem) || asks_for(folder, Method::bounds);
}

}  // namespace talus::report
