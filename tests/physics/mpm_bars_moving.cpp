// SPDX-License-Identifier: MIT
// Bars in MPM at moving geometry: pull-out of a block that moves away equals bond × length, and soil that translates
// over several elements carries bars and plates without a change of their force.

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/locate.hpp"
#include "mpm/solver/bars.hpp"
#include "mpm/solver/step.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

constexpr double bond_strength = 4e3, plate = 4e3, yield_slip = 1e-3;  ///< [N/m], [N], [m]

mpm::SoilPlace find_place(const mpm::Body<2>& body, const Vec<2>& x, const Vec<2>& inwards) {
  mpm::SoilPlace place;
  place.x = x;
  place.element = mesh::find_element<2>(body.mesh(), {x[0] + 1e-4 * inwards[0], x[1] + 1e-4 * inwards[1]});
  place.xi = mesh::find_local(body.mesh(), place.element, x);
  return place;
}

/// A level bar with pieces of half an element; `strength`: of its plate of 1 m.
mpm::Bar make_bar(const mpm::Body<2>& body, double head, double end, double y, double size, double strength) {
  mpm::Bar bar;
  bar.tension = {1e8, 0, 1e6, true};
  const double length = std::abs(end - head), sign = end > head ? 1 : -1;
  const int pieces = static_cast<int>(std::ceil(2 * length / size));
  for (int i = 0; i <= pieces; ++i) {
    mpm::BarNode& node = bar.nodes.emplace_back();
    node.place = length * i / pieces;
    node.soil = find_place(body, {head + sign * node.place, y}, {sign, 0});
    const double own = (i == 0 || i == pieces ? 0.5 : 1) * length / pieces;
    node.bond = {own * bond_strength / yield_slip, -own * bond_strength, own * bond_strength, false};
  }
  bar.pieces.assign(static_cast<std::size_t>(pieces), {.length = length / pieces});
  const int places = static_cast<int>(std::ceil(4 / size));
  for (int k = 0; k < places && strength > 0; ++k)
    bar.plate.places.push_back(find_place(body, {head, y - 0.5 + (k + 0.5) / places}, {sign, 0}));
  bar.plate.law = {strength / yield_slip, 0, strength, true};
  mpm::settle_bar(bar);
  return bar;
}

double find_largest(const mpm::Bar& bar) {
  double largest = 0;
  for (const mpm::BarPiece& piece : bar.pieces) largest = std::max(largest, piece.tension);
  return largest;
}

void expect_balance(const mpm::Body<2>& body, double scale) {
  Vec<2> sum{};
  for (const Vec<2>& f : body.nodes.load)
    for (std::size_t d = 0; d < 2; ++d) sum[d] += f[d];
  EXPECT_NEAR(norm(sum), 0, 1e-11 * scale) << "what the bar takes off one node it gives to another";
}

/// A block of 2 m at x = 5 m moves away from soil at x < 4 m, and a bar from its outer face resists. In a mirrored test
/// x counts from the right.
void pull_out(double size, double strength, bool is_mirrored) {
  SCOPED_TRACE("elements of " + std::to_string(size) + " m, plate of " + std::to_string(strength) + " N" +
               (is_mirrored ? ", mirrored" : ""));
  constexpr double width = 9, height = 3, start = 2;
  const int columns = static_cast<int>(std::lround(width / size)), rows = static_cast<int>(std::lround(height / size));
  const auto place = [&](double x) { return is_mirrored ? width - x : x; };
  const double sign = is_mirrored ? -1 : 1;
  mpm::Body<2> body = support::fill_body<2>(
      support::make_mesh<2>({columns, rows}, {width, height}, 0),
      {{material::LinearElastic::from_young(1e7, 0.3), 1800}}, 3,
      [&](const Vec<2>& x) { return place(x[0]) < 4 || (place(x[0]) > 5 && place(x[0]) < 7) ? 0 : -1; },
      [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
        p.velocity = {place(x[0]) > 5 ? sign * start : 0, 0};
      });
  for (int d = 0; d < 2; ++d) support::fix_nodes<2>(body, d, [&](const Vec<2>& x) { return place(x[0]) < 0.01; });
  body.bars = {make_bar(body, place(7), place(0.5), 1.5, size, strength)};
  mpm::StepOptions<2> o;
  mpm::gather_nodal_sums(body, o);
  o.dt = 0.5 * mpm::find_critical_step(body, 1.0).dt;
  const auto measure = [&](auto&& value) {
    double sum = 0, mass = 0;
    for (int id = 0; id < body.points.size(); ++id) {
      const auto p = mpm::view_point(body, id);
      if (place(body.points.reference[static_cast<std::size_t>(id)][0]) < 5) continue;
      sum += p.mass * value(p), mass += p.mass;
    }
    return std::pair{sum, mass};
  };
  double impulse = 0, worst = 0;
  const double far = std::max(0.6, 1.2 * size);
  for (double moved = 0; moved < far;) {
    mpm::step(body, o);
    const double force = find_largest(body.bars[0]);
    impulse += force * o.dt;
    const auto [sum, mass] = measure([&](const auto& p) { return sign * p.displacement[0]; });
    moved = sum / mass;
    if (moved > 5 * yield_slip) worst = std::max(worst, std::abs(force - (strength + bond_strength * (2 - moved))));
    ASSERT_LT(body.step_count, 20000);
  }
  // A node has the bond of half an element, and leaves it where the next point is its own size away.
  EXPECT_LT(worst, 0.6 * size * bond_strength);
  const auto [momentum, mass] = measure([&](const auto& p) { return sign * p.velocity[0]; });
  EXPECT_NEAR(momentum, mass * start - impulse, 0.01 * impulse) << "the bar alone slows the block";
  expect_balance(body, strength + 2 * bond_strength);
  EXPECT_NEAR(body.bars[0].nodes.front().soil.x[0], place(7), 0.02) << "the soil at rest holds the bar";
}

