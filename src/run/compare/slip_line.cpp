// SPDX-License-Identifier: MIT
#include "run/compare/slip_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "mesh/planar.hpp"
#include "output/files/frames_reader.hpp"
#include "results/json.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/record/motion.hpp"
#include "run/mpm/record/sections.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;

/// Largest distance between a simplified line and the full one, over the width of the line.
constexpr double simplified = 0.004;
/// Number of points compared. Only the middle part of a line is compared, as its ends are extensions to the ground.
constexpr int compared_points = 60;
/// Least slope of the ends of a line up to the ground [-].
constexpr double flattest_end = 0.2;

/// Douglas–Peucker simplification.
void simplify(const site::Polyline& line, std::size_t from, std::size_t to, double tolerance, std::vector<bool>& kept) {
  std::size_t farthest = from;
  double distance = tolerance;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double d = mesh::compute_distance(line[i], line[from], line[to]);
    if (d > distance) distance = d, farthest = i;
  }
  if (farthest == from) return;
  kept[farthest] = true;
  simplify(line, from, farthest, tolerance, kept);
  simplify(line, farthest, to, tolerance, kept);
}

/// Returns `count` evenly spaced points along the line.
site::Polyline resample(const site::Polyline& line, int count) {
  std::vector<double> along(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    along[i] = along[i - 1] + std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  site::Polyline points;
  std::size_t i = 1;
  for (int k = 0; k < count; ++k) {
    const double s = along.back() * (k + 0.5) / count;
    while (i + 1 < line.size() && along[i] < s) ++i;
    const double share = along[i] > along[i - 1] ? (s - along[i - 1]) / (along[i] - along[i - 1]) : 0;
    points.push_back({line[i - 1][0] + share * (line[i][0] - line[i - 1][0]),
                      line[i - 1][1] + share * (line[i][1] - line[i - 1][1])});
  }
  return points;
}

std::vector<double> list_distances(const site::Polyline& a, const site::Polyline& b) {
  std::vector<double> distances;
  for (const site::Point& x : resample(a, compared_points)) distances.push_back(mesh::compute_distance(x, b));
  return distances;
}

struct LastFrame {
  MovedSection section;
  double largest = 0;  ///< displacement [m]
};

/// Reads the last frame of a folder, with the points at their positions before the motion.
std::optional<LastFrame> read_last_frame(const fs::path& folder) {
  if (!output::holds_frames(folder)) return std::nullopt;
  const output::ResultsReader reader(folder);
  if (reader.size() == 0) return std::nullopt;
  const output::Frame frame = reader.read(reader.size() - 1);
  const output::Field* u = output::find(frame.point_fields, "displacement");
  const output::Field* volume = output::find(frame.point_fields, "volume");
  if (u == nullptr || volume == nullptr || frame.point_count() == 0) return std::nullopt;
  LastFrame moved;
  double area = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(frame.point_count()); ++i) {
    const double ux = u->values[3 * i], uy = u->values[3 * i + 1], size = std::hypot(ux, uy);
    if (!std::isfinite(size)) continue;
    moved.section.positions.push_back({frame.positions[3 * i] - ux, frame.positions[3 * i + 1] - uy});
    moved.section.displacement.push_back(size);
    moved.section.across.push_back(ux);
    moved.largest = std::max(moved.largest, size);
    area += volume->values[i];
  }
  moved.section.spacing = std::sqrt(area / static_cast<double>(frame.point_count()));
  return moved;
}

void take(MovedLimit limit, PointsSlipLine& into) {
  into.line = std::move(limit.line);
  into.sides = std::move(limit.sides);
}

}  // namespace

