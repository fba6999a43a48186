#pragma once
// [materials.NAME]: a compiled Abaqus UMAT.

#include <string>
#include <vector>

#include "input/case/material_model.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// A compiled Abaqus UMAT.
struct ExternalModel {
  std::string library;       ///< shared library, as given
  std::string library_file;  ///< the same as it is found from here
  std::string material;      ///< name of the material, for CMNAME
  std::string symbol = "umat_";
  std::vector<double> constants;       ///< PROPS
  int states = 0;                      ///< NSTATV
  std::vector<double> initial_states;  ///< zero where not given
  double constrained_modulus = 0;      ///< for the time step [Pa]
};

template <class Visitor>
void describe_external(Visitor& v, ExternalModel& e, const MaterialModel& model) {
  const auto external = MaterialModel::external;
  v.key("library", e.library, plain().needed_with("model", model, external).example(R"("model.so")"),
        "The shared library that holds the UMAT; its path is relative to the case file.");
  v.key("symbol", e.symbol, plain().allowed_with("model", model, external),
        "Name of the subroutine in it; Fortran compilers call UMAT \"umat_\".");
  v.key("constants", e.constants, plain().allowed_with("model", model, external).example("[45e6, 0.3]"),
        "PROPS, the constants that the UMAT expects, in SI units (stress in Pa).");
  v.key("states", e.states, plain().at_least(0).at_most(20).allowed_with("model", model, external),
        "NSTATV, how many state variables each point has.");
  v.key("initial_states", e.initial_states, plain().allowed_with("model", model, external).example("[125e3]"),
        "STATEV at the start; zero where not given.");
  v.key("constrained_modulus", e.constrained_modulus,
        quantity("kPa").above(0).needed_with("model", model, external).example("60000"),
        "The largest stiffness in one-dimensional compression that the UMAT can have; it sets the time step.");
}

}  // namespace talus::input
