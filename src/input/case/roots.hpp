#pragma once
// Roots in the case: where they are, how much of them, and what they are worth.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "input/case/water.hpp"
#include "input/language/time_table.hpp"

namespace talus::input {

enum class RootProfile { uniform, exponential, table };
enum class RootBundleModel { wu_waldron, fibre_bundle };

/// Roots that cross a shear plane, by class of diameter; what practice turns into a cohesion.
struct RootBundle {
  RootBundleModel model = RootBundleModel::wu_waldron;
  std::vector<double> diameters;    ///< [m]
  std::vector<double> area_ratios;  ///< root area over soil area of each class at the ground [-]
  std::vector<double> strengths;    ///< tensile strength of each class [Pa]
  double orientation = 1.2;         ///< k' = cosθ tanφ + sinθ [-]
};

/// Water that the plants draw from the soil where their roots are, in proportion to the roots, less by Feddes'
/// reduction: nothing below suctions[0] (no air) and above suctions[3] (wilting), all between [1] and [2], linear
/// between.
struct Transpiration {
  TimeTable rate;  ///< potential [m/s] per horizontal area of ground, over time [s]
  SeriesShape series = SeriesShape::linear;
  std::array<double, 4> suctions{1e3, 2.5e3, 40e3, 1.5e6};  ///< [Pa]
};

/// [[roots]]: root content as a function of the depth normal to the ground, and along it. Blocks add up.
struct Roots {
  std::string ground;  ///< named line: depth is the distance from it
  double depth = 0;    ///< below which there are none [m]
  RootProfile profile = RootProfile::uniform;
  double decay_depth = 0;                          ///< exponential: share exp(-z/this) [m]
  std::vector<std::array<double, 2>> depth_table;  ///< table: depth [m], share [-]
  std::vector<std::array<double, 2>> along;        ///< x [m], share [-]; empty: 1
  std::optional<double> content;                   ///< m_r at the ground [%], for rooted_cam_clay
  std::optional<double> cohesion;                  ///< c_r at the ground [Pa], for rooted_mohr_coulomb; or
  std::optional<RootBundle> bundle;                ///< what c_r follows from
  // Age: shares of the content and of the cohesion that are there now.
  std::optional<double> age;                  ///< since planting [s]
  std::vector<std::array<double, 2>> growth;  ///< age [s], share [-]
  std::optional<double> felled;               ///< time since felling [s]
  std::vector<std::array<double, 2>> decay;   ///< time since felling [s], share [-]
  std::optional<Transpiration> transpiration;
};

}  // namespace talus::input
