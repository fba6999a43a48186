// SPDX-License-Identifier: MIT
// Bars across steep parts of a base: they bear where the motion of the mass lengthens them, so that the factor is
// continuous in the surface, grows with the bars, and is the same for a circle and the polyline along it.

#include <algorithm>
#include <random>

#include "support/lem_searches.hpp"

namespace talus::lem {
namespace {

Bar make_nail(const Point& head, double dip, double length, double force) {
  Bar bar;
  bar.name = "nail";
  bar.head = head;
  bar.end = {head[0] + length * std::cos(dip), head[1] - length * std::sin(dip)};
  bar.tensile = bar.plate = force;
  bar.bond = 1e6;
  return bar;
}

/// A block on a steep plane with one bar at any dip, as in LemSupports. The bar has its force where that raises the
/// factor, which is while θ + δ < 90° + φ_F; prestress is a load and stays.
TEST(LemSupportsMotion, ABlockOnASteepPlaneHasTheLargerOfTwoFactors) {
  const double c = 12, phi = 30 * degree, gamma = 20, height = 6, plane = 80 * degree, force = 20;
  const double weight = 0.5 * gamma * height * height / std::tan(plane), length = height / std::sin(plane);
  const Surface surface = make_polyline({{0, 0}, {height / std::tan(plane), height}});
  const double own = c * length + weight * std::cos(plane) * std::tan(phi), driving = weight * std::sin(plane);
  int slack = 0;
  for (double dip = 2; dip < 80; dip += 6) {
    const double along = force * std::cos(plane + dip * degree), across = force * std::sin(plane + dip * degree);
    const double active = (own + across * std::tan(phi)) / (driving - along);
    const double resisting = own + along;
    const double passive =
        (resisting + std::sqrt(resisting * resisting + 4 * driving * across * std::tan(phi))) / (2 * driving);
    const double bare = own / driving;
    slack += bare > active;
    for (const bool is_active : {false, true})
      for (const bool has_prestress : {false, true}) {
        Section section = make_section({{-10, 0}, {0, 0}, {0, height}, {30, height}}, make_soil(c, 30, gamma), -10);
        section.bars = {make_nail({0, 3}, dip * degree, 8, force)};
        section.bars[0].is_active = is_active;
        if (has_prestress) section.bars[0].prestress = force;
        const double with = is_active ? active : passive;
        const double expected = is_active && has_prestress ? with : std::max(with, bare);
        for (const Method method : {Method::janbu, Method::spencer, Method::corps_2, Method::fellenius})
          EXPECT_NEAR(find_factor(Slope(Section(section)), surface, method), expected, 1e-6 * expected)
              << to_word(method) << ", " << dip << "°";
      }
  }
  EXPECT_GT(slack, 3);
}

/// A cut of 76° with six rows of nails of 14 m.
Section make_nailed_cut(double length = 14, double cohesion = 10, double friction = 30) {
  Section section = make_section({{-20, 9}, {0, 9}, {2.25, 0}, {25, 0}}, make_soil(cohesion, friction, 20), -8);
  for (int row = 0; row < 6; ++row) {
    const double y = 8.25 - 1.5 * row;
    Bar& nail = section.bars.emplace_back();
    nail.name = "nail";
    nail.row = row + 1;
    nail.head = {0.25 * (9 - y), y};
    nail.end = {nail.head[0] - length * std::cos(15 * degree), y - length * std::sin(15 * degree)};
    nail.tensile = 200 / 1.5, nail.plate = 100 / 1.5, nail.bond = 30 / 1.5;
  }
  return section;
}

/// The mass moves as one over an upper leg of 74° or 76°, so that the nails across it bear in both.
TEST(LemSupportsMotion, TwoDegreesOfTheUpperLegChangeLittle) {
  const Slope slope(make_nailed_cut());
  double last = 0;
  for (double x = -4.6; x < -3.5; x += 0.02) {
    const double factor = find_factor(slope, make_polyline({{x, 9}, {-3, 5}, {2.25, 0}}), Method::janbu_corrected);
    if (last > 0) {
      EXPECT_NEAR(factor, last, 0.006 * last) << x;
    }
    last = factor;
  }
  const double flat = find_factor(slope, make_polyline({{-4.147, 9}, {-3, 5}, {2.25, 0}}), Method::janbu_corrected);
  const double steep = find_factor(slope, make_polyline({{-3.997, 9}, {-3, 5}, {2.25, 0}}), Method::janbu_corrected);
  EXPECT_NEAR(steep, flat, 0.03 * flat);
}

/// A surface that crosses a prestressed anchor at a right angle, as a search found it. By Janbu it has 1.231 with the
/// force of 50 kN/m on its upper leg, and 0.955 without it.
TEST(LemSupportsMotion, AMillimetreDoesNotRemoveAnAnchor) {
  Section section = make_section({{0, 10}, {11, 10}, {15, 4}, {26, 4}}, make_soil(6, 28, 19), 0);
  Bar& anchor = section.bars.emplace_back();
  anchor.head = {12.5, 7.75};
  anchor.end = {12.5 - 12 * std::cos(15 * degree), 7.75 - 12 * std::sin(15 * degree)};
  anchor.tensile = 50, anchor.plate = 225, anchor.bond = 50, anchor.prestress = 50, anchor.free_length = 7;
  anchor.is_active = true;
  const Slope slope(section);
  const auto solve_moved = [&](double x, double y) {
    return find_factor(slope,
                       make_polyline({{9.781085040759825 + x, 10.0},
                                      {10.507107532043449, 7.2158061023958435 + y},
                                      {11.422631095668313, 6.164451830215189},
                                      {12.173665290110945, 5.443885698223749},
                                      {12.918967861209687, 4.861514473655841},
                                      {13.761416171602034, 4.357303547145126},
                                      {14.346883336465831, 4.113002252483624},
                                      {14.761145824076612, 4.01517063221381},
                                      {14.99999752346372, 4.000003714804419}}),
                       Method::janbu, 50);
  };
  const double factor = solve_moved(0, 0);
  EXPECT_NEAR(factor, 1.231, 0.005);
  for (const double moved : {-1e-3, 1e-3}) {
    EXPECT_NEAR(solve_moved(moved, 0), factor, 0.001);
    // The corner of the surface lies on the anchor, and its force on the upper or on the lower leg.
    EXPECT_NEAR(solve_moved(0, moved), factor, 0.002);
  }
}

/// Surfaces through the toe of the cut, with steep upper ends.
std::vector<Surface> draw_surfaces(const Slope& slope) {
  std::mt19937 random(7);
  const auto draw = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() % 10000) / 10000;
  };
  std::vector<Surface> surfaces;
  for (int i = 0; i < 30; ++i) {
    const double x = draw(-9, -1.5);
    surfaces.push_back(hang_polyline(slope, x, 2.25, {{x + draw(0, 1.5), draw(4, 8)}, {x + draw(1, 3), draw(2, 5)}}));
    const double radius = draw(9, 14), rise = std::asin(9 / (2 * radius));
    const Circle circle{{2.25 + radius * std::sin(rise - draw(0.4, 0.9)), radius}, radius};
    for (const auto& [from, to] : find_arcs(slope, circle))
      if (to - from > 1) surfaces.push_back(make_arc(circle.centre, circle.radius, from, to));
  }
  return surfaces;
}

