#pragma once
// [fem]: the factor of safety by quadratic finite elements.

#include "input/case/case.hpp"
#include "input/case/declare_mesh.hpp"
#include "input/language/codec.hpp"

namespace talus::input {

template <>
inline constexpr auto choices<FlowRule> = std::array{
    Choice{FlowRule::as_given, "as_given", "the dilatancy of the materials"},
    Choice{FlowRule::associated, "associated", "ψ = φ, as limit analysis and slices assume"},
    Choice{FlowRule::both, "both", "one after the other"},
};

template <class Visitor>
void describe(Visitor& v, FiniteElements& f) {
  v.key("size", f.size, quantity("m").above(0).example("1.0"),
        "Size of the quadratic elements; if not given, that of [mesh].");
  v.key("algorithm", f.algorithm, plain(), "Gmsh's algorithm for their mesh.");
  v.key("flow", f.flow, plain(), "Plastic flow of the trials.");
  v.key("from", f.from, plain().above(0), "Lower end of the first bracket; widened when the factor is not in it.");
  v.key("to", f.to, plain().above(0), "Upper end of the first bracket.");
  v.key("resolution", f.resolution, plain().above(0), "Width of the last bracket.");
  v.key("force_tolerance", f.force_tolerance, plain().above(0).below(1),
        "Largest out-of-balance force over the external force in an equilibrium.");
  v.key("displacement_tolerance", f.displacement_tolerance, plain().above(0).below(1),
        "And largest motion still to come over all displacement of the load step; both must hold.");
  v.key("iterations", f.iterations, plain().at_least(1).at_most(10000),
        "Linear systems that are solved in a load step or trial, at most. A trial that runs out of them counts as "
        "failed, "
        "and a warning says so: it may have stood.");
  v.key("load_steps", f.load_steps, plain().at_least(1).at_most(10000),
        "Steps in which weight and loads come on; halved where one does not converge.");
}

}  // namespace talus::input
