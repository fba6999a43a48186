#include "laboratory/point_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "laboratory/point_words.hpp"
#include "output/files/history.hpp"

namespace talus::laboratory {
namespace {

bool is_stress(const input::PointQuantity& quantity) {
  return std::string(quantity.unit) == "Pa";
}

}  // namespace

std::string write_point_table(const PointCurve& curve, const std::string& stress_unit) {
  const auto& quantities = input::list_point_quantities();
  const double si = units::get_si_factor(stress_unit);
  std::string text;
  for (const input::PointQuantity& q : quantities)
    text += fmt::format("{}{} [{}]", text.empty() ? "" : ",", q.name, is_stress(q) ? stress_unit : q.unit);
  text += '\n';
  for (const PointRow& row : curve.rows) {
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const double value = get_quantity(row, quantities[i].name);
      // Ten digits: what is beyond them is the rounding of sums of thousands of increments.
      text += (i > 0 ? "," : "") + fmt::format("{:.10g}", is_stress(quantities[i]) ? value / si : value);
    }
    text += '\n';
  }
  return text;
}

const PointRow& find_peak(const PointCurve& curve) {
  return *std::max_element(curve.rows.begin(), curve.rows.end(),
                           [](const PointRow& a, const PointRow& b) { return std::abs(a.q) < std::abs(b.q); });
}

std::optional<double> find_point_result(const PointCurve& curve, const input::PointTest& test,
                                        const input::PointResultName& name) {
  if (name.quantity == "peak_q") return find_peak(curve).q;
  if (!name.strain) {
    if (!curve.stopped.empty()) return std::nullopt;  // the end was not reached
    return get_quantity(curve.rows.back(), name.quantity);
  }
  const auto strain =
      test.kind == input::PointTestKind::simple_shear ? &PointRow::shear_strain : &PointRow::axial_strain;
  // A goal of 0.1 that is reached by a thousand steps may end a rounding error short of it.
  const double slack = 1e-9;
  for (std::size_t i = 1; i < curve.rows.size(); ++i) {
    const PointRow &a = curve.rows[i - 1], &b = curve.rows[i];
    const double from = a.*strain, to = b.*strain;
    if (std::min(from, to) - slack > *name.strain || std::max(from, to) + slack < *name.strain) continue;
    const double share = to == from ? 1 : std::clamp((*name.strain - from) / (to - from), 0.0, 1.0);
    return (1 - share) * get_quantity(a, name.quantity) + share * get_quantity(b, name.quantity);
  }
  return std::nullopt;
}

results::PointTest describe_point_test(const input::PointTest& test, const PointCurve& curve, const std::string& file) {
  const PointRow& peak = find_peak(curve);
  results::PointTest told;
  told.name = test.name;
  told.material = test.material;
  told.kind = name_kind(test);
  told.path = describe_path(test);
  told.set = describe_settings(test);
  told.file = file;
  told.steps = curve.rows.size() - 1;
  told.turns = curve.turns;
  told.stopped = curve.stopped;
  told.peak_q = peak.q;
  told.peak_q_strain = test.kind == input::PointTestKind::simple_shear ? peak.shear_strain : peak.axial_strain;
  for (const input::PointQuantity& q : input::list_point_quantities())
    told.end[q.name] = get_quantity(curve.rows.back(), q.name);
  return told;
}

}  // namespace talus::laboratory
