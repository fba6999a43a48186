// SPDX-License-Identifier: MIT
// A case that starts from the result of another is bitwise identical to one run of both, except for round-off of the
// time.

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "golden/loaded_bank.hpp"
#include "mesh/generate.hpp"
#include "mpm/solver/observe.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/stage/stage.hpp"
#include "run/mpm/start/end_state.hpp"
#include "run/mpm/start/prepare.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using golden::Bank;
using nlohmann::json;

class StartFromResult : public testing::Test {
 protected:
  input::LoadedCase read(const Bank& bank, const std::vector<input::Override>& changes = {}) const {
    return input::read_case_text(golden::write_bank(bank), (folder_ / "case.toml").string(), changes);
  }
  json run(const Bank& bank, const std::string& result, const std::vector<input::Override>& changes = {}) const {
    run::RunOptions options;
    options.folder = folder_ / result;
    return support::run_case(read(bank, changes), options);
  }
  output::Frame last_frame(const std::string& result) const {
    const output::ResultsReader reader(folder_ / result);
    return reader.read(reader.size() - 1);
  }

  template <int D>
  static void run_stage(const input::LoadedCase& loaded, int number, mpm::Body<D>& body) {
    const input::Stage& stage = loaded.data.stages[0];
    run::set_strength(body, loaded.data, stage.cohesion, 1);
    run::StageState state;
    state.gravity_share = number > 0 ? 1 : 0;
    run::run_stage(body, run::make_plan<D>(loaded.data, stage, 2.5, 1), state);
  }

  /// Expects both stages on one body to be bitwise identical to the second one on a body that starts from the end of
  /// the first.
  template <int D>
  void expect_bitwise_identical(Bank bank, const std::string& water = "") {
    bank.stages += water;
    const input::LoadedCase one = read(bank);
    mpm::Body<D> whole = run::prepare<D>(one.data, mesh::generate<D>(one.data.mesh));
    run_stage<D>(one, 0, whole);
    fs::create_directories(folder_ / "one");
    run::save_end_state<D>(folder_ / "one", one.echo, one.echo, "", whole);
    const std::vector<int> element = whole.points.element;

    bank.base = "silt";  // the same soils, in the other order of the alphabet
    bank.bank = "clay";
    bank.stages = golden::slide + water;
    const input::LoadedCase two = read(bank, {{"initial.result", "one"}});
    mpm::Body<D> started = run::prepare<D>(two.data, {});
    EXPECT_EQ(started.time, 0);
    EXPECT_EQ(mpm::find_largest_displacement(started).value, 0);
    whole.time = 0;        // the last step of a stage takes what is left, to the round-off of the time,
    whole.step_count = 0;  // and elements exchange water in every fourth step of a run
    whole.water.budgets = started.water.budgets;
    input::LoadedCase slide = one;
    slide.data.stages = two.data.stages;
    run_stage<D>(slide, 1, whole);
    run_stage<D>(two, 1, started);
    EXPECT_NE(whole.points.element, element) << "points must change their elements, or nothing is tested";
    EXPECT_EQ(whole.points.id, started.points.id);
    // Free slots hold what the lanes of whatever material left there.
    const std::size_t slot = static_cast<std::size_t>(whole.points.fields * lane_width);
    ASSERT_EQ(whole.points.data.size(), started.points.data.size());
    for (std::size_t i = 0; i < whole.points.data.size(); ++i)
      ASSERT_TRUE(whole.points.id[i / slot * lane_width + i % lane_width] < 0 ||
                  whole.points.data[i] == started.points.data[i])
          << "value " << i % slot / lane_width;
    EXPECT_TRUE(whole.elements.strain == started.elements.strain);
    EXPECT_TRUE(whole.nodes.motion == started.nodes.motion);
    EXPECT_TRUE(whole.water.motion == started.water.motion);
    EXPECT_EQ(whole.work.external, started.work.external);
    for (std::size_t i = 0; i < whole.water.budgets.size(); ++i) {
      EXPECT_EQ(whole.water.budgets[i].entered, started.water.budgets[i].entered);
      EXPECT_EQ(whole.water.budgets[i].runoff, started.water.budgets[i].runoff);
    }
    for (int id = 0; id < whole.points.size(); ++id)
      ASSERT_EQ(whole.material_names[whole.points.material[id]] == "a",
                started.material_names[started.points.material[id]] == "silt");
  }

