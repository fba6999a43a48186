// SPDX-License-Identifier: MIT
// Bars in the soil of MPM against closed forms: uniform strain with bond that yields at the ends, pull-out, rotation,
// rupture, and balance of forces and energy.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "mesh/locate.hpp"
#include "mpm/solver/bars.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

constexpr double stiffness = 1e7, strength = 50e3, bond = 4e3, bond_stiffness = 4e8;  ///< [N], [N], [N/m], [N/m²]

/// A bar of `pieces` pieces from `head` to `end`, joined to the soil at rest.
mpm::Bar make_bar(const mpm::Body<2>& body, const Vec<2>& head, const Vec<2>& end, int pieces) {
  mpm::Bar bar;
  bar.tension = {stiffness, 0, strength, true};
  const double length = std::hypot(end[0] - head[0], end[1] - head[1]), piece = length / pieces;
  for (int i = 0; i <= pieces; ++i) {
    mpm::BarNode node;
    const double t = static_cast<double>(i) / pieces, own = i == 0 || i == pieces ? piece / 2 : piece;
    node.place = t * length;
    node.soil.x = {head[0] + t * (end[0] - head[0]), head[1] + t * (end[1] - head[1])};
    node.soil.element = mesh::find_element<2>(body.mesh(), node.soil.x);
    node.soil.xi = mesh::find_local(body.mesh(), node.soil.element, node.soil.x);
    node.bond = {own * bond_stiffness, -own * bond, own * bond, false};
    bar.nodes.push_back(node);
  }
  bar.pieces.assign(static_cast<std::size_t>(pieces), {.length = piece});
  mpm::settle_bar(bar);
  return bar;
}

/// A block of 8 m × 4 m of elastic soil.
mpm::Body<2> make_block(double jitter) {
  return support::fill_body<2>(support::make_mesh<2>({32, 16}, {8, 4}, jitter),
                               {{material::LinearElastic::from_young(1e7, 0.3), 1800}}, 3,
                               [](const Vec<2>&) { return 0; });
}

/// Moves the bars of a body through `steps` steps in which the nodes of the soil move with `velocity`.
void move_bars(mpm::Body<2>& body, const std::function<Vec<2>(const Vec<2>&)>& velocity, double dt, int steps,
               bool moving, bool jacks = false) {
  mpm::StepOptions<2> o;
  o.dt = dt;
  o.moving = moving;
  o.jacks = jacks;
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    const Vec<2> v = velocity(body.mesh().nodes[i]);
    const mpm::Layout<2>& layout = *body.layout;
    for (int k = 0; k < layout.count_motion_rows(static_cast<int>(i)); ++k)
      for (std::size_t d = 0; d < 2; ++d)
        body.nodes.motion[static_cast<std::size_t>(layout.motion_row(static_cast<int>(i), k)) * mpm::motion_stride<2> +
                          2 + d] = v[d];
  }
  for (int n = 0; n < steps; ++n) {
    mpm::advance_bars(body, o);
    mpm::gather_loads(body);
  }
}

mpm::Body<2> make_body_with(const Vec<2>& head, const Vec<2>& end, int pieces, double jitter = 0) {
  mpm::Body<2> body = make_block(jitter);
  mpm::gather_nodal_sums(body, mpm::StepOptions<2>{});
  body.bars = {make_bar(body, head, end, pieces)};
  mpm::gather_loads(body);
  return body;
}

/// Elastic energy of a bar and its bond, and what the bond has dissipated [J].
double sum_energy(const mpm::Bar& bar) {
  double energy = 0;
  for (const mpm::BarPiece& piece : bar.pieces)
    energy += piece.length * (0.5 * stiffness * piece.strain * piece.strain + strength * piece.plastic);
  for (const mpm::BarNode& node : bar.nodes)
    energy += 0.5 * node.bond.stiffness * node.slip * node.slip + node.bond.upper * std::abs(node.all_slip - node.slip);
  return energy;
}

