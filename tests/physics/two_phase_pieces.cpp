// SPDX-License-Identifier: MIT
// Parts of the plain two-velocity step by hand: drag at a node, fixed phases, damping, smoothing, rain and seepage.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

const NodeDirection free_node{.solid_mass = 3,
                              .water_mass = 2,
                              .content = 0.3,
                              .drag = 700,
                              .v = 0.4,
                              .w = -0.2,
                              .solid_force = 11,
                              .water_force = -5,
                              .solid_fixed = false,
                              .water_fixed = false};

TEST(TwoPhaseDrag, SolutionFulfilsBothBalancesAndTheMixtureFeelsNoDrag) {
  for (const Drag drag : {Drag::implicit_at_nodes, Drag::explicit_as_source}) {
    const double dt = 0.01;
    const Accelerations a = solve_direction(free_node, dt, drag);
    const double later = drag == Drag::implicit_at_nodes ? dt : 0.0;
    const double relative = -0.2 - 0.4 + later * (a.water - a.solid);
    EXPECT_NEAR(2 * a.water, -5 - 700 * relative, 1e-10);
    EXPECT_NEAR(3 * a.solid, 11 + 0.3 * 700 * relative, 1e-10);
    EXPECT_NEAR(3 * a.solid + 0.3 * 2 * a.water, 11 - 0.3 * 5, 1e-10);
  }
}

TEST(TwoPhaseDrag, ImplicitDragIsTheExplicitOneInSmallStepsAndDarcysLawInLargeOnes) {
  const Accelerations exact = solve_direction(free_node, 1e-9, Drag::explicit_as_source);
  const Accelerations small = solve_direction(free_node, 1e-9, Drag::implicit_at_nodes);
  EXPECT_NEAR(small.water / exact.water, 1, 1e-5);
  EXPECT_NEAR(small.solid / exact.solid, 1, 1e-5);
  NodeDirection tight = free_node;
  tight.drag = 1e12, tight.solid_fixed = true, tight.v = tight.w = 0;
  const Accelerations a = solve_direction(tight, 0.01, Drag::implicit_at_nodes);
  EXPECT_NEAR((tight.w + 0.01 * a.water) / (tight.water_force / tight.drag), 1, 1e-6);
}

TEST(TwoPhaseDrag, FixedPhaseIsAtRestAndDragsTheOther) {
  NodeDirection node = free_node;
  const double dt = 0.01;
  node.water_fixed = true;
  Accelerations a = solve_direction(node, dt, Drag::implicit_at_nodes);
  EXPECT_NEAR(node.w + dt * a.water, 0, 1e-15);
  EXPECT_NEAR(3 * a.solid, 11 - 0.3 * 700 * (node.v + dt * a.solid), 1e-10);
  node.water_fixed = false, node.solid_fixed = true;
  a = solve_direction(node, dt, Drag::implicit_at_nodes);
  EXPECT_NEAR(node.v + dt * a.solid, 0, 1e-15);
  EXPECT_NEAR(2 * a.water, -5 - 700 * (node.w + dt * a.water), 1e-10);
}

TEST(TwoPhaseDamping, ActsAgainstEachPhaseOnItsOwnUnbalancedForce) {
  WetBody<2> body = make_column<2>(1, 1.0, make_table_soil(), 0.4);
  body.solid_constraints.assign(4, {}), body.water_constraints.assign(4, {});
  for (WetPoint<2>& point : body.points) point.v = {1, -1}, point.w = {1, 1};
  body.gravity = {0, -10};
  classify_wet_elements(body, {});
  map_wet_points(body);
  std::vector<WetNode<2>> before = body.nodes;
  solve_wet_momentum(body, {.time_step = 1, .drag = Drag::explicit_as_source, .damping = 0.2, .water_damping = 0.5});
  for (std::size_t i = 0; i < 4; ++i) {
    // Solid and water fall under their own weights: 10 less 20 % and 50 %. Water moves upwards: its damping helps
    // gravity; the solid moves downwards. The drag pulls at each by the other's speed.
    const double drag = before[i].drag() * 2, theta = 0.4;
    EXPECT_NEAR(body.nodes[i].water_acceleration[1], -10 * 1.5 - drag / before[i].whole_mass, 1e-6);
    EXPECT_NEAR(body.nodes[i].solid_acceleration[1], -10 * 0.8 + theta * drag / before[i].solid_mass, 1e-6);
    EXPECT_NEAR(body.nodes[i].water_acceleration[0], 0, 1e-9);
  }
}

/// One node on a surface with a normal that is no axis.
WetBody<2> make_surface_node(SurfaceKind kind) {
  WetBody<2> body;
  body.mesh.nodes = {{0.0, 0.0}};
  body.nodes.resize(1);
  body.nodes[0].solid_mass = 3, body.nodes[0].water_mass = 0.8, body.nodes[0].whole_mass = 2;
  body.nodes[0].surface = Vector<2>(3, 4) / 10;
  body.solid_constraints.resize(1), body.water_constraints.resize(1);
  body.surface = {{.kind = kind, .rain = {0, -0.02}}};
  return body;
}

