// SPDX-License-Identifier: MIT
// Reads a case with the installed library, makes its mesh, for which the module of Gmsh is loaded, and prints its
// title.

#include <cstdio>

#include "input/read.hpp"
#include "mesh/generate.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 1;
  const talus::input::Case data = talus::input::read_case(arguments[1]).data;
  if (talus::mesh::generate<2>(data.mesh).elements.empty()) return 1;
  std::puts(data.title.c_str());
  return 0;
}