/// With bond much stiffer than the bar, N(s) = min(bond s, E A ε, bond (L - s)).
TEST(MpmBars, YieldAtTheEndsInSoilThatStretches) {
  mpm::Body<2> body = make_body_with({7.1, 2.3}, {0.9, 1.7}, 40, 0.15);
  const double length = std::hypot(6.2, 0.6), strain = 1e-3;
  move_bars(
      body,
      [&](const Vec<2>& x) {
        return Vec<2>{strain * x[0], strain * x[1]};
      },
      1e-3, 1000, false);
  const mpm::Bar& bar = body.bars[0];
  for (std::size_t j = 0; j < bar.pieces.size(); ++j) {
    const double s = 0.5 * (bar.nodes[j].place + bar.nodes[j + 1].place);
    const double closed = std::min({bond * s, stiffness * strain, bond * (length - s)});
    EXPECT_NEAR(bar.pieces[j].tension, closed, 0.03 * stiffness * strain) << s;
  }
  EXPECT_NEAR(bar.pieces[20].tension, stiffness * strain, 2e-3 * stiffness * strain)
      << "elastic slip decays over 0.16 m, and the middle is 0.6 m away";
  EXPECT_NEAR(bar.pieces[3].tension, bond * 3.5 * length / 40, 1e-6 * stiffness * strain) << "all bond has yielded";
}

/// Soil that moves off pulls the bar out of the soil that rests: the largest force is the bond on its embedded length.
TEST(MpmBars, PullOutOfTheShorterLength) {
  mpm::Body<2> body = make_body_with({7.5, 2}, {2.25, 2}, 84);
  move_bars(
      body,
      [](const Vec<2>& x) {
        return Vec<2>{std::clamp((x[0] - 4) / 0.25, 0.0, 1.0), 0};
      },
      1e-4, 2000, false);
  const mpm::Bar& bar = body.bars[0];
  double largest = 0;
  for (const mpm::BarPiece& piece : bar.pieces) largest = std::max(largest, piece.tension);
  EXPECT_GE(largest, bond * 1.75 * 0.98);
  EXPECT_LE(largest, bond * 2.0) << "the soil shears in one row of elements";
  EXPECT_NEAR(bar.nodes.back().all_slip, -0.2, 0.005) << "it follows the soil at its head";
  Vec<2> sum{};
  for (const Vec<2>& f : body.nodes.load)
    for (std::size_t d = 0; d < 2; ++d) sum[d] += f[d];
  EXPECT_NEAR(norm(sum), 0, 1e-6 * largest);
  EXPECT_NEAR(body.work.supports, sum_energy(bar), 0.01 * body.work.supports);
  EXPECT_EQ(body.work.external, body.work.supports) << "what a step counts as work of the loads is taken off";
}

TEST(MpmBars, CarryNothingWhenTheyRotateWithTheSoil) {
  mpm::Body<2> body = make_body_with({5.2, 2.6}, {2.8, 1.4}, 12, 0.15);
  constexpr int steps = 20000;
  const double angle = 1.2;
  move_bars(
      body,
      [](const Vec<2>& x) {
        return Vec<2>{-(x[1] - 2), x[0] - 4};
      },
      angle / steps, steps, true);
  const mpm::Bar& bar = body.bars[0];
  for (const mpm::BarPiece& piece : bar.pieces) EXPECT_LT(piece.tension, 1e-4 * stiffness);
  const double before = std::atan2(0.6, 1.2), radius = std::hypot(0.6, 1.2);
  EXPECT_NEAR(bar.nodes[0].soil.x[0], 4 + radius * std::cos(before + angle), 1e-3);
  EXPECT_NEAR(bar.nodes[0].soil.x[1], 2 + radius * std::sin(before + angle), 1e-3);
}

/// A bar whose bond is stronger than itself tears where the soil parts.
TEST(MpmBars, TearAtTheirRuptureStrain) {
  mpm::Body<2> body = make_body_with({7.5, 2}, {0.5, 2}, 56);
  mpm::Bar& bar = body.bars[0];
  for (mpm::BarNode& node : bar.nodes) node.bond.upper *= 100, node.bond.lower *= 100, node.bond.stiffness *= 100;
  bar.rupture_strain = 0.05;
  const auto part = [](const Vec<2>& x) { return Vec<2>{std::clamp((x[0] - 4) / 0.25, 0.0, 1.0), 0}; };
  move_bars(body, part, 1e-4, 100, false);
  EXPECT_NEAR(std::max_element(bar.pieces.begin(), bar.pieces.end(),
                               [](const auto& a, const auto& b) { return a.tension < b.tension; })
                  ->tension,
              strength, 1e-6 * strength);
  move_bars(body, part, 1e-4, 2000, false);
  const auto torn = std::count_if(bar.pieces.begin(), bar.pieces.end(), [](const auto& p) { return p.is_torn; });
  EXPECT_GE(torn, 1);
  for (const mpm::BarPiece& piece : bar.pieces) {
    if (piece.is_torn) {
      EXPECT_EQ(piece.tension, 0);
    }
  }
}

