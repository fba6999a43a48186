// SPDX-License-Identifier: MIT
// Number of elements across a band of softened soil, and the warning.

#include <gtest/gtest.h>

#include "run/mpm/stage/stage_warnings.hpp"
#include "support/clay_block.hpp"

namespace talus {
namespace {

constexpr int across = 16;

/// A block with plastic strain in `rows` rows of elements that start at its middle; the soil there has the void ratio
/// `loose`, elsewhere 0.8.
mpm::Body<2> make_sheared(int rows, double strain, double loose = 0.9) {
  const material::ModifiedCamClay clay = support::make_block_clay();
  const double h = support::block_width / across;
  const std::array<double, 4> stress{-5e4, -5e4, -5e4, 0};
  return support::fill_body<2>(
      support::make_mesh<2>({across, 2 * across}, {support::block_width, support::block_height}, 0), {{clay, 1800}}, 3,
      [](const Vec<2>&) { return 0; },
      [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
        const bool in = x[1] > 1 && x[1] < 1 + rows * h;
        clay.set_initial_state(stress.data(), in ? loose : 0.8, 0, 3e5, 1, p.state.data());
        p.state[0] = in ? strain : 0.1 * strain;
      });
}

TEST(NarrowBand, IsMeasuredInElements) {
  EXPECT_NEAR(run::find_soft_band(make_sheared(1, 0.2))->thickness, 1, 0.1);
  EXPECT_NEAR(run::find_soft_band(make_sheared(2, 0.2))->thickness, 2, 0.2);
  EXPECT_NEAR(run::find_soft_band(make_sheared(4, 0.2))->thickness, 4, 0.5);
}

TEST(NarrowBand, HasTheSizeOfItsElements) {
  EXPECT_NEAR(run::find_soft_band(make_sheared(2, 0.2))->size, support::block_width / across, 1e-12);
}

TEST(NarrowBand, IsOneOnlyWhereSoilShearedAndDilated) {
  EXPECT_FALSE(run::find_soft_band(make_sheared(1, 0.04))) << "hardly sheared";
  EXPECT_FALSE(run::find_soft_band(make_sheared(1, 0.2, 0.7))) << "compacted: it hardened";
  EXPECT_GT(run::find_soft_band(make_sheared(2 * across, 0.2))->thickness, 10) << "half of the block";
}

TEST(NarrowBand, RecommendsARemedy) {
  const mpm::Body<2> body = make_sheared(1, 0.2);
  const auto describe_band = [&](double thickness, double size, std::optional<double> length) {
    run::StageState state;
    state.soft_band = thickness, state.soft_size = size;
    return run::describe_narrow_band(body, state, length, {}).value_or("");
  };
  EXPECT_EQ(describe_band(0, 0, {}), "");
  EXPECT_EQ(describe_band(2, 0.1, {}), "");
  EXPECT_EQ(
      describe_band(1.2, 0.1, {}),
      "soil that softens ('soil0') sheared in a band of 1.2 elements of 0.1 m: when it moves, and how deep, depend "
      "on their size. Give mesh.softening_length, at least twice that");
  EXPECT_EQ(describe_band(1.2, 0.1, 0.2), "") << "fine enough";
  EXPECT_NE(describe_band(2.2, 0.2, 0.3).find("mesh.softening_length = 0.3 m must be at least twice that"),
            std::string::npos)
      << "elements too large for their length";
}

/// A stage keeps the thinnest of its outputs.
TEST(NarrowBand, IsWatchedAtEachOutput) {
  const mpm::Body<2> thin = make_sheared(1, 0.2), thick = make_sheared(4, 0.2), none = make_sheared(1, 0.01);
  int outputs = 0;
  run::StageHooks<2> hooks;
  hooks.output = [&](run::Pause<2>&, run::StageState&) { ++outputs; };
  hooks = run::watch_bands(none, hooks);
  run::StageState state;
  const auto record = [&](const mpm::Body<2>& body) {
    run::PauseHere<2> here(body);
    hooks.output(here, state);
  };
  record(none);
  EXPECT_EQ(state.soft_band, 0);
  for (const auto* body : {&thick, &thin, &thick}) record(*body);
  EXPECT_NEAR(state.soft_band, 1, 0.1);
  EXPECT_NEAR(state.soft_size, support::block_width / across, 1e-12);
  EXPECT_EQ(outputs, 4);
}

}  // namespace
}  // namespace talus
