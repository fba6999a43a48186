// SPDX-License-Identifier: MIT
// Functions of parts that this build lacks: mesh generator, seepage, compiled constitutive laws. Seepage begins with a
// mesh, whose function throws the sentence for the user.
#include "base/error.hpp"
#include "material/external.hpp"
#include "mesh/generate.hpp"
#include "site/initial_water.hpp"
#include "site/known_state.hpp"
#include "site/season.hpp"

namespace talus {

namespace {

[[noreturn]] void refuse_seepage() {
  fail_input(
      "the pore pressures of this case come from seepage, which the engine in the browser does not compute: download "
      "the case and run it with the program");
}

}  // namespace

namespace mesh {

template <int D>
Mesh<D> generate(const Plan&) {
  refuse_seepage();
}
template Mesh<2> generate<2>(const Plan&);

}  // namespace mesh

namespace fem {

template <int D>
SeepageResult<D> solve_steady_seepage(const SeepageModel<D>&, const SeepageOptions&, const std::vector<double>&,
                                      double) {
  refuse_seepage();
}
template SeepageResult<2> solve_steady_seepage<2>(const SeepageModel<2>&, const SeepageOptions&,
                                                  const std::vector<double>&, double);

}  // namespace fem

namespace site {

template <int D>
fem::SeepageModel<D> make_seepage_model(const input::Case&, const mesh::Mesh<D>&, mesh::Mesh<D>&) {
  refuse_seepage();
}
template fem::SeepageModel<2> make_seepage_model<2>(const input::Case&, const mesh::Mesh<2>&, mesh::Mesh<2>&);

template <int D>
Season<D> run_season(const input::Case&, const fem::SeepageModel<D>&, const std::vector<double>&) {
  refuse_seepage();
}
template Season<2> run_season<2>(const input::Case&, const fem::SeepageModel<2>&, const std::vector<double>&);

results::Season make_season_result(const SeasonRecord&) {
  refuse_seepage();
}
MappedWater map_water(const input::KnownWater&, const mesh::Mesh<2>&) {
  refuse_seepage();
}

}  // namespace site

namespace material {

void External::check(const Input&, const SoilFindings& findings) {
  findings.add("library", "the engine in the browser cannot load compiled laws: run this case with the program");
}

}  // namespace material

}  // namespace talus
