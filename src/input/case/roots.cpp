// SPDX-License-Identifier: MIT
// Checks of [[roots]]: keys of each block, soils that accept roots, and requirements of rooted soils.
#include "input/case/roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "input/case/checks.hpp"

namespace talus::input {
namespace {

using material::RootEffect;

bool has_soil(const Case& data, RootEffect effect) {
  return std::any_of(data.materials.begin(), data.materials.end(),
                     [&](const auto& entry) { return entry.second.traits().roots == effect; });
}

/// Returns the word of the first model with this effect of roots.
const char* find_word(RootEffect effect) {
  const auto& all = material::Laws::traits;
  return std::find_if(all.begin(), all.end(), [&](const material::Traits& t) { return t.roots == effect; })->word;
}

bool gives_cohesion(const Roots& roots) {
  return roots.cohesion || roots.bundle;
}

/// Check of one block of [[roots]].
class Block : BlockFindings {
 public:
  Block(const Case& data, const Roots& roots, const std::string& block, Findings& all)
      : BlockFindings(all, block), data_(data), roots_(roots) {}

  void check() const {
    check_kind();
    check_soil();
    check_bundle();
    check_time("age", roots_.age, "growth", roots_.growth);
    check_time("felled", roots_.felled, "decay", roots_.decay);
    check_transpiration();
  }

 private:
  void check_kind() const {
    if (!is_sound("content") || !is_sound("cohesion") || !is_sound("bundle")) return;
    const int kinds =
        int(roots_.content.has_value()) + int(roots_.cohesion.has_value()) + int(roots_.bundle.has_value());
    if (kinds == 0 && !roots_.transpiration && is_sound("transpiration"))
      findings.add(
          path,
          "[[roots]] does not say what roots there are: give 'content' for {}, or 'cohesion' or [roots.bundle] for {}",
          find_word(RootEffect::content), find_word(RootEffect::cohesion));
    if (kinds > 1)
      findings.add(path,
                   "[[roots]] has more than one of 'content', 'cohesion' and [roots.bundle]; give one of them, and "
                   "another [[roots]] for another soil");
  }

  void check_soil() const {
    if (!findings.is_sound("materials")) return;
    const auto need = [&](const char* key, RootEffect effect) {
      if (is_sound(key) && !has_soil(data_, effect))
        report(key, "'{}' of [[roots]] needs a material with model = \"{}\"", key, find_word(effect));
    };
    if (roots_.content) need("content", RootEffect::content);
    if (roots_.cohesion) need("cohesion", RootEffect::cohesion);
    if (roots_.bundle) need("bundle", RootEffect::cohesion);
  }

  void check_bundle() const {
    if (!roots_.bundle || !is_sound("bundle")) return;
    const RootBundle& bundle = *roots_.bundle;
    const std::size_t classes = bundle.area_ratios.size();
    if (classes == 0) report("bundle.area_ratios", "'area_ratios' needs one number for each class of roots");
    const auto compare = [&](const char* key, std::size_t count) {
      if (count != classes)
        report(fmt::format("bundle.{}", key),
               "'{}' has {} numbers and 'area_ratios' has {}; each class of roots needs one of both", key, count,
               classes);
    };
    compare("strengths", bundle.strengths.size());
    if (bundle.model == RootBundleModel::fibre_bundle || !bundle.diameters.empty())
      compare("diameters", bundle.diameters.size());
  }

  void check_time(const char* key, const std::optional<double>& time, const char* table,
                  const std::vector<std::array<double, 2>>& rows) const {
    if (!is_sound(key) || !is_sound(table) || time.has_value() != rows.empty()) return;
    if (time)
      report(key, "'{}' needs '{}', the share of the roots at different times", key, table);
    else
      report(table, "'{}' has no meaning without '{}'", table, key);
  }

  void check_transpiration() const {
    if (!roots_.transpiration || !is_sound("transpiration")) return;
    if (!is_wet(data_) && findings.is_sound("materials"))
      return report(
          "transpiration",
          "[roots.transpiration] has no meaning: no material has pore water; add a table [materials.NAME.water]");
    const std::vector<double>& times = roots_.transpiration->rate.time;
    if (roots_.transpiration->series == SeriesShape::steps &&
        std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end())
      report("transpiration.rate", "the times of 'rate' must increase from row to row where series = \"steps\"");
  }

  const Case& data_;
  const Roots& roots_;
};

/// Checks that a rooted soil is given roots, even if their content is zero.
void check_rooted_soil(const Case& data, const std::string& name, const Material& material, Findings& findings) {
  const RootEffect effect = material.traits().roots;
  const bool takes_content = effect == RootEffect::content;
  if (effect == RootEffect::none) return;
  const std::string path = "materials." + name, key = takes_content ? "root_content" : "root_cohesion";
  if (!findings.is_sound(path) || !findings.is_sound("roots") || findings.places.is_given(path + "." + key)) return;
  if (std::any_of(data.roots.begin(), data.roots.end(),
                  [&](const Roots& r) { return takes_content ? r.content.has_value() : gives_cohesion(r); }))
    return;
  findings.add(
      path, "material '{}' is rooted, but nothing says by how much: give '{}' (0 for none), or a [[roots]] with '{}'",
      name, key, takes_content ? "content" : "cohesion");
}

void check_equilibrium(const Case& data, Findings& findings) {
  const std::string& stage = data.initial.equilibrium;
  const std::string path = "initial.equilibrium";
  if (stage.empty() || !findings.is_sound(path)) return;
  if (findings.is_sound("stage") &&
      std::none_of(data.stages.begin(), data.stages.end(), [&](const Stage& s) { return s.name == stage; }))
    return findings.add(path, "there is no stage '{}'", stage);
  if (findings.is_sound("materials") &&
      std::none_of(data.materials.begin(), data.materials.end(), [](const auto& entry) {
        return material::needs<material::Preconsolidation>(entry.second.model) && entry.second.preconsolidation_ratio;
      }))
    findings.add(path, "'equilibrium' has no meaning: no material has a 'preconsolidation_ratio'");
}

}  // namespace

void check_roots(const Case& data, Findings& findings) {
  for (std::size_t i = 0; i < data.roots.size(); ++i)
    Block(data, data.roots[i], fmt::format("roots.{}", i), findings).check();
  for (const auto& [name, material] : data.materials) check_rooted_soil(data, name, material, findings);
  check_equilibrium(data, findings);
}

}  // namespace talus::input