  const fs::path folder_ = support::make_scratch("start");
};

TEST_F(StartFromResult, IsBitForBitTheNextStage) {
  expect_bitwise_identical<2>({});
  expect_bitwise_identical<3>({.dimension = 3});
}

TEST_F(StartFromResult, IsBitForBitTheNextStageOfWetSoil) {
  // In the Darcy formulation a node sums the pores of its soils in their order.
  const std::string flows = "water = \"flows\"\n";
  expect_bitwise_identical<2>({.wet_base = true, .wet_bank = true}, flows);
  expect_bitwise_identical<2>({.wet_bank = true}, flows);
  expect_bitwise_identical<3>({.dimension = 3, .wet_base = true, .wet_bank = true}, flows);
}

/// Runs by the program's own entry, against one run with both stages. The last step differs by the round-off of the
/// time, 1e-16 of 0.6 s in a step of some 1e-3 s; what grows from that in one step stays far below 1e-9.
TEST_F(StartFromResult, GivesWhatOneRunGives) {
  const std::pair<std::string, std::string> soils[] = {
      {"dry_", ""},
      {"flowing_", "water = \"flows\"\nwater_exchange = false\n"},  // it counts the steps of a run
      {"seeping_", ""}};
  for (const auto& [dir, held] : soils) {
    const bool wet = dir != "dry_";
    Bank bank{.wet_base = wet, .wet_bank = wet};
    bank.stages = golden::settle + held + golden::slide + held;
    const json whole = run(bank, dir + "whole");
    bank.stages = golden::settle + held;
    const json first = run(bank, dir + "one");
    bank.stages = golden::slide + held;
    const json second = run(bank, dir + "two", {{"initial.result", dir + "one"}});
    EXPECT_EQ(whole.at("stages")[1].at("steps"), second.at("stages")[0].at("steps"));
    const output::Frame a = last_frame(dir + "whole"), b = last_frame(dir + "two");
    ASSERT_EQ(a.ids, b.ids);
    for (std::size_t i = 0; i < a.positions.size(); ++i) ASSERT_NEAR(a.positions[i], b.positions[i], 1e-11);
    for (const char* name : {"stress", "velocity", "plastic_strain", "strain", "pore_pressure", "saturation"}) {
      const output::Field *p = output::find(a.point_fields, name), *q = output::find(b.point_fields, name);
      ASSERT_EQ(p == nullptr, q == nullptr);
      if (p == nullptr) continue;
      double scale = 0;
      for (const double value : p->values) scale = std::max(scale, std::abs(value));
      for (std::size_t i = 0; i < p->values.size(); ++i)
        ASSERT_NEAR(p->values[i], q->values[i], 1e-9 * scale) << name << " " << i;
    }
    // Time, displacements and budgets begin anew; the start is named.
    EXPECT_NEAR(second.at("stages")[0].at("time").get<double>(), 0.35, 1e-12);
    EXPECT_EQ(second.at("start").at("result"), dir + "one");
    EXPECT_NEAR(second.at("start").at("time").get<double>(), 0.25, 1e-12);
    EXPECT_FALSE(first.contains("start"));
    const auto work = [](const json& summary) { return summary.at("budgets").at("external_work").get<double>(); };
    EXPECT_NEAR(work(first) + work(second), work(whole), 1e-9 * std::abs(work(whole)));
    const output::HistoryTable history = output::read_history(folder_ / (dir + "two") / "history.csv");
    for (const char* name : {"time", "step", "external_work", "largest_displacement"})
      for (std::size_t c = 0; c < history.columns.size(); ++c)
        EXPECT_TRUE(history.columns[c].name != name || history.values[c].front() == 0) << name;
    if (!wet) continue;
    EXPECT_EQ(second.at("water").at("initial"), first.at("water").at("stored"));
    EXPECT_NEAR(first.at("water").at("entered").get<double>() + second.at("water").at("entered").get<double>(),
                whole.at("water").at("entered").get<double>(), 1e-9 * whole.at("water").at("entered").get<double>());
    EXPECT_LT(std::abs(second.at("water").at("error").get<double>()), 1e-9);
  }
}

