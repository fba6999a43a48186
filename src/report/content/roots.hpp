#pragma once
// [[roots]] of a run, from the echo of its input: what each block is worth, and sentences about it.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace talus::report {

struct RootBlock {
  std::string ground;
  double depth = 0;                ///< [m]
  std::optional<double> content;   ///< at the ground, of roots of full age [-]
  std::optional<double> cohesion;  ///< the same; of a bundle what follows from it [Pa]
  std::string bundle;              ///< how the bundle was added up, in words; empty without one
  double age_share = 1;            ///< share that has grown and is not decayed [-]
  bool transpires = false;
};

/// The blocks of the case that add content or cohesion, or transpire.
std::vector<RootBlock> read_roots(const nlohmann::json& summary);

/// What the numbers of rooted soils rest on; nothing for a case without.
std::vector<std::string> list_root_assumptions(const nlohmann::json& summary);

}  // namespace talus::report
