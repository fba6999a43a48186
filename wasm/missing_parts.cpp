// SPDX-License-Identifier: MIT
// Functions that this build lacks. Each throws a sentence for the user.
#include "base/error.hpp"
#include "mesh/generate.hpp"

namespace talus::mesh {

template <int D>
Mesh<D> generate(const Plan&) {
  fail_input(
      "the pore pressures of this case come from seepage, which needs a mesh; the engine in the browser has none: "
      "download the case and run it with the program");
}

template Mesh<2> generate<2>(const Plan&);
template Mesh<3> generate<3>(const Plan&);

}  // namespace talus::mesh
