// SPDX-License-Identifier: MIT
// Exit gradients: several soils in a box that is not full, mirror images, and faces above the exit point.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "physics/seepage_box.hpp"
#include "site/flow_measures.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

using namespace support;

input::Case make_case() {
  input::Case data;
  for (const char* name : {"soil", "other"}) {
    input::Material& soil = data.materials[name];
    soil.porosity = 0.4;
    soil.slices.unit_weight = std::string(name) == "soil" ? 20e3 : 14e3;
    data.regions[name] = name;
  }
  return data;
}

/// Names the sides between soil and empty elements whose normal out of the soil points along `axis`.
template <int D>
void name_inner_sides(mesh::Mesh<D>& mesh, const std::string& name, std::size_t axis) {
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      const int behind = mesh.neighbours[e][k];
      if (mesh.element_region[e] == mesh::empty_region || behind < 0 ||
          mesh.element_region[behind] != mesh::empty_region)
        continue;
      const std::array<double, D> inward = mesh::find_shape_gradient(mesh, e, k);
      if (std::abs(inward[axis]) < 0.7 * norm(inward)) continue;
      typename mesh::Mesh<D>::Side side;
      std::size_t n = 0;
      for (int j = 0; j <= D; ++j)
        if (j != k) side[n++] = mesh.elements[e][j];
      mesh.sides[name].push_back(side);
    }
}

template <int D>
results::FlowState measure(const mesh::Mesh<D>& mesh, const SeepageModel<D>& model) {
  const site::Site site(make_case());
  return site::FlowMeasures<D>(site, mesh, model).measure(fem::solve_steady_seepage<D>(model), 0);
}

const results::ExitGradient* find_exit(const results::FlowState& state, const std::string& name) {
  const auto found =
      std::find_if(state.exits.begin(), state.exits.end(), [&](const auto& exit) { return exit.name == name; });
  return found == state.exits.end() ? nullptr : &*found;
}

/// Two columns of soil with conductivities 500 apart, 1 m high under 1 m of empty elements, with heads of 2.4 m below
/// and 2 m above: the gradient is 0.4 in both, and the lighter soil has the smaller factor.
template <int D>
void check_columns(const std::array<int, D>& cells, const Vec<D>& size, double jitter) {
  auto mesh = make_soil_box<D>(
      cells, size, [&](const Vec<D>& x) { return x[1] > 1   ? mesh::empty_region
                                                 : x[0] < 1 ? 0
                                                            : 1; }, 0);
  name_inner_sides<D>(mesh, "ground", 1);
  if (jitter > 0)
    for (auto& x : mesh.nodes)
      if (x[1] > 0.1 && x[1] < 0.9) x[1] += jitter * std::sin(40 * x[0] + 7 * x[1]);
  mesh::finish(mesh, mesh::Order::as_given);
  SeepageModel<D> model{&mesh, {make_soil<D>(5e-5), make_soil<D>(1e-7)}, {}};
  model.boundaries = {make_condition(mesh, "bottom", HydraulicKind::total_head, 2.4),
                      make_condition(mesh, "ground", HydraulicKind::total_head, 2.0)};
  const results::FlowState state = measure<D>(mesh, model);
  ASSERT_EQ(state.exits.size(), 1u) << "water enters at the bottom";
  const results::ExitGradient& exit = state.exits[0];
  EXPECT_EQ(exit.name, "ground");
  EXPECT_NEAR(exit.gradient, 0.4, 1e-8);
  ASSERT_TRUE(exit.factor);
  EXPECT_NEAR(*exit.factor, (14e3 / gamma_w - 1) / 0.4, 1e-7);
  EXPECT_FALSE(exit.grows);
}

TEST(SeepageExits, HaveTheGradientOfEachSoilBesideEmptyElements) {
  check_columns<2>({8, 8}, {2, 2}, 0);
  check_columns<2>({8, 8}, {2, 2}, 0.02);
  check_columns<3>({4, 4, 2}, {2, 2, 1}, 0.02);
}

/// A pit beside a bank in a box: the soil is the box but for its upper right quarter.
mesh::Mesh<2> make_pit() {
  auto mesh = make_soil_box<2>(
      {16, 8}, {8, 4}, [](const Vec<2>& x) { return x[0] > 4 && x[1] > 2 ? mesh::empty_region : 0; }, 0);
  name_inner_sides<2>(mesh, "floor", 1);
  name_inner_sides<2>(mesh, "wall", 0);
  return mesh;
}

