#pragma once
// [materials.NAME]: the keys of a compiled Abaqus UMAT.

#include "input/case/case.hpp"
#include "input/language/codec.hpp"

namespace talus::input {

template <class Visitor>
void describe_external(Visitor& v, Material& m) {
  const auto external = MaterialModel::external;
  ExternalModel& e = m.external;
  v.key("library", e.library, plain().needed_with("model", m.model, external).example(R"("model.so")"),
        "The shared library that holds the UMAT; its path is relative to the case file.");
  v.key("symbol", e.symbol, plain().allowed_with("model", m.model, external),
        "Name of the subroutine in it; Fortran compilers call UMAT \"umat_\".");
  v.key("constants", e.constants, plain().allowed_with("model", m.model, external).example("[45e6, 0.3]"),
        "PROPS, the constants that the UMAT expects, in SI units (stress in Pa).");
  v.key("states", e.states, plain().at_least(0).at_most(20).allowed_with("model", m.model, external),
        "NSTATV, how many state variables each point has.");
  v.key("initial_states", e.initial_states, plain().allowed_with("model", m.model, external).example("[125e3]"),
        "STATEV at the start; zero where not given.");
  v.key("constrained_modulus", e.constrained_modulus,
        quantity("kPa").above(0).needed_with("model", m.model, external).example("60000"),
        "The largest stiffness in one-dimensional compression that the UMAT can have; it sets the time step.");
}

}  // namespace talus::input
