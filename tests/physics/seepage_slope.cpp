// SPDX-License-Identifier: MIT
// The unsaturated slope of section 3.4.2: steady seepage, and suction and saturation at the crest.

#include <gtest/gtest.h>

#include "mesh/generate.hpp"
#include "physics/seepage_box.hpp"

namespace talus {
namespace {

using namespace support;

mesh::Mesh<2> make_slope(double size) {
  mesh::Plan plan;
  plan.box_max = {44, 17};
  plan.size = size;
  plan.polygons = {{"soil", {{0, 0}, {44, 0}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}}};
  plan.lines = {{"face", {{0, 15}, {12, 15}, {32, 5}}}, {"foot", {{32, 5}, {44, 5}}}};
  return mesh::generate<2>(plan);
}

SeepageModel<2> make_model(const mesh::Mesh<2>& mesh, const material::Conductivity& law) {
  auto soil = make_soil<2>(material::find_conductivity(6e-11, 1000, 9.81, 1e-3));
  soil.retention = material::VanGenuchten{0.15, 1.0, 6.13e3, 0.27};  // Table 3.4
  soil.relative = law;
  soil.water_modulus = 80e6;
  SeepageModel<2> model{&mesh, {soil}, {}};
  model.boundaries = {make_condition(mesh, "left", HydraulicKind::total_head, 10),
                      make_condition(mesh, "face", HydraulicKind::seepage_face),
                      make_condition(mesh, "foot", HydraulicKind::total_head, 5)};
  return model;
}

std::size_t find_node(const mesh::Mesh<2>& mesh, double x, double y) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i) {
    const auto distance = [&](std::size_t n) { return std::hypot(mesh.nodes[n][0] - x, mesh.nodes[n][1] - y); };
    if (distance(i) < distance(best)) best = i;
  }
  return best;
}

TEST(SeepageSlope, CrestHasThePublishedSuctionAndSaturation) {
  // Printed: at most 56 kPa, 0.52, with a constant conductivity; shown for elements and material points of 0.75 m,
  // whose mean lies below the crest's own value.
  const auto mesh = make_slope(0.75);
  const auto model = make_model(mesh, material::ConstantConductivity{});
  const auto r = fem::solve_steady_seepage(model);
  const std::size_t crest = find_node(mesh, 12, 15);
  EXPECT_LT(relative_balance(r), 1e-10);
  EXPECT_NEAR(r.pressure[crest], 59.5e3, 0.5e3);  // our own value, with 1.5 m and 0.4 m elements as well
  EXPECT_NEAR(r.pressure[find_node(mesh, 0, 15)], 49.05e3, 1);
  double most = 0, least = 1;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    double mean = 0;
    for (int node : mesh.elements[e]) mean += r.pressure[static_cast<std::size_t>(node)] / 3;
    most = std::max(most, mean);
    least = std::min(least, r.saturation[e]);
  }
  EXPECT_NEAR(most, 56e3, 4e3);
  EXPECT_NEAR(least, 0.52, 0.01);
  // the water table leaves the slope above the toe
  ASSERT_EQ(r.exits.size(), 1u);
  EXPECT_NEAR(r.exits[0].highest[1], 5.7, 0.4);
  ASSERT_EQ(r.water_table.size(), 1u);
  EXPECT_NEAR(r.water_table[0].front()[1], 10, 1e-9);
}

TEST(SeepageSlope, MualemsConductivityDriesTheCrestALittleMore) {
  const auto mesh = make_slope(1.0);
  const auto constant = fem::solve_steady_seepage(make_model(mesh, material::ConstantConductivity{}));
  const std::size_t crest = find_node(mesh, 12, 15);
  for (auto measure : {material::SaturationMeasure::total, material::SaturationMeasure::effective}) {
    const auto r = fem::solve_steady_seepage(make_model(mesh, material::Mualem{0.27, measure}));
    EXPECT_LT(relative_balance(r), 1e-10);
    EXPECT_GT(r.pressure[crest], constant.pressure[crest] + 1e3);  // less water flows above the water table
    EXPECT_LT(r.pressure[crest], constant.pressure[crest] + 4e3);
    EXPECT_LT(r.inflow, 0.85 * constant.inflow);
  }
}

