#include "laboratory/point_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace talus::laboratory {
namespace {

using input::PointControl;
using input::PointTest;
using input::PointTestKind;

std::string in_kpa(double stress) {
  return fmt::format("{:.6g} kPa", stress / 1e3);
}

std::string in_per_cent(double strain) {
  return fmt::format("{:.6g} %", strain * 100);
}

std::string join(const std::vector<double>& values, std::string (*write)(double)) {
  std::string text;
  for (const double v : values) text += (text.empty() ? "" : ", ") + write(v);
  return text;
}

bool extends(const PointTest& test) {
  if (test.control == PointControl::strain) return !test.axial_strain.empty() && test.axial_strain.front() < 0;
  return !test.axial_stress.empty() && test.confining_pressure && test.axial_stress.front() < *test.confining_pressure;
}

std::string describe_goal(const PointTest& test) {
  if (test.kind == PointTestKind::wetting) return "suction " + join(test.suction, in_kpa);
  const bool shears = test.kind == PointTestKind::simple_shear;
  if (test.control == PointControl::strain)
    return (shears ? "to a shear strain of " : "to an axial strain of ") + join(test.goals(), in_per_cent);
  return (shears ? "to a shear stress of " : "to an axial stress of ") + join(test.goals(), in_kpa);
}

}  // namespace

std::string name_kind(const PointTest& test) {
  const std::string way = extends(test) ? "extension" : "compression";
  switch (test.kind) {
    case PointTestKind::isotropic_compression:
      return "isotropic compression";
    case PointTestKind::k0_compression:
      return "K0 compression";
    case PointTestKind::oedometer:
      return "oedometer";
    case PointTestKind::drained_triaxial:
      return "drained triaxial " + way;
    case PointTestKind::undrained_triaxial:
      return "undrained triaxial " + way;
    case PointTestKind::simple_shear:
      return test.drainage == input::ShearDrainage::drained ? "drained simple shear"
                                                            : "simple shear at constant volume";
    case PointTestKind::wetting:
      break;
  }
  const bool wets = test.suction.size() < 2 || test.suction[1] <= test.suction[0];
  return wets ? "wetting at constant net stress" : "drying at constant net stress";
}

std::string describe_path(const PointTest& test) {
  const double ratio = test.k0.value_or(1);
  const double radial =
      test.has_cell() ? test.confining_pressure.value_or(0) : test.vertical_stress.value_or(0) * ratio;
  const double axial = test.has_cell() ? radial / ratio : test.vertical_stress.value_or(0);
  std::string text = radial == axial ? fmt::format("from {} all round", in_kpa(axial))
                                     : fmt::format("from {} axial and {} radial stress", in_kpa(axial), in_kpa(radial));
  text += test.kind == PointTestKind::wetting ? "; " : " ";
  text += describe_goal(test);
  if (test.kind != PointTestKind::wetting) {
    text += test.control == PointControl::strain ? ", strain-controlled" : ", stress-controlled";
    if (!test.suction.empty() && test.suction.front() > 0)
      text += fmt::format(", at a suction of {}", in_kpa(test.suction.front()));
  }
  return text;
}

std::string describe_settings(const PointTest& test) {
  std::string text;
  for (const input::PointSetting& s : test.set) text += (text.empty() ? "" : ", ") + s.key + " = " + s.value;
  return text;
}

}  // namespace talus::laboratory
