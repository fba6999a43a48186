// SPDX-License-Identifier: MIT
// The example sliding_block: an elastic block on a rough plane against Coulomb's law, on the base of the box and on a
// line.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "mesh/generate.hpp"
#include "mpm/solver/observe.hpp"
#include "run/mpm/stage/stage.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus {
namespace {

constexpr double sine = 0.6, cosine = 0.8, gravity = 9.81;

struct Slide {
  double acceleration = 0;  ///< along the plane in the last stage [m/s²]
  double start_speed = 0;   ///< along the plane at its start [m/s]
  double path = 0;          ///< along the plane in the last stage [m]
  double lift = 0;          ///< of the centre of mass off the plane in the last stage [m]
};

/// Runs the example's stages with another friction; `along` points down the plane.
Slide run_example(const std::string& file, const std::string& plane, double friction,
                  const std::array<double, 2>& along) {
  const std::string path = std::string(TALUS_SOURCE_DIR) + "/examples/sliding_block/" + file;
  const input::LoadedCase loaded =
      input::read_case(path, {{"boundary." + plane + ".friction", std::to_string(friction)}});
  mpm::Body<2> body = run::prepare<2>(loaded.data, mesh::generate<2>(loaded.data.mesh));
  const double height = run::find_soil_height(body, loaded.data.gravity);
  const auto project = [&](const Vec<2>& v) { return v[0] * along[0] + v[1] * along[1]; };
  const auto project_off = [&](const Vec<2>& v) { return -v[0] * along[1] + v[1] * along[0]; };
  Slide slide;
  mpm::Totals<2> before;
  double start = 0;
  for (const input::Stage& stage : loaded.data.stages) {
    before = mpm::sum_points<2>(body, {});
    start = body.time;
    run::StageState state;
    EXPECT_EQ(run::run_stage(body, run::make_plan<2>(loaded.data, stage, height, 1), state), results::StageEnd::time);
  }
  const mpm::Totals<2> after = mpm::sum_points<2>(body, {});
  EXPECT_TRUE(body.lost.empty());
  slide.acceleration = (project(after.momentum) - project(before.momentum)) / after.mass / (body.time - start);
  slide.start_speed = project(before.momentum) / before.mass;
  slide.path = project(after.centre) - project(before.centre);
  slide.lift = project_off(after.centre) - project_off(before.centre);
  return slide;
}

struct Plane {
  std::string file, name;
  std::array<double, 2> along;
};
const std::vector<Plane> planes = {{"case.toml", "bottom", {1, 0}}, {"inclined.toml", "plane", {cosine, -sine}}};

// The remaining difference is the vibration of the block: the mean pressure on the plane over one second is not quite
// g cos θ, and the friction at points of the base that stick for a moment is less than μ times their pressure. Without
// friction neither matters, and the momentum along the plane is exact.
TEST(SlidingBlock, AccelerationIsThatOfCoulombsLaw) {
  for (const Plane& plane : planes) {
    EXPECT_NEAR(run_example(plane.file, plane.name, 0, plane.along).acceleration, gravity * sine, 1e-9) << plane.file;
    for (const double friction : {0.2, 0.4}) {
      const double exact = gravity * (sine - friction * cosine);
      const Slide slide = run_example(plane.file, plane.name, friction, plane.along);
      EXPECT_NEAR(slide.acceleration, exact, 0.01 * exact) << plane.file << ", friction " << friction;
      // One second of uniform acceleration, and a block that stays on its plane.
      EXPECT_NEAR(slide.path, slide.start_speed + 0.5 * exact, 0.02 * exact) << plane.file << ", friction " << friction;
      EXPECT_LT(std::abs(slide.lift), 0.005) << plane.file << ", friction " << friction;
    }
  }
}

TEST(SlidingBlock, BlockStaysWhereFrictionIsSteeperThanThePlane) {
  for (const Plane& plane : planes) {
    const Slide slide = run_example(plane.file, plane.name, 1.2 * sine / cosine, plane.along);
    // Free sliding would go 2.9 m; what is left is the elastic rocking of the block.
    EXPECT_LT(std::abs(slide.path), 0.002) << plane.file;
    EXPECT_LT(std::abs(slide.acceleration), 0.002 * gravity) << plane.file;
  }
}

}  // namespace
}  // namespace talus
