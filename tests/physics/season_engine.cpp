// SPDX-License-Identifier: MIT
// Root water uptake in MPM: against the same sink in seepage; budgets, threads, checkpoints; and the uptake zone of the
// [[roots]] of a case.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/error.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "run/mpm/record/point_results.hpp"
#include "run/mpm/record/water_record.hpp"
#include "site/initial_water.hpp"
#include "site/roots.hpp"
#include "support/points.hpp"
#include "support/scratch.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;

input::Material make_silt() {
  input::Material soil = make_wet_soil(50e6);
  soil.water.retention = input::RetentionCurve::van_genuchten;
  soil.water.minimum_saturation = 0.1;
  soil.water.reference_pressure = 8e3;
  soil.water.lambda = 0.4;
  soil.water.conductivity = 1e-3;
  soil.water.relative_conductivity = input::ConductivityCurve::hillel;
  soil.water.exponent = 3;
  return soil;
}

input::Roots make_plants(const std::string& ground, double depth, double rate, std::array<double, 4> suctions) {
  input::Roots roots;
  roots.ground = ground;
  roots.depth = depth;
  roots.transpiration = input::Transpiration{make_constant(rate), input::SeriesShape::linear, suctions};
  return roots;
}

template <int D>
input::Case make_planted_case(double rate, double level) {
  input::Case data = make_box_case<D>(make_silt());
  data.water.bulk_modulus = 200e6;
  data.initial.stress = input::InitialStress::k0;
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, level}};
  data.roots = {make_plants("top", 0.5, rate, {0, 0, 12e3, 22e3})};
  data.roots[0].profile = input::RootProfile::exponential;
  data.roots[0].decay_depth = 0.3;
  return data;
}

mesh::Mesh<2> make_column_mesh() {
  return make_box_mesh<2>(
      {2, 10}, {0.2, 1}, {"soil"}, [](const Vec<2>&) { return 0; }, 0);
}

/// A body at rest under its weight and its pore pressures.
template <int D>
mpm::Body<D> make_still_body(const input::Case& data, const mesh::Mesh<D>& mesh) {
  mpm::Body<D> body = run::prepare<D>(data, mesh);
  run_plan(body, make_rest_stage<D>(
                     data, body, 5,
                     {.damping = 0.5, .geometry = input::Geometry::frozen, .water = input::WaterMotion::held}));
  return body;
}

const input::StepSettings seeping{.damping = 0.2, .integration = input::Integration::mixed};
const input::StepSettings flowing{
    .damping = 0.2, .integration = input::Integration::mixed, .water = input::WaterMotion::flows};

template <int D>
double find_drawn_volume(const mpm::Body<D>& body) {
  return body.water.transpired / body.water.density;
}

void expect_to_dry_as_in_seepage(const input::StepSettings& settings, double closest) {
  const double rate = 3e-3, duration = 20;
  const input::Case data = make_planted_case<2>(rate, -0.4);
  const mesh::Mesh<2> mesh = make_column_mesh();
  auto body = make_still_body<2>(data, mesh);
  EXPECT_EQ(body.water.transpired, 0) << "drained water";
  const double before = mpm::find_water_state(body).mass;
  run_plan(body, make_stage<2>(data, body, duration, settings));
  EXPECT_LT(std::abs(run::make_water_result(data, body, before).error), 1e-11) << "65 000 steps";

  mesh::Mesh<2> wet;
  auto model = site::make_seepage_model<2>(data, mesh, wet);
  model.sinks = site::make_root_sinks<2>(data, wet);
  fem::SeepageSchedule schedule;
  schedule.outputs = {duration};
  schedule.first_step = 1e-3;
  schedule.largest_step = 0.1;
  const auto history = fem::solve_transient_seepage(model, std::vector<double>(mesh.nodes.size(), -0.4), schedule);
  const fem::Uptake& drawn = history.uptakes[0][0];
  EXPECT_NEAR(drawn.potential, rate * duration * 0.2, 1e-12);
  EXPECT_LT(drawn.actual, 0.9 * drawn.potential) << "reduced";
  std::printf("drawn %.6g by the engine, %.6g by seepage, of %.6g m3\n", find_drawn_volume(body), drawn.actual,
              drawn.potential);
  EXPECT_NEAR(find_drawn_volume(body), drawn.actual, closest * drawn.actual);
  double least = 1e9, most = 0, worst = 0;
  for_each_point(body, [&](int, const mpm::PointView<2>& p) {
    double mean = 0;
    for (int i : mesh.elements[static_cast<std::size_t>(p.element)])
      mean += history.states[0].pressure[static_cast<std::size_t>(i)] / 3;
    worst = std::max(worst, std::abs(p.pressure - mean));
    least = std::min(least, mean);
    most = std::max(most, mean);
  });
  std::printf("suctions %.4g to %.4g kPa, engine within %.3g kPa\n", least / 1e3, most / 1e3, worst / 1e3);
  EXPECT_GT(most, 16e3) << "from 4 to 14 kPa at the start";
  EXPECT_LT(worst, 0.05 * most);
}

