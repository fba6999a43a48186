// SPDX-License-Identifier: MIT
#pragma once
// Sums whose order does not depend on which threads run together: many threads add every so many values each, fewer
// add their sums, and one adds these.

#include <iterator>

#include "mpm/device/device_array.hpp"

namespace talus::mpm::device {

/// A number to be summed.
struct Total {
  double value = 0;
  TALUS_PORTABLE void add(const Total& other) { value += other.value; }
};

/// Sums of `values`: thread t of `threads` takes every threads-th of them.
template <class S>
struct AddUp {
  View<const S> values;
  View<S> sums;
  int threads;

  TALUS_PORTABLE void operator()(int t) const {
    S sum;
    for (std::size_t i = static_cast<std::size_t>(t); i < values.count; i += static_cast<std::size_t>(threads))
      sum.add(values[i]);
    sums[static_cast<std::size_t>(t)] = sum;
  }
};

template <class Grid>
class FixedSums {
 public:
  static constexpr int first_threads = 16384;

  explicit FixedSums(Grid& grid) : grid_(grid) {}

  /// Where the sums of the first round belong, for a kernel that makes them itself.
  template <class S>
  View<S> get_first() {
    return get_room<S>(0);
  }
  /// The sum of those; it stays on the device until the next one.
  template <class S>
  View<const S> finish() {
    const View<S> few = get_room<S>(1), one = get_room<S>(2);
    grid_.launch(widths[1], AddUp<S>{as_read(get_room<S>(0)), few, widths[1]});
    grid_.launch(widths[2], AddUp<S>{as_read(few), one, widths[2]});
    return as_read(one);
  }
  /// The sum of an array.
  template <class S>
  S add_up(const DeviceArray<Grid, S>& values) {
    grid_.launch(widths[0], AddUp<S>{values.read(), get_first<S>(), widths[0]});
    return fetch(finish<S>());
  }
  template <class S>
  static S fetch(View<const S> sum) {
    S value;
    Grid::fetch(&value, sum.start, sizeof(S));
    return value;
  }

 private:
  static constexpr int widths[] = {first_threads, 128, 1};

  template <class S>
  View<S> get_room(std::size_t round) {
    const auto width = static_cast<std::size_t>(widths[round]);
    partial_[round].resize(width * sizeof(S));
    return {reinterpret_cast<S*>(partial_[round].view().start), width};
  }
  template <class S>
  static View<const S> as_read(View<S> of) {
    return {of.start, of.count};
  }

  Grid& grid_;
  DeviceArray<Grid, unsigned char> partial_[std::size(widths)];
};

}  // namespace talus::mpm::device