/// Mirrors the mesh about x = 4, and numbers nodes and elements from the other end.
mesh::Mesh<2> mirror(const mesh::Mesh<2>& mesh) {
  mesh::Mesh<2> other;
  const int last = mesh.node_count() - 1;
  for (int i = last; i >= 0; --i) other.nodes.push_back({8 - mesh.nodes[i][0], mesh.nodes[i][1]});
  for (int e = mesh.element_count() - 1; e >= 0; --e) {
    const auto& n = mesh.elements[e];
    other.elements.push_back({last - n[1], last - n[0], last - n[2]});
    other.element_region.push_back(mesh.element_region[e]);
  }
  other.region_names = mesh.region_names;
  for (const auto& [name, sides] : mesh.sides)
    for (const auto& side : sides) other.sides[name].push_back({last - side[0], last - side[1]});
  mesh::finish(other, mesh::Order::as_given);
  return other;
}

TEST(SeepageExits, OfAMirrorImageAreMirrored) {
  const auto compute = [](const mesh::Mesh<2>& mesh) {
    SeepageModel<2> model{&mesh, {make_soil<2>(1e-5)}, {}};
    model.soils[0].retention = material::LinearRetention::from_scale(0.1, 1, 0.5 * gamma_w);
    model.soils[0].relative =
        material::make_conductivity_table({{0, 1}, {0.5 * gamma_w, 1e-3}}, material::Interpolation::linear, false);
    model.boundaries = {make_condition(mesh, "left", HydraulicKind::reservoir, 3.5),
                        make_condition(mesh, "wall", HydraulicKind::seepage_face),
                        make_condition(mesh, "floor", HydraulicKind::seepage_face)};
    return measure<2>(mesh, model);
  };
  const mesh::Mesh<2> pit = make_pit(), image = mirror(pit);
  const results::FlowState one = compute(pit), other = compute(image);
  ASSERT_EQ(one.exits.size(), 2u) << "no water leaves at the reservoir";
  for (const char* name : {"wall", "floor"}) {
    const auto *here = find_exit(one, name), *there = find_exit(other, name);
    ASSERT_TRUE(here != nullptr && there != nullptr) << name;
    EXPECT_NEAR(here->gradient, there->gradient, 1e-9) << name;
    EXPECT_NEAR(here->at[0] + there->at[0], 8, 1e-9) << name;
    EXPECT_NEAR(here->at[1], there->at[1], 1e-9) << name;
    EXPECT_EQ(here->factor.has_value(), there->factor.has_value()) << name;
    EXPECT_LE(here->at[1], 4) << name;
  }
  EXPECT_TRUE(find_exit(one, "floor")->factor) << "the toe of the wall is the end of level ground too";
}

nlohmann::json run(const std::string& text, const std::string& name) {
  run::RunOptions options;
  options.folder = make_scratch("seepage_exits") / name;
  options.overwrite = true;
  return support::run_case(input::read_case_text(text, "flow.toml"), options);
}

/// A dam of van Genuchten's soil in a box, with the pool on its slope and a seepage face on the other one; mirrored for
/// `side` = -1.
std::string write_dam(int side, double head) {
  const auto x = [&](int at) { return side * at; };
  return fmt::format(R"(
analysis.methods = ["seepage"]
mesh.size = 1.3
initial.pore_pressure = "seepage"
geometry.polygon = [{{ name = "a", points = [[{0}, -4], [{1}, -4], [{1}, 0], [{2}, 0], [{3}, 6], [{4}, 6], [0, 0], [{0}, 0]] }}]
geometry.line = [{{ name = "pool", points = [[{0}, 0], [0, 0], [{4}, 6]] }}, {{ name = "air", points = [[{3}, 6], [{2}, 0], [{1}, 0]] }}]
regions.a = "sand"
hydraulic = [{{ on = "pool", condition = "total_head", head = {5} }}, {{ on = "air", condition = "seepage_face" }}]
[materials.sand]
unit_weight = 20
porosity = 0.4
[materials.sand.water]
retention = "van_genuchten"
reference_pressure = "8 kPa"
lambda = 0.4
relative_conductivity = "constant"
conductivity = "1e-5 m/s"
)",
                     x(-6), x(26), x(20), x(12), x(8), head);
}