/// Soil that has come to rest stays at rest, because its stress carries it. Without that stress it would settle again.
TEST_F(StartFromResult, LeavesSoilAtRestAtRest) {
  Bank bank{.cohesion = 50, .stages = golden::come_to_rest};
  const json first = run(bank, "one");
  ASSERT_EQ(first.at("stages")[0].at("end"), "rest");
  const double settlement = first.at("stages")[0].at("displacement");
  const json again = run(bank, "two", {{"initial.result", "one"}});
  EXPECT_EQ(again.at("stages")[0].at("end"), "rest");
  EXPECT_LT(again.at("stages")[0].at("displacement").get<double>(), 0.01 * settlement);
  EXPECT_LT(again.at("stages")[0].at("time").get<double>(), first.at("stages")[0].at("time").get<double>());
}

/// A third case starts from the second as the second did from the first, and roots hold what slides without them.
TEST_F(StartFromResult, TakesAnotherStrengthAndContinues) {
  Bank bank;
  run(bank, "one");
  bank.stages = golden::slide;
  const auto slide = [&](const std::string& from, const std::string& to, double cohesion) {
    bank.cohesion = cohesion;
    const json summary = run(bank, to, {{"initial.result", from}});
    EXPECT_TRUE(summary.at("warnings").empty()) << summary.at("warnings").dump();
    return summary.at("stages")[0].at("displacement").get<double>();
  };
  const double without = slide("one", "two", 1.5), with_roots = slide("one", "rooted", 30);
  EXPECT_LT(with_roots, 0.5 * without);
  // At the end of the slide the bank still moves; stronger soil stops it earlier.
  const double third = slide("two", "three", 1.5), held = slide("two", "held", 30);
  EXPECT_LT(held, 0.8 * third);
  EXPECT_EQ(last_frame("three").ids.size(), last_frame("one").ids.size());
}

/// One elastic soil, then two of another law: the points get the state variables of the new law, with initial value
/// zero.
TEST_F(StartFromResult, TakesAnotherLaw) {
  Bank bank{.wet_base = true, .wet_bank = true};
  std::string text = golden::write_bank(bank);
  text.erase(text.find("[materials.b]"));
  text += golden::write_rest(bank);
  text.replace(text.find("bank = \"b\""), 10, "bank = \"a\"");
  for (const char* key : {"cohesion", "friction_angle", "dilatancy_angle", "tensile_strength"}) {
    const auto at = text.find(key);
    text.erase(at, text.find('\n', at) - at);
  }
  text.replace(text.find("mohr_coulomb"), 12, "linear_elastic");
  run::RunOptions options;
  options.folder = folder_ / "one";
  support::run_case(input::read_case_text(text, (folder_ / "one.toml").string()), options);
  const mpm::Body<2> body =
      run::prepare<2>(read(bank, {{"initial.result", "one"}, {"materials.b.porosity", "0.4"}}).data, {});
  const output::Frame end = last_frame("one");
  const std::vector<double>& pressure = output::find(end.point_fields, "pore_pressure")->values;
  const std::vector<double>& stress = output::find(end.point_fields, "stress")->values;
  double largest = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    const auto p = mpm::view_point(body, id);
    const std::size_t i = static_cast<std::size_t>(id);
    ASSERT_EQ(-p.pressure, pressure[i]);
    ASSERT_EQ(p.stress[1], stress[6 * i + 1]);
    ASSERT_EQ(p.plastic_strain, 0);
    largest = std::max(largest, std::abs(p.pressure));
  }
  EXPECT_GT(largest, 0);
}

