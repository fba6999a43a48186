// SPDX-License-Identifier: MIT
// Cost of the strength reduction by FEM under mesh refinement: linear systems, factorisations and seconds on one
// thread, for the slope of Griffiths and Lane with and without dilatancy.
//
// Usage: fem_solid [smallest element, ft]

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fem/solid/solid.hpp"
#include "mesh/generate.hpp"

using namespace talus;

int main(int count, char** words) {
  const double smallest = count > 1 ? std::atof(words[1]) : 2.5, degree = std::acos(-1.0) / 180;
  std::printf("%9s %9s %5s %8s %8s %15s %9s\n", "elements", "unknowns", "psi", "factor", "systems", "factorisations",
              "seconds");
  for (double size = 5; size >= smallest * 0.999; size /= std::sqrt(2.0)) {
    mesh::Plan plan;
    plan.box_min = {0, 0};
    plan.box_max = {160, 50};
    plan.size = size;
    plan.polygons = {{"soil", {{0, 0}, {160, 0}, {60, 50}, {0, 50}}}};
    const auto mesh = mesh::generate<2>(plan);
    for (const double psi : {20.0, 0.0}) {
      fem::SolidModel<2> model;
      model.mesh = &mesh;
      model.make_law = [&](int, double factor) -> material::Law {
        const material::MohrCoulombStrength strength{312.5, 20 * degree, psi * degree, 312.5 / std::tan(20 * degree)};
        return material::MohrCoulomb(material::LinearElastic::from_young(1e5, 0.3), strength.reduced(factor));
      };
      model.unit_weight.assign(mesh.elements.size(), 125);
      model.direction = {0, -1};
      model.supports = {{"base", mesh.sides.at("bottom"), {true, true}, false},
                        {"left", mesh.sides.at("left"), {true, false}, false}};
      fem::ReductionOptions options;
      options.solid.threads = 1;
      const auto r = fem::reduce_strength<2>(model, options);
      std::size_t soil = 0;
      for (int region : mesh.element_region) soil += region != mesh::empty_region;
      std::printf("%9zu %9d %5g %8.4f %8d %15d %9.2f\n", soil, r.unknowns, psi, r.factor, r.iterations,
                  r.factorisations, r.seconds);
      std::fflush(stdout);
    }
  }
}
