// SPDX-License-Identifier: MIT
// Results are bitwise identical for any number of threads: a hash over all point fields of failing slopes.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "mpm/solver/step.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

/// FNV-1a hash of all point fields, the lost points and the sums of the run.
template <int D>
std::uint64_t hash_body(const mpm::Body<D>& body) {
  std::uint64_t h = 14695981039346656037u;
  const auto add = [&](std::uint64_t bits) {
    for (int i = 0; i < 8; ++i) {
      h ^= bits >> (8 * i) & 0xff;
      h *= 1099511628211u;
    }
  };
  const auto add_number = [&](double x) { add(std::bit_cast<std::uint64_t>(x)); };
  for (int id = 0; id < body.points.size(); ++id) {
    add(static_cast<std::uint64_t>(static_cast<std::int64_t>(body.points.element[static_cast<std::size_t>(id)])));
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    for (const auto* field : {&p.position, &p.velocity, &p.displacement}) {
      for (double x : *field) add_number(x);
    }
    for (const auto* field : {&p.stress, &p.strain}) {
      for (double x : *field) add_number(x);
    }
    for (double x : {p.mass, p.volume, p.plastic_strain}) add_number(x);
  }
  for (const auto& lost : body.lost) {
    add(static_cast<std::uint64_t>(lost.id));
    for (double x : lost.momentum) add_number(x);
  }
  for (double x : {body.work.external, body.work.damped, body.work.dissipated, body.monitor.out_of_balance,
                   body.monitor.kinetic_energy})
    add_number(x);
  return h;
}

/// A weak bank of two soils beside an open end: it fails, spreads through many chunks, and some of it leaves the grid.
template <int D>
mpm::Body<D> make_bank() {
  std::array<int, D> cells;
  Vec<D> size;
  cells[0] = D == 2 ? 40 : 14, size[0] = 4;
  cells[1] = D == 2 ? 20 : 7, size[1] = 2;
  if constexpr (D == 3) cells[2] = 4, size[2] = 1;
  const auto elastic = material::LinearElastic::from_young(2e6, 0.3);
  mpm::Body<D> body = support::fill_body<D>(
      support::make_mesh<D>(cells, size),
      {{material::MohrCoulomb(elastic, {300, 0.4, 0.05, 100}), 1800},
       {material::MohrCoulomb(elastic, {100, 0.3, 0.0, 50}), 1600}},
      D == 2 ? 3 : 4, [](const Vec<D>& x) { return x[1] > 1.6 - 0.35 * x[0] ? -1
                                                   : x[1] < 0.6             ? 0
                                                                            : 1; },
      [](mpm::InitialPoint<D>& p, const Vec<D>& x) { p.velocity[0] = 1.5 * x[1]; }, 11);
  support::fix_nodes<D>(body, 0, [](const Vec<D>& x) { return x[0] < 1e-9 || x[1] < 1e-9; });
  support::fix_nodes<D>(body, 1, [](const Vec<D>& x) { return x[1] < 1e-9; });
  if constexpr (D == 3) support::fix_nodes<3>(body, 2, [](const Vec<3>& x) { return x[2] < 1e-9 || x[2] > 1 - 1e-9; });
  return body;
}

template <int D>
void expect_bitwise_identical(int steps) {
  for (const support::Mode& mode : support::all_modes()) {
    for (const bool moving : {true, false}) {
      std::uint64_t first = 0;
      for (const int threads : {1, 2, 4}) {
        mpm::Body<D> body = make_bank<D>();
        ASSERT_GE(body.layout->chunks, 8);
        mpm::StepOptions<D> o;
        o.mixed = mode.mixed;
        o.smoothing = mode.smoothing;
        o.moving = moving;
        o.damping = 0.05;
        o.gravity[1] = -9.81;
        o.monitor = true;
        o.threads = threads;
        o.dt = 0.6 * mpm::find_critical_step(body, 1).dt;
        mpm::gather_nodal_sums(body, o);
        const std::vector<int> start = body.points.element;
        support::run_steps(body, o, steps);
        if (moving) {
          EXPECT_NE(start, body.points.element) << "points must change their elements to test anything";
        }
        EXPECT_GT(body.work.dissipated, 0) << "the bank must fail to test anything";
        const std::uint64_t h = hash_body(body);
        if (threads == 1) first = h;
        EXPECT_EQ(h, first) << mode.name << (moving ? "" : " frozen") << " with " << threads << " threads";
      }
    }
  }
}

TEST(Threads, PlaneBankIsTheSameForAnyNumber) {
  expect_bitwise_identical<2>(200);
}
TEST(Threads, SpatialBankIsTheSameForAnyNumber) {
  expect_bitwise_identical<3>(120);
}

}  // namespace
}  // namespace talus
