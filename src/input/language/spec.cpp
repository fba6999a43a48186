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

std::string Spec::write_usual_range() const {
  if (!usual_range) return "";
  return fmt::format("{:g} to {:g}{}{}", usual_range->low, usual_range->high, unit.empty() ? "" : " " + unit,
                     usual_range->or_zero ? ", or 0" : "");
}

std::string Spec::find_oddity(const std::string& path, double value, bool is_plain) const {
  if (!usual_range || usual_range->holds(value)) return "";
  const std::string unit_text = unit.empty() ? "" : " " + unit;
  std::string meant;
  if (is_plain)
    for (const Slip& slip : usual_range->slips)
      if (const double other = value * slip.factor; other != 0 && usual_range->holds(other))
        meant +=
            fmt::format("{}{:g} {} would be {:.3g}{}", meant.empty() ? " (" : "; ", value, slip.unit, other, unit_text);
  return fmt::format(
      "'{}' is {:g}{}; the usual range is {}{}. Correct it, or name the key in 'unusual' where it is meant", path,
      value, unit_text, write_usual_range(), meant.empty() ? "" : meant + ")");
}

bool Spec::allows(double value) const {
  if (low && (low->open ? value <= low->value : value < low->value)) return false;
  return !high || (high->open ? value < high->value : value <= high->value);
}

Spec Spec::at_least(double value) && {
  return low = Limit{value, false}, std::move(*this);
}

Spec Spec::above(double value) && {
  return low = Limit{value, true}, std::move(*this);
}

Spec Spec::at_most(double value) && {
  return high = Limit{value, false}, std::move(*this);
}

Spec Spec::below(double value) && {
  return high = Limit{value, true}, std::move(*this);
}

Spec Spec::usual(double least, double most, std::vector<Slip> slips) && {
  return usual_range = UsualRange{least, most, std::move(slips), false, false}, std::move(*this);
}

Spec Spec::usual_or_zero(double least, double most, std::vector<Slip> slips) && {
  return usual_range = UsualRange{least, most, std::move(slips), true, false}, std::move(*this);
}

Spec Spec::of_either_sign() && {
  return usual_range->either_sign = true, std::move(*this);
}

Spec Spec::or_infinite() && {
  return allows_infinity = true, std::move(*this);
}

Spec Spec::required() && {
  return is_required = true, std::move(*this);
}

Spec Spec::example(const char* text) && {
  return examples = {text}, std::move(*this);
}

Spec Spec::example_each(std::vector<std::string> texts) && {
  return examples = std::move(texts), std::move(*this);
}

Spec Spec::needed_without(const char* key, bool other_is_given) && {
  return std::move(*this).depend(key, "", !other_is_given, true);
}

Spec Spec::allowed_without(const char* key, bool other_is_given) && {
  return std::move(*this).depend(key, "", !other_is_given, false);
}

Spec Spec::by_methods(std::vector<std::string> words) && {
  return methods = std::move(words), std::move(*this);
}

Spec Spec::unless_given(const char* key, bool other_is_given) && {
  return instead = Alternative{key, "", other_is_given}, std::move(*this);
}

Spec Spec::depend(const char* key, std::string value, bool holds, bool required) && {
  return std::move(*this).depend_on_any({{key, std::move(value), holds}}, required);
}

Spec Spec::depend_on_any(std::vector<Alternative> others, bool required) && {
  return condition = Condition{std::move(others), required}, std::move(*this);
}

Spec Spec::or_depend(Alternative other) && {
  return condition->any.push_back(std::move(other)), std::move(*this);
}

std::string Spec::write_value(int value) {
  return std::to_string(value);
}

std::string Spec::write_value(const char* word) {
  return '"' + std::string(word) + '"';
}

Spec quantity(const char* unit) {
  Spec spec;
  spec.unit = unit;
  return spec;
}

Spec plain() {
  return {};
}

}  // namespace talus::input
