// SPDX-License-Identifier: MIT
// Checks of [[roots]]: keys of each block, soils that accept roots, and requirements of rooted soils.
#include "input/case/roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "input/case/checks.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, RootBundle& b) {
  v.key("model", b.model, plain().required().example(R"("fibre_bundle")"), "How the roots add up.");
  v.key("diameters", b.diameters, quantity("mm").above(0).example("[0.5, 1, 2]"),
        "Diameters of the classes of roots that cross a shear plane; the fibre bundle needs them.");
  v.key("area_ratios", b.area_ratios, plain().above(0).below(1).required().example("[2e-4, 4e-4, 3e-4]"),
        "Root area over soil area of each class at the ground.");
  v.key("strengths", b.strengths, quantity("MPa").above(0).required().example("[40, 25, 15]"),
        "Tensile strength of each class; thin roots are the stronger ones.");
  v.key("orientation", b.orientation, plain().above(0).at_most(2),
        "cos θ tan φ + sin θ of roots that are drawn to the angle θ in the shear zone, 1.0 to 1.3 in most soils.");
}

void describe(Visitor& v, Transpiration& t) {
  Series rate{t.rate};
  v.key("rate", rate, quantity("mm/day").at_least(0).required().example("4"),
        "Potential transpiration per horizontal area of ground, or rows of time and rate.");
  v.key("series", t.series, plain(), "How rows of time are joined.");
  v.key("suctions", t.suctions, quantity("kPa").at_least(0),
        "Feddes' reduction: nothing is drawn below the first suction (no air) and above the last (wilting), all "
        "between the second and the third, and straight lines in between.");
}

void describe(Visitor& v, Roots& r) {
  v.key("ground", r.ground, plain().required().example(R"("crest")"),
        "The named line that the roots grow under: depth is the distance from it, normal to it.");
  v.key("depth", r.depth, quantity("m").above(0).required().example("0.5"), "Below this there are none.");
  v.key("profile", r.profile, plain(), "How content or cohesion change with depth.");
  v.key("decay_depth", r.decay_depth,
        quantity("m").above(0).needed_with("profile", r.profile, RootProfile::exponential).example("0.2"),
        "Depth at which they have fallen to 37 %.");
  ShareTable depths{r.depth_table}, along{r.along}, growth{r.growth}, decay{r.decay};
  v.key("depth_table", depths,
        quantity("m")
            .at_least(0)
            .needed_with("profile", r.profile, RootProfile::table)
            .example("[[0, 1], [0.3, 0.6], [0.8, 0]]"),
        "Depths and shares; constant beyond the ends.");
  v.key("along", along, quantity("m").example("[[10, 0], [12, 1], [30, 1]]"),
        "Shares over x, where the planting is not the same everywhere; constant beyond the ends. If not given, 1.");
  PerCent<std::optional<double>> content{r.content};
  v.key("content", content, quantity("%").at_least(0).below(100).example("0.88"),
        "m_r at the ground, for rooted_cam_clay. A plain number is per cent. One of `content`, `cohesion` and "
        "[roots.bundle] is needed, unless the plants only transpire.");
  v.key("cohesion", r.cohesion, quantity("kPa").at_least(0).example("5"),
        "c_r at the ground, for rooted_mohr_coulomb.");
  v.key("age", r.age, quantity("year").at_least(0).example("3"), "Time since planting.");
  v.key("growth", growth, quantity("year").at_least(0).example("[[0, 0], [2, 0.4], [10, 1]]"),
        "Ages and the share of the roots that has grown by then.");
  v.key("felled", r.felled, quantity("year").at_least(0).example("1"), "Time since the plants were felled.");
  v.key("decay", decay, quantity("year").at_least(0).example("[[0, 1], [5, 0.2], [10, 0]]"),
        "Times since felling and the share of the roots that still holds.");
  v.optional_table(
      "bundle", r.bundle,
      "The roots that cross a shear plane, in the place of their cohesion; belongs to the [[roots]] before it.");
  v.optional_table("transpiration", r.transpiration,
                   "Water that the plants draw from the soil where their roots are; belongs to the [[roots]] before "
                   "it. Without this block they draw none.");
}
namespace {

using material::RootEffect;

bool has_soil(const Case& data, RootEffect effect) {
  return std::any_of(data.materials.begin(), data.materials.end(),
                     [&](const auto& entry) { return entry.second.traits().roots == effect; });
}

/// Returns the word of the first model with this effect of roots.
const char* find_word(RootEffect effect) {
  int model = 0;
  while (material::get_traits(material::Model(model)).roots != effect) ++model;
  return material::get_traits(material::Model(model)).word;
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
