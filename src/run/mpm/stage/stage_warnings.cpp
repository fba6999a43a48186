// SPDX-License-Identifier: MIT
#include "run/mpm/stage/stage_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "material/every_law.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/state/partition.hpp"

namespace talus::run {

namespace {

/// Soil slower than this fraction of the fastest node counts as at rest.
constexpr double moving_share = 0.1;

/// A point and the square of its distance from a place [m²].
struct Nearest {
  double square = std::numeric_limits<double>::max();
  int id = std::numeric_limits<int>::max();
  int material = -1;

  bool operator<(const Nearest& other) const { return std::tie(square, id) < std::tie(other.square, other.id); }
};

}  // namespace

template <int D>
std::string find_nearest_material(const mpm::Body<D>& body, const std::type_identity_t<Vec<D>>& x) {
  Nearest nearest;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    double square = 0;
    for (std::size_t d = 0; d < D; ++d) square += (p.position[d] - x[d]) * (p.position[d] - x[d]);
    nearest = std::min(nearest, {square, id, p.material});
  }
  const std::vector<Nearest> all = mpm::join_lists(body, std::vector{nearest});
  const int material = std::min_element(all.begin(), all.end())->material;
  return material >= 0 ? body.material_names[static_cast<std::size_t>(material)] : "unknown";
}

template <int D>
results::MovingSoil find_moving_soil(const mpm::Body<D>& body) {
  results::MovingSoil moving;
  moving.speed = body.monitor.speed;
  if (body.monitor.fastest_node >= 0) {
    const Vec<D>& x = body.mesh().nodes[static_cast<std::size_t>(body.monitor.fastest_node)];
    moving.place.assign(x.begin(), x.begin() + D);
    moving.material = find_nearest_material<D>(body, x);
  }
  double all = 0, fast = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    all += p.mass;
    if (norm(p.velocity) >= moving_share * moving.speed) fast += p.mass;
  }
  moving.share = all > 0 ? fast / all : 0;
  return moving;
}

std::string describe_restless(const input::Stage& stage, const results::Stage& report, const ShownUnits& units) {
  std::string moved;
  if (report.moving && !report.moving->place.empty())
    moved = fmt::format(
        ": '{}' at {} still moves at {}, {:.0f} % of the mass moves faster than {}, and "
        "the largest displacement is {}",
        report.moving->material, format_place(report.moving->place, units.length),
        format_value(report.moving->speed, units.speed(), 2), 100 * report.moving->share,
        format_value(moving_share * report.moving->speed, units.speed(), 2),
        format_value(report.displacement, units.length, 3));
  return fmt::format(
      "stage '{}' was not at rest after {:g} s{}; its unbalanced force is {:.2g} of gravity. Where displacements still "
      "grow, the soil there fails, which is a result; where the speed goes up and down, give the stage more damping or "
      "time.",
      stage.name, stage.duration, moved, report.force_ratio);
}

std::string describe_setback(const std::string& what, const results::Retry& s) {
  return fmt::format(
      "{} became unstable at t = {:.4g} s: {}. It was calculated again from t = {:.4g} s with courant = {:g} and "
      "smoothing = \"{}\"; look at the soil at that place, and write these two values into the case where the result "
      "shall stand.",
      what, s.time, s.reason, s.back_to, s.courant, s.smoothing);
}

template std::string find_nearest_material<2>(const mpm::Body<2>&, const Vec<2>&);
template std::string find_nearest_material<3>(const mpm::Body<3>&, const Vec<3>&);
template results::MovingSoil find_moving_soil<2>(const mpm::Body<2>&);
template results::MovingSoil find_moving_soil<3>(const mpm::Body<3>&);

namespace {

/// Plastic strain from which soil counts as part of a band.
constexpr double sheared = 0.05;
/// Band thickness, in elements, up to which the mesh determines it.
constexpr double thin = 1.75;
/// Ratio of element size to nonlocal length up to which a band is independent of the elements: 0.5, plus a tenth for
/// the scatter of element sizes.
constexpr double coarse = 0.55;

/// Means over the points of softening soil.
struct SoftElements {
  std::vector<double> volume, strain, void_ratio;
};

/// Returns 0 for laws without a void ratio.
double find_void_ratio(const material::Law& law, const double* state) {
  return std::visit(
      [&](const auto& l) -> double {
        if constexpr (requires { l.find_void_ratio(state); })
          return l.find_void_ratio(state);
        else
          return 0;
      },
      law);
}

template <int D>
SoftElements gather(const mpm::Body<D>& body) {
  SoftElements e;
  const std::size_t count = body.mesh().elements.size();
  e.volume.assign(count, 0), e.strain.assign(count, 0), e.void_ratio.assign(count, 0);
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    const auto& law = body.laws[static_cast<std::size_t>(p.material)];
    if (!material::traits_of(law).softens) continue;
    const auto element = static_cast<std::size_t>(body.points.element[static_cast<std::size_t>(id)]);
    e.volume[element] += p.volume;
    e.strain[element] += p.volume * p.plastic_strain;
    e.void_ratio[element] += p.volume * find_void_ratio(law, p.state.data());
  }
  for (std::size_t i = 0; i < count; ++i)
    if (e.volume[i] > 0) e.strain[i] /= e.volume[i], e.void_ratio[i] /= e.volume[i];
  return e;
}

