// SPDX-License-Identifier: MIT
// [support.NAME] in FEM: a nailed wedge with its closed form, a nailed cut on two meshes beside LEM, a published plate
// (Torggler 2016), and the limits that results name.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/extrapolate.hpp"
#include "lem/search/search.hpp"
#include "material/every_law.hpp"
#include "run/common/bars_of_case.hpp"
#include "run/common/section_of_case.hpp"
#include "run/fem/solid_of_case.hpp"
#include "support/supported_slope.hpp"

namespace talus {
namespace {

constexpr double degree = 0.017453292519943295;

/// A cut of 8 m at 60° with five rows of nails that break at 30 kN each, on a spacing of 1.5 m.
std::string write_cut(const std::string& sense, double plate = 0) {
  return fmt::format(R"(
title = "Nailed cut"
[geometry]
ground = [[0, 13], [13.3812, 13], [18, 5], [30, 5]]
[[geometry.layer]]
name = "silt"
level = 0
[regions]
silt = "silt"
[materials.silt]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 8
friction_angle = 30
dilatancy_angle = 30
tensile_strength = 0
young_modulus = 30
poisson_ratio = 0.3
[support.nails]
kind = "nail"
first = [13.8431, 12.2]
rows = 5
row_spacing = 1.5
inclination = 15
length = 7
out_of_plane_spacing = 1.5
tensile_strength = 30
plate = {}
bond = 20
axial_stiffness = 1e5
{}
[analysis]
methods = ["fem", "lem"]
[lem]
methods = ["bishop"]
[fem]
size = 0.6
)",
                     plate, sense);
}

using support::read_site, support::reduce, support::Reduced;

/// Strength reduction without tension cut-off, as LEM takes the soil of the cut.
Reduced reduce_cone(const site::Site& site, double share, double from, double to) {
  run::SolidOfCase<2> solid = run::make_solid<2>(site, share);
  solid.model.make_law = [](int, double factor) -> material::Law {
    const material::MohrCoulombStrength strength{8e3, 30 * degree, 30 * degree, 8e3 / std::tan(30 * degree)};
    return material::MohrCoulomb(material::LinearElastic::from_young(3e7, 0.3), strength.reduced(factor));
  };
  return reduce(std::move(solid), from, to);
}

double search_lem(const site::Site& site) {
  lem::SearchOptions options;
  options.methods = {lem::Method::bishop};
  options.threads = 2;
  return lem::search(lem::Slope(run::make_section(site).section), options).circular.at(0).solution.factor;
}

TEST(ElementSupports, NailedCutHasTheFactorOfLimitEquilibrium) {
  const site::Site site = read_site(write_cut("sense = \"active\""));
  const Reduced coarse = reduce_cone(site, 2, 1.3, 1.5), fine = reduce_cone(site, 1, 1.3, 1.5);
  EXPECT_LT(fine.found.factor, coarse.found.factor);
  const double factor = extrapolate_to_zero(2, coarse.found.factor, 1, fine.found.factor), lem = search_lem(site);
  EXPECT_NEAR(factor, lem, 0.05 * lem) << coarse.found.factor << " " << fine.found.factor;
  EXPECT_GT(factor, 1.2) << "without nails it is below 1";
  for (const auto& bar : run::make_bar_results(site, fine.solid.model, fine.found)) {
    EXPECT_NEAR(bar.largest, 20e3, 1) << bar.row;
    EXPECT_EQ(bar.limit, results::ElementBarLimit::tension) << bar.row;
    EXPECT_EQ(bar.support, "nails");
    EXPECT_FALSE(bar.bending.has_value());
    ASSERT_EQ(bar.place.size(), bar.force.size());
    ASSERT_EQ(bar.place.size(), bar.at_start.size());
  }
}

TEST(ElementSupports, FacingAndBondOfTheCase) {
  const site::Site site = read_site(write_cut("", 45));
  const auto bars = run::make_bars(site);
  ASSERT_EQ(bars.size(), 5u);
  EXPECT_NEAR(bars[2].bond({10, 8}), 20e3 / 1.5, 1e-6);
  EXPECT_NEAR(bars[2].plate, 30e3, 1e-6);
  EXPECT_NEAR(bars[2].axial_stiffness, 1e8 / 1.5, 1);
  EXPECT_FALSE(bars[2].reduces_bond);
  EXPECT_TRUE(run::make_bars(read_site(write_cut("sense = \"passive\"")))[0].reduces_bond);
  // The facing under a head is 1 m wide, as no head is nearer.
  ASSERT_EQ(bars[2].plate_line.size(), 2u);
  EXPECT_NEAR(std::hypot(bars[2].plate_line[1][0] - bars[2].plate_line[0][0],
                         bars[2].plate_line[1][1] - bars[2].plate_line[0][1]),
              1, 1e-6);
  const double middle = 0.5 * (bars[2].plate_line[0][1] + bars[2].plate_line[1][1]);
  EXPECT_NEAR(middle, bars[2].head[1], 1e-3);
}

TEST(ElementSupports, LimitsOfABar) {
  fem::BarForces forces;
  forces.axial = {{0.5, 1.5, 2.5}, {10, 20, 8}, {50, 50, 50}};
  forces.bond = {{0, 1, 2, 3}, {-10, -10, 12, 12}, {12, 12, 12, 12}};
  auto result = run::make_bar_result(forces, forces);
  EXPECT_EQ(result.largest, 20);
  EXPECT_NEAR(*result.tension, 0.4, 1e-12);
  EXPECT_NEAR(*result.pull_out, 1, 1e-12);
  EXPECT_NEAR(*result.stripping, 10.0 / 12, 1e-12);
  EXPECT_EQ(result.limit, results::ElementBarLimit::pull_out);
  forces.bond.value = {-12, -12, 6, 6};
  EXPECT_EQ(run::make_bar_result(forces, forces).limit, results::ElementBarLimit::stripping);
  forces.plate_limit = 100;
  EXPECT_EQ(run::make_bar_result(forces, forces).limit, results::ElementBarLimit::none);
  forces.axial.value[1] = 50;
  EXPECT_EQ(run::make_bar_result(forces, forces).limit, results::ElementBarLimit::tension);
  forces.moment = {{1}, {-30}, {30}};
  result = run::make_bar_result(forces, forces);
  EXPECT_EQ(result.moment, 30);
  EXPECT_EQ(result.limit, results::ElementBarLimit::bending);
}

/// A wedge of strong soil on a weak band of the thickness `band` along a plane of 45° through (12, 2), under a face of
/// 75°, with two nails that break at 30 kN/m. The band has no weight, so that every plane in it carries the same wedge.
std::string write_wedge(double band) {
  const double steep = std::tan(75 * degree), crest = 12 - 6 / steep, lower = band * std::sqrt(2.0);
  const auto find_face = [&](double y) { return 12 - (y - 2) / steep; };
  const double y = (2 - lower - 2 / steep) / (1 - 1 / steep), x = find_face(y), foot = find_face(0);
  return fmt::format(R"(
title = "Nailed wedge"
[geometry]
[[geometry.polygon]]
name = "wedge"
points = [[12, 2], [{0}, 8], [6, 8]]
[[geometry.polygon]]
name = "band"
points = [[12, 2], [6, 8], [{1}, 8], [{2}, {3}]]
[[geometry.polygon]]
name = "base"
points = [[0, -1], [16, -1], [16, 0], [{4}, 0], [{2}, {3}], [{1}, 8], [0, 8]]
[regions]
wedge = "strong"
band = "joint"
base = "strong"
[materials.strong]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 300
friction_angle = 25
dilatancy_angle = 25
tensile_strength = 600
young_modulus = 1e5
poisson_ratio = 0.3
[materials.joint]
model = "mohr_coulomb"
unit_weight = 0.01
cohesion = 8
friction_angle = 25
dilatancy_angle = 25
tensile_strength = 17
young_modulus = 2e4
poisson_ratio = 0.3
[support.nails]
kind = "nail"
heads = [[{5}, 4], [{6}, 6]]
inclination = 0
length = 9
out_of_plane_spacing = 1
tensile_strength = 30
plate = inf
bond = 1000
sense = "active"
axial_stiffness = 1e5
[analysis]
methods = ["fem"]
[fem]
size = 0.8
)",
                     crest, 6 - lower, x, y, foot, find_face(4), find_face(6));
}

