// SPDX-License-Identifier: MIT
// Pore pressures at the same points in LEM, FEM, limit analysis and MPM: every source of water, in soils with and
// without pore water of their own, before and after a stage of construction, against closed forms.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "input/read.hpp"
#include "lem/section/slope.hpp"
#include "mesh/generate.hpp"
#include "run/bounds/case_fields.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/common/section_of_case.hpp"
#include "run/construction/stage_model.hpp"
#include "run/fem/start_stress.hpp"
#include "run/mpm/start/conditions.hpp"
#include "site/initial_water.hpp"
#include "site/pore_water.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810, moist = 19e3, saturated = 21e3, r_u = 0.3, border = -1;

/// The bank of 4 m in sand on clay, whose border is level.
double find_ground(double x) {
  return x < 5 ? 4 : x < 11 ? 4 - (x - 5) * 4 / 6 : 0;
}
/// The plane water table, which no method has to interpolate.
double find_level(double x) {
  return 2.2 - 0.2 * x;
}

enum class Source { table, lines, grid, ratio, ratio_grid, seepage };
enum class Wet { none, sand, clay, both };

const char* name(Source source) {
  switch (source) {
    case Source::table:
      return "table";
    case Source::lines:
      return "lines";
    case Source::grid:
      return "grid";
    case Source::ratio:
      return "r_u";
    case Source::ratio_grid:
      return "grid of r_u";
    case Source::seepage:
      break;
  }
  return "seepage";
}

struct Slope {
  Source source = Source::table;
  Wet wet = Wet::none;
  bool has_stage = false;
  /// Soils with a piezometric line one metre above the table.
  std::string lined = R"("sand", "clay")";
  std::string clay = "mohr_coulomb", methods = R"("lem", "fem", "bounds")";

  bool is_wet(const std::string& soil) const {
    return wet == Wet::both || wet == (soil == "sand" ? Wet::sand : Wet::clay);
  }
  std::string describe() const {
    return fmt::format("{}, water of sand {}, of clay {}, {}", name(source), is_wet("sand"), is_wet("clay"),
                       has_stage ? "after a stage" : "no stage");
  }

