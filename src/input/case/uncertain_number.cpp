// SPDX-License-Identifier: MIT
#include "input/case/uncertain_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "input/case/material.hpp"
#include "input/language/parse.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

namespace {

/// The visitor that calls `take` for each number of a material; `factor` is the unit of the number in SI.
class NumberVisitor : public Visitor {
 public:
  using Take = std::function<void(const std::string& path, Member number, const Spec& spec, double factor)>;
  explicit NumberVisitor(const Take& take, std::string prefix = "") : take_(take), prefix_(std::move(prefix)) {}

 protected:
  void visit_key(const std::string& name, Member member, const Spec& spec, const char* /*meaning*/) override {
    if (member.type.get_number == nullptr) return;
    const bool has_unit = !member.type.is_per_cent && !spec.unit.empty();
    take_(prefix_ + name, member, spec, has_unit ? units::get_si_factor(spec.unit) : 1.0);
  }
  void visit_table(const std::string& name, const Blocks& block, const char* /*meaning*/) override {
    visit_block(name, block, block.at);
  }
  void visit_optional_table(const std::string& name, const Blocks& block, const char* /*meaning*/) override {
    if (block.get_size(block.at) > 0) visit_block(name, block, block.get(block.at, 0));
  }
  void visit_tables(const std::string&, const Blocks&, int, const char*) override {}
  void visit_named(const std::string&, const Blocks&, const char*, int, const char*) override {}
  void visit_entries(const std::string&, const Entries&, const char*, int, const Spec&, const char*) override {}

 private:
  void visit_block(const std::string& name, const Blocks& blocks, void* block) {
    NumberVisitor inner(take_, prefix_ + name + ".");
    blocks.describe(inner, block);
  }

  const Take& take_;
  std::string prefix_;
};

}  // namespace

std::vector<NumberKey> list_number_keys(const Material& material) {
  std::vector<NumberKey> list;
  const NumberVisitor::Take take = [&](const std::string& path, Member number, const Spec& spec, double factor) {
    const std::optional<double> value = number.type.get_number(number.at);
    list.push_back({path, spec, factor, value, !spec.condition || spec.condition->holds()});
  };
  Material copy = material;  // describe() takes mutable members
  NumberVisitor visitor(take);
  describe(visitor, copy);
  return list;
}

std::optional<NumberKey> find_number_key(const Material& material, const std::string& path) {
  for (NumberKey& key : list_number_keys(material))
    if (key.path == path) return std::move(key);
  return std::nullopt;
}

void set_number(Material& material, const std::string& path, double value) {
  bool found = false;
  const NumberVisitor::Take take = [&](const std::string& name, Member number, const Spec&, double) {
    if (name != path) return;
    number.type.set_number(number.at, value);
    found = true;
  };
  NumberVisitor visitor(take);
  describe(visitor, material);
  if (!found) fail_input("a material has no number '{}'", path);
  if (const auto e = material.given_void_ratio) material.porosity = *e / (1 + *e);
}

namespace {

using nlohmann::json;

/// Converts a TOML text to a number in `unit`.
double read_value(const std::string& text, const std::string& unit, const std::string& key, const char* what) {
  const json value = json::parse(text, nullptr, false);
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) fail_input("'{}' of '{}' is not a number: {}", what, key, text);
  const double si = units::parse_as_si(value.get<std::string>(), unit, what);
  return si / (unit.empty() ? 1.0 : units::get_si_factor(unit));
}

/// Truncates the distribution at the allowed range of the material's key, because samples beyond it are invalid cases.
void cut_at_range(UncertainNumber& u, const Case& data) {
  const std::vector<std::string> steps = split_path(u.key);
  if (steps.size() < 3 || steps[0] != "materials" || data.materials.count(steps[1]) == 0) return;
  const auto key = find_number_key(data.materials.at(steps[1]), u.key.substr(steps[0].size() + steps[1].size() + 2));
  if (!key) return;
  if (key->spec.low) u.lowest = std::max(u.lowest, key->spec.low->value);
  if (key->spec.high) u.highest = std::min(u.highest, key->spec.high->value);
}