TEST(SeasonEngine, ColumnDriesAsInSeepage) {
  expect_to_dry_as_in_seepage(flowing, 0.01);
}
TEST(SeasonEngine, ColumnInTheDarcyFormulationDriesAsInSeepage) {
  expect_to_dry_as_in_seepage(seeping, 0.01);
}

TEST(SeasonEngine, UnreducedUptakeIsTheRateTimesTheGroundIn2DAnd3D) {
  const auto look = [](auto data, const auto& mesh, double ground) {
    constexpr int D = static_cast<int>(std::tuple_size_v<std::decay_t<decltype(mesh.nodes[0])>>);
    data.roots[0].transpiration->suctions = {0, 0, 1e6, 2e6};
    input::StepSettings alone = flowing;
    alone.water_exchange = false;
    for (const input::StepSettings& settings : {flowing, alone, seeping}) {
      auto body = run::prepare<D>(data, mesh);
      auto plan = make_stage<D>(data, body, 0.05, settings);
      const double before = mpm::find_water_state(body).mass;
      run::StageState state;
      run::run_stage<D>(body, plan, state);
      const double whole = 1e-3 * ground * body.time;
      EXPECT_NEAR(find_drawn_volume(body), whole, 1e-3 * ground * 4 * state.dt) << "to the length of one exchange";
      EXPECT_LT(std::abs(run::make_water_result(data, body, before).error), 1e-12);
    }
  };
  look(make_planted_case<2>(1e-3, -0.4), make_column_mesh(), 0.2);
  look(make_planted_case<3>(1e-3, -0.4),
       make_box_mesh<3>({2, 4, 2}, {0.4, 1, 0.4}, {"soil"}, [](const Vec<3>&) { return 0; }), 0.16);
}

TEST(SeasonEngine, FrozenSoilDrawsNothingAfterAStageThatDid) {
  const input::Case data = make_planted_case<2>(1e-3, -0.4);
  auto body = run::prepare<2>(data, make_column_mesh());
  const double before = mpm::find_water_state(body).mass;
  run_plan(body, make_stage<2>(data, body, 0.05, seeping));
  const double drawn = body.water.transpired;
  EXPECT_GT(drawn, 0);
  input::StepSettings still = seeping;
  still.geometry = input::Geometry::frozen;
  run_plan(body, make_stage<2>(data, body, 0.05, still));
  EXPECT_EQ(body.water.transpired, drawn);
  EXPECT_LT(std::abs(run::make_water_result(data, body, before).error), 1e-12);
}

TEST(SeasonEngine, ThreadsAndCheckpointsChangeNothing) {
  const input::Case data = make_planted_case<2>(3e-3, -0.4);
  const auto start = run::prepare<2>(
      data,
      make_box_mesh<2>({8, 10}, {2, 1}, {"soil"}, [](const Vec<2>& x) { return x[1] < 0.6 || x[0] < 1.2 ? 0 : -1; }),
      5);
  const auto advance = [&](const input::StepSettings& settings, mpm::Body<2> body, int threads, bool interrupted) {
    auto options = run::make_options(make_stage<2>(data, body, 1, settings));
    options.gravity = run::find_gravity<2>(data.gravity);
    options.dt = 1e-4;
    options.threads = threads;
    mpm::gather_nodal_sums(body, options);
    for (int i = 0; i < 202; ++i) {
      if (interrupted && i == 101) {
        const std::filesystem::path path = support::name_scratch("body.h5");
        output::ArchiveWriter writer;
        run::put_body(writer, body);
        writer.write(path);
        mpm::Body<2> fresh = start;
        run::get_body(output::ArchiveReader(path), fresh);
        body = std::move(fresh);
      }
      mpm::step(body, options);
    }
    return body;
  };
  for (const input::StepSettings& settings : {flowing, seeping}) {
    const auto one = advance(settings, start, 1, false);
    EXPECT_GT(one.water.transpired, 0);
    for (const auto& other : {advance(settings, start, 3, false), advance(settings, start, 1, true)}) {
      EXPECT_EQ(other.water.transpired, one.water.transpired);
      for (int id = 0; id < one.points.size(); ++id) {
        if (!mpm::is_present(one, id)) continue;
        ASSERT_EQ(mpm::view_point(other, id).pressure, mpm::view_point(one, id).pressure) << id;
      }
    }
  }
}

