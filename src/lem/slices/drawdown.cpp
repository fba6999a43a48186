// SPDX-License-Identifier: MIT
// The stages of a rapid drawdown (Duncan, Wright and Wong 1990; USACE EM 1110-2-1902, 2003, appendix G).

#include <algorithm>
#include <cmath>
#include <limits>

#include "lem/slices/mass.hpp"

namespace talus::lem {

namespace {

void set_strength(const BaseStrength& strength, Slice& slice) {
  slice.cohesion = strength.cohesion;
  slice.tan_friction = strength.tan_friction;
  slice.pore_pressure = strength.pore_pressure;
}

/// Returns N'/l of a slice with forces. Suction counts as cohesion, so u is not negative.
double find_effective_normal(const Slice& slice) {
  return slice.normal / slice.length - std::max(0.0, slice.pore_pressure);
}

/// Sets the undrained strengths of the slices in soils with an R envelope.
void set_undrained(const Section& section, CutSurface& cut) {
  cut.bases.assign(cut.slices.size(), {});
  for (std::size_t i = 0; i < cut.slices.size(); ++i) {
    const Slice& before = cut.before[i];
    Slice& slice = cut.slices[i];
    DrawnBase& base = cut.bases[i];
    base.normal = find_effective_normal(before);
    base.shear = before.shear / before.length;
    const Soil& soil = section.soils[static_cast<std::size_t>(slice.soil)];
    if (!soil.envelope) continue;
    // Cohesion of roots is added to the undrained strength; that of suction is lost in undrained shear.
    const EffectiveStrength effective{before.cohesion - before.root_cohesion - before.suction_strength,
                                      soil.friction_angle};
    base.strength = slice.root_cohesion + find_undrained_strength(section.drawdown->method, *soil.envelope, effective,
                                                                  base.normal, base.shear);
    base.drains = false;
    set_strength({*base.strength, 0, 0}, slice);
  }
}

/// Restores the drained strength where it is lower, by the total normal stresses of the second stage. Returns true if
/// any slice changed.
bool drain_weaker(CutSurface& cut) {
  bool changed = false;
  for (std::size_t i = 0; i < cut.slices.size(); ++i) {
    DrawnBase& base = cut.bases[i];
    if (!base.strength) continue;
    Slice& slice = cut.slices[i];
    const BaseStrength& drained = cut.drained[i];
    const double normal = slice.normal / slice.length - std::max(0.0, drained.pore_pressure);
    if (drained.cohesion + normal * drained.tan_friction >= *base.strength) continue;
    base.drains = changed = true;
    set_strength(drained, slice);
  }
  return changed;
}

}  // namespace

double find_undrained_strength(DrawdownMethod method, const UndrainedEnvelope& envelope,
                               const EffectiveStrength& effective, double normal, double shear) {
  const double sine = std::sin(effective.friction_angle), cosine = std::cos(effective.friction_angle),
               tangent = sine / cosine;
  const double c = effective.cohesion, at_failure = c + normal * tangent;
  if (method == DrawdownMethod::corps_1970)
    return std::max(0.0, std::min(envelope.cohesion + normal * std::tan(envelope.friction_angle), at_failure));
  const double sine_r = std::sin(envelope.friction_angle), cosine_r = std::cos(envelope.friction_angle);
  const double isotropic = (envelope.cohesion * cosine_r + normal * sine_r) * cosine / (1 - sine_r);
  const double least = normal + shear * (sine - 1) / cosine;
  const double least_at_failure = (normal - c * cosine) * (1 - sine) / (cosine * cosine);  // σ'_3f; `least` is σ'_3c
  if (!(least > 0 && least_at_failure > 0)) return std::max(0.0, std::min(isotropic, at_failure));
  const double kf = (normal + c * cosine) * (1 + sine) / ((normal - c * cosine) * (1 - sine));
  const double k1 = std::min(kf, (normal + shear * (sine + 1) / cosine) / least);
  return std::max(0.0, ((kf - k1) * isotropic + (k1 - 1) * at_failure) / (kf - 1));
}

void keep_drained_strengths(CutSurface& cut) {
  cut.bases.clear();
  cut.drained.clear();
  if (cut.before.empty()) return;
  for (const Slice& slice : cut.slices)
    cut.drained.push_back({slice.cohesion, slice.tan_friction, slice.pore_pressure});
}

Solution solve_drawdown(const Slope& slope, CutSurface& cut, Method method, const Checks& all, bool keep_forces) {
  Checks checks = all;
  checks.most_below_wedges = std::numeric_limits<double>::infinity();  // undrained strengths exist on bases only
  const Section& section = slope.section();
  const bool is_effective = section.drawdown->method == DrawdownMethod::b_bar;
  for (std::size_t i = 0; i < cut.slices.size(); ++i) set_strength(cut.drained[i], cut.slices[i]);
  Solution before;
  before.method = method;
  before.refusal = cut.refusal;
  if (cut.refusal != Refusal::none) return before;
  if (!is_effective || keep_forces) {
    std::swap(cut.slices, cut.before);
    before = solve_with(*slope.before(), cut, method, checks, true, section.horizontal_acceleration);
    std::swap(cut.slices, cut.before);
  }
  Solution after;
  if (is_effective) {  // the factor before drawdown is only reported
    after = solve_with(slope, cut, method, checks, keep_forces, section.horizontal_acceleration);
  } else {
    if (before.refusal != Refusal::none) return before;
    set_undrained(section, cut);
    const bool has_third = section.drawdown->method == DrawdownMethod::three_stage;
    Checks second = checks;
    second.reject = checks.reject && !has_third;  // else the third stage is checked instead
    after = solve_with(slope, cut, method, second, keep_forces || has_third, section.horizontal_acceleration);
    const double undrained = after.factor;
    if (has_third && after.refusal == Refusal::none) {
      if (drain_weaker(cut)) {
        after = solve_with(slope, cut, method, checks, keep_forces, section.horizontal_acceleration);
      } else if (checks.reject) {
        after.refusal = check_solution(cut, after, checks);
        if (after.refusal != Refusal::none) after.factor = 0;
      }
      after.undrained = undrained;
    }
  }
  after.before = before.factor;
  if (!keep_forces) cut.bases.clear();
  return after;
}

}  // namespace talus::lem
