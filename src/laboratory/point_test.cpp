// SPDX-License-Identifier: MIT
#include "laboratory/point_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "input/case/calibration.hpp"

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

namespace {

constexpr double largest_strain = 2;  ///< [-]; a soil that flows is stopped at this strain

PointRow make_row(const PointTest& test, const PointSoil& soil, const PointState& state, const Voigt& strain,
                  double time) {
  PointRow row;
  row.time = time;
  row.axial_strain = 0 - strain[1];  // avoids a negative zero
  row.radial_strain = -(strain[0] + strain[2]) / 2;
  row.shear_strain = strain[3];
  row.volumetric_strain = -(strain[0] + strain[1] + strain[2]);
  const auto norm = [](const Voigt& v, double shear_factor) {  // of the deviator, with ½ for engineering shear strains
    const double mean = (v[0] + v[1] + v[2]) / 3;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += (v[i] - mean) * (v[i] - mean);
    for (std::size_t i = 3; i < 6; ++i) sum += 2 * (shear_factor * v[i]) * (shear_factor * v[i]);
    return std::sqrt(sum);
  };
  row.deviatoric_strain = std::sqrt(2.0 / 3) * norm(strain, 0.5);
  const Voigt& s = state.stress;
  row.axial_stress = -s[1];
  row.radial_stress = -(s[0] + s[2]) / 2;
  row.shear_stress = s[3];
  row.p = -(s[0] + s[1] + s[2]) / 3;
  // Rounding errors are set to zero.
  double q = std::sqrt(1.5) * norm(s, 1);
  if (q < 1e-7 * std::abs(row.p)) q = 0;
  if (std::abs(row.volumetric_strain) < 1e-12) row.volumetric_strain = 0;
  row.q = q > 0 && test.kind != PointTestKind::simple_shear && row.axial_stress < row.radial_stress ? -q : q;
  if (test.kind == PointTestKind::undrained_triaxial) row.pore_pressure = find_start(test).radial - row.radial_stress;
  row.suction = state.suction;
  row.saturation = soil.find_saturation(state.suction);
  row.void_ratio = soil.find_void_ratio(state, row.volumetric_strain);
  row.preconsolidation = soil.find_preconsolidation(state);
  return row;
}

/// "at axial strain 1.2 %".
std::string describe_place(const PointTest& test, const PointRow& row) {
  const bool shears = test.kind == PointTestKind::simple_shear;
  return fmt::format("at {} strain {:.3g} %", test.get_strain_word(),
                     100 * (shears ? row.shear_strain : row.axial_strain));
}

std::string describe_stop(const PointTest& test, const PointRow& row, double goal, const ShownUnit& stress) {
  const std::string at = describe_place(test, row);
  if (test.kind == PointTestKind::wetting)
    return fmt::format("the soil does not carry the net stress below a suction of {} ({})",
                       format_value(row.suction, stress, 4), at);
  if (test.control == PointControl::strain)
    return fmt::format("the test ends at {}: no stress state of the soil satisfies the constraints of the apparatus",
                       at.substr(3));
  if (test.kind == PointTestKind::simple_shear)
    return fmt::format("the soil carries a shear stress of {} and no more ({}); {} were asked for",
                       format_value(row.shear_stress, stress, 4), at, format_value(goal, stress, 4));
  return fmt::format("the soil carries an axial stress of {} and no more ({}); {} were asked for",
                     format_value(row.axial_stress + row.pore_pressure, stress, 4), at, format_value(goal, stress, 4));
}

}  // namespace

PointCurve run_point_test(const input::Material& material, const PointTest& test, const ShownUnit& stress) try {
  const Cell start = find_start(test);
  const bool wets = test.kind == PointTestKind::wetting;
  double suction = test.suction.empty() ? 0 : test.suction.front();
  const PointSoil soil(material, {-start.radial, -start.axial, -start.radial, 0, 0, 0}, suction, stress);
  std::vector<std::size_t> reached;
  const std::vector<double> values = list_values(test, reached);
  PointController controller(soil);
  PointState state = soil.start();
  Voigt strain{};
  PointCurve curve;
  curve.rows.reserve(values.size());
  curve.rows.push_back(make_row(test, soil, state, strain, 0));
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (wets) suction = values[i];
    PointStep step = make_step(test, start, values[i - 1], values[i], soil.find_suction_stress(suction));
    step.suction = suction;
    Voigt increment;
    const bool follows = controller.advance(state, increment, step);
    double largest = 0;
    for (std::size_t k = 0; k < strain.size(); ++k) {
      strain[k] += increment[k];
      largest = std::max(largest, std::abs(strain[k]));
    }
    const PointRow row =
        make_row(test, soil, state, strain, static_cast<double>(i) / static_cast<double>(values.size() - 1));
    if (!std::isfinite(row.p) || !std::isfinite(row.q))
      throw Error(ExitCode::unstable, "the model gives NaN at step {} of {}", i, values.size() - 1);
    // A step that converged in part has brought the soil to failure.
    if (follows || increment != Voigt{}) curve.rows.push_back(row);
    if (!follows || (step.free_count > 0 && largest > largest_strain)) {
      if (!follows && controller.has_model_failed()) {
        soil.throw_failure();
        throw Error(ExitCode::unstable, "the model of '{}' gives no finite stress {}, however small the step",
                    test.material, describe_place(test, curve.rows.back()));
      }
      curve.stopped = describe_stop(test, curve.rows.back(), test.goals().back(), stress);
      break;
    }
  }
  for (const std::size_t step : reached)
    if (step < curve.rows.size()) curve.turns.push_back(step);
  return curve;
} catch (const Error& error) {
  throw Error(error.code(), "test '{}': {}", test.name, error.what());
}

double get_quantity(const PointRow& row, const std::string& name) {
  // The order is that of the list of names.
  static constexpr double PointRow::*values[] = {&PointRow::time,
                                                 &PointRow::axial_strain,
                                                 &PointRow::radial_strain,
                                                 &PointRow::shear_strain,
                                                 &PointRow::volumetric_strain,
                                                 &PointRow::deviatoric_strain,
                                                 &PointRow::axial_stress,
                                                 &PointRow::radial_stress,
                                                 &PointRow::shear_stress,
                                                 &PointRow::p,
                                                 &PointRow::q,
                                                 &PointRow::pore_pressure,
                                                 &PointRow::suction,
                                                 &PointRow::saturation,
                                                 &PointRow::void_ratio,
                                                 &PointRow::preconsolidation};
  return row.*values[input::find_point_quantity(name) - input::list_point_quantities().data()];
}

}  // namespace talus::laboratory
