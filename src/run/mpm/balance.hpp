// SPDX-License-Identifier: MIT
#pragma once
// Hands chunks on between ranks where some have more to do than others, as the soil moves or parts of it cost more.

#include <functional>

#include "mpm/body/body.hpp"

namespace talus::run {

/// Of one stage. Numbers do not depend on which rank has a chunk, so nothing but time does on what is measured.
template <int D>
class LoadBalance {
 public:
  /// `whole`: on rank 0 the body that the shares were taken of, which is put together in between.
  LoadBalance(mpm::Body<D>* whole, const mpm::Body<D>& share);

  /// At every look, by all ranks: measures what each has done, and takes another share where that saves time.
  void look(mpm::Body<D>& share);
  /// Does work that is no part of the steps, such as an output: what is waited for in it says nothing of them.
  void leave_out(const std::function<void()>& work);

 private:
  mpm::Body<D>* whole_;
  int looks_ = 0;
  double spent_ = 0, sent_ = 0;  ///< when it was measured last [s]
  double cost_ = 0;              ///< of the last hand-over [s]
};

}  // namespace talus::run
