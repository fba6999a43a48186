// SPDX-License-Identifier: MIT
// Pressure of pore water from its content (T14.7), by Newton's method with bisection, and the storage of a soil.
#include "mpm/kernels/pore_state.hpp"

namespace talus::mpm {
namespace {

/// Newton's method converges quadratically: after a step this small, relative to the suction, the next step would be
/// round-off. The remaining error is in the pressure only; mass is conserved, and the next time step starts from it.
constexpr double newton_tolerance = 1e-6;
constexpr int most_iterations = 200;

/// e^x for the small x of compressed water by its series, by the exact function in lanes beyond its range. The result
/// of a lane must not depend on its neighbours, because lanes without a point hold old values.
template <class T>
TALUS_KERNEL T find_stretch(T x) {
  const T series = 1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120)))));
  const auto far = lane_abs(x) > T(0.01);
  return any(far) ? select(far, lane_exp(x), series) : series;
}

template <class T>
struct Suction {
  T pressure, saturation, capacity;
  T effective, complement;  ///< of van Genuchten's curve; see SoilWater
};

/// Suction of unsaturated lanes by Newton's method, safeguarded by bisection.
template <class T, class Curve>
TALUS_KERNEL Suction<T> find_suction(const Curve& curve, double modulus, double full, T content, T guess,
                                     MaskOf<T> wanted) {
  const double inverse = 1 / modulus;
  // Upper bound: the suction at which water would expand this far without the retention curve, as -ln x < 1/x - 1.
  T low(0.0), high = modulus * (full / select(wanted, content, T(0.5 * full)) - 1.0);
  Suction<T> s{select(guess > low && guess < high, guess, lane_min(T(1.0), high)), T(full), T(0.0), T(1.0), T(-1.0)};
  auto moving = wanted;
  for (int i = 0; i < most_iterations; ++i) {
    const T p = s.pressure;
    const material::CurvePoint<T> c = curve.evaluate(p);
    const T stretch = find_stretch(p * -inverse);
    const T excess = c.value * stretch - content, capacity = (c.slope - c.value * inverse) * stretch;
    const T step = -(excess / capacity), next = p + step;
    const auto wetter = excess > T(0.0);
    low = select(moving && wetter, p, low);
    high = select(moving && !wetter, p, high);
    // A step this small is taken even beyond a bound; the bound is then within round-off of the root.
    const auto converged = !(lane_abs(step) > newton_tolerance * p + 4e-16 * modulus);
    const auto inside = converged || (next > low && next < high);
    const auto far = low > T(0.0) && high > 16.0 * low;
    s.pressure = select(moving, select(inside, next, select(far, 4.0 * low, 0.5 * (low + high))), p);
    s.saturation = select(moving, c.value + c.slope * step, s.saturation);
    s.capacity = select(moving, capacity, s.capacity);
    moving = moving && !converged;
    if (!any(moving)) break;
  }
  const double range = curve.maximum - curve.minimum;
  if (range > 0) s.effective = (s.saturation - curve.minimum) * (1 / range);
  return s;
}

/// The same for van Genuchten's curve, in y = ln p. Its series about the guess is as accurate as the curve, so one
/// evaluation of the curve nearly always suffices, and k_r needs no further one.
template <class T>
TALUS_KERNEL Suction<T> find_suction(const material::VanGenuchten& curve, double modulus, double full, T content,
                                     T guess, MaskOf<T> wanted) {
  const double inverse = 1 / modulus, range = curve.maximum - curve.minimum, reach = curve.series_reach();
  T low(0.0), high = modulus * (full / select(wanted, content, T(0.5 * full)) - 1.0);
  const auto lost = wanted && !(guess > low && guess < high);
  Suction<T> s{select(lost, lane_min(T(1.0), 0.5 * high), guess), T(full), T(0.0), T(1.0), T(0.0)};
  s.pressure = select(wanted, s.pressure, T(1.0));
  if (any(lost)) {  // the suction at this saturation is slightly too high; Newton's method descends from it
    const T e = lane_max(T(1e-9), (select(lost, content, T(full)) - curve.minimum) * (1 / range));
    const T u = lane_max(T(1e-30), lane_power(e, -1 / curve.lambda) - 1.0);
    const T start = lane_min(0.999999 * high, curve.reference * lane_power(u, 1 - curve.lambda));
    s.pressure = select(lost, start, s.pressure);
  }
  auto moving = wanted;
  for (int i = 0; i < most_iterations; ++i) {
    const T p = s.pressure, q = p * inverse;
    const auto series = curve.expand(p);
    const T stretch = find_stretch(-q), target = content / stretch;
    const T held = range * series.effective, value = curve.minimum + held;
    const T excess = value - target;
    const auto wetter = excess > T(0.0);
    low = select(moving && wetter, p, low);
    high = select(moving && !wetter, p, high);
    // First and half the second derivative by y of F = S e^(-p/K) - content, over e^(-p/K).
    const T first = held * series.c1 - value * q;
    const T second =
        held * (0.5 * series.c1 * series.c1 + series.c2) - q * (held * series.c1 + 0.5 * value * (1.0 - q));
    const T reciprocal = 1.0 / first, newton = -(excess * reciprocal), bend = second * reciprocal;
    T y = lane_max(T(-2 * reach), lane_min(T(2 * reach), newton * (1.0 - bend * newton)));
    // One more Newton step, on the series.
    const T x = q * (y * (1.0 + y * (0.5 + y * (1.0 / 6 + y * (1.0 / 24)))));
    const T there = curve.minimum + range * series.find_effective(y);
    const T rest = there * (1.0 - x * (1.0 - x * (0.5 - x * (1.0 / 6)))) - target;
    y -= rest * reciprocal * (1.0 - 2.0 * bend * y);
    const auto near = lane_abs(newton) < T(reach);
    const auto converged = near || !(lane_abs(newton) * p > T(4e-16 * modulus));  // the round-off of the content
    const T next = p + p * select(near, y * (1.0 + y * (0.5 + y * (1.0 / 6 + y * (1.0 / 24)))), newton);
    const auto inside = converged || (next > low && next < high);
    const auto far = low > T(0.0) && high > 16.0 * low;
    const T effective = series.find_effective(y);
    s.effective = select(moving, effective, s.effective);
    s.complement = select(moving, series.find_complement(y, effective, curve.lambda), s.complement);
    s.capacity = select(moving, first * stretch / p, s.capacity);
    s.pressure = select(moving, select(inside, next, select(far, 4.0 * low, 0.5 * (low + high))), p);
    moving = moving && !converged;
    if (!any(moving)) break;
  }
  s.saturation = curve.minimum + range * s.effective;
  return s;
}

