// SPDX-License-Identifier: MIT
// Checks of [initial] result and stress: the folder of results must exist, and keys that it replaces must not be given.
#include "input/case/start.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "input/case/checks.hpp"

namespace talus::input {

void check_result(const Case& data, Findings& findings) {
  namespace fs = std::filesystem;
  const Initial& initial = data.initial;
  const std::string path = "initial.result";
  if (initial.result.empty() || !findings.is_sound(path)) return;
  const fs::path folder(initial.result_folder);
  if (!fs::exists(folder))
    findings.add(path, fmt::format("the folder of results '{}' does not exist", folder.string()));
  else if (!fs::is_directory(folder))
    findings.add(path, fmt::format("'{}' is a file; 'result' names a folder of results", folder.string()));
  else if (!fs::exists(folder / "end_state.h5"))
    findings.add(path, fmt::format("there is no end_state.h5 in '{}': was its run finished, and by this version?",
                                   folder.string()));
  if (findings.places.is_given("initial.velocity") && findings.is_sound("initial.velocity"))
    findings.add("initial.velocity", "'velocity' in [initial] has no meaning where 'result' is given");
  if (!data.stages.empty() && data.stages.front().gravity_ramp > 0 && findings.is_sound("stage.0.gravity_ramp"))
    findings.add("stage.0.gravity_ramp",
                 "'gravity_ramp' has no meaning in the first stage of a case that starts from a result: gravity acts "
                 "there already");
  const std::string meshes = "strength_reduction.frozen.meshes";
  if (data.strength_reduction.frozen.meshes > 1 && findings.is_sound(meshes))
    findings.add(meshes, fmt::format("'meshes' is {}, but the mesh of the result that the case starts from cannot be "
                                     "halved; leave it out, or write 1",
                                     data.strength_reduction.frozen.meshes));
}

void check_start_stress(const Case& data, Findings& findings) {
  if (data.initial.stress != InitialStress::elements || !findings.is_sound("initial.stress")) return;
  if (data.mesh.dimension != 2)
    findings.add("initial.stress", "the initial stress by FEM needs a plane section; write \"k0\"");
}

}  // namespace talus::input