/// A prestress acts alone only where the bar would be slack: the factor has no jump at 0, falls there with the
/// prestress and is elsewhere the same.
TEST(LemSupportsMotion, TheFactorIsContinuousInThePrestress) {
  int slack = 0, compared = 0;
  const Slope bare(make_nailed_cut(0.1));
  const std::vector<Surface> surfaces = draw_surfaces(bare);
  for (const Surface& surface : surfaces) {
    const auto find = [&](double prestress) {
      Section section = make_nailed_cut(12);
      for (Bar& bar : section.bars) bar.is_active = true, bar.prestress = prestress;
      return find_factor(Slope(std::move(section)), surface, Method::janbu);
    };
    const double without = find(0), small = find(1e-6), half = find(20), full = find(200);
    if (!(without > 0)) continue;
    EXPECT_NEAR(small, without, 1e-6 * without);
    EXPECT_LE(half, without * (1 + 1e-9));
    EXPECT_LE(full, half * (1 + 1e-9));
    ++compared;
    slack += full < without * (1 - 1e-6);
  }
  EXPECT_GT(compared, 40);
  EXPECT_GT(slack, 2);
  EXPECT_LT(slack, compared);
}

/// Vertical piles through the cut, with forces in a direction.
Section make_piled_cut(BarDirection direction, bool is_active, double friction) {
  Section section = make_nailed_cut(0.1, friction > 0 ? 10 : 40, friction);
  for (const double x : {-6.0, -3.0, -1.0, 1.5}) {
    Bar& pile = section.bars.emplace_back();
    pile.head = {x, x < 0 ? 9 : 9 - 4 * x}, pile.end = {x + 0.5, -6};
    pile.hold = BarHold::across, pile.direction = direction, pile.lateral = 60, pile.is_active = is_active;
  }
  return section;
}

/// A force along a pile presses the mass on its base, where the base is steep down the slope too.
TEST(LemSupportsMotion, AxialPilesNeverLowerAFactor) {
  int compared = 0, slack = 0;
  for (const double friction : {0.0, 35.0}) {
    const Slope bare(make_nailed_cut(0.1, friction > 0 ? 10 : 40, friction));
    for (const BarDirection direction : {BarDirection::axial, BarDirection::bisector})
      for (const bool is_active : {false, true}) {
        const Slope piled(make_piled_cut(direction, is_active, friction));
        for (const Surface& surface : draw_surfaces(bare))
          for (const Method method : {Method::fellenius, Method::bishop, Method::janbu, Method::corps_1,
                                      Method::lowe_karafiath, Method::spencer, Method::morgenstern_price}) {
            if (!surface.circle && method == Method::bishop) continue;
            CutSurface plain = cut_surface(bare, surface, 30, report_only()),
                       cut = cut_surface(piled, surface, 30, report_only());
            const double without = solve(bare, plain, method, report_only(), false).factor,
                         factor = solve(piled, cut, method, report_only(), false).factor;
            if (!(without > 0) || !(factor > 0)) continue;
            EXPECT_GE(factor, without * (1 - 1e-8)) << to_word(method) << (is_active ? ", active" : ", passive");
            ++compared;
            slack += std::any_of(cut.pulls.begin(), cut.pulls.end(), [](const BarPull& pull) { return pull.is_slack; });
          }
      }
  }
  EXPECT_GT(compared, 2000);
  EXPECT_GT(slack, 200);
}

