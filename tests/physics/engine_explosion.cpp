// SPDX-License-Identifier: MIT
// An instability that ejects all points from the grid between two checks is an error, not a finished run; a step that
// exceeds the limit by far is still too large after halving.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/box_case.hpp"

namespace talus {

TEST(EngineGrid, ExplosionThatThrowsAllPointsOutOfTheGridIsAnError) {
  for (const double courant : {30.0, 60.0}) {
    auto mesh =
        support::make_box_mesh<2>({6, 6}, {1.2, 1.2}, {"soil"}, [](const Vec<2>& x) { return x[1] < 0.8 ? 0 : -1; });
    const input::Case data = support::make_box_case<2>(support::make_elastic(10e6));
    mpm::Body<2> body = run::prepare<2>(data, mesh);
    EXPECT_THROW(support::run_plan(body, support::make_stage(data, body, 5, {.courant = courant})), Error) << courant;
  }
}

}  // namespace talus
