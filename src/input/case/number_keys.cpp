// SPDX-License-Identifier: MIT
#include "input/case/number_keys.hpp"

#include <fmt/format.h>

#include <map>
#include <type_traits>

#include "base/error.hpp"
#include "base/units.hpp"
#include "input/case/material.hpp"

namespace talus::input {
namespace {

/// The visitor that visits every key of a material and takes its numbers.
template <class Take>
class NumberVisitor {
 public:
  explicit NumberVisitor(Take& take, std::string prefix = "") : take_(take), prefix_(std::move(prefix)) {}

  template <class T>
  void key(const std::string& name, T&& member, const Spec& spec, const char* /*meaning*/) {
    using Value = std::remove_cvref_t<T>;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>)
      take_(prefix_ + name, member, spec, spec.unit.empty() ? 1.0 : units::get_si_factor(spec.unit));
    else if constexpr (std::is_same_v<Value, PerCent<double>> || std::is_same_v<Value, PerCent<std::optional<double>>>)
      take_(prefix_ + name, member.value, spec, 1.0);
  }
  template <class T>
  void table(const std::string& name, T&& block, const char* /*meaning*/) {
    NumberVisitor inner(take_, prefix_ + name + ".");
    describe(inner, block);
  }
  template <class T>
  void optional_table(const std::string& name, std::optional<T>& block, const char* meaning) {
    if (block) table(name, *block, meaning);
  }
  template <class T>
  void tables(const std::string&, std::vector<T>&, int, const char*) {}
  template <class T>
  void named(const std::string&, std::map<std::string, T>&, const char*, const char*) {}
  template <class T>
  void entries(const std::string&, std::map<std::string, T>&, const char*, int, const Spec&, const char*) {}

 private:
  Take& take_;
  std::string prefix_;
};

}  // namespace

std::vector<NumberKey> list_number_keys(const Material& material) {
  std::vector<NumberKey> list;
  const auto take = [&](const std::string& path, const auto& member, const Spec& spec, double factor) {
    list.push_back({path, spec, factor, std::optional<double>(member), !spec.condition || spec.condition->holds()});
  };
  Material copy = material;  // a declaration names members that could be written
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
  const auto take = [&](const std::string& name, auto& member, const Spec&, double) {
    if (name != path) return;
    member = value;
    found = true;
  };
  NumberVisitor visitor(take);
  describe(visitor, material);
  if (!found) throw Error(ExitCode::wrong_input, fmt::format("a material has no number '{}'", path));
  if (const auto e = material.given_void_ratio) material.porosity = *e / (1 + *e);
}

}  // namespace talus::input
