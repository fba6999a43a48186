// SPDX-License-Identifier: MIT
// The vegetated slope of section 4.4 of the source on a coarser mesh: the effect of roots on a failure in rain. The
// full comparison is `talus study examples/vegetated_slope/case.toml`.

#include "water_run.hpp"

namespace talus {
namespace {

/// Results by name, of the bare slope or with roots in the layer.
class Slope {
 public:
  explicit Slope(const char* content, const char* conductivity)
      : run_("../vegetated_slope/case.toml", {{"mesh.size", "0.4"},
                                              {"mesh.refine.0.size", "0.32"},
                                              {"materials.rooted.root_content", content},
                                              {"materials.rooted.water.conductivity", conductivity}}) {}

  double get(const std::string& name) const {
    for (const auto& r : run_.summary.at("results"))
      if (r.at("name") == name) return r.at("value").is_number() ? r.at("value").get<double>() : never;
    ADD_FAILURE() << "no result " << name;
    return 0;
  }
  const nlohmann::json& summary() const { return run_.summary; }
  double budget_error() const { return run_.budget_error; }

  static constexpr double never = 1e9;

 private:
  WaterRun run_;
};

TEST(VegetatedSlope, RootsDelayTheFailureAndMoveItAsOneBlock) {
  std::array<double, 3> bare_onset{}, bare_moved{};
  const std::array<std::string, 3> places{"toe", "mid_face", "crest"};
  {
    const Slope bare("0", "\"7.62e-4 m/s\"");
    for (std::size_t i = 0; i < 3; ++i) {
      bare_onset[i] = bare.get("onset[" + places[i] + "]");
      bare_moved[i] = bare.get("displacement[" + places[i] + "]");
    }
    EXPECT_LT(bare.budget_error(), 1e-9);
    EXPECT_EQ(bare.summary().at("stages")[0].at("preconsolidation").at("points"), bare.get("mesh.points"))
        << "R_0 holds for all soil, after the stage of equilibrium";
  }
  EXPECT_LT(bare_onset[0], bare_onset[1]) << "retrogressive: the toe first";
  EXPECT_LT(bare_onset[1], bare_onset[2]) << "and the crest last";
  const Slope rooted("1.29", "\"9.81e-4 m/s\"");
  std::array<double, 3> onset{};
  for (std::size_t i = 0; i < 3; ++i) onset[i] = rooted.get("onset[" + places[i] + "]");
  const auto [first, last] = std::minmax_element(onset.begin(), onset.end());
  EXPECT_LT(*last, Slope::never);
  EXPECT_LT(*last - *first, 0.1 * *last) << "together";
  EXPECT_GT(*first, bare_onset[0] + 60) << "and later";
  // The source halves the displacement of the upper slope; so do its toe and mid-face here.
  for (std::size_t i = 0; i < 2; ++i) {
    const double ratio = rooted.get("displacement[" + places[i] + "]") / bare_moved[i];
    EXPECT_GT(ratio, 0.1) << places[i];
    EXPECT_LT(ratio, 0.65) << places[i];
  }
}

}  // namespace
}  // namespace talus
