// SPDX-License-Identifier: MIT
#include "input/language/spec.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace talus::input {

bool Condition::holds() const {
  return std::any_of(any.begin(), any.end(), [](const Alternative& a) { return a.holds; });
}

std::string write_condition(const Condition& condition) {
  if (condition.is_absence()) return fmt::format("{} is not given", condition.any.front().key);
  std::string text;
  for (std::size_t i = 0; i < condition.any.size(); ++i) {
    const Alternative& a = condition.any[i];
    const bool goes_on = i > 0 && condition.any[i - 1].key == a.key;
    text += i > 0 ? " or " : "";
    text += goes_on ? a.value : fmt::format("{} {} {}", a.key, a.differs ? "other than" : "=", a.value);
  }
  return text;
}

std::string write_waivers(const Spec& spec) {
  std::string text;
  for (const std::string& method : spec.methods)
    text += fmt::format("{}\"{}\"", text.empty() ? "; only with the methods " : " or ", method);
  if (spec.instead) text += fmt::format("; not where {} is given", spec.instead->key);
  return text;
}

bool Spec::is_waived(const std::set<std::string>& asked_methods) const {
  if (instead && instead->holds) return true;
  return !methods.empty() && std::none_of(methods.begin(), methods.end(),
                                          [&](const std::string& method) { return asked_methods.count(method) != 0; });
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

}  // namespace talus::input
