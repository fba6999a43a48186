// SPDX-License-Identifier: MIT
#pragma once
// The compiled UMATs of tests/umat.

#include <filesystem>
#include <string>
#include <vector>

#include "material/external.hpp"

namespace talus::support {

inline std::string find_umat(const std::string& name) {
  return std::string(TALUS_UMAT_FOLDER) + "/umat_" + name + ".so";
}

struct ExternalCase {
  std::string umat;
  std::vector<double> constants;
  int states = 0;
  std::vector<double> initial_states = {};
  std::string symbol = "umat_";
  std::string material = "clay of Oslo";
};

inline material::External open_umat(const ExternalCase& c) {
  material::ExternalParameters p;
  p.library = find_umat(c.umat);
  p.symbol = c.symbol;
  p.material = c.material;
  p.constants = c.constants;
  p.states = c.states;
  p.initial_states = c.initial_states;
  p.constrained_modulus = 1e7;
  return material::External(p);
}

}  // namespace talus::support

/// Skips a test whose UMAT is in Fortran where there was no compiler for it.
#define TALUS_NEEDS_FORTRAN(name)                                                                                    \
  do {                                                                                                               \
    if (!std::filesystem::exists(support::find_umat(name))) GTEST_SKIP() << "no Fortran compiler: no umat_" << name; \
  } while (false)
