// SPDX-License-Identifier: MIT
#include "results/supports.hpp"

#include <fmt/format.h>

#include <set>

namespace talus::results {

namespace {

std::string list_names(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

}  // namespace

std::string describe_support_sense(const SliceResult& slices) {
  std::set<std::string> active, passive;
  bool has_supports = false;
  for (const auto* list : {&slices.critical, &slices.noncircular, &slices.given})
    for (const CriticalSurface& surface : *list) {
      if (!surface.supports) continue;
      has_supports = true;
      for (const SupportForce& force : *surface.supports) (force.is_active ? active : passive).insert(force.support);
    }
  if (!has_supports) return "";
  if (active.empty() && passive.empty()) return "no support that holds a slip surface";
  const std::string loads = fmt::format("{} active (loads, which F does not divide)", list_names(active));
  const std::string resistances = fmt::format("{} passive (F divides their forces)", list_names(passive));
  if (passive.empty()) return "supports " + loads;
  return "supports " + (active.empty() ? resistances : loads + ", " + resistances);
}

const char* get_title(SupportLimit limit) {
  switch (limit) {
    case SupportLimit::tension:
      return "tensile strength";
    case SupportLimit::pull_out:
      return "pull-out";
    case SupportLimit::stripping:
      return "stripping";
    case SupportLimit::prestress:
      return "prestress";
    case SupportLimit::lateral:
      return "lateral resistance";
    case SupportLimit::shear:
      return "shear strength";
    case SupportLimit::embedment:
      return "embedment: the pile moves through the stable soil";
    case SupportLimit::rotation:
      return "embedment: the pile rotates";
    case SupportLimit::one_hinge:
      return "plastic moment: one hinge";
    case SupportLimit::two_hinges:
      return "plastic moment: two hinges";
  }
  return "";
}

}  // namespace talus::results
