// SPDX-License-Identifier: MIT
// The grid: points that leave it, the moving free surface, the critical time step, and instability.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <type_traits>

#include "base/error.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/solver/step.hpp"
#include "support/box_case.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

template <class Dimension>
class EngineGrid : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EngineGrid, Dimensions);

template <int D>
void set_box(std::array<int, D>& cells, Vec<D>& size, int nx, int ny, double h) {
  cells[0] = nx, size[0] = nx * h;
  cells[1] = ny, size[1] = ny * h;
  if constexpr (D == 3) cells[2] = 2, size[2] = 2 * h;
}

TYPED_TEST(EngineGrid, PointsThatLeaveAreRecordedOnceWithTheirMassAndMomentum) {
  constexpr int D = TypeParam::value;
  std::array<int, D> cells;
  Vec<D> size;
  set_box<D>(cells, size, 10, 5, 0.2);
  auto mesh = support::make_box_mesh<D>(
      cells, size, {"soil"}, [](const Vec<D>& x) { return x[0] > 1.2 && x[1] > 0.2 && x[1] < 0.8 ? 0 : -1; });
  input::Case data = support::make_box_case<D>(support::make_elastic(1e6));
  data.boundaries.clear();
  data.gravity.acceleration = 0;
  data.initial.velocity["soil"] = {2, 0.3, 0};
  mpm::Body<D> body = run::prepare<D>(data, mesh, 3);
  const auto before = mpm::sum_points(body, {});
  const int count = body.points.size();
  const auto plan = support::make_stage(data, body, 0.25, {});
  EXPECT_EQ(support::run_plan(body, plan), results::StageEnd::time);
  EXPECT_NEAR(body.time, 0.25, 1e-12) << "the run continues without them";
  ASSERT_GT(body.lost.size(), 10u);
  ASSERT_LT(static_cast<int>(body.lost.size()), count);
  const auto after = mpm::sum_points(body, {});
  double mass = after.mass;
  Vec<D> momentum = after.momentum;
  std::set<int> ids;
  for (const auto& lost : body.lost) {
    EXPECT_TRUE(ids.insert(lost.id).second) << "point " << lost.id << " left twice";
    EXPECT_FALSE(mpm::is_present(body, lost.id));
    mass += lost.mass;
    for (std::size_t d = 0; d < D; ++d) momentum[d] += lost.momentum[d];
    EXPECT_GT(lost.time, 0);
    EXPECT_LE(lost.time, 0.25 + 1e-12);
    bool outside = false;
    for (std::size_t d = 0; d < D; ++d) outside = outside || lost.position[d] < 0 || lost.position[d] > size[d];
    EXPECT_TRUE(outside);
  }
  EXPECT_EQ(after.points + static_cast<int>(ids.size()), count);
  EXPECT_NEAR(mass, before.mass, 1e-12 * before.mass);
  // Nothing holds the soil, so all momentum is in it or has left with it.
  for (std::size_t d = 0; d < D; ++d) EXPECT_NEAR(momentum[d], before.momentum[d], 1e-10 * before.mass);
}

TYPED_TEST(EngineGrid, RunContinuesWhenAllPointsHaveLeft) {
  constexpr int D = TypeParam::value;
  std::array<int, D> cells;
  Vec<D> size;
  set_box<D>(cells, size, 4, 2, 0.2);
  auto mesh = support::make_box_mesh<D>(cells, size, {"soil"}, [](const Vec<D>& x) { return x[0] > 0.4 ? 0 : -1; });
  input::Case data = support::make_box_case<D>(support::make_elastic(1e6));
  data.boundaries.clear();
  data.initial.velocity["soil"] = {5, 0, 0};
  mpm::Body<D> body = run::prepare<D>(data, mesh);
  EXPECT_EQ(support::run_plan(body, support::make_stage(data, body, 0.5, {})), results::StageEnd::time);
  EXPECT_EQ(mpm::sum_points(body, {}).points, 0);
  EXPECT_EQ(static_cast<int>(body.lost.size()), body.points.size());
}

/// A column of weak soil that collapses over the floor of its box.
template <int D>
mpm::Body<D> make_collapse(Vec<D>& size) {
  std::array<int, D> cells;
  set_box<D>(cells, size, 16, 7, 0.25);
  const material::MohrCoulomb soil(material::LinearElastic::from_young(2e6, 0.3), {200, 0.4, 0.05, 100});
  mpm::Body<D> body = support::fill_body<D>(
      support::make_mesh<D>(cells, size), {{soil, 1800}}, D == 2 ? 3 : 4,
      [](const Vec<D>& x) { return x[0] < 1.3 && x[1] < 1.5 ? 0 : -1; }, {}, 4);
  support::fix_faces<D>(body, size, 1);
  support::fix_nodes<D>(body, 0, [](const Vec<D>& x) { return x[1] < 1e-9; });
  return body;
}

