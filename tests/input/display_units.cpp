// SPDX-License-Identifier: MIT
// Sentences on a case in feet and pounds contain no metric unit.

#include <regex>

#include "mesh/plan.hpp"
#include "methods_slope.hpp"
#include "results/governing.hpp"
#include "results/timeline.hpp"
#include "run/lem/run_lem.hpp"
#include "run/mpm/reduction/criteria.hpp"
#include "run/mpm/reduction/frozen_factor.hpp"
#include "run/mpm/stage/stage_warnings.hpp"
#include "site/site.hpp"

namespace talus::input {
namespace {

const std::vector<Override> pounds{
    {"output.length_unit", "\"ft\""}, {"output.displacement_unit", "\"in\""}, {"output.stress_unit", "\"psf\""}};

void expect_no_metric_unit(const std::string& sentence) {
  static const std::regex metric(R"([0-9)] (m|mm|m/s|m/s²|m²|m³|m³/m|kPa|Pa|MPa|kN/m|kN/m3|kN/m³)([ ,.;:)]|$))");
  static const std::regex customary(R"([0-9)] (ft|in|ft/s|ft²|psf|pcf)([ ,.;:)]|$))");
  EXPECT_FALSE(std::regex_search(sentence, metric)) << sentence;
  EXPECT_TRUE(std::regex_search(sentence, customary)) << sentence;
}

/// Checks the sentences that name a length or a stress; returns their number.
template <class Sentences>
std::size_t check(const Sentences& sentences) {
  std::size_t count = 0;
  for (const std::string& sentence : sentences) {
    // A number with a unit, and no percentage.
    static const std::regex unit(R"([0-9)] (m|mm|m/s|m²|kPa|Pa|ft|in|ft/s|ft²|psf)([ ,.;:)]|$))");
    if (!std::regex_search(sentence, unit)) continue;
    expect_no_metric_unit(sentence);
    ++count;
  }
  return count;
}

std::string write_bank(const std::string& soil, const std::string& rest) {
  return R"(analysis.methods = ["lem"]
regions.a = "s"
[[geometry.polygon]]
name = "a"
points = [["0 ft", "0 ft"], ["150 ft", "0 ft"], ["150 ft", "20 ft"], ["90 ft", "20 ft"], ["60 ft", "50 ft"], ["0 ft", "50 ft"]]
[materials.s]
model = "mohr_coulomb"
friction_angle = 25
)" + soil +
         rest;
}

TEST(DisplayUnits, StandInTheWarningsOfGroundAndWater) {
  const Case data = read(write_bank("unit_weight = \"50 pcf\"\ncohesion = 0\n", R"([initial]
pore_pressure = "water_table"
water_table = [["20 ft", "70 ft"], ["100 ft", "30 ft"]]
[lem.tension_crack]
depth = "40 ft"
limit = false
)"),
                         pounds);
  EXPECT_EQ(check(site::find_odd_water(data)), 2u) << "it slopes above the ground and floods the toe";
  const run::PreparedSlope prepared = run::prepare_slope(data);
  EXPECT_EQ(check(prepared.notes), 1u) << "crack";
  EXPECT_EQ(check(std::vector{run::describe_uplift(*prepared.slope)}), 1u);
  for (const site::SteepFace& face : site::find_steep_faces(data))
    EXPECT_NE(site::describe(face, data.units().length).find("between (90, 20) and (60, 50)"), std::string::npos);
  const site::Polyline level{{0, 0}, {30, 0}};
  for (const site::Polyline& table : {site::Polyline{{40, -1}, {50, -1}}, {{0, 200}}, {{0, -9}}})
    EXPECT_GT(check(site::find_odd_water(table, level, -3, data.units().length, "The water table")), 0u);
  EXPECT_EQ(check(site::find_open_ends({{{10, 0}, {20, 0}, 5, 5}}, level, data.units().length)), 2u);
}

TEST(DisplayUnits, StandInTheWarningsOfASearch) {
  const auto search = [](const std::string& settings) {
    const Case data = read(write_bank("unit_weight = \"120 pcf\"\ncohesion = \"200 psf\"\n",
                                      "[lem]\nmethods = [\"bishop\"]\nnoncircular = false\n" + settings),
                           pounds);
    const results::SliceResult result = run::run_lem(data, run::prepare_slope(data), 1).result;
    std::size_t count = check(result.warnings);
    for (const auto* list : {&result.critical, &result.noncircular})
      for (const results::CriticalSurface& c : *list) count += check(c.warnings);
    for (const auto& hit : result.search->limit_hits) count += check(std::vector{hit.limit});
    return count;
  };
  EXPECT_GT(search("[lem.entry_exit]\nexit = [\"95 ft\", \"99 ft\"]\nentry = [\"40 ft\", \"44 ft\"]\n"), 0u);
  EXPECT_GT(search("search = \"grid\"\nsmallest_depth = \"15 ft\"\n[lem.grid]\ncolumns = 5\nrows = 5\n"
                   "corners = [[\"60 ft\", \"60 ft\"], [\"70 ft\", \"70 ft\"]]\nlevels = [\"15 ft\", \"18 ft\"]\n"),
            0u);
}

TEST(DisplayUnits, StandInFaultsOfTheGeometry) {
  const std::string water = "[initial]\npore_pressure = \"water_table\"\nwater_table = ";
  const std::string surface = "[[lem.surface]]\nname = \"a\"\n";
  for (const std::string& text :
       {slices_alone + water + "[[9, 30], [2, 30]]\n",
        slices_alone + "[[surcharge]]\nname = \"road\"\nx = [60, 55]\nload = [1, 1]\n",
        slices_alone + "[[surcharge]]\nname = \"road\"\nx = [60, 95]\nload = [1, 1]\n",
        slices_alone + "[lem.tension_crack]\ndepth = 2\nwater = 3\n", slices_alone + "[lem.grid]\nlevels = [50, 60]\n",
        slices_alone + surface + "points = [[20, 25], [30, 20], [25, 21], [60, 35]]\n",
        slices_alone + surface + "points = [[20, 22], [40, 21], [60, 35]]\n",
        slices_alone + surface + "points = [[20, 25], [40, 15], [60, 35]]\n",
        slices_alone + surface + "centre = [40, 50]\nradius = 20\nends = [10, 60]\n",
        change(slices_alone, "soil = \"soil\"\n", "soil = \"soil\"\nb = \"soil\"\n") +
            "[[geometry.polygon]]\nname = \"b\"\npoints = [[0, 19], [90, 19], [90, 21], [0, 21]]\n"}) {
    const std::vector<Diagnostic> faults = find_faults(text, pounds);
    ASSERT_FALSE(faults.empty()) << text;
    for (const Diagnostic& fault : faults) expect_no_metric_unit(fault.sentence);
  }
  mesh::Plan plan = read(slices_alone, pounds).mesh;
  plan.size = 1;
  plan.lines = {{"a", {{0, 20}, {99, 20}}}};
  try {
    mesh::check_plan(plan);
    ADD_FAILURE() << "the line leaves the box";
  } catch (const Error& error) {
    expect_no_metric_unit(error.what());
  }
}

TEST(DisplayUnits, AreThoseOfTheCaseEvenIfOneIsUnknown) {
  const std::vector<Diagnostic> faults =
      find_faults(slices_alone + "[lem.tension_crack]\ndepth = 2\nwater = 3\n", {{"output.length_unit", "\"fete\""}});
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_NE((faults[0].sentence + faults[1].sentence).find("is 3 m high, but the crack is 2 m deep"),
            std::string::npos);
}

TEST(DisplayUnits, StandInTheSentencesOfMaterialPoints) {
  const ShownUnits units = make_shown_units("ft", "in", "psf");
  results::Stage stage;
  stage.moving = results::MovingSoil{.speed = 0.3, .place = {1.5, 3}, .material = "sand", .share = 0.2};
  stage.displacement = 0.4;
  results::MeshFactor mesh;
  mesh.size = 0.5, mesh.lower = 1.2, mesh.undecided = 3;
  results::CriticalSurface surface;
  surface.crack = 1.2;
  results::Timeline timeline;
  timeline.releases.emplace_back();
  timeline.releases[0].largest_displacement = 3;
  timeline.releases[0].front_advance = 2;
  for (const std::string& sentence :
       {run::describe_restless({}, stage, units), run::describe_undecided(mesh, {}, units.length),
        run::find_displacement_criterion({{1.0, 0.0}, {1.4, 0.1}}, 0.3, units.length).note,
        results::name_surface({&surface, results::SurfaceSource::critical, ""}, units),
        results::format_releases(timeline, units)})
    expect_no_metric_unit(sentence);
}

}  // namespace
}  // namespace talus::input
