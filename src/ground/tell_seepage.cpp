// SPDX-License-Identifier: MIT
#include "ground/tell_seepage.hpp"

#include <algorithm>

namespace talus::ground {
namespace {

template <std::size_t D>
std::vector<double> to_list(const std::array<double, D>& x) {
  return {x.begin(), x.end()};
}

}  // namespace

template <int D>
results::Seepage tell_seepage(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& r) {
  results::Seepage told;
  told.inflow = r.inflow;
  told.outflow = r.outflow;
  told.balance_error = r.balance_error;
  told.iterations = r.iterations;
  told.undecided = r.undecided;
  const auto driest =
      static_cast<std::size_t>(std::max_element(r.pressure.begin(), r.pressure.end()) - r.pressure.begin());
  told.largest_suction = r.pressure[driest];
  told.largest_suction_at = to_list(mesh.nodes[driest]);
  for (const fem::Discharge& d : r.discharges) told.discharges.push_back({d.name, d.inflow, d.outflow, d.runoff});
  for (const fem::FaceExtent<D>& e : r.exits) told.exits.push_back({e.name, to_list(e.highest), to_list(e.lowest)});
  for (const auto& line : r.water_table) {
    auto& points = told.water_table.emplace_back();
    for (const auto& x : line) points.push_back(to_list(x));
  }
  return told;
}

template results::Seepage tell_seepage<2>(const mesh::Mesh<2>&, const fem::SeepageResult<2>&);
template results::Seepage tell_seepage<3>(const mesh::Mesh<3>&, const fem::SeepageResult<3>&);

}  // namespace talus::ground
