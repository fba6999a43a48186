// SPDX-License-Identifier: MIT
// Supports per metre of slope: the spacing divides what belongs to one bar, of every kind.

#include "site/supports.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "input/read.hpp"

namespace talus::site {
namespace {

/// Returns the bars of a support of 2 m spacing, or of `spacing`, in a cut.
std::vector<Bar> list(const std::string& kind, const std::string& keys, double spacing) {
  const std::string text = fmt::format(R"(
[geometry]
ground = [[0, 8], [14, 8], [18, 2], [32, 2]]
[[geometry.layer]]
name = "silt"
level = -8
[regions]
silt = "silt"
[materials.silt]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 6
friction_angle = 30
dilatancy_angle = 0
tensile_strength = 0
[analysis]
methods = ["lem"]
[lem]
methods = ["bishop"]
[support.some]
kind = "{}"
out_of_plane_spacing = {}
{}
)",
                                       kind, spacing, keys);
  return list_bars(Site(input::read_case_text(text, "cut.toml").data));
}

/// Values of one bar that a wider spacing divides.
std::vector<double> get_forces(const Bar& bar) {
  return {bar.tensile, bar.plate,     bar.bond,    bar.bond_factor, bar.prestress,
          bar.lateral, bar.stiffness, bar.bending, bar.moment,      std::isfinite(bar.shear) ? bar.shear : 0};
}

TEST(SiteSupports, SpacingDividesWhatBelongsToOneBar) {
  const std::string place = "heads = [[16, 5]]\ninclination = 15\nlength = 9\n";
  const std::vector<std::pair<const char*, std::string>> kinds{
      {"nail", place + "tensile_strength = 140\nplate = 80\nbond = 22\naxial_stiffness = 1e5\nbending_stiffness = "
                       "20\nplastic_moment = 4\n"},
      {"nail", place + "tensile_strength = 140\nplate = 80\nbond_adhesion = 5\nbond_friction = 25\ndiameter = 0.1\n"},
      {"anchor", place + "tensile_strength = 400\nplate = 300\nbond = 60\nbond_length = 4\nprestress = 200\n"},
      {"bolt", place + "tensile_strength = 90\nprestress = 40\n"},
      {"pile",
       "x = [16]\nlength = 8\nlateral_resistance = 60\nshear_strength = 300\naxial_stiffness = "
       "1e6\nbending_stiffness = 2e4\nplastic_moment = 150\n"}};
  for (const auto& [kind, keys] : kinds) {
    const auto one = list(kind, keys, 1), three = list(kind, keys, 3);
    ASSERT_EQ(one.size(), 1u) << kind;
    ASSERT_EQ(three.size(), 1u) << kind;
    const auto per_bar = get_forces(one[0]), per_metre = get_forces(three[0]);
    double sum = 0;
    for (std::size_t i = 0; i < per_bar.size(); ++i) {
      if (std::isinf(per_bar[i])) {  // no such limit
        EXPECT_TRUE(std::isinf(per_metre[i])) << kind << " " << i;
        continue;
      }
      sum += per_bar[i];
      EXPECT_NEAR(per_metre[i], per_bar[i] / 3, 1e-12 * per_bar[i]) << kind << " " << i;
    }
    EXPECT_GT(sum, 0) << kind;
    EXPECT_EQ(one[0].length(), three[0].length());
    EXPECT_EQ(one[0].free_length, three[0].free_length);
    EXPECT_EQ(three[0].spacing, 3);
  }
}

}  // namespace
}  // namespace talus::site
