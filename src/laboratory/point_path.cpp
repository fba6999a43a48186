// SPDX-License-Identifier: MIT
#include "laboratory/point_path.hpp"

#include <algorithm>
#include <cmath>

namespace talus::laboratory {
namespace {

using input::PointControl;
using input::PointTest;
using input::PointTestKind;

// Axial is y; lateral directions are x and z; shear is xy.
constexpr Voigt axial{0, 1, 0, 0, 0, 0}, lateral{1, 0, 1, 0, 0, 0}, lateral_mean{0.5, 0, 0.5, 0, 0, 0};
constexpr Voigt shear{0, 0, 0, 1, 0, 0}, all_round{1, 1, 1, 0, 0, 0};
constexpr Voigt at_constant_volume{-0.5, 1, -0.5, 0, 0, 0}, stress_difference{-0.5, 1, -0.5, 0, 0, 0};

Voigt scale(const Voigt& v, double factor) {
  Voigt out;
  for (std::size_t i = 0; i < v.size(); ++i) out[i] = v[i] * factor;
  return out;
}

}  // namespace

Cell find_start(const PointTest& test) {
  if (test.has_cell()) {
    const double radial = test.confining_pressure.value_or(0);
    return {radial / test.k0.value_or(1), radial};
  }
  const double vertical = test.vertical_stress.value_or(0);
  return {vertical, vertical * test.k0.value_or(1)};
}

PointStep make_step(const PointTest& test, const Cell& start, double from, double to, double sucked) {
  PointStep step;
  const bool by_strain = test.control == PointControl::strain;
  const double d = to - from;
  const auto hold_radial = [&](double net) { step.add(lateral, lateral_mean, -(net + sucked)); };
  const auto hold_axial = [&](double net) { step.add(axial, axial, -(net + sucked)); };
  switch (test.kind) {
    case PointTestKind::isotropic_compression:
      if (by_strain) {
        step.fixed = scale(all_round, -d);
      } else {
        hold_axial(to);
        hold_radial(to);
      }
      break;
    case PointTestKind::k0_compression: {
      const double k0 = test.k0.value_or(1);
      if (by_strain) {
        step.fixed = scale(axial, -d);
        // σ'_r + χs = k0 (σ'_a + χs)
        Voigt ratio = lateral_mean;
        ratio[1] = -k0;
        step.add(lateral, ratio, (k0 - 1) * sucked);
      } else {
        hold_axial(to);
        hold_radial(k0 * to);
      }
      break;
    }
    case PointTestKind::oedometer:
      if (by_strain)
        step.fixed = scale(axial, -d);
      else
        hold_axial(to);
      break;
    case PointTestKind::drained_triaxial:
      if (by_strain)
        step.fixed = scale(axial, -d);
      else
        hold_axial(to);
      hold_radial(start.radial);
      break;
    case PointTestKind::undrained_triaxial:
      if (by_strain)
        step.fixed = scale(at_constant_volume, -d);
      else
        step.add(at_constant_volume, stress_difference, -(to - start.radial));
      break;
    case PointTestKind::simple_shear:
      if (by_strain)
        step.fixed = scale(shear, d);
      else
        step.add(shear, shear, to);
      if (test.drainage == input::ShearDrainage::drained) hold_axial(start.axial);
      break;
    case PointTestKind::wetting:
      hold_axial(start.axial);
      hold_radial(start.radial);
      break;
  }
  return step;
}

std::vector<double> list_turns(const PointTest& test) {
  std::vector<double> turns = test.goals();
  if (test.kind == PointTestKind::wetting) return turns;
  const bool from_stress = test.control == PointControl::stress && test.kind != PointTestKind::simple_shear;
  turns.insert(turns.begin(), from_stress ? find_start(test).axial : 0);
  return turns;
}

std::vector<double> list_values(const PointTest& test, std::vector<std::size_t>& reached) {
  const std::vector<double> turns = list_turns(test);
  double length = 0;
  for (std::size_t i = 1; i < turns.size(); ++i) length += std::abs(turns[i] - turns[i - 1]);
  std::vector<double> values{turns.front()};
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double leg = turns[i] - turns[i - 1];
    const int count = std::max(1, static_cast<int>(std::lround(test.steps * std::abs(leg) / std::max(length, 1e-300))));
    for (int k = 1; k <= count; ++k) values.push_back(k == count ? turns[i] : turns[i - 1] + leg * k / count);
    reached.push_back(values.size() - 1);
  }
  return values;
}

}  // namespace talus::laboratory