TEST(ElementSupports, NailedWedgeHasItsClosedForm) {
  // F = (c l + (W cos θ + T sin θ) tan φ) / (W sin θ - T cos θ). Elements shear over the whole band instead of on its
  // upper side, the shortest plane: the error falls with its thickness. Extrapolation triples that of the search and
  // leaves that of one mesh.
  const double base = 6 - 6 / std::tan(75 * degree), weight = 20 * 0.5 * base * 6, pull = 60,
               length = 6 * std::sqrt(2.0), cosine = std::sqrt(0.5);
  const double expected = (8 * length + (weight + pull) * cosine * std::tan(25 * degree)) / ((weight - pull) * cosine);
  const auto search = [&](double band) {
    const site::Site site = read_site(write_wedge(band));
    const run::SolidOfCase<2> solid = run::make_solid<2>(site, 1);
    fem::ReductionOptions options;
    options.from = 1.1, options.to = 1.3, options.resolution = 5e-4;
    const fem::ReductionResult<2> found = fem::reduce_strength<2>(solid.model, options);
    for (const auto& bar : run::make_bar_results(site, solid.model, found)) {
      EXPECT_NEAR(bar.largest, 30e3, 1) << bar.row;
      EXPECT_EQ(bar.limit, results::ElementBarLimit::tension);
    }
    return found.factor;
  };
  const double thick = search(0.3), thin = search(0.15);
  EXPECT_NEAR(thick, expected, 0.008 * expected);
  EXPECT_NEAR(thin, expected, 0.004 * expected);
  EXPECT_NEAR(2 * thin - thick, expected, 0.003 * expected) << thick << " " << thin;
}

