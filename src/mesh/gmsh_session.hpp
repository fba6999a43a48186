// SPDX-License-Identifier: MIT
#pragma once
// The lock, the start and the end of Gmsh, which keeps one global state per process.

#include <mutex>
#include <string>

namespace talus::mesh {

/// Holds Gmsh for the caller: quiet, one thread, a fixed random seed, no configuration files, nothing left behind.
/// Other threads wait. The number of OpenMP threads, which Gmsh changes, is restored at the end.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Gmsh's last message of an error, without its full stop; "no reason given" where there is none.
  static std::string get_last_error();

 private:
  std::unique_lock<std::mutex> lock_;
  int threads_;
};

}  // namespace talus::mesh
