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

/// Linearisation of H over the pressure: for draining pores the tangent at the last solution (Newton's method); pores
/// that fill hold the content at zero pressure and what compression adds.
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
  static constexpr int draining_rounds = 4;
  /// Error of the line, as a fraction of the pore volume, below which it fits.
  static constexpr double tolerance = 1e-11;

  /// Updates the line after a solution with the pressure `next`. `content`: water of the pores at the start of the step
  /// [m³]. Returns whether the line fitted before.
  TALUS_PORTABLE bool bend(const auto& water, double content, double next, int round) {
    if (!drains) return true;
    if (!full && next < 0) {
      *this = fill(water);
      return false;
    }
    if (full) {
      if (next <= 0 || round >= draining_rounds) return true;
      full = false;
      pressure = content < water.find_full().held ? water.find_suction(content, 1) : 0;
      const auto v = water.find(pressure);
      held = v.held;
      storage = v.storage;
      return false;
    }
    const auto right = water.find(next);
    if (std::abs(at(next) - right.held) <= tolerance * water.find_full().held) return true;
    pressure = next;
    held = right.held;
    storage = right.storage;
    return false;
  }
};

}  // namespace talus::mpm