/// A nailed cut, or one with a wall, with layers and a water table. `way`: x of a place that is drawn at x.
std::string write_drawn(bool has_wall, const std::function<double(double)>& way) {
  const auto place = [&](double x, double y) { return fmt::format("[{}, {}]", way(x), y); };
  const auto list = [&](std::vector<std::string> places) {
    if (way(1) < way(0)) std::reverse(places.begin(), places.end());
    return fmt::format("[{}]", fmt::join(places, ", "));
  };
  const std::string nails = fmt::format(R"(
[support.nails]
kind = "nail"
heads = [{}, {}]
ends = [{}, {}]
out_of_plane_spacing = 1.5
tensile_strength = 150
plate = 70
bond = 25
axial_stiffness = 4e4
)",
                                        place(18.906666667, 10.2), place(17.806666667, 7.2),
                                        place(24.775552271, 8.952529855), place(23.675552271, 5.952529855)),
                    wall = fmt::format(R"(
[support.sheet]
kind = "wall"
line = [{}, {}]
interface_strength = 0.67
axial_stiffness = 2e6
bending_stiffness = 5e4
)",
                                       place(17, 5), place(17, 2));
  const auto lower = list({place(0, 0), place(40, 0), place(40, 5), place(17, 5), place(0, 5)}),
             upper = list({place(17, 5), place(40, 5), place(40, 11), place(19.2, 11)}),
             table = list({place(0, 3.2), place(15, 4.2), place(40, 6.4)});
  const auto soil = [](const char* name, double cohesion, double angle) {
    return fmt::format(
        "[materials.{}]\nmodel = \"mohr_coulomb\"\nunit_weight = 19\ncohesion = {}\nfriction_angle = {}\n"
        "dilatancy_angle = {}\ntensile_strength = 5\nyoung_modulus = 50\npoisson_ratio = 0.3\n",
        name, cohesion, angle, angle);
  };
  return fmt::format(R"(
title = "Cut"
[[geometry.polygon]]
name = "lower"
points = {}
[[geometry.polygon]]
name = "upper"
points = {}
[regions]
lower = "till"
upper = "silt"
{}{}[initial]
pore_pressure = "water_table"
water_table = {}
[analysis]
methods = ["fem"]
[fem]
size = 2
{})",
                     lower, upper, soil("till", 12, 32), soil("silt", 5, 28), table, has_wall ? wall : nails);
}

/// The mesh of a mirror image is the mirrored mesh.
TEST(ElementSupports, MirrorImageHasTheSameFactor) {
  for (const bool has_wall : {false, true}) {
    const auto find = [&](const std::function<double(double)>& way) {
      return reduce(read_site(write_drawn(has_wall, way)), 1, 1, 1.5).found;
    };
    const auto here = find([](double x) { return x; }), there = find([](double x) { return 40 - x; });
    EXPECT_EQ(there.factor, here.factor);
    EXPECT_NEAR(there.elastic_displacement, here.elastic_displacement, 1e-9 * here.elastic_displacement);
    EXPECT_NEAR(there.trials.front().displacement, here.trials.front().displacement,
                1e-5 * here.trials.front().displacement);
  }
}

TEST(ElementSupports, PlateOfTorgglerHasItsPublishedFactor) {
  const auto find = [](bool has_plate) {
    const site::Site site = read_site(support::write_torggler_slope(
        has_plate ? "kind = \"pile\"\nx = [28.66]\nlength = 7.5\nout_of_plane_spacing = 1\nshear_strength = 1e6\n"
                  : ""));
    const auto search = [&](double share) { return reduce(site, share, 1.05, 1.25).found.factor; };
    return extrapolate_to_zero(2, search(2), 1, search(1));
  };
  EXPECT_NEAR(find(false), 1.111, 0.02 * 1.111);
  EXPECT_NEAR(find(true), 1.175, 0.02 * 1.175);
}

}  // namespace
}  // namespace talus
