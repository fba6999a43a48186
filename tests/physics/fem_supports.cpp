// SPDX-License-Identifier: MIT
// [support.NAME] in FEM: a nailed cut on two meshes beside LEM, a published plate (Torggler 2016), and the limits that
// results name.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "base/extrapolate.hpp"
#include "input/read.hpp"
#include "lem/search/search.hpp"
#include "run/common/bars_of_case.hpp"
#include "run/common/section_of_case.hpp"
#include "run/fem/solid_of_case.hpp"

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

site::Site read_site(const std::string& text) {
  return site::Site(input::read_case_text(text, "cut.toml").data);
}

struct Reduced {
  run::SolidOfCase<2> solid;
  fem::ReductionResult<2> found;
};

/// `is_cone`: without tension cut-off, as LEM takes the soil.
Reduced reduce(const site::Site& site, double share, double from, double to, bool is_cone = false) {
  Reduced reduced{run::make_solid<2>(site, share), {}};
  if (is_cone)
    reduced.solid.model.make_law = [](int, double factor) -> material::Law {
      const material::MohrCoulombStrength strength{8e3, 30 * degree, 30 * degree, 8e3 / std::tan(30 * degree)};
      return material::MohrCoulomb(material::LinearElastic::from_young(3e7, 0.3), strength.reduced(factor));
    };
  fem::ReductionOptions options;
  options.from = from, options.to = to;
  reduced.found = fem::reduce_strength<2>(reduced.solid.model, options);
  return reduced;
}

double search_lem(const site::Site& site) {
  lem::SearchOptions options;
  options.methods = {lem::Method::bishop};
  options.threads = 2;
  return lem::search(lem::Slope(run::make_section(site).section), options).circular.at(0).solution.factor;
}

TEST(ElementSupports, NailedCutHasTheFactorOfLimitEquilibrium) {
  const site::Site site = read_site(write_cut("sense = \"active\""));
  const Reduced coarse = reduce(site, 2, 1.3, 1.5, true), fine = reduce(site, 1, 1.3, 1.5, true);
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

/// Torggler (2016), 10 m at 30° on 20 m: PLAXIS has 1.111, and 1.175 with a plate of 7.5 m in the middle of the slope.
std::string write_plate(bool has_plate) {
  return std::string(R"(
title = "Plate in a slope"
[geometry]
ground = [[0, 20], [20, 20], [37.32, 30], [57, 30]]
[[geometry.layer]]
name = "soil"
level = 0
[regions]
soil = "soil"
[materials.soil]
model = "mohr_coulomb"
unit_weight = 16
cohesion = 10
friction_angle = 15
dilatancy_angle = 0
tensile_strength = 0
young_modulus = 2
poisson_ratio = 0.4
[analysis]
methods = ["fem"]
[fem]
size = 1
)") + (has_plate ? R"(
[support.plate]
kind = "pile"
x = [28.66]
length = 7.5
out_of_plane_spacing = 1
shear_strength = 1e6
axial_stiffness = 2e6
bending_stiffness = 4e4
)"
                 : "");
}

TEST(ElementSupports, PlateOfTorgglerHasItsPublishedFactor) {
  const auto find = [](bool has_plate) {
    const site::Site site = read_site(write_plate(has_plate));
    const auto search = [&](double share) { return reduce(site, share, 1.05, 1.25).found.factor; };
    return extrapolate_to_zero(2, search(2), 1, search(1));
  };
  EXPECT_NEAR(find(false), 1.111, 0.02 * 1.111);
  EXPECT_NEAR(find(true), 1.175, 0.02 * 1.175);
}

}  // namespace
}  // namespace talus