TEST(RootSink, CoversTheGroundAndFollowsTheRoots) {
  input::Case data = make_planted_case<2>(1e-8, 0);
  // Elements of 0.25 m, wider than the last tenth of the roots
  const auto mesh = make_box_mesh<2>({8, 8}, {2, 2}, {"soil"}, [](const Vec<2>&) { return 0; });
  data.roots = {make_plants("top", 0.6, 1e-8, {0, 0, 1e5, 2e5})};
  const auto find_sums = [&](const input::Roots& roots) {
    const auto d = site::find_root_distribution<2>(data, roots, mesh);
    std::array<double, 3> sums{};  // all, its moment about the ground, what is right of the middle
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& x = mesh.nodes[static_cast<std::size_t>(mesh.elements[e][k])];
        sums[0] += d.weights[e][k];
        sums[1] += d.weights[e][k] * (2 - x[1]);
        if (x[0] > 1) sums[2] += d.weights[e][k];
      }
    }
    EXPECT_NEAR(sums[0], d.covered, 1e-12);
    return sums;
  };
  const auto even = find_sums(data.roots[0]);
  EXPECT_NEAR(even[0], 2, 1e-12);
  EXPECT_NEAR(even[1] / even[0], 0.3, 0.01) << "mean depth";
  input::Roots other = data.roots[0];
  other.profile = input::RootProfile::table;
  other.depth_table = {{0, 1}, {0.6, 0}};
  EXPECT_NEAR(find_sums(other)[1] / 2, 0.2, 0.01);
  other = data.roots[0];
  other.along = {{0.5, 0}, {1.5, 1}};
  const auto part = find_sums(other);
  EXPECT_NEAR(part[0], 1, 0.01);
  EXPECT_GT(part[2], 0.8 * part[0]);
  other.ground = "nowhere";
  EXPECT_THROW(site::find_root_distribution<2>(data, other, mesh), Error);
  other.ground = "left";
  EXPECT_THROW(site::find_root_distribution<2>(data, other, mesh), Error) << "a wall has no horizontal extent";
  data.roots[0].transpiration->suctions = {0, 0, 2e5, 1e5};
  EXPECT_THROW(site::make_root_sinks<2>(data, mesh), Error) << "suctions that fall";
}

TEST(RootSink, SlopeAndCrestDrinkAlikePerHorizontalMetre) {
  // The mesh of a strip under a line that is level up to x = 2 and falls at 45° from there on.
  mesh::Mesh<2> mesh = make_box_mesh<2>(
      {80, 20}, {4, 1}, {"soil"}, [](const Vec<2>&) { return 0; }, 0);
  for (auto& x : mesh.nodes) x[1] -= std::max(0.0, x[0] - 2);
  mesh::finish(mesh, mesh::Order::as_given);
  input::Case data = make_planted_case<2>(1e-8, -9);
  data.roots = {make_plants("top", 0.3, 1e-8, {0, 0, 1e5, 2e5})};
  const auto d = site::find_root_distribution<2>(data, data.roots[0], mesh);
  EXPECT_NEAR(d.covered, 4, 1e-12);
  double crest = 0, slope = 0, others = 0;  // away from the bend and the ends
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    double x = 0;
    for (int i : mesh.elements[e]) x += mesh.nodes[static_cast<std::size_t>(i)][0] / 3;
    for (double w : d.weights[e]) (x > 0.5 && x < 1.5 ? crest : x > 2.6 && x < 3.6 ? slope : others) += w;
  }
  EXPECT_NEAR(slope / crest, 1, 0.03);
}

}  // namespace
}  // namespace talus
