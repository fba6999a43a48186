#include "run/mpm/water_summary.hpp"

#include <algorithm>
#include <cmath>

#include "run/mpm/record/water_record.hpp"

namespace talus::run {
namespace {

using nlohmann::json;

const char* to_word(mpm::SurfaceKind kind) {
  switch (kind) {
    case mpm::SurfaceKind::open:
      return "open";
    case mpm::SurfaceKind::seepage:
      return "seepage_face";
    case mpm::SurfaceKind::rain:
      return "rain";
    case mpm::SurfaceKind::flux:
      return "flux";
    case mpm::SurfaceKind::head:
      return "total_head";
    case mpm::SurfaceKind::pressure:
      return "pressure";
  }
  return "";
}

template <std::size_t D>
json to_list(const std::array<double, D>& x) {
  json list = json::array();
  for (const double c : x) list.push_back(c);
  return list;
}

}  // namespace

template <int D>
json describe_water(const input::Case& data, const mpm::Body<D>& body, double initial) {
  const mpm::Water<D>& water = body.water;
  const std::vector<std::string> names = name_surfaces(water.surfaces);
  json surfaces = json::array();
  double entered = 0, left = 0, runoff = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const mpm::SurfaceBudget& b = water.budgets[i];
    entered += b.entered;
    left += b.left;
    runoff += b.runoff;
    surfaces.push_back({{"name", names[i]},
                        {"condition", to_word(water.surfaces[i].kind)},
                        {"entered", b.entered},
                        {"left", b.left},
                        {"supplied", b.supplied},
                        {"runoff", b.runoff}});
  }
  const WaterState<D> state = find_water_state(body);
  const double stored = state.mass;
  const double unexplained =
      stored - (initial + entered + water.pressed_in - left - water.transpired - water.lost_between - water.left_grid);
  json budget{{"density", data.water.density},
              {"initial", initial},
              {"stored", stored},
              {"entered", entered},
              {"left", left},
              {"runoff", runoff},
              {"lost_between", water.lost_between},
              {"left_grid", water.left_grid},
              {"pressed_in", water.pressed_in},
              {"error", unexplained / std::max({initial, stored, 1e-300})},
              {"largest_pressure", state.largest_pressure},
              {"largest_suction", state.largest_suction},
              {"largest_suction_at", to_list(state.place)},
              {"surfaces", surfaces}};
  if (!water.uptakes.empty()) budget["transpired"] = water.transpired;
  return budget;
}

template <int D>
json describe_seepage(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& r) {
  json discharges = json::array(), exits = json::array(), table = json::array();
  for (const fem::Discharge& d : r.discharges)
    discharges.push_back({{"name", d.name}, {"inflow", d.inflow}, {"outflow", d.outflow}, {"runoff", d.runoff}});
  for (const fem::FaceExtent<D>& e : r.exits)
    exits.push_back({{"name", e.name}, {"highest", to_list(e.highest)}, {"lowest", to_list(e.lowest)}});
  for (const auto& line : r.water_table) {
    json points = json::array();
    for (const auto& x : line) points.push_back(to_list(x));
    table.push_back(points);
  }
  const auto driest = std::max_element(r.pressure.begin(), r.pressure.end()) - r.pressure.begin();
  return {{"inflow", r.inflow},
          {"outflow", r.outflow},
          {"balance_error", r.balance_error},
          {"iterations", r.iterations},
          {"undecided", r.undecided},
          {"largest_suction", r.pressure[static_cast<std::size_t>(driest)]},
          {"largest_suction_at", to_list(mesh.nodes[static_cast<std::size_t>(driest)])},
          {"discharges", discharges},
          {"exits", exits},
          {"water_table", table}};
}

#define TALUS_INSTANTIATE(D)                                                        \
  template json describe_water<D>(const input::Case&, const mpm::Body<D>&, double); \
  template json describe_seepage<D>(const mesh::Mesh<D>&, const fem::SeepageResult<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
