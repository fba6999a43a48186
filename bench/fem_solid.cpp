// SPDX-License-Identifier: MIT
// Cost of the strength reduction by FEM under mesh refinement: linear systems, factorisations and seconds, for the
// slope of Griffiths and Lane with and without dilatancy; in 3D 40 ft of it, between a plane of symmetry and a rigid
// wall.
//
// Usage: fem_solid [2|3] [largest element, ft] [smallest element, ft] [threads]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "fem/solid/solid.hpp"
#include "material/every_law.hpp"
#include "mesh/generate.hpp"

using namespace talus;

namespace {

constexpr double degree = std::numbers::pi / 180;

template <int D>
std::vector<fem::Support<D>> make_supports(const mesh::Mesh<D>& mesh) {
  std::vector<fem::Support<D>> supports(D == 2 ? 2 : 4);
  supports[0] = {"base", mesh.sides.at("bottom"), {}, false};
  supports[0].fixed.fill(true);
  supports[1] = {"left", mesh.sides.at("left"), {true}, false};
  if constexpr (D == 3) {
    supports[2] = {"front", mesh.sides.at("front"), {false, false, true}, false};
    supports[3] = {"back", mesh.sides.at("back"), {true, true, true}, false};
  }
  return supports;
}

template <int D>
void reduce(const mesh::Mesh<D>& mesh, double psi, int threads) {
  fem::SolidModel<D> model;
  model.mesh = &mesh;
  model.make_law = [&](int, double factor) -> material::Law {
    const material::MohrCoulombStrength strength{312.5, 20 * degree, psi * degree, 312.5 / std::tan(20 * degree)};
    return material::MohrCoulomb(material::LinearElastic::from_young(1e5, 0.3), strength.reduced(factor));
  };
  model.unit_weight.assign(mesh.elements.size(), 125);
  model.direction[1] = -1;
  model.supports = make_supports<D>(mesh);
  fem::ReductionOptions options;
  options.solid.threads = threads;
  const auto r = fem::reduce_strength<D>(model, options);
  std::size_t soil = 0;
  for (int region : mesh.element_region) soil += region != mesh::empty_region;
  std::printf("%9zu %9d %5g %8.4f %8d %15d %9.2f\n", soil, r.unknowns, psi, r.factor, r.iterations, r.factorisations,
              r.seconds);
  std::fflush(stdout);
}

template <int D>
void refine(double largest, double smallest, int threads) {
  std::printf("%9s %9s %5s %8s %8s %15s %9s\n", "elements", "unknowns", "psi", "factor", "systems", "factorisations",
              "seconds");
  for (double size = largest; size >= smallest * 0.999; size /= std::sqrt(2.0)) {
    mesh::Plan plan;
    plan.dimension = D;
    plan.thickness = 40;
    plan.box_min = {0, 0};
    plan.box_max = {160, 50};
    plan.size = size;
    plan.polygons = {{"soil", {{0, 0}, {160, 0}, {60, 50}, {0, 50}}}};
    const auto mesh = mesh::generate<D>(plan);
    for (const double psi : {20.0, 0.0}) reduce<D>(mesh, psi, threads);
  }
}

}  // namespace

int main(int count, char** words) {
  const bool solid = count > 1 && std::atoi(words[1]) == 3;
  const double largest = count > 2 ? std::atof(words[2]) : (solid ? 12 : 5),
               smallest = count > 3 ? std::atof(words[3]) : largest / 2;
  (solid ? refine<3> : refine<2>)(largest, smallest, count > 4 ? std::atoi(words[4]) : 1);
}
