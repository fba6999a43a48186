#include "model/spec.hpp"

#include <fmt/format.h>

namespace talus::model {

std::string write_condition(const Condition& condition) {
  return condition.value.empty() ? fmt::format("{} is not given", condition.key)
                                 : fmt::format("{} = {}", condition.key, condition.value);
}

std::string Spec::write_range() const {
  const std::string unit_text = unit.empty() ? "" : " " + unit;
  std::string text;
  if (low) text = fmt::format("{} {:.15g}{}", low->open ? "above" : "at least", low->value, unit_text);
  if (high)
    text += fmt::format("{}{} {:.15g}{}", low ? " and " : "", high->open ? "below" : "at most", high->value, unit_text);
  return text;
}

bool Spec::allows(double value) const {
  if (low && (low->open ? value <= low->value : value < low->value)) return false;
  return !high || (high->open ? value < high->value : value <= high->value);
}

}  // namespace talus::model
