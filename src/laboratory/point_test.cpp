// SPDX-License-Identifier: MIT
#include "laboratory/point_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "input/case/measured_table.hpp"
#include "laboratory/point_path.hpp"

namespace talus::laboratory {
namespace {

using input::PointControl;
using input::PointTest;
using input::PointTestKind;

constexpr double largest_strain = 2;  ///< [-]; beyond it, a soil that flows is stopped

PointRow make_row(const PointTest& test, const PointSoil& soil, const PointState& state, const Voigt& strain,
                  double time) {
  PointRow row;
  row.time = time;
  row.axial_strain = 0 - strain[1];  // no minus before a zero
  row.radial_strain = -(strain[0] + strain[2]) / 2;
  row.shear_strain = strain[3];
  row.volumetric_strain = -(strain[0] + strain[1] + strain[2]);
  const auto norm = [](const Voigt& v, double shear_factor) {  // of the deviator, ½ of engineering shear strains
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
  // Shows pure rounding as zero.
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

std::string describe_stop(const PointTest& test, const PointRow& row, double goal) {
  const std::string at = describe_place(test, row);
  if (test.kind == PointTestKind::wetting)
    return fmt::format("the soil does not carry the net stress below a suction of {:.4g} kPa ({})", row.suction / 1e3,
                       at);
  if (test.control == PointControl::strain)
    return fmt::format("the test ends at {}: no stress state of the soil satisfies the constraints of the apparatus",
                       at.substr(3));
  if (test.kind == PointTestKind::simple_shear)
    return fmt::format("the soil carries a shear stress of {:.4g} kPa and no more ({}); {:.4g} kPa were asked for",
                       row.shear_stress / 1e3, at, goal / 1e3);
  return fmt::format("the soil carries an axial stress of {:.4g} kPa and no more ({}); {:.4g} kPa were asked for",
                     (row.axial_stress + row.pore_pressure) / 1e3, at, goal / 1e3);
}

}  // namespace

PointCurve run_point_test(const input::Material& material, const PointTest& test) try {
  const Cell start = find_start(test);
  const bool wets = test.kind == PointTestKind::wetting;
  double suction = test.suction.empty() ? 0 : test.suction.front();
  const PointSoil soil(material, {-start.radial, -start.axial, -start.radial, 0, 0, 0}, suction);
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
      throw Error(ExitCode::unstable, fmt::format("the model gives no number at step {} of {}", i, values.size() - 1));
    // A step that was followed in part has taken the soil to where it gives way.
    if (follows || increment != Voigt{}) curve.rows.push_back(row);
    if (!follows || (step.free_count > 0 && largest > largest_strain)) {
      if (!follows && controller.has_model_failed()) {
        soil.throw_failure();
        throw Error(ExitCode::unstable, fmt::format("the model of '{}' gives no number {}, however small the step",
                                                    test.material, describe_place(test, curve.rows.back())));
      }
      curve.stopped = describe_stop(test, curve.rows.back(), test.goals().back());
      break;
    }
  }
  for (const std::size_t step : reached)
    if (step < curve.rows.size()) curve.turns.push_back(step);
  return curve;
} catch (const Error& error) {
  throw Error(error.code(), fmt::format("test '{}': {}", test.name, error.what()));
}

double get_quantity(const PointRow& row, const std::string& name) {
  // In the order of the list.
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
