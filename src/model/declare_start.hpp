#pragma once
// [gravity] and [initial]: the weight of the soil and its state at the start.

#include "model/case.hpp"
#include "model/codec.hpp"

namespace talus::model {

template <>
inline constexpr auto choices<InitialStress> = std::array{
    Choice{InitialStress::none, "none", "no stress: the first stage brings the weight on"},
    Choice{InitialStress::k0, "k0", "the weight of the column above, and K0 times it to the sides"},
};

template <class Visitor>
void describe(Visitor& v, Gravity& g) {
  v.key("acceleration", g.acceleration, quantity("m/s2").at_least(0), "Acceleration of gravity.");
  v.key("direction", g.direction, plain(), "Direction in which it acts, of any length but zero.");
}

template <class Visitor>
void describe(Visitor& v, Initial& i) {
  v.key("stress", i.stress, plain(), "Stress at the start.");
  v.key("k0", i.k0, plain().at_least(0).allowed_with("stress", i.stress, InitialStress::k0).example("0.5"),
        "Ratio of horizontal to vertical stress; if not given, ν/(1-ν) of each material.");
  v.entries("velocity", i.velocity, "soil", 0, quantity("m/s").example("[1, 0]"), "Velocity of a region at the start.");
}

}  // namespace talus::model