TEST(MpmBarsMoving, PullOutIsBondTimesLength) {
  for (const double size : {1.0 / 2, 1.0 / 3, 1.0 / 4})
    for (const bool is_mirrored : {false, true}) pull_out(size, 0, is_mirrored);
}
TEST(MpmBarsMoving, AddTheirPlateToThePullOut) {
  for (const double size : {1.0 / 2, 1.0 / 3, 1.0 / 4})
    for (const bool is_mirrored : {false, true}) pull_out(size, plate, is_mirrored);
}

/// Moves all soil with `velocity`, whatever its stress.
void carry(mpm::Body<2>& body, const std::function<Vec<2>(const Vec<2>&)>& velocity, double dt, int steps,
           bool moving) {
  mpm::StepOptions<2> o;
  o.dt = dt;
  o.moving = moving;
  for (int n = 0; n < steps; ++n) {
    for (int i = 0; i < body.mesh().node_count(); ++i) {
      const Vec<2> v = velocity(body.mesh().nodes[static_cast<std::size_t>(i)]);
      for (int k = 0; k < body.layout->count_motion_rows(i); ++k) {
        double* row =
            &body.nodes.motion[static_cast<std::size_t>(body.layout->motion_row(i, k)) * mpm::motion_stride<2>];
        row[0] = row[1] = 0, row[2] = v[0], row[3] = v[1];
      }
    }
    std::fill(body.nodes.sums.begin(), body.nodes.sums.end(), 0.0);
    const mpm::MoverLists movers = mpm::advance_points(mpm::Dry{}, body, o);
    mpm::relocate(body, o, movers);
    mpm::advance_bars(body, o);
    mpm::gather_loads(body);
  }
}

/// A block in the middle of a larger grid, with a bar through its right face.
mpm::Body<2> make_block() {
  mpm::Body<2> body = support::fill_body<2>(
      support::make_mesh<2>({28, 20}, {7, 5}, 0), {{material::LinearElastic::from_young(1e7, 0.3), 1800}}, 3,
      [](const Vec<2>& x) { return x[0] > 1 && x[0] < 4 && x[1] > 1 && x[1] < 3 ? 0 : -1; });
  mpm::gather_nodal_sums(body, mpm::StepOptions<2>{});
  body.bars = {make_bar(body, 4, 1.5, 2.1, 0.25, plate)};
  mpm::gather_loads(body);
  return body;
}

TEST(MpmBarsMoving, KeepTheirForceWhereAllSoilTranslates) {
  mpm::Body<2> body = make_block();
  mpm::Bar& bar = body.bars[0];
  carry(
      body,
      [](const Vec<2>& x) {
        return Vec<2>{2e-4 * (x[0] - 1), 0};
      },
      1, 2, false);
  const double held = bar.plate.force, largest = find_largest(bar);
  ASSERT_GT(held, 0.1 * plate);
  ASSERT_LT(held, plate) << "elastic, so that any slack shows";
  const mpm::Bar before = bar;
  constexpr int steps = 500;
  constexpr double dt = 1e-3;
  const Vec<2> velocity{2.5, -1.1};  // five elements to the right, two down
  carry(
      body, [&](const Vec<2>&) { return velocity; }, dt, steps, true);
  EXPECT_NEAR(bar.plate.force, held, 1e-9 * held);
  for (std::size_t j = 0; j < bar.pieces.size(); ++j)
    EXPECT_NEAR(bar.pieces[j].tension, before.pieces[j].tension, 1e-9 * largest) << j;
  for (std::size_t i = 0; i < bar.nodes.size(); ++i)
    for (std::size_t d = 0; d < 2; ++d)
      EXPECT_NEAR(bar.nodes[i].soil.x[d] - before.nodes[i].soil.x[d], steps * dt * velocity[d], 1e-11) << i;
  expect_balance(body, largest);
}

