// SPDX-License-Identifier: MIT
// Conversion between a body and the arrays of a device: blocks of lane_width elements here, of device_width elements
// there.
#include "mpm/backend/device_image.hpp"

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "material/every_law.hpp"
#include "mpm/backend/thread_body.hpp"
#include "mpm/kernels/pressure_kernels.hpp"
#include "mpm/kernels/softening.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/slots.hpp"

namespace talus::mpm {

namespace {

template <class T>
View<const T> look_at(const std::vector<T>& list) {
  return {list.data(), list.size()};
}

/// Extends an array by element to whole blocks of a device. The order of elements is the same; blocks are longer there.
std::vector<double> lengthen(const AlignedVector<double>& field, int elements) {
  std::vector<double> longer(field.begin(), field.begin() + elements);
  longer.resize(static_cast<std::size_t>((elements + device_width - 1) / device_width) * device_width, 0.0);
  return longer;
}

/// Calls work(array of the body, array of the image) for the fields of elements that persist from step to step.
template <int D, class Work>
void for_fields(Water<D>& water, WaterImage<D>& image, Work&& work) {
  work(water.volume, image.volume);
  work(water.stretch, image.stretch);
  work(water.mean_saturation, image.mean_saturation);
  work(water.mean_pressure, image.mean_pressure);
}

/// Stores the rows of the graph in slices of device_width nodes.
template <int D>
void slice_rows(const NodeGraph<D>& graph, WaterImage<D>& image) {
  constexpr int stride = NodeGraph<D>::row_stride;
  const int nodes = static_cast<int>(graph.size.size());
  std::vector<int> now(graph.column.size(), -1);  // the place of an entry here; -1: a gap
  int begin = 0;
  for (int first = 0; first < nodes; first += device_width) {
    int longest = 0;
    for (int i = first; i < std::min(nodes, first + device_width); ++i) {
      const int length = (graph.row_end(i) - graph.row_start[i]) / stride;
      for (int k = 0; k < length; ++k) now[graph.row_start[i] + k * stride] = begin + i - first + k * device_width;
      image.row_start.push_back(begin + i - first);
      image.row_ends.push_back(image.row_start.back() + length * device_width);
      longest = std::max(longest, length);
    }
    begin += longest * device_width;
  }
  image.column.assign(static_cast<std::size_t>(begin), 0);
  for (std::size_t n = 0; n < now.size(); ++n)
    if (now[n] >= 0) image.column[now[n]] = graph.column[n];
  for (int i = 0; i < nodes; ++i)
    for (int t = graph.touch_start[i]; t < graph.touch_end(i); t += graph.touch_stride)
      for (int k = 0; k <= D; ++k) image.place.push_back(now[graph.place[static_cast<std::size_t>(t) * (D + 1) + k]]);
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
  const std::size_t element_work = 2 * soils + 10 + D + 1 + 2 * D + (D + 1) + (image.loads ? D * (D + 1) : 0),
                    node_work = 2 * soils + 20 + 5 * D;
  std::size_t weights = 0;
  for (const DeviceUptake& uptake : image.uptakes) weights += uptake.weight.size() * sizeof(double);
  return of(image.surface_of_node, image.constraint_of_node, image.constraints, image.node_size, image.row_start,
            image.row_ends, image.column, image.place) +
         of(image.volume, image.stretch, image.mean_saturation, image.mean_pressure) + weights +
         (lanes * element_work + nodes * (node_work + 3)) * sizeof(double) +
         nodes * (sizeof(SurfaceWater) + sizeof(HeldLine)) + image.column.size() * (1 + 2 * D) * sizeof(double);
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

namespace {

std::size_t find_place(int e, int size, int i, int width) {
  return (static_cast<std::size_t>(e / width) * static_cast<std::size_t>(size) + static_cast<std::size_t>(i)) *
             static_cast<std::size_t>(width) +
         static_cast<std::size_t>(e % width);
}

/// Converts an array [block][size][lane] of the body to the blocks of a device; empty if it is empty.
std::vector<double> widen(const AlignedVector<double>& field, int elements, int size) {
  if (field.empty()) return {};
  const int blocks = (elements + device_width - 1) / device_width;
  std::vector<double> wide(static_cast<std::size_t>(blocks) * static_cast<std::size_t>(size) * device_width, 0.0);
  for (int e = 0; e < elements; ++e)
    for (int i = 0; i < size; ++i)
      wide[find_place(e, size, i, device_width)] = field[find_place(e, size, i, lane_width)];
  return wide;
}
void narrow(const std::vector<double>& wide, int elements, int size, AlignedVector<double>& field) {
  if (field.empty()) return;
  for (int e = 0; e < elements; ++e)
    for (int i = 0; i < size; ++i)
      field[find_place(e, size, i, lane_width)] = wide[find_place(e, size, i, device_width)];
}

template <int D>
void lay_out(const Body<D>& body, DeviceImage<D>& image) {
  const mesh::Mesh<D>& mesh = body.mesh();
  const int elements = mesh.element_count(), blocks = (elements + device_width - 1) / device_width;
  image.mesh = {look_at(mesh.nodes),   look_at(mesh.elements),  look_at(mesh.neighbours),
                look_at(mesh.volumes), look_at(mesh.altitudes), look_at(mesh.gradients)};
  const std::size_t lanes = static_cast<std::size_t>(blocks) * device_width;
  image.connectivity.resize(lanes * (D + 1));
  image.gradients.assign(lanes * D * D, 0.0);
  image.volumes.assign(lanes, 0.0);
  image.row_start.assign(mesh.nodes.size() + 1, 0);
  for (int e = 0; e < static_cast<int>(lanes); ++e) {
    for (int k = 0; k <= D; ++k) {
      const int node = mesh.elements[std::min(e, elements - 1)][k];
      image.connectivity[find_place(e, D + 1, k, device_width)] = node;
      if (e < elements) ++image.row_start[node + 1];
    }
    if (e >= elements) continue;
    for (int i = 0; i < D * D; ++i) image.gradients[find_place(e, D * D, i, device_width)] = mesh.gradients[e][i];
    image.volumes[e] = mesh.volumes[e];
  }
  for (std::size_t i = 0; i + 1 < image.row_start.size(); ++i) image.row_start[i + 1] += image.row_start[i];
  image.node_rows.resize(static_cast<std::size_t>(elements) * (D + 1));
  std::vector<int> next(image.row_start.begin(), image.row_start.end() - 1);
  for (int e = 0; e < elements; ++e)
    for (int k = 0; k <= D; ++k) image.node_rows[next[mesh.elements[e][k]]++] = e * (D + 1) + k;
}

template <int D>
void copy_points(const Body<D>& body, int threads, DeviceImage<D>& image) {
  const Points<D>& points = body.points;
  const int elements = body.mesh().element_count(), blocks = (elements + device_width - 1) / device_width;
  image.fields = points.fields;
  image.point_count = points.size();
  image.count = widen(points.count, elements, 1);
  image.block_start.clear();
  image.block_capacity.clear();
  std::int64_t slots = 0;
  for (int b = 0; b < blocks; ++b) {
    const auto first = image.count.begin() + static_cast<std::ptrdiff_t>(b) * device_width;
    const int most = static_cast<int>(*std::max_element(first, first + device_width));
    image.block_start.push_back(slots);
    image.block_capacity.push_back(most == 0 ? 0 : most + spare_slots);
    slots += image.block_capacity.back();
  }
  image.data.assign(static_cast<std::size_t>(slots) * static_cast<std::size_t>(points.fields) * device_width, 0.0);
  image.id.assign(static_cast<std::size_t>(slots) * device_width, -1);
  parallel_for(blocks, threads, [&](int b) {
    for (int e = b * device_width; e < std::min(elements, (b + 1) * device_width); ++e) {
      for (int k = 0; k < static_cast<int>(points.count[e]); ++k) {
        const std::int64_t from = points.block_start[e / lane_width] + k, to = image.block_start[b] + k;
        const double* p = points.slot(from) + e % lane_width;
        double* q = &image.data[static_cast<std::size_t>(to * points.fields * device_width + e % device_width)];
        for (int f = 0; f < points.fields; ++f) q[f * device_width] = p[f * lane_width];
        image.id[static_cast<std::size_t>(to * device_width + e % device_width)] =
            points.id[static_cast<std::size_t>(from * lane_width + e % lane_width)];
      }
    }
  });
  image.material = {points.material.data(), points.material.size()};
  image.reference = {points.reference.data(), points.reference.size()};
  image.strain_offset.assign(points.strain_offset.begin(), points.strain_offset.end());
}

/// Calls work(array of the body, array of the image, size) for the fields of elements that change, [block][size][lane].
template <int D, class Work>
void for_fields(Elements<D>& elements, DeviceImage<D>& image, Work&& work) {
  work(elements.strain, image.strain, PointFields<D>::stress_size);
  work(elements.fill_limit, image.fill_limit, 1);
  work(elements.apart, image.apart, 1);
  work(elements.rough, image.rough, 1);
  work(elements.plastic_dilation, image.plastic_dilation, 1);
  work(elements.softened, image.softened, 1);
  work(elements.softening_volume, image.softening_volume, 1);
  work(elements.nonlocal_correction, image.nonlocal_correction, 1);
}

/// Writes the k-th point of element `e`, which is in block `b`, from fields with the stride of a device.
template <int D>
void put_point(Points<D>& points, int b, int e, int k, int id, const double* from) {
  const std::int64_t slot = points.block_start[b] + k, place = slot * lane_width + e % lane_width;
  double* to = points.slot(slot) + e % lane_width;
  for (int f = 0; f < points.fields; ++f) to[f * lane_width] = from[f * device_width];
  points.id[static_cast<std::size_t>(place)] = id;
  points.element[id] = e;
  points.place[id] = place;
  points.block_materials[b] |= 1u << points.material[id];
}

template <int D>
void read_points(const DeviceImage<D>& image, int threads, Body<D>& body) {
  Points<D>& points = body.points;
  const int elements = body.mesh().element_count();
  std::vector<int> used(static_cast<std::size_t>(body.layout->blocks), 0);
  for (int e = 0; e < elements; ++e)
    used[e / lane_width] = std::max(used[e / lane_width], static_cast<int>(image.count[e]));
  allocate_slots(points, used);
  std::fill(points.element.begin(), points.element.end(), -1);
  std::fill(points.place.begin(), points.place.end(), -1);
  parallel_for(body.layout->blocks, threads, [&](int b) {
    for (int e = b * lane_width; e < std::min(elements, (b + 1) * lane_width); ++e) {
      for (int k = 0; k < static_cast<int>(image.count[e]); ++k) {
        const std::int64_t slot = image.block_start[e / device_width] + k;
        const double* from =
            &image.data[static_cast<std::size_t>(slot * image.fields * device_width + e % device_width)];
        put_point(points, b, e, k, image.id[static_cast<std::size_t>(slot * device_width + e % device_width)], from);
      }
      points.count[e] = image.count[e];
    }
    points.block_used[b] = used[b];
  });
  std::copy(image.strain_offset.begin(), image.strain_offset.end(), points.strain_offset.begin());
}

/// The sums of a node are written to its first row; a node's rows are summed wherever they are read.
template <int D>
void read_nodes(const DeviceImage<D>& image, Body<D>& body) {
  const Layout<D>& layout = *body.layout;
  Nodes<D>& nodes = body.nodes;
  std::fill(nodes.sums.begin(), nodes.sums.end(), 0.0);
  for (int i = 0; i < body.mesh().node_count(); ++i) {
    for (int k = 0; k < layout.count_motion_rows(i); ++k) {
      const auto row = static_cast<std::size_t>(layout.motion_row(i, k)), from = static_cast<std::size_t>(i);
      if (k == 0) std::copy_n(&image.sums[from * sums_stride], sums_stride, &nodes.sums[row * sums_stride]);
      std::copy_n(&image.motion[from * motion_stride<D>], motion_stride<D>, &nodes.motion[row * motion_stride<D>]);
    }
  }
  nodes.displacement = image.displacement;
  nodes.motion_step = image.motion_step;
}

/// Lists the loads on nodes by node, in the order of the loads.
template <int D>
void list_loads(const Body<D>& body, DeviceImage<D>& image) {
  const std::vector<Load<D>>& loads = body.conditions.loads;
  if (loads.empty()) return;
  for (std::size_t l = 0; l < loads.size(); ++l)
    for (const auto& entry : loads[l].entries)
      (loads[l].on_points ? image.point_loads : image.node_loads)
          .push_back({static_cast<int>(l), entry.index, entry.force});
  std::stable_sort(image.node_loads.begin(), image.node_loads.end(),
                   [](const auto& a, const auto& b) { return a.index < b.index; });
  image.load_start.assign(body.mesh().nodes.size() + 1, 0);
  for (const DeviceLoad<D>& load : image.node_loads) ++image.load_start[load.index + 1];
  std::partial_sum(image.load_start.begin(), image.load_start.end(), image.load_start.begin());
}

}  // namespace

template <int D>
DeviceImage<D> make_device_image(const Body<D>& body, int threads) {
  DeviceImage<D> image;
  lay_out(body, image);
  copy_points(body, threads, image);
  const int elements = body.mesh().element_count();
  for_fields(const_cast<Elements<D>&>(body.elements), image,
             [&](const AlignedVector<double>& field, std::vector<double>& wide, int size) {
               wide = widen(field, elements, size);
             });
  image.held_saturation = widen(body.elements.held_saturation, elements, 1);
  for (const material::Law& law : body.laws) image.laws.push_back(store_law(law));
  list_loads(body, image);
  image.constraint_of_node = body.conditions.constraint_of_node;
  image.constraints = body.conditions.constraints;
  if (body.softening_reach) {
    image.reach_start = look_at(body.softening_reach->start);
    image.reach_element = look_at(body.softening_reach->element);
    image.reach_weight = look_at(body.softening_reach->weight);
  }
  image.smallest_mass = body.smallest_mass;
  image.motion.resize(body.mesh().nodes.size() * motion_stride<D>);
  for (int i = 0; i < body.mesh().node_count(); ++i)
    std::copy_n(&body.nodes.motion[static_cast<std::size_t>(body.layout->motion_row(i, 0)) * motion_stride<D>],
                motion_stride<D>, &image.motion[static_cast<std::size_t>(i) * motion_stride<D>]);
  image.displacement = body.nodes.displacement;
  image.motion_step = body.nodes.motion_step;
  image.water = make_water_image(body);
  return image;
}

template <int D>
void read_device_image(const DeviceImage<D>& image, int threads, Body<D>& body) {
  read_points(image, threads, body);
  const int elements = body.mesh().element_count();
  for_fields(body.elements, const_cast<DeviceImage<D>&>(image),
             [&](AlignedVector<double>& field, const std::vector<double>& wide, int size) {
               narrow(wide, elements, size, field);
             });
  narrow(image.moments, elements, moment_size<D>, body.elements.moments);
  read_nodes(image, body);
  read_water_image(image.water, body);
  gather_loads(body);
}

template <int D>
std::size_t count_bytes(const DeviceImage<D>& image) {
  const auto of = [](const auto&... lists) { return ((lists.size() * sizeof *lists.data()) + ...); };
  const std::size_t lanes = image.count.size(), nodes = image.mesh.nodes.size(), numbers = sizeof(double);
  const std::size_t points = static_cast<std::size_t>(image.point_count), slots = image.id.size() / device_width,
                    slot = device_width * (static_cast<std::size_t>(image.fields) * numbers + sizeof(int)),
                    mover = static_cast<std::size_t>(image.fields) * numbers + 5 * sizeof(int);
  const std::size_t element_work = moment_size<D> + (D + 1) * sums_stride + (D + 1) * D + 2 + 2 + 2,
                    node_work = 1 + 2 * sums_stride + D + 16;
  return of(image.mesh.nodes, image.mesh.elements, image.mesh.neighbours, image.mesh.volumes, image.mesh.altitudes,
            image.mesh.gradients) +
         of(image.connectivity, image.row_start, image.node_rows, image.gradients, image.volumes, image.reach_start,
            image.reach_element, image.reach_weight) +
         of(image.material, image.reference, image.held_saturation, image.data, image.count, image.id,
            image.strain_offset, image.strain) +
         of(image.fill_limit, image.apart, image.rough, image.plastic_dilation, image.softened, image.softening_volume,
            image.nonlocal_correction, image.motion, image.displacement) +
         points * (sizeof(int) + sizeof(std::int64_t)) + (find_room(slots) - slots) * slot +
         points / mover_share * mover + of(image.load_start, image.node_loads, image.point_loads) +
         image.point_loads.size() * (3 * sizeof(int) + sizeof(Vec<D>) * (D + 1)) + lanes * element_work * numbers +
         nodes * node_work * numbers + count_bytes(image.water);
}

#define TALUS_INSTANTIATE(D)                                         \
  template std::size_t count_bytes<D>(const DeviceImage<D>&);        \
  template DeviceImage<D> make_device_image<D>(const Body<D>&, int); \
  template void read_device_image<D>(const DeviceImage<D>&, int, Body<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
