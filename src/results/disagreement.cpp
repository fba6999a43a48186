// SPDX-License-Identifier: MIT
#include "results/disagreement.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, Disagreement& r) {
  v.key("low_title", r.low_title, {"", "method with the smaller factor"});
  v.key("low", r.low, {"", "its factor, or the upper bound that limit analysis proves"});
  v.key("high_title", r.high_title, {"", "method with the larger factor"});
  v.key("high", r.high, {"", "its factor, or the lower bound that limit analysis proves"});
  v.key("ratio", r.ratio, {"", "ratio of the two"});
  v.key("text", r.text, {"", "the same as a sentence"});
}

}  // namespace talus::results
