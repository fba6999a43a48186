#pragma once
// [[boundary]] and [[traction]]: what acts on named sides and lines.

#include "input/case/case.hpp"
#include "input/language/codec.hpp"

namespace talus::input {

template <>
inline constexpr auto choices<Fix> = std::array{
    Choice{Fix::full, "full", "no motion"},
    Choice{Fix::normal, "normal", "no motion across the side, free motion along it"},
    Choice{Fix::plane, "plane", "no motion along the given normal"},
    Choice{Fix::friction, "friction", "a rough wall that the soil may leave but not cross"},
    Choice{Fix::velocity, "velocity", "the given velocity"},
};

template <>
inline constexpr auto choices<Carrier> = std::array{
    Choice{Carrier::points, "points", "the material points beside the side carry the load along with them"},
    Choice{Carrier::sides, "sides", "the load stays on the sides of the mesh, fixed in space"},
};

template <class Visitor>
void describe(Visitor& v, Boundary& b) {
  v.key("on", b.on, plain().required().example_each({R"("bottom")", R"("left")", R"("right")"}),
        "A side (left, right, bottom, top; in 3D also front, back), a named line, or a side group of the mesh file.");
  v.key("fix", b.fix, plain().required().example_each({R"("full")", R"("normal")", R"("normal")"}),
        "What the boundary does to the motion.");
  v.key("normal", b.normal, plain().needed_with("fix", b.fix, Fix::plane).example("[1, 1]"),
        "Direction of the suppressed motion, of any length but zero.");
  v.key("friction", b.friction, plain().at_least(0).needed_with("fix", b.fix, Fix::friction).example("0.5"),
        "Coulomb's coefficient of the wall.");
  v.key("velocity", b.velocity, quantity("m/s").needed_with("fix", b.fix, Fix::velocity).example("[0.1, 0]"),
        "Prescribed velocity.");
  v.key("factor", b.factor, quantity("s").allowed_with("fix", b.fix, Fix::velocity).example("[[0, 0], [1, 1]]"),
        "The velocity is multiplied by this factor: linear between the rows, constant before and after them.");
}

template <class Visitor>
void describe(Visitor& v, Traction& t) {
  v.key("on", t.on, plain().required().example(R"("crest")"), "A side or a named line, as in [[boundary]].");
  v.key("carrier", t.carrier, plain(), "What carries the load.");
  v.key("traction", t.traction, quantity("kPa").required().example("[0, -20]"), "Load per area.");
  v.key("factor", t.factor, quantity("s").example("[[0, 0], [2, 1]]"),
        "The load is multiplied by this factor: linear between the rows, constant before and after them.");
}

}  // namespace talus::input