/// The suction WaterLaw::dry, by bisection on a logarithmic scale.
double find_dry_suction(const WaterLaw& law) {
  constexpr double rest = 1e-3;
  const double least = material::saturation(law.retention, driest);
  double low = 0, high = std::log(law.dry);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const bool is_dry = material::saturation(law.retention, std::exp(middle)) - least <= rest * (law.full - least);
    (is_dry ? high : low) = middle;
  }
  return std::exp(high);
}

}  // namespace

template <class T>
PoreState<T> find_pore_state(const WaterLaw& law, T content, T guess, MaskOf<T> active) {
  const double modulus = law.bulk_modulus, full = law.full;
  const auto unsaturated = active && content < T(full);
  const T compressed = lane_log(select(active, content, T(full)) * (1 / full)) * -modulus;
  PoreState<T> state{compressed, T(full), T(0.0), T(0.0), content * (-1 / modulus)};
  if (!any(unsaturated)) {
    state.bishop = find_bishop(law, state.pressure, state.saturation);
    state.relative = T(law.saturated_relative);
    return state;
  }
  material::SoilWater<T> water;
  std::visit(
      [&](const auto& curve) {
        const Suction<T> s = find_suction(curve, modulus, full, content, guess, unsaturated);
        state.pressure = select(unsaturated, s.pressure, state.pressure);
        state.saturation = select(unsaturated, lane_min(T(full), s.saturation), state.saturation);
        state.capacity = select(unsaturated, s.capacity, state.capacity);
        water.effective = select(unsaturated, s.effective, T(1.0));
        water.complement = select(unsaturated, s.complement, T(0.0));
      },
      law.retention);
  water.suction = state.pressure;
  water.saturation = state.saturation;
  water.slope = water.effective_slope = T(0.0);
  state.bishop = find_bishop(law, state.pressure, state.saturation);
  state.relative = lane_max(find_relative(law, water), T(lowest_relative_conductivity));
  return state;
}

WaterLaw finish(WaterLaw law) {
  const material::SoilWater<double> water = material::find_water(law.retention, 0.0);
  law.full = water.saturation;
  law.saturated_relative = find_relative(law, water);
  law.drains = material::saturation(law.retention, 1e5) < law.full;
  if (law.drains) law.dry = find_dry_suction(law);
  return law;
}

double find_content(const WaterLaw& law, double pressure) {
  return material::saturation(law.retention, pressure) * std::exp(-pressure / law.bulk_modulus);
}

double find_storage(const WaterLaw& law, double pressure) {
  const material::SoilWater<double> water = material::find_water(law.retention, pressure);
  return water.saturation / law.bulk_modulus - water.slope;
}

template PoreState<double> find_pore_state<double>(const WaterLaw&, double, double, bool);
template PoreState<Pack> find_pore_state<Pack>(const WaterLaw&, Pack, Pack, Mask);
template PoreState<double> find_state_at_pressure<double>(const WaterLaw&, double);
template PoreState<Pack> find_state_at_pressure<Pack>(const WaterLaw&, Pack);

}  // namespace talus::mpm