TEST(LemSupportsMotion, LongerNailsNeverLowerAFactor) {
  int compared = 0, slack = 0;
  for (const double friction : {0.0, 15.0, 35.0}) {
    const double cohesion = friction > 0 ? 10 : 40;
    const Slope bare(make_nailed_cut(0.1, cohesion, friction));
    const std::vector<Surface> surfaces = draw_surfaces(bare);
    std::vector<double> janbu(surfaces.size(), 0.0), bishop(surfaces.size(), 0.0);
    for (double length = 1; length <= 15; length += 1) {
      const Slope slope(make_nailed_cut(length, cohesion, friction));
      for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (auto* last : {&janbu, &bishop}) {
          if (last == &bishop && !surfaces[i].circle) continue;
          CutSurface cut = cut_surface(slope, surfaces[i], 50, report_only());
          const double factor =
              solve(slope, cut, last == &janbu ? Method::janbu : Method::bishop, report_only(), false).factor;
          if (!(factor > 0)) continue;
          EXPECT_GE(factor, (*last)[i] * (1 - 1e-8)) << "surface " << i << ", " << length << " m, φ = " << friction;
          (*last)[i] = factor;
          ++compared;
          slack += std::any_of(cut.pulls.begin(), cut.pulls.end(), [](const BarPull& pull) { return pull.is_slack; });
        }
    }
  }
  EXPECT_GT(compared, 2000);
  EXPECT_GT(slack, 20);
}

TEST(LemSupportsMotion, ACircleAndThePolylineAlongItAgree) {
  const Slope slope(make_nailed_cut());
  int compared = 0;
  for (const Surface& circle : draw_surfaces(slope)) {
    if (!circle.circle) continue;
    const CutSurface cut = cut_surface(slope, circle, 60, report_only());
    if (cut.refusal != Refusal::none) continue;
    std::vector<Point> line{cut.slices.front().base_left};
    for (const Slice& slice : cut.slices) line.push_back(slice.base_right);
    const double factor = find_factor(slope, circle, Method::janbu, 60);
    if (!(factor > 0)) continue;
    EXPECT_NEAR(find_factor(slope, make_polyline(line), Method::janbu, 60), factor, 1e-6 * factor);
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST(LemSupportsMotion, TheMirrorImageIsTheSame) {
  const Section section = make_nailed_cut(10, 10, 20);
  Section turned = mirror(section);
  for (Bar& bar : turned.bars) bar.head[0] = -bar.head[0], bar.end[0] = -bar.end[0];
  for (const BarDirection direction :
       {BarDirection::axial, BarDirection::tangent, BarDirection::bisector, BarDirection::normal}) {
    Section here = section, there = turned;
    for (Section* one : {&here, &there})
      for (Bar& bar : one->bars) bar.direction = direction;
    const Slope slope(here), other(there);
    for (const Surface& surface : draw_surfaces(slope)) {
      Surface image = surface;
      if (image.circle) {
        image.circle->centre[0] = -image.circle->centre[0];
        image.from = -surface.to, image.to = -surface.from;
      }
      for (Point& p : image.line) p[0] = -p[0];
      std::reverse(image.line.begin(), image.line.end());
      const double factor = find_factor(slope, surface, Method::janbu, 40);
      EXPECT_NEAR(find_factor(other, image, Method::janbu, 40), factor, 1e-8 * factor);
    }
  }
}

/// A force across a nearly vertical bar has a sign, which must not jump where the base is parallel to the bar.
TEST(LemSupportsMotion, AForceAcrossABarIsContinuousInTheSurface) {
  Section section = make_section({{-20, 9}, {0, 9}, {2.25, 0}, {25, 0}}, make_soil(10, 30, 20), -8);
  Bar& pile = section.bars.emplace_back();
  pile.head = {-1.2, 9}, pile.end = {-4.2, 0.2};
  pile.hold = BarHold::across, pile.direction = BarDirection::normal, pile.lateral = 40;
  const Slope slope(section);
  double last = 0;
  for (double x = -4.5; x < -3.2; x += 0.01) {
    const double factor = find_factor(slope, make_polyline({{x, 9}, {-3, 2}, {2.25, 0}}), Method::janbu);
    if (last > 0) {
      EXPECT_NEAR(factor, last, 0.015 * last) << x;
    }
    last = factor;
  }
}

}  // namespace
}  // namespace talus::lem
