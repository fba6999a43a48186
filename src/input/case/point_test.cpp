// SPDX-License-Identifier: MIT
#include "input/case/point_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.hpp"
#include "input/case/checks.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, PointTest& t) {
  v.key("name", t.name, plain().required().example(R"("cell 100 kPa")"), "Name of the test in tables and pictures.");
  v.key("material", t.material, plain().required().example(R"("sand")"), "Its soil.");
  v.key("kind", t.kind, plain().required().example(R"("drained_triaxial")"), "What is done to the soil.");
  v.key("control", t.control, plain().allowed_unless("kind", t.kind, PointTestKind::wetting),
        "What the apparatus prescribes.");
  v.key("drainage", t.drainage, plain().allowed_with("kind", t.kind, PointTestKind::simple_shear),
        "What happens to the volume in simple shear.");
  using enum PointTestKind;
  v.key("confining_pressure", t.confining_pressure,
        quantity("kPa")
            .above(0)
            .needed_with("kind", t.kind, drained_triaxial)
            .or_with("kind", t.kind, undrained_triaxial)
            .or_with("kind", t.kind, isotropic_compression)
            .or_with("kind", t.kind, wetting)
            .example("100"),
        "Radial stress at the start: effective, of soil with suction net.");
  v.key("vertical_stress", t.vertical_stress,
        quantity("kPa")
            .above(0)
            .needed_with("kind", t.kind, oedometer)
            .or_with("kind", t.kind, k0_compression)
            .or_with("kind", t.kind, simple_shear)
            .example("25"),
        "Axial stress at the start: effective, of soil with suction net.");
  v.key("k0", t.k0, plain().above(0).allowed_unless("kind", t.kind, isotropic_compression).example("0.5"),
        "Radial over axial stress at the start. Required of tests with a vertical stress; 1 where not given.");
  v.key("axial_strain", Turns{t.axial_strain}, plain().above(-1).below(1).example("0.25"),
        "Axial strain at the end, or at each turning point; compression is positive, extension negative. In isotropic "
        "compression it is a third of the volumetric strain. Strain control only.");
  v.key("shear_strain", Turns{t.shear_strain}, plain().example("0.3"),
        "Engineering shear strain at the end, or at each turning point. Simple shear under strain control only.");
  v.key("axial_stress", Turns{t.axial_stress}, quantity("kPa").at_least(0).example("[400, 100, 800]"),
        "Axial stress at the end, or at each turning point: effective, total in undrained tests. Stress control only.");
  v.key("shear_stress", Turns{t.shear_stress}, quantity("kPa").example("40"),
        "Shear stress at the end, or at each turning point. Simple shear under stress control only.");
  v.key(
      "suction", Turns{t.suction}, quantity("kPa").at_least(0).example("60"),
      "Suction of the pore water: one value, which stays; in wetting the path, from the start on. 0 where not given.");
  v.key("steps", t.steps, plain().at_least(1).at_most(1e6), "Steps of the test, shared out among its legs.");
  v.key("set", t.set, plain().example("{ porosity = 0.4 }"),
        "Keys of the material that have another value in this test.");
}
namespace {

struct Subject : BlockFindings {
  const PointTest& test;
};

const char* find_goal(const PointTest& test) {
  const bool shears = test.kind == PointTestKind::simple_shear;
  if (test.kind == PointTestKind::wetting) return "suction";
  if (test.control == PointControl::strain) return shears ? "shear_strain" : "axial_strain";
  return shears ? "shear_stress" : "axial_stress";
}

void check_goals(const Subject& s) {
  if (!s.is_sound("kind") || !s.is_sound("control")) return;
  const std::string goal = find_goal(s.test);
  const char* why = s.test.kind == PointTestKind::wetting    ? "a wetting test follows it"
                    : s.test.control == PointControl::strain ? "control = \"strain\" needs it"
                                                             : "control = \"stress\" needs it";
  if (!s.is_given(goal)) s.report(goal, "missing key '{}' in [[test]]; {}", goal, why);
  for (const char* key : {"axial_strain", "shear_strain", "axial_stress", "shear_stress"})
    if (key != goal && s.is_given(key) && s.is_sound(key))
      s.report(key, "'{}' in [[test]] has no meaning here; this test follows '{}'", key, goal);
}

void check_start(const Subject& s) {
  if (!s.is_sound("kind") || !s.is_sound("k0") || s.test.has_cell() || s.test.k0) return;
  s.report("k0",
           "missing key 'k0' in [[test]], for example k0 = 0.5; a test with a vertical stress needs the radial stress "
           "at its start");
}

void check_suction(const Subject& s, const Case& data) {
  if (!s.is_sound("suction") || !s.is_sound("kind") || s.test.suction.empty()) return;
  const bool wets = s.test.kind == PointTestKind::wetting;
  if (wets && s.test.suction.size() < 2)
    return s.report("suction",
                    "'suction' of a wetting test is its path and needs at least two values, such as [60, 0]");
  if (!wets && s.test.suction.size() > 1)
    return s.report(
        "suction",
        "'suction' has {} values; only kind = \"wetting\" has a path of it, elsewhere it is one value, which stays",
        s.test.suction.size());
  const bool is_dry = *std::max_element(s.test.suction.begin(), s.test.suction.end()) == 0;
  if (s.test.kind == PointTestKind::undrained_triaxial && !is_dry)
    return s.report("suction", "an undrained test is one of saturated soil: its 'suction' must be 0");
  const auto soil = data.materials.find(s.test.material);
  if (is_dry || soil == data.materials.end() || soil->second.water.is_wet()) return;
  s.report("suction", "a suction needs the retention curve of the soil: add [materials.{}.water]", s.test.material);
}

void check_material(const Subject& s, const Case& data) {
  if (!s.is_sound("material") || !s.findings.is_sound("materials") || data.materials.count(s.test.material)) return;
  std::vector<std::string> names;
  for (const auto& entry : data.materials) names.push_back(entry.first);
  s.report("material", "there is no material '{}'; {}", s.test.material, talus::suggest(s.test.material, names));
}

}  // namespace

