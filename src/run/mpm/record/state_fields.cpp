// SPDX-License-Identifier: MIT
#include "run/mpm/record/state_fields.hpp"

#include <algorithm>

namespace talus::run {

StateFields::StateFields(const std::vector<material::Law>& laws) {
  for (const material::Law& law : laws) {
    std::vector<std::size_t>& places = places_.emplace_back();
    for (const material::StateField& field : material::list_state_fields(law)) {
      const auto known = std::find_if(fields_.begin(), fields_.end(),
                                      [&](const material::StateField& f) { return f.name == field.name; });
      places.push_back(static_cast<std::size_t>(known - fields_.begin()));
      if (known == fields_.end()) fields_.push_back(field);
    }
  }
}

std::vector<double> StateFields::arrange(const material::Law& law, std::size_t number, const double* state,
                                         double saturation) const {
  std::vector<double> values(fields_.size()), shown(places_[number].size());
  for (std::size_t k = 0; k < fields_.size(); ++k) values[k] = fields_[k].elsewhere;
  if (shown.empty()) return values;
  material::show_state(law, state, saturation, shown.data());
  for (std::size_t i = 0; i < shown.size(); ++i) values[places_[number][i]] = shown[i];
  return values;
}

}  // namespace talus::run
