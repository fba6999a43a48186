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

void describe(Visitor& v, RootBundle& b);

void describe(Visitor& v, Transpiration& t);

void describe(Visitor& v, Roots& r);

}  // namespace talus::input
