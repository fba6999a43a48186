// SPDX-License-Identifier: MIT
// Factor of safety of a bank with roots: a uniform root cohesion equals a cohesion, however it is given, and a rooted
// layer gives a factor between that and the factor without roots.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

#include "base/parallel.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string rooted_slope_text = support::write_slope(
    "bank", {"geometry.box=[[0, 0], [16, 8]]",
             "geometry.polygon.soil.points=[[0, 0], [16, 0], [16, 2], [11, 2], [6, 7], [0, 7]]",
             "geometry.line=[{ name = 'ground', points = [[0, 7], [6, 7], [11, 2], [16, 2]] }]", "mesh.size=1.25",
             "materials.silt.young_modulus=20 MPa", "materials.silt.cohesion=4", "materials.silt.friction_angle=25",
             "materials.silt.dilatancy_angle=5", "materials.silt.tensile_strength=4",
             "stage=[{ name = 'weight', duration = 10, until = 'rest', geometry = 'frozen', damping = 0.5 }]",
             "analysis.kind=strength_reduction", "strength_reduction.curve.enabled=false",
             "strength_reduction.frozen={ meshes = 1, from = 1.2, to = 1.6, resolution = 0.02 }"});

class RootedBank : public testing::Test {
 protected:
  double find_factor(const std::vector<input::Override>& soil) {
    run::RunOptions options;
    options.folder = folder_;
    options.threads = default_threads();
    options.overwrite = true;
    const json summary = support::run_case(input::read_case_text(rooted_slope_text, "bank.toml", soil), options);
    EXPECT_EQ(summary.at("stages")[0].at("end"), "rest");
    return summary.at("factor_of_safety").at("frozen").at("factor");
  }
  const fs::path folder_ = support::name_scratch("bank");
};

const input::Override rooted{"materials.silt.model", "rooted_mohr_coulomb"};

TEST_F(RootedBank, HasTheFactorOfABankWithTheSumOfCohesions) {
  const double sum = find_factor({{"materials.silt.cohesion", "9"}});
  EXPECT_DOUBLE_EQ(find_factor({rooted, {"materials.silt.root_cohesion", "5"}}), sum);
  // The same from roots whose layer reaches through all soil: 0.5 ‰ of 1.25 · 8 MPa.
  const std::string bundle =
      "{ model = 'wu_waldron', diameters = [2], area_ratios = [5e-4], strengths = [8], orientation = 1.25 }";
  EXPECT_DOUBLE_EQ(find_factor({rooted, {"roots", "[{ ground = 'ground', depth = 20, bundle = " + bundle + " }]"}}),
                   sum);
}

TEST_F(RootedBank, GainsLessFromAShallowLayer) {
  const double bare = find_factor({});
  const double none = find_factor({rooted, {"materials.silt.root_cohesion", "0"}});
  const double layer = find_factor({rooted, {"roots", "[{ ground = 'ground', depth = 1, cohesion = 5 }]"}});
  const double all = find_factor({rooted, {"materials.silt.root_cohesion", "5"}});
  EXPECT_DOUBLE_EQ(none, bare);
  EXPECT_GT(layer, bare + 0.02);
  EXPECT_LT(layer, all - 0.02);
}

}  // namespace
}  // namespace talus