  std::string write() const {
    std::string text = fmt::format(R"(
analysis.methods = [{}]
unusual = ["materials"]
mesh.size = 2
bounds.size = 2
fem = {{ size = 2, meshes = 1 }}
geometry.ground = [[0, 4], [5, 4], [11, 0], [16, 0]]
geometry.layer = [{{ name = "sand", level = -1 }}, {{ name = "clay", level = -4 }}]
regions = {{ sand = "sand", clay = "clay" }}
surcharge = [{{ name = "hut", x = [2, 4], load = [1e-6, 1e-6] }}]
)",
                                   methods);
    if (has_stage) text += "construction = [{ name = \"hut\", duration = \"1 s\", add = [\"hut\"] }]\n";
    const std::string stress = "stress = \"k0\", ", table = "water_table = [[0, 2.2], [16, -1]]";
    if (source == Source::table)
      text += fmt::format("initial = {{ {}pore_pressure = \"water_table\", {} }}\n", stress, table);
    if (source == Source::lines)
      text += fmt::format(
          "initial = {{ {}pore_pressure = \"water_table\", {}, piezometric_line = [{{ materials = [{}], points = [[0, "
          "3.2], [16, 0]] }}] }}\n",
          stress, table, lined);
    if (source == Source::grid || source == Source::ratio_grid)
      text += fmt::format(
          "initial = {{ {}pore_pressure = \"grid\", pressure_grid = {{ file = \"{}.csv\", quantity = \"{}\" }} }}\n",
          stress, source == Source::grid ? "heads" : "ratios", source == Source::grid ? "head" : "r_u");
    if (source == Source::ratio) text += fmt::format("initial = {{ {}pore_pressure = \"zero\" }}\n", stress);
    if (source == Source::seepage)
      text += fmt::format(
          "initial = {{ {}pore_pressure = \"seepage\" }}\nhydraulic = [{{ on = \"left\", condition = \"total_head\", "
          "head = "
          "-2 }}, {{ on = \"right\", condition = \"total_head\", head = -2 }}]\n",
          stress);
    for (const std::string soil : {"sand", "clay"}) {
      const bool is_tresca = soil == "clay" && clay == "tresca";
      text += fmt::format(
          "[materials.{}]\nmodel = \"{}\"\nunit_weight = 19\nsaturated_unit_weight = 21\nporosity = 0.4\n"
          "young_modulus = 3e4\npoisson_ratio = 0.3\n",
          soil, is_tresca ? "tresca" : "mohr_coulomb");
      text += is_tresca ? "undrained_strength = 80\n"
                        : "cohesion = 30\nfriction_angle = 35\ndilatancy_angle = 0\ntensile_strength = 30\n";
      if (source == Source::ratio) text += fmt::format("pore_pressure_ratio = {}\n", r_u);
      if (is_wet(soil))
        text += fmt::format("[materials.{}.water]\nretention = \"saturated\"\nconductivity = \"1e-12 m/s\"\n", soil);
    }
    return text;
  }

  /// Weight of soil where no water table decides: saturated if it has water, at zero pressure.
  double find_column(double x, double y) const {
    const auto weigh = [&](const std::string& soil) { return is_wet(soil) ? saturated : moist; };
    const double top = find_ground(x);
    return weigh("sand") * (top - std::max(y, border)) + weigh("clay") * (std::max(y, border) - y);
  }
  /// Returns the pore pressure by the rules of docs/manual/case-file.md [Pa], compression positive, zero for suction.
  double find_pressure(const std::string& soil, double x, double y) const {
    if (soil == "clay" && clay == "tresca") return 0;
    switch (source) {
      case Source::lines:
        return std::max(0.0, gamma_w * (find_level(x) + (lined.find(soil) != std::string::npos ? 1 : 0) - y));
      case Source::ratio:
      case Source::ratio_grid:
        return r_u * find_column(x, y);
      case Source::seepage:
        return is_wet(soil) ? std::max(0.0, gamma_w * (-2 - y)) : 0;
      case Source::table:
      case Source::grid:
        break;
    }
    return std::max(0.0, gamma_w * (find_level(x) - y));
  }
};