PointsSlipLine find_points_slip_line(const input::Case& data, const results::RunResult& run, const fs::path& folder) {
  PointsSlipLine result;
  if (data.mesh.dimension != 2) return result;
  const double height = run.slope_height.value_or(0);
  if (data.analysis == input::AnalysisKind::run) {
    if (const auto moved = read_last_frame(folder)) {
      take(find_moved_limit(moved->section,
                            std::max(moved_share * moved->largest, find_onset_threshold(data.output, height))),
           result);
      result.factor = 1;
      result.source = "lower limit of the soil that moved in the run";
    }
    return result;
  }
  // The failed end of the bracket on the finest mesh is nearest to the onset of failure.
  for (const int mesh : {1, 0}) {
    const auto kept =
        results::find_file<results::SlipLine>(folder / "frozen" / fmt::format("mesh_{}", mesh) / slip_line_file);
    if (!kept) continue;
    result.factor = kept->factor;
    result.line = kept->points;
    result.sides = kept->sides.value_or(std::vector<results::SideLine>{});
    result.source = fmt::format("lower limit of the soil that runs away at SRF {:.3f}", result.factor);
    return result;
  }
  if (!run.curve) return result;
  const double failed = data.strength_reduction.curve.displacement_ratio * height;
  for (const results::Trial& trial : run.curve->points) {
    const double factor = trial.factor;
    if (trial.displacement < failed) continue;
    const auto moved = read_last_frame(folder / "trials" / fmt::format("srf_{:.4f}", factor));
    if (!moved) continue;
    take(find_moved_limit(moved->section, moved_share * moved->largest), result);
    if (result.line.empty()) continue;
    result.factor = factor;
    result.source = fmt::format("lower limit of the soil that moved in the trial at SRF {:g}", factor);
    return result;
  }
  return result;
}

std::optional<lem::Surface> make_surface(const lem::Slope& slope, const site::Polyline& given) {
  const double width = slope.right() - slope.left(), least = 1e-6 * width;
  site::Polyline line = given;
  if (line.size() < 2) return std::nullopt;
  if (line.front()[0] > line.back()[0]) std::reverse(line.begin(), line.end());
  // Keeps points inside the soil that continue to the right.
  site::Polyline inside;
  for (const site::Point& x : line) {
    if (x[0] <= slope.left() + least || x[0] >= slope.right() - least) continue;
    if (x[1] >= slope.ground(x[0]) - least) continue;
    if (!inside.empty() && x[0] <= inside.back()[0] + least) continue;
    inside.push_back({x[0], std::max(x[1], slope.section().base + least)});
  }
  if (inside.size() < 3) return std::nullopt;
  std::vector<bool> kept(inside.size(), false);
  kept.front() = kept.back() = true;
  simplify(inside, 0, inside.size() - 1, simplified * (inside.back()[0] - inside.front()[0]), kept);
  site::Polyline body;
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (kept[i]) body.push_back(inside[i]);
  // The ends are extended in their direction to the ground.
  const auto lead_on = [&](const site::Point& end, const site::Point& before) -> std::optional<site::Point> {
    const double dx = end[0] - before[0], dy = end[1] - before[1], sign = dx > 0 ? 1 : -1;
    const double slope_out = std::max(dy / std::abs(dx), flattest_end);
    const double step = width / 2000;
    for (int k = 1; k < 4000; ++k) {
      const double x = end[0] + sign * step * k, y = end[1] + slope_out * step * k;
      if (x <= slope.left() || x >= slope.right()) return std::nullopt;
      if (y < slope.ground(x)) continue;
      // The line crosses the ground between the last two places.
      double in = end[0] + sign * step * (k - 1), out = x;
      for (int i = 0; i < 60; ++i) {
        const double middle = (in + out) / 2;
        (end[1] + slope_out * std::abs(middle - end[0]) < slope.ground(middle) ? in : out) = middle;
      }
      return site::Point{out, slope.ground(out)};
    }
    return std::nullopt;
  };
  const auto left = lead_on(body.front(), body[1]), right = lead_on(body.back(), body[body.size() - 2]);
  if (!left || !right) return std::nullopt;
  lem::Surface surface;
  surface.line.push_back(*left);
  for (const site::Point& x : body)
    if (x[0] > surface.line.back()[0] + least && x[0] < (*right)[0] - least) surface.line.push_back(x);
  surface.line.push_back(*right);
  surface.from = surface.line.front()[0];
  surface.to = surface.line.back()[0];
  return surface;
}

double find_distance(const site::Polyline& a, const site::Polyline& b) {
  const auto there = list_distances(a, b), back = list_distances(b, a);
  return std::max(*std::max_element(there.begin(), there.end()), *std::max_element(back.begin(), back.end()));
}

double find_mean_distance(const site::Polyline& a, const site::Polyline& b) {
  const auto mean = [](const std::vector<double>& d) {
    return std::accumulate(d.begin(), d.end(), 0.0) / static_cast<double>(d.size());
  };
  return std::max(mean(list_distances(a, b)), mean(list_distances(b, a)));
}

}  // namespace talus::run
