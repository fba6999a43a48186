// SPDX-License-Identifier: MIT
// Nonlocal softening against plain loops at every point; bitwise identity for any number of threads and after a
// checkpoint.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "output/files/archive.hpp"
#include "reference/plain_softening.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "support/clay_block.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double length = 0.3;

std::vector<double> copy(const AlignedVector<double>& values, std::size_t count) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// Softening of a step, from the law itself: points of their own, whose strain is that of their element.
template <int D>
struct PlainStep {
  static constexpr int NS = material::stress_size<D>;
  std::vector<double> softened, volume;

  PlainStep(const mpm::Body<D>& before, const mpm::Body<D>& after, const std::vector<double>& nonlocal_correction)
      : softened(nonlocal_correction.size(), 0), volume(nonlocal_correction.size(), 0) {
    const material::ModifiedCamClay clay = support::make_block_clay();
    support::for_each_point<D>(before, [&](int id, const mpm::PointView<D>& p) {
      const auto q = mpm::view_point(after, id);
      const auto e = static_cast<std::size_t>(before.points.element[static_cast<std::size_t>(id)]);
      std::array<double, NS> stress, strain;
      std::copy(p.stress.begin(), p.stress.end(), stress.begin());
      for (std::size_t i = 0; i < NS; ++i) strain[i] = q.strain[i] - p.strain[i];
      auto state = p.state;
      material::Surroundings<double> around;
      material::Softening<double> softening{nonlocal_correction[e]};
      around.softening = &softening;
      clay.update<NS>(stress.data(), strain.data(), state.data(), true, around);
      softened[e] += p.volume * std::max(softening.softened, 0.0);
      volume[e] += p.volume;
      // Strains are differences of sums: their round-off times the stiffness.
      for (std::size_t i = 0; i < NS; ++i) EXPECT_NEAR(q.stress[i], stress[i], 1e-6);
      EXPECT_NEAR(q.state[1], state[1], 1e-9 * state[1]);
    });
  }
};

template <int D>
void compare_with_plain_loops(int cells, int before, int compared) {
  mpm::Body<D> body = support::make_clay_block<D>(cells, length);
  mpm::StepOptions<D> o = support::make_block_options(body);
  o.mixed = false, o.objective = false, o.smoothing = input::Smoothing::none;
  mpm::gather_nodal_sums(body, o);
  support::run_steps(body, o, before);
  const std::size_t count = body.mesh().elements.size();
  double most = 0;
  for (int n = 0; n < compared; ++n) {
    const std::vector<double> nonlocal_correction = reference::find_nonlocal_correction(
        body.mesh(), copy(body.elements.softened, count), copy(body.elements.softening_volume, count), length);
    const mpm::Body<D> old = body;
    mpm::step(body, o);
    const PlainStep<D> plain(old, body, nonlocal_correction);
    const double largest = *std::max_element(nonlocal_correction.begin(), nonlocal_correction.end());
    most = std::max(most, largest);
    for (std::size_t e = 0; e < count; ++e) {
      EXPECT_NEAR(body.elements.nonlocal_correction[e], nonlocal_correction[e], 1e-12 * largest);
      EXPECT_NEAR(body.elements.softened[e], plain.softened[e], 1e-9 * plain.volume[e] * largest);
      EXPECT_NEAR(body.elements.softening_volume[e], plain.volume[e], 1e-12);
    }
  }
  EXPECT_GT(most, 1e-9) << "it must soften to test anything";
}

TEST(SofteningLength, IsThatOfPlainLoops) {
  compare_with_plain_loops<2>(8, 1500, 3);
  compare_with_plain_loops<3>(4, 1000, 3);
}

/// The pressure of every point, which all that happens before has changed.
template <int D>
std::vector<double> list_pressures(const mpm::Body<D>& body) {
  std::vector<double> list;
  support::for_each_point<D>(body, [&](int, const mpm::PointView<D>& p) { list.push_back(p.state[1]); });
  return list;
}

TEST(SofteningLength, IsBitwiseIdenticalForAnyNumberOfThreads) {
  std::vector<double> first;
  for (const int threads : {1, 2, 4}) {
    mpm::Body<2> body = support::make_clay_block<2>(12, length);
    mpm::StepOptions<2> o = support::make_block_options(body);
    o.threads = threads, o.moving = true;
    support::run_steps(body, o, 3000);
    if (threads == 1) first = list_pressures(body);
    EXPECT_EQ(list_pressures(body), first) << threads;
  }
}

TEST(SofteningLength, ResumesBitwiseIdentical) {
  mpm::Body<2> body = support::make_clay_block<2>(8, length);
  mpm::StepOptions<2> o = support::make_block_options(body);
  o.moving = true;
  support::run_steps(body, o, 2000);
  ASSERT_GT(std::accumulate(body.elements.softened.begin(), body.elements.softened.end(), 0.0), 0);
  const std::filesystem::path file = support::name_scratch("body.h5");
  output::ArchiveWriter archive;
  run::put_body(archive, body);
  archive.write(file);
  mpm::Body<2> resumed = support::make_clay_block<2>(8, length);
  run::get_body(output::ArchiveReader(file), resumed);
  mpm::gather_loads(resumed);
  support::run_steps(body, o, 50);
  support::run_steps(resumed, o, 50);
  EXPECT_EQ(list_pressures(body), list_pressures(resumed));
}

}  // namespace
}  // namespace talus
