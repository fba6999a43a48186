// SPDX-License-Identifier: MIT
// Cases with a compiled UMAT as a soil: results of the built-in model, state variables, threads, and the message of a
// run that fails.

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "mesh/generate.hpp"
#include "mpm/solver/observe.hpp"
#include "run/mpm/stage/stage.hpp"
#include "run/mpm/start/prepare.hpp"
#include "support/external_model.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

/// Weak soil over the soil under test, which lies in every element of the base and in some that hold both.
std::string write_external_case(const std::string& soil, const std::string& integration, double duration) {
  return support::write_slope("dry",
                              {"geometry.box=[[0, 0], [30, 13]]", "geometry.line=[]",
                               "geometry.polygon=[{ name = 'base', points = [[0, 0], [30, 0], [30, 4], [0, 4]] }, "
                               "{ name = 'slope', points = [[0, 4], [24, 4], [10, 11], [0, 11]] }]",
                               "mesh={ size = 2, points_per_element = 3 }", "materials.sand.grain_density=2650",
                               "materials.sand.porosity=0.4", "materials.sand.poisson_ratio=0.25",
                               "materials.sand.friction_angle=25", "regions={ base = 'rock', slope = 'sand' }"}) +
         "[materials.rock]\ngrain_density = 2600\nporosity = 0.2\n" + soil +
         "[[stage]]\nname = \"slide\"\ndamping = 0.05\nintegration = \"" + integration +
         "\"\nduration = " + std::to_string(duration) + "\n";
}

const std::string elastic = "model = \"linear_elastic\"\nyoung_modulus = \"60 MPa\"\npoisson_ratio = 0.25\n";

/// λ + 2μ of the elastic soil is 72 MPa exactly, so both cases take the same steps.
std::string name_umat(const std::string& umat, const std::string& rest) {
  return "model = \"external\"\nlibrary = \"" + support::find_umat(umat) + "\"\nconstrained_modulus = \"72 MPa\"\n" +
         rest;
}

mpm::Body<2> run(const std::string& text, int threads) {
  const input::LoadedCase loaded = input::read_case_text(text, "slope.toml", {});
  mpm::Body<2> body = run::prepare<2>(loaded.data, mesh::generate<2>(loaded.data.mesh));
  const double height = run::find_soil_height(body, loaded.data.gravity);
  for (const input::Stage& stage : loaded.data.stages) {
    run::StageState state;
    run::run_stage(body, run::make_plan<2>(loaded.data, stage, height, threads), state);
  }
  return body;
}

/// Largest differences of the points' stress over the largest stress, and of their place [m].
struct Difference {
  double stress = 0, place = 0;
};
Difference compare(const mpm::Body<2>& a, const mpm::Body<2>& b) {
  Difference d;
  double largest = 0;
  EXPECT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.step_count, b.step_count);
  for (int id = 0; id < a.points.size(); ++id) {
    const auto p = mpm::view_point(a, id), q = mpm::view_point(b, id);
    for (std::size_t i = 0; i < 4; ++i) {
      largest = std::max(largest, std::abs(p.stress[i]));
      d.stress = std::max(d.stress, std::abs(p.stress[i] - q.stress[i]));
    }
    for (std::size_t i = 0; i < 2; ++i) d.place = std::max(d.place, std::abs(p.position[i] - q.position[i]));
  }
  d.stress /= largest;
  return d;
}

// Blocks of one law, of two laws, full elements and single points, geometry that moves: 0.5 s of a slide.
TEST(ExternalModel, ElasticUmatGivesTheBuiltInModelsResults) {
  for (const std::string integration : {"mixed", "points"}) {
    const mpm::Body<2> built_in = run(write_external_case(elastic, integration, 0.5), 2);
    const std::string umat = name_umat("elastic", "constants = [60e6, 0.25]\n");
    const mpm::Body<2> external = run(write_external_case(umat, integration, 0.5), 2);
    EXPECT_GT(mpm::find_largest_displacement(built_in).value, 0.02) << "or nothing was tested";
    const Difference d = compare(built_in, external);
    EXPECT_LT(d.stress, 1e-9) << integration;
    EXPECT_LT(d.place, 1e-9) << integration;
    // A UMAT that keeps no data between calls does not see the threads either.
    const Difference none = compare(external, run(write_external_case(umat, integration, 0.5), 1));
    EXPECT_EQ(none.stress, 0) << integration;
    EXPECT_EQ(none.place, 0) << integration;
  }
}

// The UMAT counts its calls in its first state variable: every point must have as many as there were steps.
TEST(ExternalModel, StateVariablesAreCarriedByThePoints) {
  for (const std::string integration : {"mixed", "points"}) {
    const std::string counting =
        name_umat("failing", "symbol = \"no_number\"\nconstants = [1e9]\nstates = 2\ninitial_states = [1000, 5]\n");
    const mpm::Body<2> body = run(write_external_case(counting, integration, 0.2), 2);
    ASSERT_GT(body.step_count, 20);
    int counted = 0;
    for (int id = 0; id < body.points.size(); ++id) {
      const auto p = mpm::view_point(body, id);
      if (body.material_names[static_cast<std::size_t>(p.material)] != "rock") continue;
      ++counted;
      ASSERT_NEAR(p.state[1], 1000 + static_cast<double>(body.step_count), 1e-9) << integration << ", point " << id;
      ASSERT_NEAR(p.state[2], 5, 1e-12) << integration;
      ASSERT_EQ(p.plastic_strain, 0);
    }
    EXPECT_GT(counted, 50);
  }
}

