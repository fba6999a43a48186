// SPDX-License-Identifier: MIT
#include "material/cam_clay.hpp"

#include <fmt/format.h>

#include <cmath>

namespace talus::material {
namespace {

/// Returns M with its tan φ divided by `factor`.
double reduce_slope(double slope, double factor) {
  const double sine = std::min(3 * slope / (6 + slope), 0.9999);
  const double reduced = std::sin(std::atan(std::tan(std::asin(sine)) / factor));
  return 6 * reduced / (3 - reduced);
}

Property make_slope(const char* key, std::string title, const char* symbol, double slope) {
  return {key,    std::move(title),
          symbol, ShownAs::number,
          slope,  [slope](double factor) { return reduce_slope(slope, factor); }};
}

}  // namespace

void Preconsolidation::check(const SoilFindings& findings, const char* title) const {
  if (!findings.is_sound("preconsolidation") || !findings.is_sound("preconsolidation_ratio")) return;
  if (!preconsolidation && !preconsolidation_ratio)
    findings.add(
        "",
        fmt::format(
            "material '{}' is {}; give its 'preconsolidation', for example 125 (kPa), or its 'preconsolidation_ratio'",
            findings.name, title));
  else if (preconsolidation && preconsolidation_ratio)
    findings.add("preconsolidation_ratio",
                 fmt::format("material '{}' has both a preconsolidation and a preconsolidation_ratio; give one of them",
                             findings.name));
}

void RootParameters::check(const SoilFindings& findings) const {
  if (std::isfinite(breaking_strain) || !findings.is_sound("root_breaking_strain")) return;
  for (const char* key : {"root_breaking_range", "root_residual_share"})
    if (findings.is_given(key) && findings.is_sound(key))
      findings.add(
          key, fmt::format("'{}' has no meaning without 'root_breaking_strain', at which roots begin to break", key));
}

template <bool Rooted>
CamClay<Rooted> CamClay<Rooted>::make(const Input& in, const StrengthChange& change) {
  const CamClayInput& soil = in.template get<CamClayInput>();
  const CamClayParameters parameters{.compression = soil.compression,
                                     .swelling = soil.swelling,
                                     .poisson_ratio = in.template get<PoissonInput>().poisson_ratio,
                                     .critical_state_slope = soil.critical_state_slope,
                                     .suction_hardening = soil.suction_hardening,
                                     .smallest_pressure = soil.smallest_pressure,
                                     .strength_factor = change.factor};
  if constexpr (Rooted)
    return CamClay(parameters, in.template get<RootParameters>());
  else
    return CamClay(parameters);
}

template <bool Rooted>
void CamClay<Rooted>::check(const Input& in, const SoilFindings& findings) {
  const CamClayInput& clay = in.template get<CamClayInput>();
  if (findings.is_sound("lambda") && findings.is_sound("kappa") && clay.swelling >= clay.compression)
    findings.add("kappa", fmt::format("'kappa' is {:.6g} and 'lambda' is {:.6g}; κ must be smaller than λ",
                                      clay.swelling, clay.compression));
  if (findings.is_sound("porosity") && findings.is_sound("void_ratio") && findings.porosity <= 0)
    findings.add(
        findings.gives_void_ratio ? "void_ratio" : "porosity",
        fmt::format("material '{}' has no pores, but the stiffness and the hardening of Cam-clay follow from its void "
                    "ratio; give one above 0",
                    findings.name));
  in.template get<Preconsolidation>().check(findings, "Cam-clay");
  if constexpr (Rooted) in.template get<RootParameters>().check(findings);
}

template <bool Rooted>
Properties CamClay<Rooted>::list_properties(const Input& in) {
  const CamClayInput& clay = in.template get<CamClayInput>();
  const Preconsolidation& set = in.template get<Preconsolidation>();
  Properties list{
      {"lambda", "slope of the normal-compression line", "λ", ShownAs::number, clay.compression, {}},
      {"kappa", "slope of the swelling lines", "κ", ShownAs::number, clay.swelling, {}},
      make_slope("critical_state_slope", "slope of the critical-state line", "M₀", clay.critical_state_slope),
      {"preconsolidation",
       "preconsolidation pressure, saturated and without roots",
       "p′c₀",
       ShownAs::stress,
       set.preconsolidation,
       {}},
      {"preconsolidation_ratio", "preconsolidation ratio", "R₀", ShownAs::number, set.preconsolidation_ratio, {}}};
  if (clay.suction_hardening != 0)
    list.push_back({"suction_hardening", "hardening by suction", "b", ShownAs::number, clay.suction_hardening, {}});
  list.push_back(
      {"smallest_pressure", "floor of p′ in the bulk modulus", "p′min", ShownAs::stress, clay.smallest_pressure, {}});
  return list;
}

template <bool Rooted>
Properties CamClay<Rooted>::list_root_properties(const Input& in, double content) {
  Properties list;
  if constexpr (Rooted) {
    const RootParameters& r = in.template get<RootParameters>();
    list = {
        {"root_hardening", "hardening by roots, per per cent", "Rp", ShownAs::per_per_cent, r.hardening, {}},
        {"root_strength", "slope gained by roots, per per cent", "Ra", ShownAs::per_per_cent, r.strength, {}},
        {"root_activation", "activation of roots, in the place of Rp mr", "Rp mr", ShownAs::number, r.activation, {}}};
    if (std::isfinite(r.breaking_strain))
      list.insert(
          list.end(),
          {{"root_breaking_strain",
            "activation strain at which roots begin to break",
            "εr,peak",
            ShownAs::number,
            r.breaking_strain,
            {}},
           {"root_breaking_range",
            "activation strain within which they break",
            "Δεr",
            ShownAs::number,
            r.breaking_range,
            {}},
           {"root_residual_share", "share of the roots that stays", "", ShownAs::number, r.residual_share, {}}});
    if (content > 0)
      list.push_back(make_slope("critical_state_slope_rooted",
                                fmt::format("slope of the critical-state line with {:.3g} % of roots", content), "Mr",
                                in.template get<CamClayInput>().critical_state_slope + r.strength * content));
  }
  return list;
}

template <bool Rooted>
CamClay<Rooted>::CamClay(const CamClayParameters& soil, const RootParameters& roots)
    : soil_(soil),
      roots_(roots),
      activation_(roots.activation.value_or(-1)),
      over_swelling_(1 / soil.swelling),
      over_plastic_slope_(1 / (soil.compression - soil.swelling)),
      shear_ratio_(1.5 * (1 - 2 * soil.poisson_ratio) / (1 + soil.poisson_ratio)),
      floor_(1e-3 * soil.smallest_pressure),
      over_range_(1 / std::max(roots.breaking_range, 1e-12)),
      breaks_(std::isfinite(roots.breaking_strain)) {
  const double slope = reduce(soil_.critical_state_slope);
  slope_square_ = slope * slope;
}

template <bool Rooted>
double CamClay<Rooted>::find_preconsolidation(const double* state, double saturation) const {
  if (!(state[1] < set_below)) return not_set;
  double exponent = soil_.suction_hardening * (1 - saturation);
  if constexpr (Rooted) exponent += state[6] * state[4];
  return find_preconsolidation(state[1], exponent);
}

template <bool Rooted>
void CamClay<Rooted>::set_initial_state(const double* sigma, double e, double content, double preconsolidation,
                                        double saturation, double* state) const {
  state[0] = 0;
  state[2] = e;
  double exponent = soil_.suction_hardening * (1 - saturation);
  if constexpr (Rooted) {
    state[3] = content;
    state[4] = roots_.hardening * content;
    state[5] = 0;
    state[6] = 1;
    exponent += state[4];
  }
  const double needed = std::max(find_pressure(sigma), floor_) * std::exp(-limit_exponent(exponent));
  state[1] = preconsolidation < set_below ? std::max(preconsolidation, needed) : not_set;
}

template <bool Rooted>
void CamClay<Rooted>::show(const double* state, double saturation, double* values) const {
  const double pressure = find_preconsolidation(state, saturation);
  values[0] = is_set(pressure) ? pressure : std::numeric_limits<double>::quiet_NaN();
  values[1] = state[2];
  if constexpr (Rooted) {
    values[2] = state[3];
    values[3] = state[5];
    values[4] = state[6];
  }
}

template class CamClay<false>;
template class CamClay<true>;

}  // namespace talus::material