bool PointTest::is_triaxial() const {
  return kind == PointTestKind::drained_triaxial || kind == PointTestKind::undrained_triaxial;
}

bool PointTest::has_cell() const {
  return is_triaxial() || kind == PointTestKind::isotropic_compression || kind == PointTestKind::wetting;
}

const std::vector<double>& PointTest::goals() const {
  if (kind == PointTestKind::wetting) return suction;
  const bool shears = kind == PointTestKind::simple_shear;
  if (control == PointControl::strain) return shears ? shear_strain : axial_strain;
  return shears ? shear_stress : axial_stress;
}

const std::vector<PointQuantity>& list_point_quantities() {
  static const std::vector<PointQuantity> list{
      {"time", "running parameter", "", "-"},
      {"axial_strain", "axial strain", "εₐ", "-", PointQuantityKind::strain},
      {"radial_strain", "radial strain", "εᵣ", "-", PointQuantityKind::strain},
      {"shear_strain", "shear strain", "γ", "-", PointQuantityKind::strain},
      {"volumetric_strain", "volumetric strain", "εᵥ", "-", PointQuantityKind::strain},
      {"deviatoric_strain", "deviatoric strain", "", "-", PointQuantityKind::strain},
      {"axial_stress", "axial effective stress", "σ′ₐ", "Pa", PointQuantityKind::stress},
      {"radial_stress", "radial effective stress", "σ′ᵣ", "Pa", PointQuantityKind::stress},
      {"shear_stress", "shear stress", "τ", "Pa", PointQuantityKind::stress},
      {"p", "mean effective stress", "p′", "Pa", PointQuantityKind::stress},
      {"q", "deviatoric stress", "q", "Pa", PointQuantityKind::stress},
      {"pore_pressure", "excess pore pressure", "Δu", "Pa", PointQuantityKind::stress},
      {"suction", "suction", "s", "Pa", PointQuantityKind::stress},
      {"saturation", "degree of saturation", "S", "-"},
      {"void_ratio", "void ratio", "e", "-"},
      {"preconsolidation", "preconsolidation pressure", "p′c", "Pa", PointQuantityKind::stress},
  };
  return list;
}

PointQuantityKind find_point_quantity_kind(const std::string& name) {
  for (const PointQuantity& quantity : list_point_quantities())
    if (name == quantity.name) return quantity.kind;
  return PointQuantityKind::other;
}

void check_point_tests(const Case& data, Findings& findings) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < data.tests.size(); ++i) {
    const Subject subject{{findings, fmt::format("test.{}", i)}, data.tests[i]};
    const std::string& name = subject.test.name;
    if (subject.is_sound("name")) {
      // Names of results have the form test[NAME].q[0.1].
      if (name.find_first_of("[]/") != std::string::npos)
        subject.report("name", "the name '{}' must not hold any of [ ] /", name);
      else if (!names.insert(name).second)
        subject.report("name", "there are two tests named '{}'", name);
    }
    check_material(subject, data);
    check_goals(subject);
    check_start(subject);
    check_suction(subject, data);
  }
}

}  // namespace talus::input