TEST(SeepageSlope, SoilsFromGravelToClayConvergeWithAndWithoutRain) {
  const auto mesh = make_slope(1.0);
  struct Soil {
    const char* name;
    double conductivity, reference, lambda;
    std::vector<double> rain;  // over k_s; negative: evaporation
  };
  // Gravel under moderate rain is left out: its fringe of 3 cm needs elements of its size.
  for (const Soil& s :
       {Soil{"gravel", 1e-2, 300, 0.7, {0, 3}}, Soil{"sand", 8e-5, 700, 0.62, {0, 0.01, 0.3, 3}},
        Soil{"silt", 7e-7, 6e3, 0.29, {0, 0.01, 0.3, 3}}, Soil{"clay", 5e-8, 12e3, 0.08, {0, 0.01, 0.3, 3, -1e-3}}}) {
    for (double rain : s.rain) {
      const auto measure = material::SaturationMeasure::effective;
      auto model = make_model(mesh, material::Mualem{s.lambda, measure});
      auto& soil = model.soils[0];
      soil.conductivity = {s.conductivity, s.conductivity};
      soil.retention = material::VanGenuchten{0.1, 1, s.reference, s.lambda};
      if (s.lambda < 0.2)  // its conductivity would halve within 1 Pa
        soil.relative = material::Mualem::with_air_entry(s.lambda, measure, soil.retention, 500);
      auto& face = model.boundaries[1];
      face.kind = HydraulicKind::rain;
      face.measure = fem::FluxMeasure::vertical;
      face.value = rain * s.conductivity;
      face.suction_limit = 500e3;
      const auto r = fem::solve_steady_seepage(model);
      EXPECT_LT(relative_balance(r), 1e-10) << s.name << " " << rain;
      EXPECT_EQ(r.undecided, 0) << s.name << " " << rain;
      const auto& d = r.discharges[1];
      if (rain >= 0) {
        EXPECT_NEAR(d.inflow + d.runoff, rain * s.conductivity * 32, 1e-9 * s.conductivity) << s.name << " " << rain;
      } else {
        EXPECT_EQ(d.inflow + d.runoff, 0);
      }
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        if (r.face[i] == fem::FaceState::open) {
          EXPECT_GE(r.pressure[i], 0) << s.name << " " << rain;
        }
      }
    }
  }
}

TEST(SeepageSlope, FaultsAreMessages) {
  const auto mesh = make_slope(2.0);
  const auto message = [&](const auto& change) -> std::string {
    auto model = make_model(mesh, material::ConstantConductivity{});
    change(model);
    try {
      (void)fem::solve_steady_seepage(model);
    } catch (const Error& e) {
      return e.what();
    }
    return "none";
  };
  using Model = SeepageModel<2>;
  const auto expect = [&](const std::string& part, const auto& change) {
    const std::string sentence = message(change);
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  };
  expect("porosity of 1", [](Model& m) { m.soils[0].porosity = 1; });
  expect("head of -3 m, which lies below the model", [](Model& m) { m.boundaries[2].value = -3; });
  expect("limits of saturation", [](Model& m) { m.soils[0].retention = material::VanGenuchten{0.8, 0.5, 1e3, 0.3}; });
  expect("different heads, 10 and 4 m",
         [&](Model& m) { m.boundaries.push_back(make_condition(mesh, "bottom", HydraulicKind::total_head, 4)); });
  expect("fluxes alone", [](Model& m) {
    for (auto& b : m.boundaries) b.kind = HydraulicKind::flux, b.value = 0;
  });
  expect("no surface of the soil",
         [&](Model& m) { m.boundaries.push_back(make_condition(mesh, "top", HydraulicKind::rain)); });
  EXPECT_EQ(message([](Model&) {}), "none");
}

}  // namespace
}  // namespace talus