/// Another retention curve keeps the pressures and changes the water.
TEST_F(StartFromResult, KeepsThePressuresOfAnotherRetentionCurve) {
  Bank bank{.wet_base = true, .wet_bank = true};
  const json first = run(bank, "one");
  bank.stages = golden::slide;
  const std::vector<input::Override> changes = {{"initial.result", "one"},
                                                {"materials.b.water.reference_pressure", "2"}};
  const mpm::Body<2> same = run::prepare<2>(read(bank, {changes[0]}).data, {}),
                     other = run::prepare<2>(read(bank, changes).data, {});
  double less = 0;
  for (int id = 0; id < same.points.size(); ++id) {
    const auto p = mpm::view_point(same, id), q = mpm::view_point(other, id);
    ASSERT_EQ(p.pressure, q.pressure);
    if (p.material == 0)
      ASSERT_EQ(p.water_mass, q.water_mass);
    else
      ASSERT_NEAR(q.water_mass, q.saturation * q.porosity * q.volume * 1000 * std::exp(-q.pressure / 5e7),
                  1e-9 * p.water_mass);
    less += p.water_mass - q.water_mass;
  }
  EXPECT_GT(less, 0) << "a lower reference pressure holds less";
  const json second = run(bank, "two", changes);
  EXPECT_NE(second.at("warnings").dump().find("material 'b' holds water otherwise"), std::string::npos);
  EXPECT_NEAR(second.at("water").at("initial").get<double>() + less, first.at("water").at("stored").get<double>(),
              1e-9 * first.at("water").at("stored").get<double>());
}

/// Strength reduction from a result: the curve is that of one run, and the frozen factor, whose stages start from the
/// state of the result, is that of one run to its resolution.
TEST_F(StartFromResult, ReducesTheStrengthFromThere) {
  Bank bank{.cohesion = 8, .stages = golden::come_to_rest};
  run(bank, "one");
  const std::string again = "[[stage]]\nname = \"again\"\nduration = 0.2\ndamping = 0.5\n";
  const std::string reduction =
      "[analysis]\nkind = \"strength_reduction\"\n[strength_reduction.curve]\nsmoothing = \"none\"\nfrom = 1\nto = "
      "1.6\nstep = 0.3\n"
      "refine = false\nwindow = 0.3\nrunout = [1.6]\nrunout_time = 0.5\n[strength_reduction.frozen]\n"
      "resolution = 0.05\nalgorithm = \"frontal\"\ncorner_refinement = 1\n";  // a result's mesh is used as it is
  bank.stages = std::string(golden::come_to_rest) + again + reduction;
  const json whole = run(bank, "whole", {{"strength_reduction.frozen.meshes", "1"}});
  bank.stages = again + reduction;
  const json second = run(bank, "two", {{"initial.result", "one"}});
  const json &a = whole.at("curve").at("points"), &b = second.at("curve").at("points");
  ASSERT_EQ(a.size(), 3u);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double u = a[i].at("displacement");
    EXPECT_NEAR(u, b[i].at("displacement").get<double>(), 1e-6 * u);
  }
  EXPECT_GT(a[2].at("displacement").get<double>(), 2 * a[0].at("displacement").get<double>());
  const auto get_factor = [](const json& summary) {
    return summary.at("factor_of_safety").at("frozen").at("factor").get<double>();
  };
  EXPECT_NEAR(get_factor(second), get_factor(whole), 0.06);
  EXPECT_GT(get_factor(second), 1.05);
  EXPECT_NE(second.at("warnings").dump().find("cannot be halved"), std::string::npos);
  // The work of a runout continues from that of its stages, not from that of the result.
  const output::HistoryTable history = output::read_history(folder_ / "two" / "trials" / "srf_1.6000" / "history.csv");
  for (std::size_t c = 0; c < history.columns.size(); ++c)
    EXPECT_TRUE(history.columns[c].name != "external_work" ||
                std::abs(history.values[c].front() - second.at("budgets").at("external_work").get<double>()) <
                    1e-9 * std::abs(whole.at("budgets").at("external_work").get<double>()));
}