template <int D>
std::vector<std::vector<int>> list_elements_at_nodes(const mesh::Mesh<D>& mesh) {
  std::vector<std::vector<int>> at(mesh.nodes.size());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const int node : mesh.elements[static_cast<std::size_t>(e)]) at[static_cast<std::size_t>(node)].push_back(e);
  return at;
}

/// Lists the elements that share a node with element `e`, including `e`.
template <int D>
void list_around(const mesh::Mesh<D>& mesh, const std::vector<std::vector<int>>& at_nodes, std::size_t e,
                 std::vector<int>& around) {
  around.clear();
  for (const int node : mesh.elements[e])
    around.insert(around.end(), at_nodes[static_cast<std::size_t>(node)].begin(),
                  at_nodes[static_cast<std::size_t>(node)].end());
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
}

}  // namespace

// In a straight band of n > 1 rows of elements, the band is on average the fraction 1 - 2/(3n) of the soil in elements
// that share a node with one of the band; in one row it is 1/3.
template <int D>
std::optional<SoftBand> find_soft_band(const mpm::Body<D>& body) {
  const SoftElements e = gather(body);
  const auto peak = std::max_element(e.strain.begin(), e.strain.end());
  if (peak == e.strain.end() || !(*peak > sheared)) return std::nullopt;
  const auto at_nodes = list_elements_at_nodes(body.mesh());
  double band = 0, part = 0, size = 0, inside = 0, beside = 0, outside = 0;
  std::vector<int> around;
  for (std::size_t i = 0; i < e.volume.size(); ++i) {
    if (!(e.strain[i] > 0.5 * *peak)) continue;
    list_around(body.mesh(), at_nodes, i, around);
    double all = 0, like = 0;
    for (const int number : around) {
      const auto other = static_cast<std::size_t>(number);
      all += e.volume[other];
      const bool belongs = e.strain[other] > 0.5 * e.strain[i];
      like += belongs ? e.volume[other] : 0;
      beside += belongs ? 0 : e.volume[other];
      outside += belongs ? 0 : e.volume[other] * e.void_ratio[other];
    }
    band += e.volume[i];
    part += e.volume[i] * like / all;
    size += e.volume[i] * std::pow((D == 2 ? 2 : 6) * body.mesh().volumes[i], 1.0 / D);
    inside += e.volume[i] * e.void_ratio[i];
  }
  if (!(beside > 0) || inside / band <= outside / beside)
    return std::nullopt;  // the soil dilated as a whole, or the band compacted
  return SoftBand{2 / (3 * (1 - part / band)), size / band};
}

template <int D>
StageHooks<D> watch_bands(const mpm::Body<D>& body, StageHooks<D> hooks) {
  if (std::none_of(body.laws.begin(), body.laws.end(),
                   [](const material::Law& law) { return material::traits_of(law).softens; }))
    return hooks;
  hooks.output = [record = std::move(hooks.output)](Pause<D>& now, StageState& state) {
    record(now, state);
    const auto band = find_soft_band(now.whole());
    if (!band) return;
    state.soft_band = state.soft_band > 0 ? std::min(state.soft_band, band->thickness) : band->thickness;
    state.soft_size = std::max(state.soft_size, band->size);
  };
  return hooks;
}

template <int D>
std::optional<std::string> describe_narrow_band(const mpm::Body<D>& body, const StageState& state,
                                                std::optional<double> length, const ShownUnits& units) {
  const bool depends = length ? state.soft_size > coarse * *length : state.soft_band <= thin;
  if (state.soft_band == 0 || !depends) return std::nullopt;
  std::vector<std::string> soils;
  for (std::size_t m = 0; m < body.laws.size(); ++m)
    if (material::traits_of(body.laws[m]).softens) soils.push_back("'" + body.material_names[m] + "'");
  return fmt::format(
      "soil that softens ({}) sheared in a band of {:.2g} elements of {}: when it moves, and how deep, depend on "
      "their size. {}",
      fmt::join(soils, ", "), std::max(1.0, state.soft_band), format_value(state.soft_size, units.length, 2),
      length
          ? fmt::format("mesh.softening_length = {} must be at least twice that", format_value(*length, units.length))
          : "Give mesh.softening_length, at least twice that");
}