TEST(MpmBars, PressOnTheGroundWithTheirPlate) {
  mpm::Body<2> body = make_body_with({7.9, 2}, {0.5, 2}, 30);
  mpm::Bar& bar = body.bars[0];
  for (const double y : {1.6, 2.0, 2.4}) {
    mpm::SoilPlace place;
    place.x = {7.9, y};
    place.element = mesh::find_element<2>(body.mesh(), place.x);
    place.xi = mesh::find_local(body.mesh(), place.element, place.x);
    bar.plate.places.push_back(place);
  }
  bar.plate.law = {1e7, 0, 6e3, true};
  mpm::gather_loads(body);
  // The front slides out over the bar; 3 m of bond behind hold more than plate and the bond of 4 m in front.
  move_bars(
      body,
      [](const Vec<2>& x) {
        return Vec<2>{std::clamp((x[0] - 7) / 0.25, 0.0, 1.0), 0};
      },
      1e-4, 1000, false);
  EXPECT_NEAR(bar.plate.force, 6e3, 1e-6);
  double largest = 0;
  for (const mpm::BarPiece& piece : bar.pieces) largest = std::max(largest, piece.tension);
  EXPECT_NEAR(largest, 6e3 + bond * 0.9, 0.25 * bond) << "plate and the bond in front strip off";
  Vec<2> sum{};
  for (const Vec<2>& f : body.nodes.load)
    for (std::size_t d = 0; d < 2; ++d) sum[d] += f[d];
  EXPECT_NEAR(norm(sum), 0, 1e-6 * largest);
  EXPECT_EQ(body.work.external, body.work.supports);
}

/// Soil that parts, closes and leaves the bar makes pieces yield and go slack; their nodes stay beside the soil.
TEST(MpmBars, StayWithTheSoilWhenTheyYieldAndGoSlack) {
  mpm::Body<2> body = make_body_with({7.5, 2}, {0.5, 2}, 56);
  body.bars[0].tension.upper = 3e3;
  for (int n = 0; n < 40; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1;
    // Three blocks; from the tenth turn on the bar is bare between them.
    move_bars(
        body,
        [&](const Vec<2>& x) {
          return Vec<2>{sign * (std::clamp((x[0] - 3) / 0.25, 0.0, 1.0) - std::clamp((x[0] - 5) / 0.25, 0.0, 0.5)), 0};
        },
        1e-3, 50, false);
    if (n == 10)
      for (int e = 0; e < body.mesh().element_count(); ++e) {
        const auto& corner = body.mesh().nodes[static_cast<std::size_t>(body.mesh().elements[e][0])];
        if ((corner[0] > 2.5 && corner[0] < 3.5) || corner[0] > 6.5) body.points.count[static_cast<std::size_t>(e)] = 0;
      }
  }
  const mpm::Bar& bar = body.bars[0];
  for (const mpm::BarNode& node : bar.nodes) EXPECT_LT(std::abs(node.all_slip), 0.15) << node.place;
  EXPECT_LT(bar.pieces[0].tension, 1) << "beyond the soil nothing pulls";
  for (const mpm::BarNode& node : bar.nodes)
    EXPECT_NEAR(-node.force[0], node.soil.is_joined ? node.bond.stiffness * node.slip : 0.0, 1e-6 * 3e3)
        << "in equilibrium at " << node.place;
}

TEST(MpmBars, KeepTheirPrestressWhileTheyAreJacked) {
  mpm::Body<2> body = make_body_with({7.9, 2}, {0.5, 2}, 30);
  mpm::Bar& bar = body.bars[0];
  bar.nodes[0].bond = {};
  bar.prestress = 15e3;
  bar.plate.places = {bar.nodes[0].soil};
  bar.plate.law = {1e7, 0, 30e3, true};
  mpm::settle_bar(bar);
  EXPECT_NEAR(bar.pieces[0].tension, 15e3, 1e-6);
  EXPECT_NEAR(bar.plate.force, 15e3, 1e-5);
  double held = 0;
  for (const mpm::BarNode& node : bar.nodes) held -= node.bond.stiffness * node.slip;
  EXPECT_NEAR(held, 15e3, 1e-5) << "the bond holds what the plate presses";
  mpm::gather_loads(body);
  const auto stretch = [](const Vec<2>& x) { return Vec<2>{1e-3 * x[0], 0}; };
  move_bars(body, stretch, 1e-2, 50, false, true);
  EXPECT_NEAR(bar.pieces[0].tension, 15e3, 1e-6);
  move_bars(body, stretch, 1e-2, 50, false);
  EXPECT_GT(bar.pieces[0].tension, 16e3) << "locked off, it follows the soil";
}

}  // namespace
}  // namespace talus
