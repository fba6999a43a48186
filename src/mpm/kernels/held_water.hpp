// SPDX-License-Identifier: MIT
#pragma once
// Water content of a node's pores as a function of pressure, H_i(p) of theory 22, and its linearisation for one
// solution.

#include <algorithm>
#include <cmath>

#include "mpm/kernels/pore_state.hpp"

namespace talus::mpm {

/// H_i(p) for the soils at the nodes of T from one on. Laws, Pores: the types of the body, [material] and
/// [material][node].
template <class Laws, class Pores, class T = double>
class HeldWater {
 public:
  struct Value {
    T held{0.0}, storage{0.0};  ///< [m³]; −d held/dp [m³/Pa]
  };

  TALUS_PORTABLE HeldWater(const Laws& laws, const Pores& pores, int node) : laws_(laws), pores_(pores), node_(node) {}

  TALUS_PORTABLE Value find(T p) const {
    Value sum;
    visit([&](const WaterLaw& law, T pores) {
      const material::SoilWater<T> water = material::find_water(law.retention, p);
      const T stretched = pores * lane_exp(p * (-1 / law.bulk_modulus));
      T saturation = water.saturation, slope = water.slope;
      const MaskOf<T> dry = p > T(law.dry);
      if (any(dry)) {  // H falls with ln p to zero at 1 GPa, where all soil is dry
        const double decades = std::log(driest / law.dry);
        const T suction = lane_max(p, T(law.dry)), left = lane_max(T(0.0), lane_log(driest / suction) * (1 / decades));
        slope = select(dry, slope * left - saturation / (suction * decades), slope);
        saturation = select(dry, saturation * left, saturation);
      }
      sum.held += stretched * saturation;
      sum.storage += stretched * (saturation * (1 / law.bulk_modulus) - slope);
    });
    return sum;
  }

  /// Value at zero pressure, with the storage of full pores under positive pressure.
  TALUS_PORTABLE Value find_full() const {
    Value sum;
    visit([&](const WaterLaw& law, T pores) {
      sum.held += pores * law.full;
      sum.storage += pores * (law.full / law.bulk_modulus);
    });
    return sum;
  }

  /// Returns whether a soil releases water under suction; otherwise the compressibility of water is the only storage.
  TALUS_PORTABLE MaskOf<T> drains() const {
    MaskOf<T> any(false);
    visit([&](const WaterLaw& law, T pores) { any = any || (MaskOf<T>(law.drains) && pores > T(0.0)); });
    return any;
  }

  /// Suction [Pa] at which the pores of the nodes `wanted` hold `water`, less than at zero pressure; Newton's method,
  /// safeguarded by bisection. Undefined at other nodes.
  TALUS_PORTABLE T find_suction(T water, T guess, MaskOf<T> wanted) const {
    constexpr double accuracy = 1e-12;  // of the last step; the remaining error is of its square
    const MaskOf<T> empty = !(water > T(0.0));
    MaskOf<T> runs = wanted && !empty;
    T low(0.0), high(driest), p = lane_max(T(1.0), lane_min(guess, high));
    for (int i = 0; i < 200 && any(runs); ++i) {
      const Value v = find(p);
      const MaskOf<T> more = v.held > water;
      low = select(more, p, low);
      high = select(more, high, p);
      const T newton = p + (v.held - water) / v.storage, middle = 0.5 * (low + high),
              other = select(high == T(driest), lane_min(4.0 * p, middle), middle),
              next = select(newton > low && newton < high, newton, other);
      const MaskOf<T> moves = lane_abs(next - p) > accuracy * next;
      p = select(runs, next, p);
      runs = runs && moves;
    }
    return select(empty, T(driest), p);
  }

 private:
  TALUS_PORTABLE void visit(auto&& work) const {
    for (std::size_t k = 0; k < laws_.size(); ++k) {
      if (!laws_[k].wet) continue;
      const T pores = load_unaligned<T>(&pores_[k][static_cast<std::size_t>(node_)]);
      if (any(pores > T(0.0))) work(laws_[k], pores);
    }
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
