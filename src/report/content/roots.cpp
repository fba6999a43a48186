// SPDX-License-Identifier: MIT
#include "report/content/roots.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ground/root_content.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {
namespace {

/// How a bundle was added up.
std::string describe_bundle(const input::RootBundle& bundle) {
  const std::size_t classes = bundle.area_ratios.size();
  return fmt::format(
      "{} {} class{} of roots",
      bundle.model == input::RootBundleModel::fibre_bundle ? "a fibre bundle of" : "Wu and Waldron's sum over", classes,
      classes == 1 ? "" : "es");
}

/// "falling with exp(−z/0.2 m) down to 0.5 m".
std::string describe_profile(const input::Roots& roots, const ShownUnit& length) {
  const std::string depth = show(roots.depth, length);
  const std::string along = roots.along.empty() ? "" : ", not the same along the ground";
  switch (roots.profile) {
    case input::RootProfile::exponential:
      return fmt::format("falling with exp(−z/{}) down to {}{}", show(roots.decay_depth, length), depth, along);
    case input::RootProfile::table:
      return fmt::format("by a table of depth down to {}{}", depth, along);
    default:
      return fmt::format("the same down to {}{}", depth, along);
  }
}

/// At the ground, of roots of full age; empty where plants only transpire.
std::string describe_worth(const input::Roots& roots, const ShownUnits& units) {
  if (roots.content) return fmt::format("{} % of the dry mass at the ground", show_number(*roots.content));
  const auto cohesion = ground::find_ground_cohesion(roots);
  if (!cohesion) return "";
  return fmt::format("a cohesion of {} at the ground{}", show(*cohesion, units.stress),
                     roots.cohesion ? "" : " (" + describe_bundle(*roots.bundle) + ")");
}

}  // namespace

std::vector<std::string> list_root_assumptions(const ResultFolder& folder) {
  std::vector<std::string> sentences;
  const ShownUnits units = read_units(folder.run);
  for (const input::Roots& roots : folder.data.roots) {
    const double age_share = ground::find_age_share(roots);
    if (const std::string worth = describe_worth(roots, units); !worth.empty())
      sentences.push_back(fmt::format(
          "Roots under '{}': {}, {}.{}", roots.ground, worth, describe_profile(roots, units.length),
          age_share == 1 ? "" : fmt::format(" {} % of that holds at their age.", show_number(100 * age_share))));
    if (roots.transpiration)
      sentences.push_back(
          fmt::format("Plants on '{}' transpire at the given rate, reduced after Feddes; interception and the effect "
                      "of roots on the conductivity are not modelled.",
                      roots.ground));
  }
  std::vector<std::string> clay, cohesive, breaking;
  for (const auto& [name, soil] : folder.data.materials) {
    if (soil.traits().roots == material::RootEffect::content)
      (std::isfinite(soil.breaking_strain) ? breaking : clay).push_back(name);
    if (soil.traits().roots == material::RootEffect::cohesion) cohesive.push_back(name);
  }
  if (!clay.empty())
    sentences.push_back(
        fmt::format("Soil and roots are one material in {}, and the roots never break: after large "
                    "movements their part of the strength is too high.",
                    join_words(clay)));
  if (!breaking.empty())
    sentences.push_back(
        fmt::format("Soil and roots are one material in {}; roots break as the activation strain grows, "
                    "in every direction alike.",
                    join_words(breaking)));
  if (!cohesive.empty())
    sentences.push_back(
        fmt::format("The roots of {} are modelled as a constant cohesion: it raises the strength at failure, and "
                    "describes neither the mobilisation of the roots nor their breakage.",
                    join_words(cohesive)));
  return sentences;
}

}  // namespace talus::report