#define TALUS_INSTANTIATE(D)                                                                          \
  template std::optional<SoftBand> find_soft_band<D>(const mpm::Body<D>&);                            \
  template StageHooks<D> watch_bands<D>(const mpm::Body<D>&, StageHooks<D>);                          \
  template std::optional<std::string> describe_narrow_band<D>(const mpm::Body<D>&, const StageState&, \
                                                              std::optional<double>, const ShownUnits&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

namespace {

/// Largest ratio of wave crossing time to duration of the process. The error of consolidation under a sudden load is
/// 0.5 % at a twentieth, 6 % at a sixth and 21 % at a half (theory 5).
constexpr double largest_share = 0.1;

/// Conductivity from which pore water takes some milliseconds, k/(n g), to follow a change of its drag [m/s].
constexpr double open_soil = 1e-2;

/// Fraction of the weight that excess pore pressure may carry at the end of a weight stage.
constexpr double largest_excess = 0.05;

/// Rounds down to one digit.
double round_down(double x) {
  const double unit = std::pow(10.0, std::floor(std::log10(x)));
  return std::floor(x / unit * (1 + 1e-9)) * unit;
}

}  // namespace

template <int D>
DrainedWave find_drained_wave(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  const double g = norm(plan.gravity);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, slowest = 0, fastest_drainage = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    const double height = g > 0 ? -dot(p.position, plan.gravity) / g : p.position[D - 1];
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    const double modulus = material::constrained_modulus(body.laws[p.material], p.stress.data(), p.state.data());
    slowest = std::max(slowest, (p.mass + p.water_mass) / (p.volume * modulus));
    if (!p.wet || !input::moves(plan.step.water)) continue;
    const mpm::WaterLaw& law = body.water.laws[p.material];
    const double conductivity = law.conductivity * plan.step.conductivity_factor;
    fastest_drainage = std::max(fastest_drainage, conductivity * modulus / (law.density * law.drag_gravity));
  }
  const double height = std::max(0.0, highest - lowest);
  DrainedWave wave{height * std::sqrt(plan.step.mass_scaling * slowest)};
  if (fastest_drainage > 0) wave.drainage = height * height / fastest_drainage;
  return wave;
}

template <int D>
std::optional<std::string> describe_slow_wave(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  const double scaling = plan.step.mass_scaling;
  if (scaling <= 1) return std::nullopt;
  const DrainedWave wave = find_drained_wave(body, plan);
  const double lasting = plan.until_rest ? std::numeric_limits<double>::infinity() : plan.duration;
  const bool drains = wave.drainage && *wave.drainage < lasting;
  const double process = drains ? *wave.drainage : lasting, share = wave.crossing / process;
  if (!(share > largest_share)) return std::nullopt;
  return fmt::format(
      "stage '{}': with mass_scaling = {:.3g} a wave needs {:.2g} s to cross the drained soil. What takes less than "
      "ten times as long lags behind, and {} {:.2g} s. A mass_scaling up to {:g} follows it",
      plan.name, scaling, wave.crossing, drains ? "the soil drains in" : "the stage lasts", process,
      round_down(std::max(1.0, scaling * std::pow(largest_share / share, 2))));
}

template <int D>
std::optional<std::string> describe_fast_water(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  if (plan.step.water != input::WaterMotion::seeps) return std::nullopt;
  for (std::size_t m = 0; m < body.water.laws.size(); ++m) {
    const mpm::WaterLaw& law = body.water.laws[m];
    const double conductivity = law.conductivity * plan.step.conductivity_factor;
    if (law.wet && conductivity > open_soil)
      return fmt::format(
          "stage '{}': water = \"seeps\" leaves out the inertia of the water itself, which matters in '{}' with a "
          "conductivity of {} where the flow changes within seconds; water = \"flows\" has it",
          plan.name, body.material_names[m], format_value(conductivity, plan.units.speed()));
  }
  return std::nullopt;
}

template <int D>
CarriedWeight find_carried_weight(const mpm::Body<D>& body) {
  CarriedWeight carried;
  double volume = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    if (!p.wet) continue;
    volume += p.volume;
    carried.water -= p.volume * p.pressure;
    carried.grains -= p.volume * p.stress[1];
  }
  if (volume > 0) carried = {carried.water / volume, carried.grains / volume};
  return carried;
}

template <int D>
std::optional<std::string> describe_undrained_weight(const mpm::Body<D>& body, const std::string& stage,
                                                     const CarriedWeight& before, const ShownUnits& units) {
  const CarriedWeight now = find_carried_weight(body);
  const double excess = now.water - before.water, weight = excess + now.grains - before.grains;
  if (!(excess > largest_excess * weight) || !(weight > 0)) return std::nullopt;
  return fmt::format(
      "stage '{}': at its end the pore water carries {:.0f} % of the weight that the stage brought on (mean excess "
      "pressure {}): the soil is at rest, not drained, and its effective stresses are too low. Leave `water` "
      "and "
      "`geometry` of a weight stage out, which holds the pore pressures, or give the water time to drain",
      stage, 100 * std::min(1.0, excess / weight), format_value(excess, units.stress, 3));
}

#define TALUS_INSTANTIATE(D)                                                                                \
  template DrainedWave find_drained_wave<D>(const mpm::Body<D>&, const StagePlan<D>&);                      \
  template std::optional<std::string> describe_slow_wave<D>(const mpm::Body<D>&, const StagePlan<D>&);      \
  template std::optional<std::string> describe_fast_water<D>(const mpm::Body<D>&, const StagePlan<D>&);     \
  template CarriedWeight find_carried_weight<D>(const mpm::Body<D>&);                                       \
  template std::optional<std::string> describe_undrained_weight<D>(const mpm::Body<D>&, const std::string&, \
                                                                   const CarriedWeight&, const ShownUnits&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
