// Million point-steps per second of the engine on the yardstick's slope.
//   step_speed D CASE THREADS [WARM STEPS REPEATS] [mixed] [smooth] [stable] [objective]
// CASE is small, mid or large. Single-threaded runs are timed in CPU time, threaded ones in wall time.

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <set>
#include <string>

#include "yardstick_case.hpp"

namespace {

double read_clock(bool wall) {
  timespec t;
  clock_gettime(wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <int D>
std::size_t memory_per_point(const talus::mpm::Body<D>& body) {
  const auto size = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  const auto& p = body.points;
  const auto& e = body.elements;
  const auto& n = body.nodes;
  const auto& l = *body.layout;
  const auto& m = l.mesh;
  const std::size_t total = size(p.data) + size(p.id) + size(p.count) + size(p.element) + size(p.place) +
                            size(p.material) + size(p.reference) + size(p.strain_offset) + size(e.moments) +
                            size(e.strain) + size(e.fill_limit) * 4 + size(n.sums) + size(n.motion) + size(n.average) +
                            size(n.smoothed) + size(n.displacement) + size(l.connectivity) + size(l.gradients) +
                            size(l.volumes) + size(l.node_rows) + size(l.row_start) + size(m.nodes) + size(m.elements) +
                            size(m.neighbours) + size(m.volumes) + size(m.gradients) + size(m.altitudes);
  return total / static_cast<std::size_t>(p.size());
}

template <int D>
void run(const std::string& name, int threads, int warm, int steps, int repeats, const std::set<std::string>& flags) {
  auto y = talus::bench::make_yardstick<D>(name, threads > 1 ? 0 : (name == "large" ? 0 : 1));
  y.options.threads = threads;
  y.options.mixed = flags.count("mixed") > 0;
  if (flags.count("smooth")) y.options.smoothing = talus::model::Smoothing::strain;
  if (flags.count("stable")) y.options.smoothing = talus::model::Smoothing::stable;
  y.options.objective = flags.count("objective") > 0;
  for (int s = 0; s < warm; ++s) talus::mpm::step(y.body, y.options);
  double best = 1e30;
  for (int r = 0; r < repeats; ++r) {
    const double start = read_clock(threads > 1);
    for (int s = 0; s < steps; ++s) talus::mpm::step(y.body, y.options);
    best = std::min(best, (read_clock(threads > 1) - start) / steps);
  }
  const double points = y.body.points.size();
  fmt::print("talus D={} {} points={} threads={} chunks={} : best {:.2f} Mpps, {:.1f} us/step, {} bytes/point\n", D,
             name, y.body.points.size(), threads, y.body.layout->chunks, points / best * 1e-6, best * 1e6,
             memory_per_point(y.body));
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int i, int fallback) {
    return count > i && std::isdigit(arguments[i][0]) ? std::atoi(arguments[i]) : fallback;
  };
  const int dimension = number(1, 2);
  const std::string name = count > 2 ? arguments[2] : "small";
  const bool large = name == "large";
  const int threads = number(3, 1), warm = number(4, large ? 10 : 200), steps = number(5, large ? 10 : 1000),
            repeats = number(6, 5);
  const std::set<std::string> flags(arguments + 1, arguments + count);
  if (dimension == 2)
    run<2>(name, threads, warm, steps, repeats, flags);
  else
    run<3>(name, threads, warm, steps, repeats, flags);
  return 0;
}
