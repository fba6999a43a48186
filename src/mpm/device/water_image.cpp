// SPDX-License-Identifier: MIT
#include "mpm/device/water_image.hpp"

#include <algorithm>

#include "mpm/device/thread_body.hpp"
#include "mpm/mixture/pressure_lines.hpp"

namespace talus::mpm {
namespace {

template <class T>
View<const T> look_at(const std::vector<T>& list) {
  return {list.data(), list.size()};
}

/// Numbers by element stand in the same order here and there; blocks there are longer.
std::vector<double> lengthen(const AlignedVector<double>& field, int elements) {
  std::vector<double> longer(field.begin(), field.begin() + elements);
  longer.resize(static_cast<std::size_t>((elements + device_width - 1) / device_width) * device_width, 0.0);
  return longer;
}

/// The fields of elements that stay from step to step.
template <int D, class Work>
void for_fields(Water<D>& water, WaterImage<D>& image, Work&& work) {
  work(water.volume, image.volume);
  work(water.stretch, image.stretch);
  work(water.mean_saturation, image.mean_saturation);
  work(water.mean_pressure, image.mean_pressure);
}

/// The graph's rows in slices: entry k of each row, then entry k + 1 of each. Short rows leave gaps.
template <int D>
void slice_rows(const NodeGraph<D>& graph, WaterImage<D>& image) {
  const int nodes = static_cast<int>(graph.size.size());
  std::vector<int> now(graph.column.size());  // the place of an entry here
  int begin = 0;
  for (int first = 0; first < nodes; first += device_width) {
    int longest = 0;
    for (int i = first; i < std::min(nodes, first + device_width); ++i) {
      const int length = graph.row_end(i) - graph.row_start[i];
      for (int k = 0; k < length; ++k) now[graph.row_start[i] + k] = begin + i - first + k * device_width;
      image.row_start.push_back(begin + i - first);
      image.row_ends.push_back(image.row_start.back() + length * device_width);
      longest = std::max(longest, length);
    }
    begin += longest * device_width;
  }
  image.column.assign(static_cast<std::size_t>(begin), 0);
  for (std::size_t n = 0; n < now.size(); ++n) image.column[now[n]] = graph.column[n];
  for (const int place : graph.place) image.place.push_back(now[place]);
}

bool loads(const SurfaceCondition& c) {
  return c.kind == SurfaceKind::head || c.kind == SurfaceKind::pressure;
}

}  // namespace

template <int D>
WaterImage<D> make_water_image(const Body<D>& body) {
  WaterImage<D> image;
  const Water<D>& water = body.water;
  if (!water.is_wet()) return image;
  image.laws = water.laws;
  image.density = water.density;
  image.first_field = water.first_field;
  image.surfaces = static_cast<int>(water.surfaces.size());
  image.loads = std::any_of(water.surfaces.begin(), water.surfaces.end(), loads);
  image.surface_of_node = look_at(water.surface_of_node);
  image.constraint_of_node = look_at(water.constraint_of_node);
  image.constraints = look_at(water.constraints);
  const NodeGraph<D>& graph = *water.darcy.graph;
  image.node_size = look_at(graph.size);
  slice_rows(graph, image);
  for (const RootUptake& uptake : water.uptakes) image.uptakes.push_back({uptake.reduction, look_at(uptake.weight)});
  for_fields(const_cast<Water<D>&>(water), image, [&](const AlignedVector<double>& field, std::vector<double>& there) {
    there = lengthen(field, body.mesh().element_count());
  });
  image.pressure = water.darcy.pressure;
  image.own = water.darcy.own;
  image.change = water.darcy.change;
  image.ponded = water.darcy.ponded;
  return image;
}

template <int D>
void read_water_image(const WaterImage<D>& image, Body<D>& body) {
  Water<D>& water = body.water;
  if (!water.is_wet()) return;
  for_fields(water, const_cast<WaterImage<D>&>(image),
             [&](AlignedVector<double>& field, const std::vector<double>& there) {
               std::copy_n(there.begin(), body.mesh().element_count(), field.begin());
             });
  water.darcy.pressure = image.pressure;
  water.darcy.own = image.own;
  water.darcy.change = image.change;
  water.darcy.ponded = image.ponded;
  water.surface_is_stale = true;
}

template <int D>
std::size_t count_bytes(const WaterImage<D>& image) {
  if (image.laws.empty()) return 0;
  const auto of = [](const auto&... lists) { return ((lists.size() * sizeof *lists.data()) + ...); };
  const std::size_t soils = image.laws.size(), lanes = image.volume.size(), nodes = image.node_size.size();
  const std::size_t element_work = 2 * soils + 8 + D + 1 + 2 * D + (D + 1) + (image.loads ? D * (D + 1) : 0),
                    node_work = 2 * soils + 14 + 6 * D;
  std::size_t weights = 0;
  for (const DeviceUptake& uptake : image.uptakes) weights += uptake.weight.size() * sizeof(double);
  return of(image.surface_of_node, image.constraint_of_node, image.constraints, image.node_size, image.row_start,
            image.row_ends, image.column, image.place) +
         of(image.volume, image.stretch, image.mean_saturation, image.mean_pressure) + weights +
         (lanes * element_work + nodes * (node_work + 3)) * sizeof(double) +
         nodes * (sizeof(SurfaceWater) + sizeof(HeldLine)) +
         image.column.size() * (sizeof(PressureEntry<D>) + sizeof(Vec<D>));
}

template <int D>
std::vector<DeviceSurface> find_device_surfaces(const Body<D>& body) {
  std::vector<DeviceSurface> surfaces;
  for (const SurfaceCondition& c : body.water.surfaces)
    surfaces.push_back({c.kind, c.vertical, lets_nothing_through(c), c.suction_limit, find_value(c, body.time)});
  return surfaces;
}

#define TALUS_INSTANTIATE(D)                                         \
  template WaterImage<D> make_water_image<D>(const Body<D>&);        \
  template void read_water_image<D>(const WaterImage<D>&, Body<D>&); \
  template std::size_t count_bytes<D>(const WaterImage<D>&);         \
  template std::vector<DeviceSurface> find_device_surfaces<D>(const Body<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
