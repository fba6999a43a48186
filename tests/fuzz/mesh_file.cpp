// SPDX-License-Identifier: MIT
// Fuzz target: the checks of a mesh file in text before Gmsh reads it.
#include "mesh/gmsh_mesh.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto& path = talus::fuzz::as_file({data, size}, "mesh_file.msh");
  talus::fuzz::try_to([&] { talus::mesh::check_mesh_file(path.string()); });
  return 0;
}
