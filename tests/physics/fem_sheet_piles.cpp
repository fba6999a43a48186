// SPDX-License-Identifier: MIT
// [support.NAME] with kind = "wall" in FEM and LEM: a published plate (Torggler 2016), a cantilever sheet pile beside
// its limit equilibrium on two meshes, a strut, and surfaces that do not cross the wall.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/extrapolate.hpp"
#include "lem/search/search.hpp"
#include "run/common/bars_of_case.hpp"
#include "run/common/section_of_case.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/lem/run_lem.hpp"
#include "support/supported_slope.hpp"

namespace talus {
namespace {

constexpr double pi = 3.14159265358979323846;

using support::read_site, support::reduce, support::Reduced, support::write_sheet;

std::string write_plate() {
  return support::write_torggler_slope(
      "kind = \"wall\"\nline = [[28.66, 25], [28.66, 17.5]]\ninterface_strength = 1\n");
}

TEST(SheetPiles, PlateOfTorgglerHasItsPublishedFactor) {
  const site::Site site = read_site(write_plate());
  const double coarse = reduce(site, 2, 1.05, 1.25).found.factor;
  const Reduced fine = reduce(site, 1, 1.05, 1.25);
  EXPECT_NEAR(extrapolate_to_zero(2, coarse, 1, fine.found.factor), 1.175, 0.02 * 1.175)
      << coarse << " " << fine.found.factor;
  const auto results = run::make_bar_results(site, fine.solid.model, fine.found);
  ASSERT_EQ(results.size(), 1u);
  const results::ElementBar& plate = results[0];
  EXPECT_EQ(plate.kind, "wall");
  ASSERT_TRUE(plate.moments && plate.shears && plate.left && plate.right && plate.line && plate.sliding);
  EXPECT_EQ(plate.moments->size(), plate.place.size());
  EXPECT_GT(plate.moment, 1e3);
  EXPECT_GT(*plate.sliding, 0.05);
  EXPECT_EQ(plate.limit, results::ElementBarLimit::none);
}

/// Factor of a smooth cantilever wall: Rankine's pressures of the reduced strength, which change sides at the point
/// about which the wall turns; force and moment are in balance. Units kN and m.
double find_cantilever_factor(double free, double embedded, double friction, double cohesion) {
  constexpr double weight = 20;
  const auto is_stable = [&](double factor) {
    const double phi = std::atan(std::tan(friction) / factor), root = std::tan(pi / 4 + phi / 2),
                 c = 2 * cohesion / factor;
    const auto push = [&](double depth) { return std::max(0.0, weight * depth / (root * root) - c / root); };
    const auto resist = [&](double depth) { return depth > 0 ? weight * depth * root * root + c * root : 0; };
    const auto balance = [&](double turn) {  // force and moment about the toe
      std::array<double, 2> sum{};
      constexpr int parts = 2000;
      const double step = (free + embedded) / parts;
      for (int i = 0; i < parts; ++i) {
        const double depth = (i + 0.5) * step, below = depth - free;
        const double p = below < turn ? push(depth) - resist(below) : resist(depth) - push(below);
        sum[0] += p * step, sum[1] += p * step * (free + embedded - depth);
      }
      return sum;
    };
    double low = 0, high = embedded;
    for (int i = 0; i < 40; ++i) (balance(0.5 * (low + high))[0] > 0 ? low : high) = 0.5 * (low + high);
    return balance(low)[1] < 0;
  };
  double low = 0.5, high = 3;
  for (int i = 0; i < 25; ++i) (is_stable(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return low;
}

TEST(SheetPiles, CantileverHasTheFactorOfItsLimitEquilibrium) {
  EXPECT_NEAR(find_cantilever_factor(3, 3, 35 * pi / 180, 0), 1.230, 2e-3);
  const double expected = find_cantilever_factor(3, 3, 35 * pi / 180, 0.2);
  const site::Site site = read_site(write_sheet(6));
  const double coarse = reduce(site, 2, 1.1, 1.4).found.factor;
  const Reduced fine = reduce(site, 1, 1.1, 1.4);
  const double factor = extrapolate_to_zero(2, coarse, 1, fine.found.factor);
  EXPECT_NEAR(factor, expected, 0.05 * expected) << coarse << " " << fine.found.factor;
  const auto wall = run::make_bar_results(site, fine.solid.model, fine.found).at(0);
  // At the bottom of the cut: M = γ K_a H³/6 and V = γ K_a H²/2 of the reduced strength.
  const double phi = std::atan(std::tan(35 * pi / 180) / fine.found.failed),
               active = std::pow(std::tan(pi / 4 - phi / 2), 2);
  double shear = 0;
  for (std::size_t i = 0; i < wall.place.size(); ++i)
    if (wall.place[i] < 3) shear = std::abs((*wall.shears)[i]);
  EXPECT_NEAR(shear, 20e3 * active * 4.5, 0.1 * 20e3 * active * 4.5);
}

TEST(SheetPiles, HingeLowersTheFactor) {
  const site::Site site = read_site(write_sheet(8, "plastic_moment = 40"));
  const Reduced found = reduce(site, 2, 1, 1.4);
  const auto wall = run::make_bar_results(site, found.solid.model, found.found).at(0);
  EXPECT_EQ(wall.limit, results::ElementBarLimit::bending);
  EXPECT_NEAR(*wall.bending, 1, 0.02);
  EXPECT_LT(found.found.factor, reduce(read_site(write_sheet(8)), 2, 1, 1.8).found.factor - 0.1);
}

TEST(SheetPiles, StrutRaisesTheFactor) {
  const site::Site site =
      read_site(write_sheet(5, "strut_levels = [2.5]\nstrut_stiffness = 2e4\nstrut_strength = 200"));
  const Reduced found = reduce(site, 2, 1, 2);
  EXPECT_GT(found.found.factor, reduce(read_site(write_sheet(5)), 2, 0.8, 1.4).found.factor + 0.1);
  const auto wall = run::make_bar_results(site, found.solid.model, found.found).at(0);
  ASSERT_TRUE(wall.struts);
  EXPECT_GT(wall.struts->at(0), 1e3);
}

/// Factor of a smooth wall with an anchor or strut at a depth, by moments about it of Rankine's pressures of the
/// reduced strength (free earth support). Units kN and m.
double find_anchored_factor(double free, double embedded, double level, double friction, double cohesion) {
  constexpr double weight = 20;
  const auto is_stable = [&](double factor) {
    const double phi = std::atan(std::tan(friction) / factor), root = std::tan(pi / 4 + phi / 2),
                 c = 2 * cohesion / factor;
    double moment = 0;
    constexpr int parts = 4000;
    const double step = (free + embedded) / parts;
    for (int i = 0; i < parts; ++i) {
      const double depth = (i + 0.5) * step, below = depth - free;
      double p = std::max(0.0, weight * depth / (root * root) - c / root);
      if (below > 0) p -= weight * below * root * root + c * root;
      moment += p * (depth - level) * step;
    }
    return moment < 0;
  };
  double low = 0.3, high = 4;
  for (int i = 0; i < 30; ++i) (is_stable(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return low;
}

/// An anchor at a depth of 1 m of the wall, horizontal, with a bond that does not fail.
const char* const tie = R"([support.tie]
kind = "anchor"
heads = [[12, 2]]
inclination = 0
length = 11
bond_length = 4
out_of_plane_spacing = 2
tensile_strength = 1000
plate = 900
bond = 800
axial_stiffness = 1e5
)";

TEST(SheetPiles, AnchoredWallIsNoWeakerThanFreeEarthSupport) {
  const double expected = find_anchored_factor(3, 1.5, 1, 35 * pi / 180, 0.2);
  const site::Site site = read_site(write_sheet(4.5, tie));
  const double coarse = reduce(site, 2, 0.8, 2).found.factor;
  const Reduced fine = reduce(site, 1, 0.8, 2);
  const double factor = extrapolate_to_zero(2, coarse, 1, fine.found.factor);
  // Rankine's pressures are in equilibrium and within the strength, so that FEM may not lie below. It lies above: the
  // soil arches between anchor and embedment, and 1.5 m of embedment have few elements (2.50, 2.25 and 2.03 on 1, 0.5
  // and 0.25 m, against 1.53; the interval of the first two is 1.53 to 2.25).
  EXPECT_GT(factor, expected) << coarse << " " << fine.found.factor;
  EXPECT_LT(fine.found.factor, coarse);
  const auto results = run::make_bar_results(site, fine.solid.model, fine.found);
  ASSERT_EQ(results.size(), 2u);
  const results::ElementBar& anchor = results[0];
  ASSERT_TRUE(anchor.on_wall);
  EXPECT_EQ(*anchor.on_wall, "sheet");
  EXPECT_FALSE(results[1].on_wall);
  EXPECT_GT(anchor.plate, 10e3);
  EXPECT_LT(reduce(read_site(write_sheet(4.5)), 2, 0.5, 1.4).found.factor, factor - 0.1) << "without the anchor";
}

TEST(SheetPiles, WeightIsALoadInLimitEquilibriumAndFem) {
  const site::Site site = read_site(write_sheet(6, "weight = 8\n[earthquake]\nhorizontal = 0.1\n"));
  const auto walls = run::make_walls(site, *run::make_solid<2>(site, 2).mesh);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_NEAR(walls[0].line_load[1], -8e3, 1e-6);
  EXPECT_NEAR(std::abs(walls[0].line_load[0]), 0.8e3, 1e-6) << "inertia of the wall";
  const lem::Section section = run::make_section(site).section;
  ASSERT_EQ(section.surcharges.size(), 1u);
  const auto& load = section.surcharges[0].load;
  EXPECT_NEAR((load[1][0] - load[0][0]) * load[0][1], 8e3 * 6, 1e-6);
  EXPECT_TRUE(run::make_section(read_site(write_sheet(6))).section.surcharges.empty());
}

TEST(SheetPiles, InterfaceIsAFractionOfTheSoilBesideIt) {
  const auto find = [](const std::string& soil, const Vec<2>& place) {
    std::string text = write_sheet(6, "interface_strength = 0.6\n");
    text.replace(text.find("bond_friction = 0\n"), 18, "");
    const auto from = text.find("model ="), to = text.find("unit_weight");
    text.replace(from, to - from, soil);
    const auto cohesion = text.find("cohesion = 0.2"), young = text.find("young_modulus");
    if (soil.find("tresca") != std::string::npos) text.replace(cohesion, young - cohesion, "");
    const site::Site site = read_site(text);
    return run::make_walls(site, *run::make_solid<2>(site, 2).mesh)[0].interface(0, place);
  };
  const std::string clay = "model = \"tresca\"\nundrained_strength = 20\n";
  EXPECT_NEAR(find(clay, {12, 2}).adhesion, 12e3, 1e-6);
  EXPECT_EQ(find(clay, {12, 2}).friction, 0);
  const std::string deeper = "undrained_gradient = 3\nundrained_level = 1\n";
  EXPECT_NEAR(find(clay + deeper, {12, -2}).adhesion, 0.6 * 29e3, 1e-6);
  EXPECT_NEAR(find("model = \"mohr_coulomb\"\n", {12, 2}).adhesion, 120, 1e-6);
  EXPECT_NEAR(find("model = \"mohr_coulomb\"\n", {12, 2}).friction, 0.6 * std::tan(35 * pi / 180), 1e-9);
}

TEST(SheetPiles, LimitEquilibriumSearchesBelowTheToe) {
  const auto search = [](const std::string& text) {
    const site::Site site = read_site(text);
    return lem::search(lem::Slope(run::make_section(site).section), run::make_search_options(site.data(), 2));
  };
  const auto excluded = search(write_sheet(6));
  const auto& surface = excluded.circular.at(0).surface;
  ASSERT_TRUE(surface.circle);
  EXPECT_LT(surface.from, 12);
  EXPECT_GT(surface.to, 12);
  const auto& circle = *surface.circle;
  EXPECT_LE(circle.centre[1] - std::sqrt(circle.radius * circle.radius - std::pow(12 - circle.centre[0], 2)),
            -3 + 1e-3);
  const auto resisted = search(write_sheet(6, "crossing = \"resisted\"\nshear_strength = 20"));
  EXPECT_LT(resisted.circular.at(0).solution.factor, excluded.circular.at(0).solution.factor);
}

TEST(SheetPiles, InterfaceOfASoilWithoutCohesionAndAngleIsRefused) {
  std::string text = write_plate();
  text.replace(text.find("mohr_coulomb"), 12, "hoek_brown");
  const auto from = text.find("cohesion"), to = text.find("young_modulus");
  text.replace(from, to - from, "intact_strength = 30\ngsi = 40\nintact_constant = 10\ndilatancy_ratio = 0\n");
  try {
    run::make_solid<2>(read_site(text), 2);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("bond_adhesion"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace talus
