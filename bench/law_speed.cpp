// SPDX-License-Identifier: MIT
// Million updates per second of each constitutive law in plane strain, in packs: all lanes elastic, all plastic, and
// one in four plastic, as in a sliding slope; with the time relative to Mohr–Coulomb.
//
// Usage: law_speed [STRAIN]
//
// STRAIN is the size of the strain increments (default 1e-6), which corresponds to some steps per millisecond at 1 1/s.

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "material/every_law.hpp"

namespace {

using talus::Pack;
constexpr int pack_count = 64, repeats = 2000;
constexpr double kpa = 1e3;

/// A pack of points with its strain increment.
struct Lanes {
  std::array<Pack, 4> stress, d_epsilon;
  std::array<Pack, talus::material::max_state_size> state;
};

double read_clock() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Initialises lane `l`: a plastic lane on the yield surface under loading, an elastic one well inside.
template <class Law>
void set_lane(const Law& law, Lanes& lanes, int l, bool plastic, double strain, int number) {
  const double p = 50 * kpa * (1 + 0.01 * number);
  std::array<double, 4> stress{-p, -p, -p, 0};
  std::array<double, talus::material::max_state_size> state{};
  if constexpr (!std::is_same_v<Law, talus::material::MohrCoulomb>)
    law.set_initial_state(stress.data(), 0.8, 0.5, plastic ? p : 3 * p, 0.9, state.data());
  const std::array<double, 4> direction{0.5 * strain, -strain, 0, 0.7 * strain};
  for (int i = 0; i < (plastic ? 40 : 1); ++i) {  // until the yield surface is reached
    std::array<double, 4> d = direction;
    for (double& x : d) x *= 2e-3 / strain;
    talus::material::Surroundings<double> around;
    around.saturation = 0.9;
    law.template update<4>(stress.data(), d.data(), state.data(), true, around);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    lanes.stress[i].value[l] = stress[i];
    lanes.d_epsilon[i].value[l] = plastic ? direction[i] : -direction[i];
  }
  for (std::size_t i = 0; i < state.size(); ++i) lanes.state[i].value[l] = state[i];
}

/// Returns the seconds per update of one point, with `plastic_of_four` of four lanes plastic.
template <class Law>
double time_law(const Law& law, int plastic_of_four, double strain) {
  std::vector<Lanes> packs(pack_count);
  int number = 0;
  for (Lanes& lanes : packs)
    for (int l = 0; l < talus::lane_width; ++l, ++number)
      set_lane(law, lanes, l, (number + number / 4) % 4 < plastic_of_four, strain, number % 100);
  talus::material::Surroundings<Pack> around;
  around.saturation = Pack(0.9);
  Pack sum(0.0);
  double best = 1e30;
  for (int round = 0; round < 5; ++round) {
    const double start = read_clock();
    for (int r = 0; r < repeats; ++r) {
      for (const Lanes& lanes : packs) {
        std::array<Pack, 4> stress = lanes.stress;
        auto state = lanes.state;
        const auto response =
            law.template update<4>(stress.data(), lanes.d_epsilon.data(), state.data(), talus::Mask(true), around);
        sum += stress[0] + stress[1] + stress[2] + stress[3] + response.dissipation;
        for (std::size_t i = 0; i < static_cast<std::size_t>(Law::state_size); ++i) sum += state[i];
      }
    }
    best = std::min(best, (read_clock() - start) / (repeats * pack_count * talus::lane_width));
  }
  if (sum[0] == 12345) fmt::print("\n");  // prevents the compiler from removing the updates
  return best;
}

template <class Law>
void print_row(const char* name, const Law& law, double strain, std::array<double, 3>& yardstick) {
  std::array<double, 3> time{};
  for (std::size_t k = 0; k < 3; ++k) time[k] = time_law(law, std::array{0, 1, 4}[k], strain);
  if (yardstick[0] == 0) yardstick = time;
  fmt::print("{:20}", name);
  for (std::size_t k = 0; k < 3; ++k) fmt::print("{:12.0f} {:6.2f}", 1e-6 / time[k], time[k] / yardstick[k]);
  fmt::print("\n");
}

}  // namespace

int main(int count, char** arguments) {
  using namespace talus::material;
  const double strain = count > 1 ? std::atof(arguments[1]) : 1e-6;
  const CamClayParameters soil{.compression = 0.155,
                               .swelling = 0.04,
                               .poisson_ratio = 0.35,
                               .critical_state_slope = 0.827,
                               .suction_hardening = 10};
  std::array<double, 3> yardstick{};
  fmt::print("million updates per second, and time as a multiple of Mohr-Coulomb's; increments of {:g}\n", strain);
  fmt::print("{:20}{:>19}{:>19}{:>19}\n", "", "elastic", "one in four", "plastic");
  print_row("Mohr-Coulomb", MohrCoulomb(LinearElastic::from_young(20e6, 0.3), {5 * kpa, 0.4, 0.1, 1 * kpa}), strain,
            yardstick);
  print_row("modified Cam-clay", ModifiedCamClay(soil), strain, yardstick);
  print_row("rooted Cam-clay", RootedCamClay(soil, {.hardening = 0.4, .strength = 0.18}), strain, yardstick);
  print_row("with breakage",
            RootedCamClay(soil, {.hardening = 0.4, .strength = 0.18, .breaking_strain = 1, .breaking_range = 0.1}),
            strain, yardstick);
}
