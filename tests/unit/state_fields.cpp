// SPDX-License-Identifier: MIT
// State variables of the constitutive laws as fields over a body with several soils.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "material/every_law.hpp"
#include "run/mpm/record/frame.hpp"

namespace talus::run {
namespace {

const auto elastic = material::LinearElastic::from_young(1e7, 0.3);

TEST(StateFields, AreListedOnceForAllSoils) {
  const StateFields fields({elastic, material::ModifiedCamClay({}), material::RootedCamClay({}, {}),
                            material::RootedMohrCoulomb(elastic, {})});
  std::vector<std::string> names;
  for (const material::StateField& f : fields.list()) names.emplace_back(f.name);
  for (const char* name : {"preconsolidation_pressure", "void_ratio", "root_content", "intact_roots", "root_cohesion"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  EXPECT_TRUE(StateFields({elastic}).list().empty());
}

TEST(StateFields, AreNaNWhereASoilHasNone) {
  const std::vector<material::Law> laws{elastic, material::ModifiedCamClay({}),
                                        material::RootedMohrCoulomb(elastic, {})};
  const StateFields fields(laws);
  mpm::Body<2> body;
  body.laws = laws;
  const auto read = [&](int law, std::array<double, 3> state, const char* name) {
    mpm::PointView<2> point;
    point.material = law;
    std::copy(state.begin(), state.end(), point.state.begin());
    const auto values = fields.read(body, point);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (std::string_view(fields.list()[k].name) == name) return values[k];
    ADD_FAILURE() << name;
    return 0.0;
  };
  EXPECT_TRUE(std::isnan(read(0, {}, "preconsolidation_pressure"))) << "an elastic soil has none";
  EXPECT_EQ(read(0, {}, "root_cohesion"), 0) << "soil without roots has none of them";
  EXPECT_EQ(read(2, {0, 7e3, 0}, "root_cohesion"), 7e3);
  EXPECT_TRUE(std::isnan(read(1, {0, material::ModifiedCamClay::not_set, 0.6}, "preconsolidation_pressure")));
  EXPECT_EQ(read(1, {0, 5e4, 0.6}, "preconsolidation_pressure"), 5e4);
  EXPECT_EQ(read(1, {0, 5e4, 0.6}, "void_ratio"), 0.6);
}

}  // namespace
}  // namespace talus::run
