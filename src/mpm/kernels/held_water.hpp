// SPDX-License-Identifier: MIT
#pragma once
// Water content of a node's pores as a function of pressure, H_i(p) of theory 22, and its linearisation for one
// solution.

#include <algorithm>
#include <cmath>

#include "mpm/kernels/pore_state.hpp"

namespace talus::mpm {

/// H_i(p) for the soils at one node. Laws, Pores: the types of the body, [material] and [material][node].
template <class Laws, class Pores>
class HeldWater {
 public:
  struct Value {
    double held = 0, storage = 0;  ///< [m³]; −d held/dp [m³/Pa]
  };

  TALUS_PORTABLE HeldWater(const Laws& laws, const Pores& pores, int node) : laws_(laws), pores_(pores), node_(node) {}

  TALUS_PORTABLE Value find(double p) const {
    Value sum;
    visit([&](const WaterLaw& law, double pores) {
      const material::SoilWater<double> water = material::find_water(law.retention, p);
      const double modulus = law.bulk_modulus, stretched = pores * std::exp(-p / modulus);
      double saturation = water.saturation, slope = water.slope;
      if (p > law.dry) {  // H falls with ln p to zero at 1 GPa, where all soil is dry
        const double decades = std::log(driest / law.dry), left = std::max(0.0, std::log(driest / p) / decades);
        slope = slope * left - saturation / (p * decades);
        saturation *= left;
      }
      sum.held += stretched * saturation;
      sum.storage += stretched * (saturation / modulus - slope);
    });
    return sum;
  }

  /// Value at zero pressure, with the storage of full pores under positive pressure.
  TALUS_PORTABLE Value find_full() const {
    Value sum;
    visit([&](const WaterLaw& law, double pores) {
      sum.held += pores * law.full;
      sum.storage += pores * law.full / law.bulk_modulus;
    });
    return sum;
  }

  /// Returns whether a soil releases water under suction; otherwise the compressibility of water is the only storage.
  TALUS_PORTABLE bool drains() const {
    bool any = false;
    visit([&](const WaterLaw& law, double) { any = any || law.drains; });
    return any;
  }

  /// Suction [Pa] at which the pores hold `water`, less than at zero pressure; Newton's method, safeguarded by
  /// bisection.
  TALUS_PORTABLE double find_suction(double water, double guess) const {
    constexpr double accuracy = 1e-12;  // of the last step; the remaining error is of its square
    if (water <= 0) return driest;
    double low = 0, high = driest, p = std::clamp(guess, 1.0, high);
    for (int i = 0; i < 200; ++i) {
      const Value v = find(p);
      (v.held > water ? low : high) = p;
      double next = p + (v.held - water) / v.storage;
      if (!(next > low && next < high))
        next = high == driest ? std::min(4 * p, 0.5 * (low + high)) : 0.5 * (low + high);
      if (std::abs(next - p) <= accuracy * next) return next;
      p = next;
    }
    return p;
  }

 private:
  TALUS_PORTABLE void visit(auto&& work) const {
    for (std::size_t k = 0; k < laws_.size(); ++k)
      if (laws_[k].wet && pores_[k][static_cast<std::size_t>(node_)] > 0)
        work(laws_[k], pores_[k][static_cast<std::size_t>(node_)]);
  }

  const Laws& laws_;
  const Pores& pores_;
  int node_;
};

/// Linearisation of H over the pressure: for draining pores a tangent (Newton's method); pores that fill hold the
/// content at zero pressure and what compression adds.
struct HeldLine {
  double pressure = 0, held = 0, storage = 1;
  bool full = false, drains = false;

  TALUS_PORTABLE double at(double p) const { return held - storage * (p - pressure); }

  TALUS_PORTABLE static HeldLine fill(const auto& water) {
    const auto full = water.find_full();
    return {0, full.held, full.storage, true, true};
  }
  TALUS_PORTABLE static HeldLine start(const auto& water, double p) {
    const bool drains = water.drains();
    if (drains && p <= 0) return fill(water);
    const auto v = water.find(p);
    return {p, v.held, v.storage, false, drains};
  }

  /// Number of rounds in which full pores may be found to drain again. Pores wrongly taken for full are an error that
  /// the next step corrects; water that has no room is not let in.
  static constexpr int draining_rounds = 12;

  /// The line for the next round: the tangent at the pressure p at which residual + H(p) - at(next) =
  /// stiffness (p - next), the node's own equation with the pressures `next` of the other nodes. Returns the error of
  /// the line before, H(next) - at(next) [m³].
  TALUS_PORTABLE double bend(const auto& water, double next, double residual, double stiffness, int round) {
    if (!drains) return 0;
    const auto full_pores = water.find_full(), now = next > 0 ? water.find(next) : full_pores;
    const double before = at(next), at_zero = residual + full_pores.held - before + stiffness * next,
                 difference = (next > 0 ? now.held : full_pores.held - full_pores.storage * next) - before,
                 error = std::abs(difference) > round_off * full_pores.held ? difference : 0.0,
                 step = (residual + error) / (stiffness + now.storage);
    if (full && round >= draining_rounds) return error;
    if (at_zero <= 0)
      *this = fill(water);
    else if (std::abs(step) <= most_step * next)
      *this = {next, now.held, now.storage, false, true};
    else
      bend_to(water, next + step, at_zero - full_pores.held, stiffness);
    return error;
  }
  /// Returns whether bend() would leave the line of full pores as it is, without error.
  TALUS_PORTABLE bool stays_full(double next, double residual, double stiffness) const {
    return full && next <= 0 && residual + (storage + stiffness) * next <= 0;
  }
  /// The line for the next round at a node with the given pressure `next`.
  TALUS_PORTABLE void bend_at(const auto& water, double next) {
    if (drains) *this = start(water, next);
  }

 private:
  static constexpr double round_off = 1e-12;  ///< error of a line that counts as zero, as a fraction of the pores
  static constexpr double most_step = 0.1;    ///< largest relative change of a suction for which its tangent suffices

  /// Tangent near the suction at which rest + H(p) = stiffness p, by Newton's method with bisection.
  TALUS_PORTABLE void bend_to(const auto& water, double guess, double rest, double stiffness) {
    const double empty = (rest + water.find_full().held) / stiffness;  // the suction if the pores held nothing
    double low = 0, high = empty < driest ? empty : driest, p = guess;
    for (int i = 0; i < 60; ++i) {
      if (!(p > low && p < high)) p = 0.5 * (low + high);
      const auto v = water.find(p);
      *this = {p, v.held, v.storage, false, true};
      const double error = rest + v.held - stiffness * p, step = error / (stiffness + v.storage);
      if (std::abs(step) <= most_step * p) return;
      (error > 0 ? low : high) = p;
      p += step;
    }
  }
};

}  // namespace talus::mpm