TYPED_TEST(EngineGrid, NodalSumsAndFreeSurfaceFollowTheSoilAsIfFoundAnew) {
  constexpr int D = TypeParam::value;
  for (const support::Mode& mode : support::all_modes()) {
    Vec<D> size;
    mpm::Body<D> body = make_collapse<D>(size);
    const int elements = body.mesh().element_count();
    mpm::StepOptions<D> o;
    o.mixed = mode.mixed;
    o.smoothing = mode.smoothing;
    o.gravity[1] = -20;
    o.dt = 0.7 * mpm::find_critical_step(body, 1).dt;
    mpm::gather_nodal_sums(body, o);
    const auto surface_at_start = body.elements.fill_limit;
    const auto count_at_start = body.points.count;
    int emptied = 0, filled = 0, partial = 0;
    for (int round = 0; round < 12; ++round) {
      support::run_steps(body, o, 25);
      mpm::Body<D> fresh = body;
      mpm::gather_nodal_sums(fresh, o);
      double largest[1 + 2 * D] = {}, difference[1 + 2 * D] = {};
      for (int i = 0; i < body.mesh().node_count(); ++i) {
        double a[1 + 2 * D] = {}, b[1 + 2 * D] = {};
        for (int r = body.layout->row_start[static_cast<std::size_t>(i)];
             r < body.layout->row_start[static_cast<std::size_t>(i) + 1]; ++r) {
          const std::size_t row =
              static_cast<std::size_t>(body.layout->node_rows[static_cast<std::size_t>(r)]) * mpm::sums_stride;
          for (std::size_t q = 0; q < 1 + 2 * D; ++q) {
            a[q] += body.nodes.sums[row + q];
            b[q] += fresh.nodes.sums[row + q];
          }
        }
        for (std::size_t q = 0; q < 1 + 2 * D; ++q) {
          largest[q] = std::max(largest[q], std::abs(b[q]));
          difference[q] = std::max(difference[q], std::abs(a[q] - b[q]));
        }
      }
      for (std::size_t q = 0; q < 1 + 2 * D; ++q)
        ASSERT_LE(difference[q], 1e-11 * largest[q]) << mode.name << " sum " << q << " round " << round;
      if (!mode.mixed) continue;
      for (int e = 0; e < elements; ++e) {
        const std::size_t at = static_cast<std::size_t>(e);
        if (body.points.count[at] == 0) continue;
        bool surface = false;
        for (int n : body.mesh().neighbours[at])
          surface = surface || (n >= 0 && body.points.count[static_cast<std::size_t>(n)] == 0);
        ASSERT_EQ(body.elements.fill_limit[at], surface ? mpm::full_share * body.mesh().volumes[at] : 0)
            << mode.name << " element " << e;
      }
    }
    for (std::size_t e = 0; e < static_cast<std::size_t>(elements); ++e) {
      emptied += count_at_start[e] > 0 && body.points.count[e] == 0;
      filled += count_at_start[e] == 0 && body.points.count[e] > 0;
      partial += body.points.count[e] > 0 && body.elements.fill_limit[e] > 0 && surface_at_start[e] == 0;
    }
    EXPECT_GT(emptied, 3) << mode.name;
    EXPECT_GT(filled, 10) << mode.name;
    if (mode.mixed) {
      EXPECT_GT(partial, 3) << "elements inside the column must have come to the surface";
    }
  }
}

TYPED_TEST(EngineGrid, CriticalStepIsTheSmallestAltitudeOverTheWaveSpeed) {
  constexpr int D = TypeParam::value;
  std::array<int, D> cells;
  Vec<D> size;
  cells.fill(2);
  size.fill(0.5);
  // Legs of 0.25 m: the smallest altitude of the right triangle and of Kuhn's tetrahedron is 0.25/√2.
  const double e = 30e6, nu = 0.2, rho = 1900;
  mpm::Body<D> body =
      support::fill_body<D>(support::make_mesh<D>(cells, size, 0), {{material::LinearElastic::from_young(e, nu), rho}},
                            D == 2 ? 3 : 4, [](const Vec<D>&) { return 0; });
  const double constrained = e * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  EXPECT_NEAR(mpm::find_critical_step(body, 1).dt, 0.25 / std::sqrt(2.0) / std::sqrt(constrained / rho), 1e-12);
  EXPECT_NEAR(mpm::find_critical_step(body, 9).dt, 3 * 0.25 / std::sqrt(2.0) / std::sqrt(constrained / rho), 1e-12);
}

TYPED_TEST(EngineGrid, TooLargeAStepIsReportedWithStageTimeAndPlace) {
  constexpr int D = TypeParam::value;
  std::array<int, D> cells;
  Vec<D> size;
  set_box<D>(cells, size, 6, 6, 0.2);
  auto mesh = support::make_box_mesh<D>(cells, size, {"soil"}, [](const Vec<D>& x) { return x[1] < 0.8 ? 0 : -1; });
  const input::Case data = support::make_box_case<D>(support::make_elastic(10e6));
  mpm::Body<D> body = run::prepare<D>(data, mesh);
  auto plan = support::make_stage(
      data, body, 5, {.geometry = input::Geometry::frozen, .courant = 40});  // three halvings are not enough
  plan.name = "shaking";
  run::StageState state;
  run::StageHooks<D> hooks;
  bool saved = false;
  hooks.save_last_good = [&](const mpm::Body<D>& last, const run::StageState&) {
    saved = std::isfinite(mpm::sum_points(last, {}).kinetic);
    return std::string("checkpoint.h5");
  };
  try {
    run::run_stage(body, plan, state, hooks);
    FAIL() << "a step far too large must not pass";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(error.code(), ExitCode::unstable);
    EXPECT_TRUE(saved) << "the last good body must hold numbers";
    for (const char* part : {"'shaking'", "t = ", "at (", "'soil'", "courant", "checkpoint.h5"}) {
      EXPECT_NE(sentence.find(part), std::string::npos) << part << " in: " << sentence;
    }
  }
}

}  // namespace
}  // namespace talus
