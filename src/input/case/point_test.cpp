// SPDX-License-Identifier: MIT
#include "input/case/point_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.hpp"
#include "input/case/checks.hpp"

namespace talus::input {
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
