// SPDX-License-Identifier: MIT
#include "mesh/gmsh_session.hpp"

#include <gmsh.h>

namespace talus::mesh {

GmshSession::GmshSession() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.Verbosity", 1);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::option::setNumber("Mesh.RandomSeed", 1);
}

GmshSession::~GmshSession() {
  try {
    gmsh::model::mesh::removeSizeCallback();
    gmsh::finalize();
  } catch (...) {  // nothing to save and nobody to tell
  }
}

std::string GmshSession::get_last_error() {
  std::string text;
  gmsh::logger::getLastError(text);
  while (!text.empty() && (text.back() == '.' || text.back() == '\n')) text.pop_back();
  return text.empty() ? "no reason given" : text;
}

}  // namespace talus::mesh
