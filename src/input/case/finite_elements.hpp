#pragma once
// [fem]: the factor of safety by quadratic finite elements.

#include <optional>

#include "mesh/plan.hpp"

namespace talus::input {

/// Plastic flow of the trials.
enum class FlowRule { as_given, associated, both };

struct FiniteElements {
  std::optional<double> size;  ///< element size [m]; not given: that of the mesh
  mesh::Algorithm algorithm = mesh::Algorithm::delaunay;
  FlowRule flow = FlowRule::as_given;    ///< both: with ψ as given and with ψ = φ
  double from = 1.0, to = 2.0;           ///< first bracket [-]
  double resolution = 0.005;             ///< of the last [-]
  double force_tolerance = 1e-4;         ///< [-]
  double displacement_tolerance = 1e-4;  ///< [-]
  int iterations = 400;                  ///< linear systems in a load step or trial
  int load_steps = 4;
};

}  // namespace talus::input
