// SPDX-License-Identifier: MIT
#pragma once
// A grid that can time its kernels by name.

#include <cxxabi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "mpm/backend/device.hpp"

namespace talus::mpm::device {

// Names for operations that are no kernels of Talus.
struct Scan {};
struct Sort {};

/// Name of a kernel without template arguments and name spaces.
template <class Kernel>
std::string find_kernel_name() {
  int status = 0;
  char* readable = abi::__cxa_demangle(typeid(Kernel).name(), nullptr, nullptr, &status);
  std::string name = status == 0 ? readable : typeid(Kernel).name();
  std::free(readable);
  name.resize(std::min(name.size(), name.find('<')));
  return name.substr(name.rfind(':') + 1);
}

/// While kernels are timed, the host waits for each of them, so the total is longer than without timing.
template <class Grid>
class TimedGrid : public Grid {
 public:
  explicit TimedGrid(Grid grid) : Grid(std::move(grid)) {}

  void start_timing() {
    is_timing_ = true;
    times_.clear();
  }
  std::vector<KernelTime> list_times() const {
    std::vector<KernelTime> times;
    for (const auto& [name, time] : times_) times.push_back(time);
    return times;
  }

  template <class Kernel>
  void launch(int n, const Kernel& kernel) {
    time<Kernel>("", [&] { Grid::launch(n, kernel); });
  }
  template <class S, class Summand>
  void sum(int n, const Summand& summand, S* sum) {
    time<Summand>("sum of ", [&] { Grid::sum(n, summand, sum); });
  }
  void scan(const int* counts, int* starts, int n) {
    time<Scan>("", [&] { Grid::scan(counts, starts, n); });
  }
  void sort(const unsigned* keys, unsigned* sorted, int* order, int n) {
    time<Sort>("", [&] { Grid::sort(keys, sorted, order, n); });
  }

 private:
  template <class Kernel, class Launch>
  void time(const char* kind, const Launch& launch) {
    if (!is_timing_) return launch();
    Grid::wait();
    const auto start = std::chrono::steady_clock::now();
    launch();
    Grid::wait();
    const auto end = std::chrono::steady_clock::now();
    const std::string name = kind + find_kernel_name<Kernel>();
    KernelTime& time = times_[name];
    time.name = name;
    ++time.launches;
    time.seconds += std::chrono::duration<double>(end - start).count();
  }

  bool is_timing_ = false;
  std::map<std::string, KernelTime> times_;
};

}  // namespace talus::mpm::device
