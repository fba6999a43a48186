// SPDX-License-Identifier: MIT
#include "reference/bodies.hpp"

#include <random>

namespace talus::reference {

template <int D>
mesh::Mesh<D> make_box(const std::array<int, D>& cells, const std::array<double, D>& size, double jitter,
                       unsigned seed) {
  // mt19937 is the same everywhere; the standard distributions are not, so the number is scaled here.
  std::mt19937 random(seed);
  const auto draw = [&] { return 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1; };
  mesh::Mesh<D> mesh;
  std::array<int, D> stride{};
  int node_count = 1;
  for (int d = 0; d < D; ++d) {
    at(stride, d) = node_count;
    node_count *= at(cells, d) + 1;
  }
  for (int i = 0; i < node_count; ++i) {
    std::array<double, D> x{};
    std::array<int, D> index{};
    bool inside = true;
    for (int d = 0; d < D; ++d) {
      at(index, d) = i / at(stride, d) % (at(cells, d) + 1);
      inside = inside && at(index, d) > 0 && at(index, d) < at(cells, d);
    }
    for (int d = 0; d < D; ++d)
      at(x, d) = (at(index, d) + (inside ? jitter * draw() : 0.0)) * at(size, d) / at(cells, d);
    mesh.nodes.push_back(x);
  }
  for (int i = 0; i < node_count; ++i) {
    bool last = false;  // the node at the lower corner of a cell, or one on an upper face
    for (int d = 0; d < D; ++d) last = last || i / at(stride, d) % (at(cells, d) + 1) == at(cells, d);
    if (last) continue;
    std::array<int, D> order{};
    for (int d = 0; d < D; ++d) at(order, d) = d;
    do {  // one simplex for every way along D edges from the lower to the upper corner of the cell
      typename mesh::Mesh<D>::Element element{};
      element[0] = i;
      for (int k = 0; k < D; ++k) at(element, k + 1) = at(element, k) + at(stride, at(order, k));
      mesh.elements.push_back(element);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  mesh.element_region.assign(mesh.elements.size(), mesh::empty_region);
  mesh::finish(mesh);
  return mesh;
}

template <int D>
Body<D> make_body(const mesh::Mesh<D>& mesh, const Material& material) {
  Body<D> body;
  body.mesh = mesh;
  body.materials = {material};
  body.constraints.assign(mesh.nodes.size(), {});
  return body;
}

template <int D>
void fix_face(Body<D>& body, int axis, double value, int component) {
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (std::abs(at(body.mesh.nodes[i], axis) - value) < 1e-12) at(body.constraints[i].fixed, component) = true;
}

template <int D>
void fix_box(Body<D>& body, const typename mesh::Mesh<D>::Point& size) {
  for (int d = 0; d < D; ++d) {
    fix_face(body, 1, 0.0, d);
    if (d == 1) continue;
    fix_face(body, d, 0.0, d);
    fix_face(body, d, at(size, d), d);
  }
}

template <int D>
void set_k0_stress(Body<D>& body, const Slope& slope, double gravity, double k0) {
  for (Point<D>& point : body.points) {
    const double depth = std::max(0.0, slope.surface(point.x[0]) - point.x[1]);
    const double vertical = -point.mass / point.volume * gravity * depth;
    point.sigma = Vector3(k0 * vertical, vertical, k0 * vertical).asDiagonal();
  }
}

template <int D>
Body<D> make_slope(unsigned seed) {
  std::array<int, D> cells{};
  std::array<double, D> size{};
  for (int d = 0; d < D; ++d) {
    const int count[] = {D == 2 ? 16 : 8, D == 2 ? 10 : 5, 2};
    const double length[] = {8, 5, 2};
    at(cells, d) = count[d];
    at(size, d) = length[d];
  }
  Material soil;
  soil.young_modulus = 5e6;
  soil.poisson_ratio = 0.3;
  soil.plastic = true;
  soil.cohesion = 300;
  soil.friction_angle = 0.35;
  soil.dilatancy_angle = 0.1;
  soil.tensile_strength = 200;
  const double density = 1700, g = 9.81;
  const Slope slope{6, 1, 3, 4};
  Body<D> body = make_body(make_box<D>(cells, size, 0.15, seed), soil);
  body.gravity[1] = -g;
  fix_box(body, size);
  fill(body, density, 0, [&](const Vector<D>& x) { return x[1] < slope.surface(x[0]); });
  set_k0_stress(body, slope, g, 0.5);
  return body;
}

template mesh::Mesh<2> make_box<2>(const std::array<int, 2>& cells, const std::array<double, 2>& size, double jitter,
                                   unsigned seed);
template mesh::Mesh<3> make_box<3>(const std::array<int, 3>& cells, const std::array<double, 3>& size, double jitter,
                                   unsigned seed);
template Body<2> make_body<2>(const mesh::Mesh<2>& mesh, const Material& material);
template Body<3> make_body<3>(const mesh::Mesh<3>& mesh, const Material& material);
template void fix_face<2>(Body<2>& body, int axis, double value, int component);
template void fix_face<3>(Body<3>& body, int axis, double value, int component);
template void fix_box<2>(Body<2>& body, const typename mesh::Mesh<2>::Point& size);
template void fix_box<3>(Body<3>& body, const typename mesh::Mesh<3>::Point& size);
template void set_k0_stress<2>(Body<2>& body, const Slope& slope, double gravity, double k0);
template void set_k0_stress<3>(Body<3>& body, const Slope& slope, double gravity, double k0);
template Body<2> make_slope<2>(unsigned seed);
template Body<3> make_slope<3>(unsigned seed);

}  // namespace talus::reference