TEST(TwoPhaseSurface, InflowIsLimitedToTheRainAndMomentumIsKept) {
  const Vector<2> n(0.6, 0.8), v0(0.1, -0.3), w0(-0.4, -0.5);
  for (const SurfaceKind kind : {SurfaceKind::seepage, SurfaceKind::rain}) {
    const WetBody<2> body = make_surface_node(kind);
    Vector<2> v = v0, w = w0;
    limit_inflow(body, 0, v, w);
    const double allowed = kind == SurfaceKind::rain ? -0.02 * 0.8 : 0.0;
    EXPECT_NEAR(0.4 * (w - v).dot(n), allowed, 1e-15);
    EXPECT_LT((3 * (v - v0) + 0.8 * (w - w0)).norm(), 1e-15);
    EXPECT_NEAR((w - w0).dot(Vector<2>(-0.8, 0.6)), 0, 1e-15);  // nothing along the surface
    Vector<2> v_out = v0, w_out(0.5, 0.5);
    limit_inflow(body, 0, v_out, w_out);  // what leaves, leaves
    EXPECT_EQ(w_out, Vector<2>(0.5, 0.5));
    EXPECT_EQ(v_out, v0);
  }
}

TEST(TwoPhaseSurface, FixedSoilLeavesTheWholeCorrectionToTheWater) {
  WetBody<2> body = make_surface_node(SurfaceKind::seepage);
  body.solid_constraints[0].fixed = {true, true};
  body.water_constraints[0].fixed = {true, false};  // and the water may move along y only
  Vector<2> v(0, 0), w(0, -0.5);
  limit_inflow(body, 0, v, w);
  EXPECT_EQ(v, Vector<2>(0, 0));
  EXPECT_NEAR(w.norm(), 0, 1e-15);
}

TEST(TwoPhaseSurface, StandingWaterLoadsASubmergedSideLikeItsPressure) {
  WetBody<2> body = make_column<2>(2, 1.0, make_table_soil(), 0.4);
  body.gravity = {0, -10};
  // The right wall open under water 1.5 m deep: nodes at 0, 1, 2 m.
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::head, .head = 1.5});
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (body.mesh.nodes[i][0] > 0.5) body.water_constraints[i].fixed[0] = false;
  classify_wet_elements(body, {});
  body.nodes.assign(body.mesh.nodes.size(), {});
  load_free_surface(body);
  double total = 0, moment = 0;
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    total += body.nodes[i].water_force[0];
    moment += body.nodes[i].water_force[0] * body.mesh.nodes[i][1];
    EXPECT_EQ(body.nodes[i].force, body.nodes[i].water_force);
  }
  // Linear between nodes: 15, 5 and 0 kPa at 0, 1 and 2 m.
  EXPECT_NEAR(total, -(10e3 + 2.5e3), 1e-9);
  EXPECT_NEAR(moment, -(5e3 * 0.5 + 10e3 * 0.5 / 3 * 1 + 2.5e3 * (1 + 1.0 / 3)), 5);
}

TEST(TwoPhaseSurface, PartlyFilledElementHasItsSurfaceAtInnerNodesAsWell) {
  // Four of five squares are filled, the topmost by half: two halves of the surface, together the width of the column.
  Soil soil = make_table_soil();
  WetBody<2> tall = make_column<2>(5, 1.0, soil, 0.4);
  std::erase_if(tall.points, [](const WetPoint<2>& point) { return point.x[1] > 4; });
  for (WetPoint<2>& point : tall.points)
    if (point.x[1] > 3) point.volume /= 2, point.mass /= 2, point.water_mass /= 2;
  classify_wet_elements(tall, {});
  map_wet_points(tall);
  load_free_surface(tall);
  double top = 0, inner = 0, rest = 0, side = 0;
  for (std::size_t i = 0; i < tall.mesh.nodes.size(); ++i) {
    const double y = tall.mesh.nodes[i][1];
    (y > 3.9 ? top : y > 2.9 ? inner : rest) += tall.nodes[i].surface[1];
    side += std::abs(tall.nodes[i].surface[0]);
  }
  EXPECT_NEAR(top + inner, 1, 1e-14);
  EXPECT_GT(top, 0.2);
  EXPECT_GT(inner, 0.2);
  EXPECT_EQ(rest, 0);
  EXPECT_EQ(side, 0);  // the walls are closed
}

TEST(TwoPhaseSmoothing, WaterIncrementsKeepTheirSumAndLoseTheirRoughness) {
  WetBody<2> body = make_wet_body(make_box<2>({6, 6}, {1.0, 1.0}), make_table_soil());
  fill_wet(
      body, 0.4, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>&) { return 0.0; });
  classify_wet_elements(body, {});
  double before = 0, after = 0;
  for (std::size_t e = 0; e < body.cells.size(); ++e)
    body.cells[e].flux_divergence = std::sin(static_cast<double>(7 * e)),
    before += body.cells[e].flux_divergence * body.mesh.volumes[e];
  smooth_water_increments(body, {.time_step = 1, .smooth_pressure = true});
  double rough = 0, smooth = 0;
  for (std::size_t e = 0; e < body.cells.size(); ++e) {
    const double value = body.cells[e].flux_divergence + body.cells[e].surplus;
    after += value * body.mesh.volumes[e];
    rough += std::pow(body.cells[e].flux_divergence, 2), smooth += value * value;
  }
  EXPECT_NEAR(after, before, 1e-14);
  EXPECT_LT(smooth, 0.3 * rough);
}

}  // namespace
}  // namespace talus::reference
