// SPDX-License-Identifier: MIT
#pragma once
// The start and the end of Gmsh, which keeps one global state per process.

#include <string>

namespace talus::mesh {

/// Gmsh for the caller: quiet, one thread, a fixed random seed, no configuration files, nothing left behind. Gmsh may
/// crash and does not look for interruptions, so the program has one only in a child process (base/child_process.hpp).
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Gmsh's last message of an error, without its full stop; "no reason given" where there is none.
  static std::string get_last_error();
};

}  // namespace talus::mesh