/// Ground that moves outwards by less than the distance of a point from its surface, and by more.
TEST(MpmBarsMoving, PressOnGroundThatMovesOutwards) {
  for (const double far : {0.002, 0.02, 0.2, 0.6}) {
    SCOPED_TRACE(far);
    mpm::Body<2> body = make_block();
    // The block slides out over the end of the bar, which rests in x < 2 m.
    const auto slide = [](const Vec<2>& x) { return Vec<2>{std::clamp((x[0] - 2) / 0.25, 0.0, 1.0), 0}; };
    body.bars[0].nodes.back().bond = {1e9, -1e9, 1e9, false};
    const int steps = static_cast<int>(std::ceil(far / 1e-3));
    carry(body, slide, far / steps, steps, true);
    EXPECT_NEAR(body.bars[0].plate.force, plate, 1e-6 * plate);
    expect_balance(body, 2 * plate);
  }
}

TEST(MpmBarsMoving, RotateWithTheGroundWithoutForce) {
  mpm::Body<2> body = make_block();
  mpm::Bar& bar = body.bars[0];
  const Vec<2> centre{2.5, 2}, head = bar.nodes.front().soil.x;
  constexpr int steps = 4000;
  constexpr double angle = 0.5;
  carry(
      body,
      [&](const Vec<2>& x) {
        return Vec<2>{-(x[1] - centre[1]), x[0] - centre[0]};
      },
      angle / steps, steps, true);
  EXPECT_LT(bar.plate.force, 0.02 * plate);
  EXPECT_LT(find_largest(bar), 0.02 * plate);
  const Vec<2> r{head[0] - centre[0], head[1] - centre[1]};
  EXPECT_NEAR(bar.nodes[0].soil.x[0], centre[0] + r[0] * std::cos(angle) - r[1] * std::sin(angle), 2e-3);
  EXPECT_NEAR(bar.nodes[0].soil.x[1], centre[1] + r[0] * std::sin(angle) + r[1] * std::cos(angle), 2e-3);
}

/// In the two-velocity formulation bars move with the grains.
TEST(MpmBarsMoving, FollowTheGrainsOfWetSoil) {
  mpm::Body<2> body = make_block();
  const auto rows = static_cast<std::size_t>(body.layout->rows);
  constexpr std::size_t sums = mpm::wet_sums_stride<2>, motion = mpm::wet_motion_stride<2>;
  body.water.laws.resize(1);
  body.water.sums.assign(rows * sums, 0.0);
  body.water.motion.assign(rows * motion, 0.0);
  for (std::size_t row = 0; row < rows; ++row) {
    body.water.sums[row * sums] = body.nodes.sums[row * mpm::sums_stride];  // mass
    body.water.motion[row * motion + 4] = 3;                                // velocity of the grains
  }
  mpm::gather_loads(body);
  mpm::StepOptions<2> o;
  o.dt = 1e-3;
  const mpm::Bar before = body.bars[0];
  mpm::advance_bars(body, o);
  for (std::size_t i = 0; i < before.nodes.size(); ++i)
    EXPECT_NEAR(body.bars[0].nodes[i].soil.x[0] - before.nodes[i].soil.x[0], 3e-3, 1e-12) << i;
}

/// A piece that yields and loses its head goes slack where it is: by millimetres, at which its parts yield.
TEST(MpmBarsMoving, GoSlackWhereTheyAre) {
  mpm::Body<2> body = make_block();
  mpm::Bar& bar = body.bars[0];
  bar.tension.upper = 0.5 * plate;
  carry(
      body,
      [](const Vec<2>& x) {
        return Vec<2>{4e-3 * (x[0] - 1), 0};
      },
      1, 2, false);
  ASSERT_EQ(bar.pieces[0].tension, bar.tension.upper);
  const double before = bar.nodes[0].all_slip;
  bar.plate.places.clear();
  bar.nodes[0].bond = {};
  mpm::gather_loads(body);
  carry(
      body, [](const Vec<2>&) { return Vec<2>{}; }, 1, 1, false);
  EXPECT_NEAR(bar.pieces[0].tension, 0, 1e-6 * plate);
  EXPECT_NEAR(bar.nodes[0].all_slip, before, 5 * yield_slip);
}

}  // namespace
}  // namespace talus
