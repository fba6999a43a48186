// SPDX-License-Identifier: MIT
// A section made ready for many surfaces: questions about what stands over x.

#include "lem/section/slope.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "lem/section/tension_depth.hpp"
#include "lem/slices/strips.hpp"

namespace talus::lem {

Slope::Slope(Section section) : strips_(std::make_unique<Strips>()) {
  const auto faults = find_faults(section);
  if (!faults.empty()) {
    std::string sentences;
    for (const std::string& fault : faults) sentences += (sentences.empty() ? "" : "\n") + fault;
    throw Error(ExitCode::wrong_input, sentences);
  }
  strips_->section = std::move(section);
  if (strips_->section.drawdown)
    strips_->before = std::make_unique<const Slope>(Section(*strips_->section.drawdown->before));
  build_strips(*strips_);
  if (strips_->section.crack && strips_->section.crack->limited) strips_->crack_depths = compute_crack_depths(*this);
}

Slope::~Slope() = default;
Slope::Slope(Slope&&) noexcept = default;

const Section& Slope::section() const {
  return strips_->section;
}

const Slope* Slope::before() const {
  return strips_->before.get();
}

const Slope::Strips& Slope::strips() const {
  return *strips_;
}

double Slope::left() const {
  return strips_->strips.front().left;
}

double Slope::right() const {
  return strips_->strips.back().right;
}

double Slope::ground(double x) const {
  const Strip& strip = strips_->strip(strips_->find(x));
  return strip.ground.at(x - strip.left);
}

double Slope::water_table(double x) const {
  const Strip& strip = strips_->strip(strips_->find(x));
  return strip.water.at(x - strip.left);
}

int Slope::soil_at(const Point& p) const {
  const Strip& strip = strips_->strip(strips_->find(p[0]));
  const double dx = p[0] - strip.left;
  if (p[1] > strip.ground.at(dx) || p[1] < section().base) return -1;
  const int layer = strips_->find_layer(strip, dx, p[1]);
  return layer < 0 ? -1 : strips_->layer(layer).soil;
}

double Slope::pore_pressure(const Point& p) const {
  if (const auto u = strips_->pressure.find(p)) return *u;
  if (section().water_table.empty()) return 0;
  return section().water_unit_weight * (water_table(p[0]) - p[1]);
}

double Slope::crack_depth(double x) const {
  if (!section().crack) return 0;
  const std::vector<Point>& depths = strips_->crack_depths;
  if (depths.empty()) return section().crack->depth;
  const auto after =
      std::upper_bound(depths.begin(), depths.end(), x, [](double at, const Point& p) { return at < p[0]; });
  if (after == depths.begin() || after == depths.end()) return (after == depths.end() ? depths.back() : *after)[1];
  const Point &a = *std::prev(after), &b = *after;
  return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
}

double Slope::weight_above(double x, double bottom, int& soil) const {
  const Strip& strip = strips_->strip(strips_->find(x));
  const double dx = x - strip.left;
  const int i = strips_->find_layer(strip, dx, bottom);
  if (i < 0) return 0;
  const Layer& layer = strips_->layer(i);
  soil = layer.soil;
  return layer.weight.at(dx) + layer.unit_weight * (layer.top.at(dx) - bottom);
}

}  // namespace talus::lem