TEST(SeepageExits, OfADamAreAtItsToe) {
  // Without a toe drain the largest gradient is at the toe, where the level ground ends.
  std::array<double, 2> gradients{};
  for (const int side : {1, -1}) {
    const nlohmann::json state = run(write_dam(side, 4), "toe").at("flow").at("states").back();
    ASSERT_EQ(state.at("exits").size(), 1u);
    const nlohmann::json& exit = state.at("exits")[0];
    EXPECT_EQ(exit.at("name"), "air");
    EXPECT_NEAR(exit.at("at")[0].get<double>(), 20 * side, 1e-9);
    EXPECT_NEAR(exit.at("at")[1].get<double>(), 0, 1e-9);
    ASSERT_TRUE(exit.contains("factor")) << side;
    gradients[side < 0] = exit.at("gradient").get<double>();
    EXPECT_NEAR(exit.at("factor").get<double>() * gradients[side < 0], 20e3 / gamma_w - 1, 1e-9);
  }
  EXPECT_NEAR(gradients[1] / gradients[0], 1, 0.05) << "meshes are no mirror images";
}

TEST(SeepageExits, HaveTheSameBitsInEveryRun) {
  const nlohmann::json first = run(write_dam(1, 1), "a").at("flow").at("states");
  const nlohmann::json second = run(write_dam(1, 1), "b").at("flow").at("states");
  EXPECT_EQ(first, second);
  for (const auto& exit : first.back().at("exits")) {
    EXPECT_EQ(exit.at("name"), "air") << "water enters from the pool";
    EXPECT_NEAR(exit.at("at")[1].get<double>(), 0, 1e-9) << "the slope is dry";
    EXPECT_LT(exit.at("gradient").get<double>(), 1);
  }
}

TEST(SeepageExits, OfAVerticalFaceAreBelowTheExitPoint) {
  // Dupuit's dam between 8 and 2 m. Through the face above the lower water leaves less than the whole flow of about
  // 1.9 k, over its wet height: a gradient of the order of 1.
  const nlohmann::json summary = run(R"(
analysis.methods = ["seepage"]
mesh.size = 0.4
geometry.box = [[-1, 0], [17, 11]]
geometry.polygon = [{ name = "s", points = [[0, 0], [16, 0], [16, 10], [0, 10]] }]
geometry.line = [
  { name = "up", points = [[0, 0], [0, 8]] },
  { name = "down", points = [[16, 0], [16, 2]] },
  { name = "face", points = [[16, 2], [16, 10]] },
]
regions.s = "s"
initial.pore_pressure = "seepage"
hydraulic = [
  { on = "up", condition = "total_head", head = 8 }, { on = "down", condition = "total_head", head = 2 },
  { on = "face", condition = "seepage_face" }]
[materials.s]
unit_weight = 20
porosity = 0.4
[materials.s.water]
retention = "van_genuchten"
reference_pressure = 2
lambda = 0.7
minimum_saturation = 0.05
relative_conductivity = "mualem"
conductivity = "1e-5 m/s"
)",
                                     "face");
  const nlohmann::json& state = summary.at("flow").at("states").back();
  EXPECT_NEAR(state.at("outflow").get<double>(), 1.9e-5, 0.1e-5);
  const double exit_point = [&] {
    for (const auto& exit : summary.at("seepage").at("exits"))
      if (exit.at("name") == "face") return exit.at("highest")[1].get<double>();
    return 0.0;
  }();
  EXPECT_GT(exit_point, 2);
  int faces = 0;
  for (const auto& exit : state.at("exits")) {
    EXPECT_NE(exit.at("name"), "up");
    if (exit.at("name") != "face") continue;
    ++faces;
    EXPECT_LE(exit.at("at")[1].get<double>(), exit_point + 1e-9);
    EXPECT_GT(exit.at("gradient").get<double>(), 0.3);
    EXPECT_LT(exit.at("gradient").get<double>(), 3);
  }
  EXPECT_EQ(faces, 1);
}

}  // namespace
}  // namespace talus