TEST_F(StartFromResult, ResumesAndRefusesAResultThatHasChanged) {
  Bank bank{.wet_base = true, .wet_bank = true};
  run(bank, "one");
  Bank next = bank;
  next.stages = golden::slide;
  const std::vector<input::Override> from_one = {{"initial.result", "one"}};
  const json whole = run(next, "whole", from_one);
  request_interrupt();
  for (const char* result : {"parts", "late"}) EXPECT_THROW(run(next, result, from_one), Error);
  request_interrupt(false);
  run::RunOptions options;
  options.resume = true;
  options.folder = folder_ / "parts";
  const json parts = support::run_case(read(next, from_one), options);
  EXPECT_EQ(parts.at("budgets"), whole.at("budgets"));
  EXPECT_EQ(parts.at("water"), whole.at("water"));
  EXPECT_EQ(parts.at("start"), whole.at("start"));
  const output::Frame a = last_frame("parts"), b = last_frame("whole");
  EXPECT_TRUE(a.positions == b.positions);

  fs::remove_all(folder_ / "one");
  bank.cohesion = 3;
  run(bank, "one");
  options.folder = folder_ / "late";
  try {
    support::run_case(read(next, from_one), options);
    ADD_FAILURE() << "it would resume from another state than it started from";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("belongs to another case"), std::string::npos) << error.what();
  }
}

TEST_F(StartFromResult, ReportsWhatDoesNotFit) {
  const Bank dry;
  run(dry, "one");
  const auto expect = [&](const Bank& bank, std::vector<input::Override> changes, const std::string& part) {
    changes.push_back({"initial.result", "one"});
    try {
      run(bank, "two", changes);
      ADD_FAILURE() << "expected: " << part;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what() << "\nexpected: " << part;
    }
    EXPECT_FALSE(fs::exists(folder_ / "two")) << "nothing may be written";
  };
  expect({.dimension = 3}, {}, "the result 'one' has dimension 2, and this case has dimension 3");
  expect({.wet_bank = true}, {}, "material 'b' is wet, but region 'bank' is dry in the result 'one'");
  expect(dry, {{"materials.b.porosity", "0.1"}},
         "'porosity' of material 'b' is 0.1, but the masses are those of the result 'one', where region 'bank' was "
         "given 0.3");
  expect(dry, {{"mesh.points_per_element", "6"}},
         "'points_per_element' is 6, but the points are those of the result 'one', which has 3");
  expect(dry, {{"geometry.polygon.base.name", "floor"}, {"regions", "{floor = \"a\", bank = \"b\"}"}},
         "there is no region 'floor' in the result 'one'; it has 'bank', 'base'");
  try {
    run(dry, "one", {{"initial.result", "one"}});
    ADD_FAILURE() << "a result may not be written over by what starts from it";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::folder_exists);
  }
  // A mesh other than that of the result has no effect, with a warning.
  const json other = run(dry, "finer", {{"initial.result", "one"}, {"mesh.size", "0.2"}});
  EXPECT_NE(other.at("warnings").dump().find("the mesh is that of the result"), std::string::npos);
}

TEST_F(StartFromResult, RefusesTheStateOfAnotherBuild) {
  run({}, "one");
  const fs::path file = folder_ / "one" / run::end_state_file;
  const output::ArchiveReader whole(file);
  output::ArchiveWriter changed;
  const std::vector<std::int64_t> counts{1, lane_width + 1, 0};
  changed.put("counts", counts);
  changed.put("input", whole.text("input"));
  changed.write(file);
  try {
    run({}, "two", {{"initial.result", "one"}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("the result 'one' was written by a build for vectors of"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace talus
