// SPDX-License-Identifier: MIT
#include "laboratory/point_groups.hpp"

#include <algorithm>

namespace talus::laboratory {
namespace {

using input::PointTest;
using input::PointTestKind;
using results::PointGroup;
using results::PointPanel;

PointGroup describe_group(PointTestKind kind) {
  const auto make = [](const char* id, const char* title, std::vector<PointPanel> panels) {
    return PointGroup{id, title, "", std::move(panels), {}, {}, {}};
  };
  const PointPanel compression{"p", "void_ratio", true};
  switch (kind) {
    case PointTestKind::drained_triaxial:
      return make("drained_triaxial", "Drained triaxial tests",
                  {{"axial_strain", "q"}, {"axial_strain", "volumetric_strain"}, {"p", "q"}, compression});
    case PointTestKind::undrained_triaxial:
      return make("undrained_triaxial", "Undrained triaxial tests",
                  {{"axial_strain", "q"}, {"axial_strain", "pore_pressure"}, {"p", "q"}, compression});
    case PointTestKind::simple_shear:
      return make("simple_shear", "Simple shear tests",
                  {{"shear_strain", "shear_stress"},
                   {"shear_strain", "volumetric_strain"},
                   {"axial_stress", "shear_stress"},
                   compression});
    case PointTestKind::wetting:
      return make("wetting", "Wetting tests",
                  {{"suction", "volumetric_strain"},
                   {"suction", "preconsolidation"},
                   {"saturation", "volumetric_strain"},
                   compression});
    default:
      return make("compression", "Compression tests",
                  {compression, {"axial_stress", "axial_strain", true}, {"p", "q"}, {"axial_strain", "q"}});
  }
}

/// Number of `key` among the keys so far.
template <class Key>
int find_number(std::vector<Key>& keys, const Key& key) {
  const auto at = std::find(keys.begin(), keys.end(), key);
  if (at != keys.end()) return static_cast<int>(at - keys.begin());
  keys.push_back(key);
  return static_cast<int>(keys.size()) - 1;
}

std::string write_settings(const PointTest& test) {
  std::string text = test.material;
  for (const input::PointSetting& s : test.set) text += ";" + s.key + "=" + s.value;
  return text;
}

/// Everything about a test but its soil.
std::string write_path(const PointTest& test) {
  std::string text = std::to_string(static_cast<int>(test.kind)) + std::to_string(static_cast<int>(test.control)) +
                     std::to_string(static_cast<int>(test.drainage));
  for (const auto& value : {test.confining_pressure, test.vertical_stress, test.k0})
    text += ";" + std::to_string(value.value_or(-1));
  for (const auto* list : {&test.goals(), &test.suction})
    for (const double value : *list) text += ";" + std::to_string(value);
  return text;
}

/// Soil by colour and apparatus by dashes where a group has several of both, else each test its own colour.
void choose_lines(PointGroup& group, const std::vector<PointTest>& tests) {
  std::vector<std::string> soils, paths;
  for (const std::size_t i : group.tests) {
    group.colour.push_back(find_number(soils, write_settings(tests[i])));
    group.dash.push_back(find_number(paths, write_path(tests[i])));
  }
  if (soils.size() > 1 && paths.size() > 1) return;
  for (std::size_t i = 0; i < group.tests.size(); ++i) {
    group.colour[i] = static_cast<int>(i);
    group.dash[i] = 0;
  }
}

}  // namespace

std::vector<PointGroup> group_tests(const std::vector<PointTest>& tests) {
  std::vector<PointGroup> groups;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const PointGroup mine = describe_group(tests[i].kind);
    auto at = std::find_if(groups.begin(), groups.end(), [&](const PointGroup& g) { return g.id == mine.id; });
    if (at == groups.end()) at = groups.insert(groups.end(), mine);
    at->tests.push_back(i);
  }
  for (PointGroup& group : groups) choose_lines(group, tests);
  return groups;
}

}  // namespace talus::laboratory
