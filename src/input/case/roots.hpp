// SPDX-License-Identifier: MIT
#pragma once
// [[roots]]: distribution of roots, their content or cohesion, age, and water uptake.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/case/hydraulic.hpp"
#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

enum class RootProfile { uniform, exponential, table };
enum class RootBundleModel { wu_waldron, fibre_bundle };

/// Roots that cross a shear plane, by diameter class, from which a root cohesion is computed.
struct RootBundle {
  RootBundleModel model = RootBundleModel::wu_waldron;
  std::vector<double> diameters;    ///< [m]
  std::vector<double> area_ratios;  ///< root area ratio of each class at the ground [-]
  std::vector<double> strengths;    ///< tensile strength of each class [Pa]
  double orientation = 1.2;         ///< k' = cosθ tanφ + sinθ [-]
};

/// Transpiration, distributed in proportion to the roots and reduced after Feddes: zero below suctions[0] (lack of
/// oxygen) and above suctions[3] (wilting point), potential between [1] and [2], linear between.
struct Transpiration {
  TimeTable rate;  ///< potential rate [m/s] per horizontal area of ground, over time [s]
  SeriesShape series = SeriesShape::linear;
  std::array<double, 4> suctions{1e3, 2.5e3, 40e3, 1.5e6};  ///< [Pa]
};

/// [[roots]]: root content as a function of the depth normal to the ground and of the position along it. Blocks add up.
struct Roots {
  std::string ground;  ///< named line from which depth is measured
  double depth = 0;    ///< depth of the root zone [m]
  RootProfile profile = RootProfile::uniform;
  double decay_depth = 0;                          ///< exponential: fraction exp(-z/decay_depth) [m]
  std::vector<std::array<double, 2>> depth_table;  ///< table: depth [m], fraction [-]
  std::vector<std::array<double, 2>> along;        ///< x [m], fraction [-]; empty: 1
  std::optional<double> content;                   ///< m_r at the ground [%], or
  std::optional<double> cohesion;                  ///< c_r at the ground [Pa]; or
  std::optional<RootBundle> bundle;                ///< model from which c_r is computed
  // Age: the current fraction of content and cohesion.
  std::optional<double> age;                  ///< since planting [s]
  std::vector<std::array<double, 2>> growth;  ///< age [s], fraction [-]
  std::optional<double> felled;               ///< time since felling [s]
  std::vector<std::array<double, 2>> decay;   ///< time since felling [s], fraction [-]
  std::optional<Transpiration> transpiration;
};

template <>
inline constexpr auto choices<RootProfile> = std::array{
    Choice{RootProfile::uniform, "uniform", "the same down to `depth`"},
    Choice{RootProfile::exponential, "exponential", "exp(-z/decay_depth) of it at the depth z"},
    Choice{RootProfile::table, "table", "the shares of `depth_table`, straight lines between its rows"},
};
template <>
inline constexpr auto choices<RootBundleModel> = std::array{
    Choice{RootBundleModel::wu_waldron, "wu_waldron", "all roots break at once: orientation · Σ strength · area ratio"},
    Choice{RootBundleModel::fibre_bundle, "fibre_bundle",
           "they break one after the other and hand their load on, as Pollen and Simon have it"},
};

void describe(auto& v, RootBundle& b) {
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

void describe(auto& v, Transpiration& t) {
  Series rate{t.rate};
  v.key("rate", rate, quantity("mm/day").at_least(0).required().example("4"),
        "Potential transpiration per horizontal area of ground, or rows of time and rate.");
  v.key("series", t.series, plain(), "How rows of time are joined.");
  v.key("suctions", t.suctions, quantity("kPa").at_least(0),
        "Feddes' reduction: nothing is drawn below the first suction (no air) and above the last (wilting), all "
        "between the second and the third, and straight lines in between.");
}

void describe(auto& v, Roots& r) {
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

}  // namespace talus::input