class PorePressures : public ::testing::Test {
 protected:
  PorePressures() {
    std::ofstream heads(folder_ / "heads.csv"), ratios(folder_ / "ratios.csv");
    heads << "x [m], y [m], head [m]\n";
    ratios << "x, y, r_u\n";
    for (const double x : {-1.0, 17.0})
      for (const double y : {-5.0, 5.0}) {
        heads << fmt::format("{}, {}, {}\n", x, y, find_level(x));
        ratios << fmt::format("{}, {}, {}\n", x, y, r_u);
      }
  }
  input::Case read(const Slope& slope) const {
    return input::read_case_text(slope.write(), (folder_ / "case.toml").string()).data;
  }
  std::string find_fault(const Slope& slope) const {
    try {
      read(slope);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  /// Compares the models of LEM, FEM and limit analysis with the closed form, at the corners of both meshes.
  static void compare(const Slope& slope, const input::Case& data, double tolerance) {
    const site::Site site(data);
    const lem::Slope section(run::make_section(site).section);
    const auto expect = [&](const char* method, const std::string& soil, const Vec<2>& corner, const Vec<2>& middle,
                            double pressure) {
      const double right = slope.find_pressure(soil, corner[0], corner[1]);
      EXPECT_NEAR(std::max(0.0, pressure), right, tolerance)
          << method << " in " << soil << " at " << corner[0] << ", " << corner[1];
      // Just inside the soil: pressures may jump between soils.
      constexpr double inwards = 1e-5;
      const lem::Point x{corner[0] + inwards * (middle[0] - corner[0]), corner[1] + inwards * (middle[1] - corner[1])};
      int number = -1;
      const double weight = section.weight_above(x[0], x[1], number);
      ASSERT_GE(number, 0);
      const lem::Soil& here = section.section().soils[static_cast<std::size_t>(number)];
      ASSERT_EQ(here.name, soil);
      const double found = here.undrained ? 0 : section.pore_pressure(x, here, weight);
      EXPECT_NEAR(std::max(0.0, found), right, tolerance + 0.5)
          << "LEM in " << soil << " at " << corner[0] << ", " << corner[1];
    };
    const auto solid = run::make_solid<2>(site);
    const mesh::Mesh<2>& mesh = *solid.mesh;
    for (int e = 0; e < mesh.element_count(); ++e) {
      const auto n = static_cast<std::size_t>(e);
      if (mesh.element_region[n] == mesh::empty_region) continue;
      const std::string& soil = data.regions.at(mesh.region_names[static_cast<std::size_t>(mesh.element_region[n])]);
      for (std::size_t c = 0; c < 3; ++c)
        expect("FEM", soil, mesh.nodes[static_cast<std::size_t>(mesh.elements[n][c])],
               mesh::to_global(mesh, e, {1.0 / 3, 1.0 / 3}),
               solid.model.pore_stress.empty() ? 0 : -solid.model.pore_stress[n][c]);
    }
    compare_bounds(slope, site, tolerance, expect);
  }

  /// Compares the pressures of the case in limit analysis, and those of its problems, which are on the safe side where
  /// pressures are not linear.
  static void compare_bounds(const Slope& slope, const site::Site& site, double tolerance, const auto& expect) {
    const run::ProblemOfCase made = run::make_bounds_problem(site);
    const bounds::Problem &weaker = made.problem, &stronger = made.stronger ? *made.stronger : made.problem;
    std::vector<run::SoilPlace> places;
    for (std::size_t e = 0; e < weaker.size(); ++e)
      for (const int node : weaker.triangles[e]) places.push_back({e, weaker.nodes[static_cast<std::size_t>(node)]});
    const std::vector<double> pressures = made.fields->find_pressures(places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& [e, corner] = places[i];
      Vec<2> middle{};
      for (const int node : weaker.triangles[e])
        for (std::size_t d = 0; d < 2; ++d) middle[d] += weaker.nodes[static_cast<std::size_t>(node)][d] / 3;
      const std::string soil = middle[1] > border ? "sand" : "clay";
      expect("limit analysis", soil, corner, middle, pressures[i]);
      const double right = slope.find_pressure(soil, corner[0], corner[1]);
      EXPECT_GE(std::max(0.0, weaker.pore_pressure[e][i % 3]), right - tolerance);
      EXPECT_LE(std::max(0.0, stronger.pore_pressure[e][i % 3]), right + tolerance);
    }
  }

  /// Computes the stage and returns the case of the methods at its end. Expects the same pressures in its model.
  static input::Case compute_stage(const Slope& slope, const input::Case& data) {
    std::vector<std::string> notes;
    const auto mesh = run::make_whole_mesh(data, notes);
    auto stage = run::make_stage_model(data, run::before_stages, mesh, nullptr);
    fem::ConsolidationState<2> state{{}, stage->model.steady_head};
    fem::SolidModel<2> solid = stage->solid.model;
    solid.pore_stress = fem::find_corner_stress<2>(stage->model, state.head);
    const auto found = fem::find_equilibrium<2>(solid, run::make_solid_options(data.fem, 1));
    EXPECT_TRUE(found.converged);
    state.solid = found.at;
    const auto keep_water = [&] {
      return std::make_shared<const input::KnownWater>(input::KnownWater{
          *mesh, run::find_pressures(*stage, state.head), std::vector<std::array<double, 2>>(mesh->elements.size())});
    };
    auto next = run::make_stage_model(data, 0, mesh, keep_water());
    fem::ConsolidationSchedule schedule;
    schedule.duration = data.construction[0].duration;
    schedule.threads = 1;
    const auto start = fem::carry_state<2>(stage->model, state, next->model, next->elevation);
    stage = std::move(next);
    const auto result = fem::run_stage<2>(stage->model, start, schedule);
    EXPECT_TRUE(result.converged);
    state = result.outputs.back().at;
    const auto pore = fem::find_corner_stress<2>(stage->model, state.head);
    for (std::size_t e = 0; e < pore.size(); ++e) {
      if (mesh->element_region[e] == mesh::empty_region) continue;
      const std::string& soil = data.regions.at(mesh->region_names[static_cast<std::size_t>(mesh->element_region[e])]);
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec<2>& x = mesh->nodes[static_cast<std::size_t>(mesh->elements[e][c])];
        EXPECT_NEAR(std::max(0.0, -pore[e][c]), slope.find_pressure(soil, x[0], x[1]), 1)
            << "stage, " << soil << " at " << x[0] << ", " << x[1];
      }
    }
    input::Case later = stage->data;
    if (stage->is_wet) later.initial.water.known = keep_water();
    return later;
  }

  const std::filesystem::path folder_ = support::make_scratch("pore_pressures");
};

TEST_F(PorePressures, AreThoseOfEverySourceInEverySoil) {
  for (const Source source :
       {Source::table, Source::lines, Source::grid, Source::ratio, Source::ratio_grid, Source::seepage})
    for (const Wet wet : {Wet::none, Wet::sand, Wet::clay, Wet::both}) {
      if (source == Source::seepage && wet == Wet::sand) continue;  // its level lies in the clay
      const Slope slope{.source = source, .wet = wet};
      SCOPED_TRACE(slope.describe());
      if (source == Source::seepage && wet == Wet::none) {
        EXPECT_NE(find_fault(slope).find("no material has pore water"), std::string::npos);
      } else {
        compare(slope, read(slope), source == Source::seepage ? 1 : 0.01);
      }
    }
}

TEST_F(PorePressures, AreTheSameAfterAStage) {
  for (const Source source :
       {Source::table, Source::lines, Source::grid, Source::ratio, Source::ratio_grid, Source::seepage})
    for (const Wet wet : {Wet::none, Wet::sand, Wet::clay, Wet::both}) {
      if (source == Source::seepage && wet == Wet::sand) continue;
      Slope slope{.source = source, .wet = wet, .has_stage = true};
      SCOPED_TRACE(slope.describe());
      const std::string fault = find_fault(slope);
      if (source == Source::seepage && wet == Wet::none) {
        EXPECT_NE(fault.find("no material has pore water"), std::string::npos) << fault;
        continue;
      }
      // Seepage cannot start from these.
      if (wet != Wet::none && source == Source::lines) {
        EXPECT_NE(fault.find("starts from one field of pressure"), std::string::npos) << fault;
        if (wet != Wet::sand) continue;
        slope.lined = "\"clay\"";
      } else if (wet != Wet::none && source == Source::ratio) {
        EXPECT_NE(fault.find("pore pressure ratio and pore water"), std::string::npos) << fault;
        continue;
      } else if (wet != Wet::none && source == Source::ratio_grid) {
        EXPECT_NE(fault.find("cannot start from r_u"), std::string::npos) << fault;
        continue;
      }
      compare(slope, compute_stage(slope, read(slope)), 1);
    }
}

/// In total stresses no pressure acts, but the soil weighs what it does below the water table.
TEST_F(PorePressures, AreNoneInTotalStresses) {
  for (const bool has_stage : {false, true}) {
    const Slope slope{.source = Source::table, .wet = Wet::sand, .has_stage = has_stage, .clay = "tresca"};
    SCOPED_TRACE(slope.describe());
    const input::Case data = read(slope), later = has_stage ? compute_stage(slope, data) : data;
    compare(slope, later, 1);
    const auto solid = run::make_solid<2>(site::Site(later));
    const lem::Section section = run::make_section(site::Site(later)).section;
    for (std::size_t e = 0; e < solid.mesh->elements.size(); ++e)
      if (solid.mesh->element_region[e] != mesh::empty_region &&
          solid.mesh->region_names[static_cast<std::size_t>(solid.mesh->element_region[e])] == "clay") {
        EXPECT_NEAR(solid.model.unit_weight[e], saturated, 1e-6);
      }
    for (const lem::Soil& soil : section.soils) EXPECT_NEAR(soil.saturated_unit_weight, saturated, 1e-6) << soil.name;
  }
}

/// Soil beside computed seepage that has no pore water of its own weighs the same in LEM as in FEM.
TEST_F(PorePressures, OfSeepageLeaveOtherSoilDry) {
  const input::Case data = read({.source = Source::seepage, .wet = Wet::clay});
  const lem::Slope slope(run::make_section(site::Site(data)).section);
  int soil = -1;
  EXPECT_NEAR(slope.weight_above(2, -0.5, soil), 4.5 * moist, 1);
  EXPECT_NEAR(slope.water_table(2), -2, 0.05);
}

TEST_F(PorePressures, OfMpmAreThoseOrRefused) {
  for (const Source source : {Source::table, Source::grid})
    for (const Wet wet : {Wet::none, Wet::sand, Wet::clay, Wet::both}) {
      Slope slope{.source = source, .wet = wet};
      SCOPED_TRACE(slope.describe());
      const input::Case data = read(slope);
      const mesh::Mesh<2> mesh = mesh::generate<2>(data.mesh);
      if (wet != Wet::none && wet != Wet::both) {
        slope.methods = "\"lem\", \"mpm\"";
        EXPECT_NE(find_fault(slope).find(
                      fmt::format("acts in material '{}', which has no", wet == Wet::sand ? "clay" : "sand")),
                  std::string::npos)
            << find_fault(slope);
        EXPECT_THROW(run::find_carried_water<2>(data, mesh), Error);
        continue;
      }
      const auto water = site::find_initial_water<2>(data, mesh);
      const auto held = run::find_carried_water<2>(data, mesh);
      for (int e = 0; e < mesh.element_count(); ++e) {
        const auto n = static_cast<std::size_t>(e);
        if (mesh.element_region[n] == mesh::empty_region) continue;
        const std::string& soil = data.regions.at(mesh.region_names[static_cast<std::size_t>(mesh.element_region[n])]);
        const Vec<2> x = mesh::to_global(mesh, e, {1.0 / 3, 1.0 / 3});
        if (wet == Wet::both) {
          EXPECT_NEAR(std::max(0.0, -water.pressure[n]), slope.find_pressure(soil, x[0], x[1]), 0.01);
        }
        for (std::size_t c = 0; wet == Wet::none && c < 3; ++c) {
          const Vec<2>& corner = mesh.nodes[static_cast<std::size_t>(mesh.elements[n][c])];
          EXPECT_NEAR(std::max(0.0, -held.pore[n][c]), slope.find_pressure(soil, corner[0], corner[1]), 0.01);
        }
      }
    }
}

/// Standing water of the water table stays on the ground in the stages: a level table over a level bed.
TEST_F(PorePressures, StandingWaterStaysInTheStages) {
  for (const Wet wet : {Wet::none, Wet::clay, Wet::both}) {
    Slope slope{.source = Source::table, .wet = wet, .has_stage = true};
    SCOPED_TRACE(slope.describe());
    std::string text = slope.write();
    const std::string table = "[[0, 2.2], [16, -1]]";
    text.replace(text.find(table), table.size(), "[[0, 1], [16, 1]]");
    const input::Case data = input::read_case_text(text, "case.toml").data;
    std::vector<std::string> notes;
    const auto mesh = run::make_whole_mesh(data, notes);
    const auto first = run::make_stage_model(data, run::before_stages, mesh, nullptr);
    const auto known = std::make_shared<const input::KnownWater>(input::KnownWater{
        *mesh, site::find_nodal_pressure<2>(data, *mesh), std::vector<std::array<double, 2>>(mesh->elements.size())});
    const auto stage = run::make_stage_model(data, 0, mesh, known);
    const auto find_load = [](const run::StageModel& model) {
      double down = 0;
      for (const auto& load : model.solid.model.loads)
        for (std::size_t s = 0; load.name == "standing water" && s < load.sides.size(); ++s) {
          const auto &a = model.solid.mesh->nodes[static_cast<std::size_t>(load.sides[s][0])],
                     &b = model.solid.mesh->nodes[static_cast<std::size_t>(load.sides[s][1])];
          down -= 0.5 * (load.traction[s][0][1] + load.traction[s][1][1]) * std::hypot(a[0] - b[0], a[1] - b[1]);
        }
      return down;
    };
    // 1 m over the bed of 5 m, and a triangle of 1.5 m on the slope.
    const double right = gamma_w * (5 + 0.75);
    EXPECT_NEAR(find_load(*first), right, 1);
    EXPECT_NEAR(find_load(*stage), right, 1);
    const lem::Slope section(run::make_section(site::Site(stage->data)).section);
    for (const double x : {9.6, 10.5, 12.0, 15.9}) EXPECT_NEAR(section.water_table(x), 1, 1e-3) << x;
    if (!stage->is_wet) continue;
    for (const auto& boundary : stage->flow.boundaries) EXPECT_FALSE(boundary.levels.empty()) << boundary.name;
    const auto steady = fem::solve_steady_seepage<2>(stage->flow);
    for (std::size_t i = 0; i < steady.head.size(); ++i)
      if (steady.head[i] != mesh->nodes[i][1]) {
        EXPECT_NEAR(steady.head[i], 1, 1e-6) << "no flow";
      }
  }
}

/// A sand bank below a water table: Spencer's factor of the whole section without pore water of its own is 1.279,
/// and 1.9 without pressures.
TEST_F(PorePressures, GiveTheFactorsOfAWaterTableInMixedSoilsAndStages) {
  const std::string bank = R"(
analysis.methods = ["lem", "fem"]
geometry.ground = [[0, 8], [10, 8], [28, 0], [40, 0]]
geometry.layer = [{ name = "sand", level = -3 }, { name = "clay", level = -5 }]
regions = { sand = "sand", clay = "clay" }
initial = { stress = "k0", pore_pressure = "water_table", water_table = [[0, 7], [10, 6.5], [28, 0], [40, 0]] }
lem.methods = ["spencer"]
lem.noncircular = false
lem.referee = false
lem.yield_acceleration = false
lem.minima = 1
lem.entry_exit = { entries = 16, exits = 16, depths = 10 }
fem = { size = 2.5, meshes = 1 }
surcharge = [{ name = "hut", x = [2, 4], load = [1, 1] }]
materials.sand.model = "mohr_coulomb"
materials.sand.unit_weight = 18
materials.sand.saturated_unit_weight = 20
materials.sand.cohesion = 4
materials.sand.friction_angle = 32
materials.sand.dilatancy_angle = 0
materials.sand.tensile_strength = 0
materials.sand.young_modulus = 3e4
materials.sand.poisson_ratio = 0.3
[materials.clay]
model = "mohr_coulomb"
grain_density = 2700
porosity = 0.4
cohesion = 60
friction_angle = 25
dilatancy_angle = 0
tensile_strength = 0
young_modulus = 2e4
poisson_ratio = 0.3
)";
  const std::string water = "[materials.clay.water]\nretention = \"saturated\"\nconductivity = \"1e-8 m/s\"\n",
                    stage = "[[construction]]\nname = \"hut\"\nduration = 1\nadd = [\"hut\"]\n";
  const auto run = [&](const std::string& text) {
    run::RunOptions options;
    options.folder = folder_ / "run";
    options.overwrite = true;
    return support::run_case(input::read_case_text(text, (folder_ / "case.toml").string()), options);
  };
  const nlohmann::json mixed = run(bank + water);
  EXPECT_NEAR(mixed.at("lem").at("critical")[0].at("factor").get<double>(), 1.279, 0.015 * 1.279);
  EXPECT_NEAR(mixed.at("fem").at("runs")[0].at("factor").get<double>(), 1.28, 0.04);
  for (const std::string& soil : {std::string(), water}) {
    const nlohmann::json built = run(bank + soil + stage);
    for (const auto& factor : built.at("construction").at("stages")[0].at("factors"))
      EXPECT_NEAR(factor.at("factor").get<double>(), 1.28, 0.04) << factor.at("title");
  }
}

}  // namespace
}  // namespace talus