// The weight acts at once on clay that was never loaded before: the clay oscillates, yields and hardens.
TEST(ExternalModel, CamClayInFortranSettlesAsTheBuiltInOne) {
  TALUS_NEEDS_FORTRAN("cam_clay");
  // Small steps: the UMAT takes the stiffness of the start of the step, the built-in model that of its middle.
  const auto settle = [](const std::string& soil) {
    return run(write_external_case(soil, "mixed", 0.4) + "courant = 0.2\n", 2);
  };
  const std::string clay = R"(model = "modified_cam_clay"
poisson_ratio = 0.3
lambda = 0.1
kappa = 0.02
critical_state_slope = 1.2
preconsolidation = "60 kPa"
smallest_pressure = "50 kPa"
)";
  const std::string umat =
      name_umat("cam_clay", "constants = [0.1, 0.02, 0.3, 1.2, 50e3]\nstates = 2\ninitial_states = [60e3, 0.25]\n");
  const mpm::Body<2> built_in = settle(clay), external = settle(umat);
  double largest = 0, difference = 0, hardened = 0;
  for (int id = 0; id < built_in.points.size(); ++id) {
    const auto p = mpm::view_point(built_in, id), q = mpm::view_point(external, id);
    largest = std::max(largest, norm(p.displacement));
    const Vec<2> apart{p.displacement[0] - q.displacement[0], p.displacement[1] - q.displacement[1]};
    difference = std::max(difference, norm(apart));
    if (built_in.material_names[static_cast<std::size_t>(p.material)] != "rock") continue;
    hardened = std::max(hardened, p.state[1] / 60e3 - 1);
    EXPECT_NEAR(q.state[1], p.state[1], 5e-3 * p.state[1]);
    EXPECT_NEAR(q.state[2], p.state[2], 5e-4);
  }
  EXPECT_GT(hardened, 0.2) << "or the clay stayed elastic";
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(difference, 0.01 * largest);
}

using support::Outcome;
using support::run_program;

std::filesystem::path make_folder() {
  return support::make_scratch("external");
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& w : words) EXPECT_NE(text.find(w), std::string::npos) << w << "\nin: " << text;
}

TEST(ExternalModel, RunThatFailsNamesThePointAndItsPlace) {
  const std::string failing =
      name_umat("failing", "symbol = \"smaller_step\"\nconstants = [150]\nstates = 1\ninitial_states = [0.5]\n");
  try {
    run(write_external_case(failing, "points", 0.05), 2);
    ADD_FAILURE() << "the run continued";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::unstable);
    expect_words(
        error.what(),
        {"stage 'slide', step 1: the external model of material 'rock' (smaller_step in ", "failed in point ", " at (",
         ") m: it answered that the step is too long (PNEWDT = 0.25)", "strain increment (", "state variables (0.5)"});
    // NOEL is the number of the point plus one; the lowest one of the soil from 150 on.
    const std::string text = error.what();
    const int point = std::stoi(text.substr(text.find("failed in point ") + 16));
    const mpm::Body<2> body = run(write_external_case(elastic, "points", 1e-4), 1);
    int lowest = 149;
    while (body.material_names[static_cast<std::size_t>(mpm::view_point(body, lowest).material)] != "rock") ++lowest;
    EXPECT_EQ(point, lowest);
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(text.c_str() + text.find(" at ("), " at (%lf, %lf)", &x, &y), 2) << text;
    const auto place = mpm::view_point(body, point).position;
    EXPECT_NEAR(x, place[0], 1e-2);
    EXPECT_NEAR(y, place[1], 1e-2);
  }

  const std::filesystem::path folder = make_folder();
  std::ofstream(folder / "case.toml") << write_external_case(failing, "mixed", 0.05);
  const Outcome outcome =
      run_program("run '" + (folder / "case.toml").string() + "' -q -o '" + (folder / "out").string() + "'");
  EXPECT_EQ(outcome.code, 4) << outcome.text;
  expect_words(outcome.text, {"failed in point ", "the last good state is in "});
}

TEST(ExternalModel, LibraryIsBesideTheCaseAndTheReportNamesIt) {
  const std::filesystem::path folder = make_folder();
  std::filesystem::copy_file(support::find_umat("elastic"), folder / "soil.so");
  std::string soil = name_umat("elastic", "constants = [60e6, 0.25]\n");
  soil.replace(soil.find(support::find_umat("elastic")), support::find_umat("elastic").size(), "soil.so");
  std::ofstream(folder / "case.toml") << write_external_case(soil, "mixed", 0.05);
  const std::string out = (folder / "out").string();
  Outcome outcome = run_program("run '" + (folder / "case.toml").string() + "' -q -o '" + out + "'");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  std::ifstream file(folder / "out" / "report.html", std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  expect_words(page, {"external: UMAT 'umat_' of soil.so", "PROPS(2)", "and Talus cannot check it"});

  std::filesystem::remove(folder / "soil.so");
  outcome = run_program("run '" + (folder / "case.toml").string() + "' -q --overwrite -o '" + out + "'");
  EXPECT_EQ(outcome.code, 2);
  expect_words(outcome.text, {"case.toml:", "soil.so'"});
}

}  // namespace
}  // namespace talus
