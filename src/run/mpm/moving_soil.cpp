// SPDX-License-Identifier: MIT
#include "run/mpm/moving_soil.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "mpm/body/observe.hpp"
#include "mpm/body/share.hpp"

namespace talus::run {
namespace {

/// Soil that is slower than this share of the fastest node counts as standing.
constexpr double moving_share = 0.1;

/// A point and its distance from a place, squared [m²].
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

std::string describe_restless(const input::Stage& stage, const results::Stage& report) {
  std::string moved;
  if (report.moving && !report.moving->place.empty())
    moved = fmt::format(
        ": '{}' at ({:.4g}) m still moves at {:.2g} m/s, {:.0f} % of the mass moves faster than {:.2g} m/s, and "
        "the largest displacement is {:.3g} m",
        report.moving->material, fmt::join(report.moving->place, ", "), report.moving->speed,
        100 * report.moving->share, moving_share * report.moving->speed, report.displacement);
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

}  // namespace talus::run
