// SPDX-License-Identifier: MIT
// A thick cylinder under internal pressure in plane strain: Lamé's elastic solution, and Hill's solution with a plastic
// zone of Tresca material, which equals frictionless Mohr–Coulomb.

#include <gtest/gtest.h>

#include <cmath>

#include "support/solid_model.hpp"

namespace talus {
namespace {

constexpr double inner = 1, outer = 2, young = 1e7, poisson = 0.3, cohesion = 10e3;
const double pi = std::acos(-1.0);

/// A quarter of the ring with `n` sides along the inner arc; corners lie on the circles.
struct Cylinder {
  mesh::Mesh<2> mesh;
  fem::SolidModel<2> model;

  Cylinder(int n, double pressure, bool plastic) {
    mesh::Plan plan;
    plan.box_min = {0, 0};
    plan.box_max = {outer, outer};
    plan.size = pi / 2 * inner / n;
    std::vector<std::array<double, 2>> ring;
    for (int i = 0; i <= n; ++i) ring.push_back({inner * std::cos(pi / 2 * i / n), inner * std::sin(pi / 2 * i / n)});
    for (int i = 2 * n; i >= 0; --i)
      ring.push_back({outer * std::cos(pi / 4 * i / n), outer * std::sin(pi / 4 * i / n)});
    ring[static_cast<std::size_t>(n)][0] = ring[static_cast<std::size_t>(n) + 1][0] = 0;
    plan.polygons = {{"ring", ring}};
    mesh = mesh::generate<2>(plan);
    model.mesh = &mesh;
    model.make_law = [=](int, double factor) -> material::Law {
      const auto elastic = material::LinearElastic::from_young(young, poisson);
      if (!plastic) return elastic;
      return material::MohrCoulomb(elastic, material::MohrCoulombStrength{cohesion, 0, 0, 1e9}.reduced(factor));
    };
    model.unit_weight.assign(mesh.elements.size(), 0);
    support::add_roller<2>(model, 0, 0);
    support::add_roller<2>(model, 1, 0);
    fem::SurfaceLoad<2> load;
    load.name = "pressure";
    load.sides = support::find_sides<2>(mesh, [](const Vec<2>& x) { return norm(x) < 1.01 * inner; });
    for (const auto& side : load.sides) {
      std::array<Vec<2>, 2> t;
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t d = 0; d < 2; ++d)
          t[i][d] = pressure * mesh.nodes[static_cast<std::size_t>(side[i])][d] / inner;
      load.traction.push_back(t);
    }
    model.loads.push_back(load);
  }
  Cylinder(const Cylinder&) = delete;

  /// Radial displacement at the corners of the outer arc, least and largest [m].
  std::array<double, 2> find_outer(const fem::SolidState<2>& at) const {
    std::array<double, 2> range{1e9, -1e9};
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (std::abs(norm(mesh.nodes[n]) - outer) > 1e-9) continue;
      const double u = dot(at.displacement[n], mesh.nodes[n]) / outer;
      range = {std::min(range[0], u), std::max(range[1], u)};
    }
    return range;
  }
};

TEST(ThickCylinder, LameElastic) {
  const double p = 8e3, b2 = outer * outer, a = p / (b2 - 1);
  std::vector<double> errors;
  for (int n : {4, 8, 16}) {
    const Cylinder ring(n, p, false);
    const auto r = fem::find_equilibrium<2>(ring.model, {});
    ASSERT_TRUE(r.converged);
    const auto mesh = fem::make_quadratic<2>(ring.mesh);
    double error = 0, sum = 0;
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
      const double radius = norm(mesh.points[k]), x = mesh.points[k][0] / radius, y = mesh.points[k][1] / radius;
      const auto& s = r.at.stress[k];
      const double radial = s[0] * x * x + s[1] * y * y + 2 * s[3] * x * y, hoop = s[0] + s[1] - radial;
      const double e1 = radial - a * (1 - b2 / (radius * radius)), e2 = hoop - a * (1 + b2 / (radius * radius));
      error += mesh.weights[k] * (e1 * e1 + e2 * e2);
      sum += mesh.weights[k];
    }
    errors.push_back(std::sqrt(error / sum) / p);
    const double exact = (1 + poisson) / young * a * 2 * (1 - poisson) * outer;
    const auto u = ring.find_outer(r.at);
    EXPECT_NEAR(u[0] / exact, 1, 0.65 / (n * n));
    EXPECT_NEAR(u[1] / exact, 1, 0.65 / (n * n));
  }
  // straight sides approximate the arcs to second order, and that bounds the stress
  EXPECT_LT(errors[2], 4e-3);
  EXPECT_LT(errors[2], 0.35 * errors[1]);
  EXPECT_LT(errors[1], 0.35 * errors[0]);
}

TEST(ThickCylinder, HillElasticPlastic) {
  for (const double front : {1.2, 1.5, 1.8}) {
    const double p = 2 * cohesion * std::log(front / inner) + cohesion * (1 - front * front / (outer * outer));
    const Cylinder ring(16, p, true);
    const auto r = fem::find_equilibrium<2>(ring.model, {});
    ASSERT_TRUE(r.converged);
    const double exact = 2 * (1 - poisson * poisson) * cohesion * front * front / (young * outer);
    const auto u = ring.find_outer(r.at);
    EXPECT_NEAR(u[0] / exact, 1, 0.012) << front;
    EXPECT_NEAR(u[1] / exact, 1, 0.012) << front;
    const auto mesh = fem::make_quadratic<2>(ring.mesh);
    double plastic = 0;
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
      const double radius = norm(mesh.points[k]), x = mesh.points[k][0] / radius, y = mesh.points[k][1] / radius;
      if (r.at.yields[k]) plastic += mesh.weights[k];
      if (radius > 0.95 * front) continue;
      const auto& s = r.at.stress[k];
      const double radial = s[0] * x * x + s[1] * y * y + 2 * s[3] * x * y;
      EXPECT_NEAR(radial, -p + 2 * cohesion * std::log(radius / inner), 0.04 * p) << front << " " << radius;
    }
    EXPECT_NEAR(plastic, pi / 4 * (front * front - 1), 0.06 * pi / 4 * (outer * outer - 1)) << front;
  }
}

TEST(ThickCylinder, PlasticCollapseByStrengthReduction) {
  // p = 2c ln(b/a) is the limit; half of it has the factor 2
  const Cylinder ring(12, cohesion * std::log(outer / inner), true);
  fem::ReductionOptions options;
  options.from = 1.5, options.to = 2.5;
  const auto r = fem::reduce_strength<2>(ring.model, options);
  EXPECT_NEAR(r.factor, 2, 0.02);
  EXPECT_LE(r.failed - r.stable, options.resolution * 1.001);
}

}  // namespace
}  // namespace talus