void check(const UncertainNumber& u) {
  switch (u.distribution) {
    case Distribution::lognormal:
      if (u.mean <= 0) fail_input("the mean of '{}' is {:g}; a lognormal number has a mean above 0", u.key, u.mean);
      [[fallthrough]];
    case Distribution::normal:
      if (!(u.deviation > 0))
        fail_input("the deviation of '{}' is {:g}; an uncertain number has one above 0", u.key, u.deviation);
      if (u.mean < u.lowest || u.mean > u.highest)
        fail_input("the mean of '{}' is {:g}, which is not between its limits {:g} and {:g}", u.key, u.mean, u.lowest,
                   u.highest);
      break;
    case Distribution::triangular:
      if (u.mode < u.lowest || u.mode > u.highest)
        fail_input("the mode of '{}' is {:g}, which is not between lowest and highest, {:g} and {:g}", u.key, u.mode,
                   u.lowest, u.highest);
      break;
    case Distribution::uniform:
      break;
  }
  if (!(u.lowest < u.highest))
    fail_input("'lowest' of '{}' is {:g} and 'highest' is {:g}; the lowest value is the smaller one", u.key, u.lowest,
               u.highest);
}

}  // namespace

EchoedNumber find_number(const json& echo, const std::string& key) {
  const json* at = &echo;
  std::string unit;
  for (const std::string& step : split_path(key)) {
    const json* next = nullptr;
    if (at->is_object() && at->contains("given") && at->contains("value")) {
      unit = at->value("unit", "");
      at = &(*at)["value"];
    }
    if (at->is_object() && at->contains(step))
      next = &(*at)[step];
    else if (at->is_array())
      next = find_entry(*at, step);
    if (next == nullptr) fail_input("the case has no number '{}'", key);
    at = next;
  }
  if (at->is_object() && at->contains("given") && at->contains("value")) {
    unit = at->value("unit", "");
    at = &(*at)["value"];
  }
  if (!at->is_number() && !at->is_null()) fail_input("'{}' is not a single number", key);
  return {unit, at->is_number() ? std::optional(at->get<double>()) : std::nullopt};
}

UncertainNumber resolve(const RandomNumber& number, const Case& data, const json& echo) {
  const EchoedNumber own = find_number(echo, number.key);
  UncertainNumber u;
  u.key = number.key;
  u.unit = own.unit;
  u.distribution = number.distribution;
  const auto read = [&](const std::string& text, const char* what) {
    return read_value(text, own.unit, number.key, what);
  };
  const auto take = [&](const std::string& text, const char* what) {
    if (!text.empty()) return read(text, what);
    if (!own.value) fail_input("'{}' has no value in the case; give its '{}'", number.key, what);
    return *own.value;
  };
  const bool is_bounded =
      number.distribution == Distribution::triangular || number.distribution == Distribution::uniform;
  if (is_bounded && (number.lowest.empty() || number.highest.empty()))
    fail_input("'{}' has no '{}', which this distribution needs", number.key,
               number.lowest.empty() ? "lowest" : "highest");
  if (!number.lowest.empty()) u.lowest = read(number.lowest, "lowest");
  if (!number.highest.empty()) u.highest = read(number.highest, "highest");
  if (is_bounded) {
    if (number.distribution == Distribution::triangular) u.mode = take(number.mode, "mode");
  } else {
    u.mean = take(number.mean, "mean");
    if (number.deviation.empty() == !number.variation)
      fail_input("'{}' has {}; give one of 'deviation' and 'variation'", number.key,
                 number.variation ? "a deviation and a variation" : "no deviation");
    u.deviation = number.variation ? *number.variation * std::abs(u.mean) : read(number.deviation, "deviation");
    cut_at_range(u, data);
  }
  check(u);
  return u;
}

}  // namespace talus::input
