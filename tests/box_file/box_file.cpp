// SPDX-License-Identifier: MIT
// Writes a mesh of a box of 2 × 1 × 1 with groups by Gmsh itself, for the tests of mesh files:
//   box_file PATH VERSION [WORD …]
// Words: flat (2D), tilted (out of its plane), quads, text (not binary), unnamed (no group of the volume). The tests
// start it because they themselves load no Gmsh.

#include <gmsh.h>

#include <algorithm>
#include <string>
#include <vector>

int main(int count, char** arguments) {
  if (count < 3) return 2;
  const std::vector<std::string> words(arguments + 3, arguments + count);
  const auto has = [&](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); };
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::add("box");
  const int square = gmsh::model::occ::addRectangle(0, 0, 0, 2, 1);
  gmsh::vectorpair drawn;
  if (!has("flat")) gmsh::model::occ::extrude({{2, square}}, 0, 0, 1, drawn);
  if (has("tilted")) gmsh::model::occ::rotate({{2, square}}, 0, 0, 0, 1, 0, 0, 0.3);
  gmsh::model::occ::synchronize();
  const int dimension = has("flat") ? 2 : 3;
  if (!has("unnamed")) gmsh::model::setPhysicalName(dimension, gmsh::model::addPhysicalGroup(dimension, {1}), "clay");
  gmsh::model::setPhysicalName(dimension - 1, gmsh::model::addPhysicalGroup(dimension - 1, {1}), "first");
  gmsh::option::setNumber("Mesh.MeshSizeMax", 0.3);
  gmsh::option::setNumber("Mesh.RecombineAll", has("quads") ? 1 : 0);
  gmsh::option::setNumber("Mesh.Binary", has("text") ? 0 : 1);
  gmsh::option::setNumber("Mesh.MshFileVersion", std::stod(arguments[2]));
  gmsh::option::setNumber("Mesh.SaveAll", has("unnamed") ? 1 : 0);
  gmsh::model::mesh::generate(dimension);
  gmsh::write(arguments[1]);
  gmsh::finalize();
  return 0;
}
