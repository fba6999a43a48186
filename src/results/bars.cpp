// SPDX-License-Identifier: MIT
#include "results/bars.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, PointBar& r) {
  v.key("support", r.support, {"", "name of the support"});
  v.key("kind", r.kind, {"", "kind of the support"});
  v.key("row", r.row, {"", "row from the top of the pattern"});
  v.key("line", r.line, {"m", "the bar at the end of the run, from its head to its end"});
  v.key("place", r.place, {"m", "distances from the head as installed, of the middle of each piece"});
  v.key("force", r.force, {"N/m", "axial force there, per metre of slope"});
  v.key("slip", r.slip, {"m", "slip of the points of the line in the soil, towards the end of the bar"});
  v.key("largest", r.largest, {"N/m", "largest axial force"});
  v.key("plate", r.plate, {"N/m", "force of plate, facing or connection"});
  v.key("tension", r.tension, {"", "largest force over tensile strength"});
  v.maybe("pull_out", r.pull_out, {"", "utilisation of the bond behind the largest force"});
  v.maybe("stripping", r.stripping, {"", "utilisation of plate and bond in front of the largest force"});
  v.key("torn", r.torn, {"", "pieces that have torn"});
  v.key("limit", r.limit, {"", "which limit is reached"});
}

}  // namespace talus::results
