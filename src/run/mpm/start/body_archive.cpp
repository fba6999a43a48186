// SPDX-License-Identifier: MIT
#include "run/mpm/start/body_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>

#include "base/error.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::run {
namespace {

using output::ArchiveReader;
using output::ArchiveWriter;

/// Concatenates small fixed arrays as plain doubles or ints.
template <class Scalar, class Container>
std::vector<Scalar> flatten(const Container& items) {
  std::vector<Scalar> flat;
  for (const auto& item : items) flat.insert(flat.end(), item.begin(), item.end());
  return flat;
}

template <class Container, class Scalar>
void unflatten(const std::vector<Scalar>& flat, Container& items) {
  const std::size_t width = typename Container::value_type{}.size();
  items.resize(flat.size() / width);
  for (std::size_t i = 0; i < flat.size(); ++i) items[i / width][i % width] = flat[i];
}

template <class Target, class Source>
void copy_into(Target& target, const Source& source) {
  using Value = typename Target::value_type;
  target.resize(source.size());
  std::transform(source.begin(), source.end(), target.begin(), [](auto v) { return static_cast<Value>(v); });
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  return lines;
}

/// Visits the arrays of doubles of a body with their names, for writing and reading.
template <class Body, class Visit>
void visit_reals(Body& body, Visit&& visit) {
  visit("points/data", body.points.data);
  visit("points/count", body.points.count);
  visit("elements/moments", body.elements.moments);
  visit("elements/strain", body.elements.strain);
  visit("elements/fill_limit", body.elements.fill_limit);
  visit("elements/apart", body.elements.apart);
  visit("elements/plastic_dilation", body.elements.plastic_dilation);
  visit("elements/rough", body.elements.rough);
  visit("nodes/sums", body.nodes.sums);
  visit("nodes/motion", body.nodes.motion);
}

/// Visits the arrays of nonlocal softening.
template <class Body, class Visit>
void visit_softening(Body& body, Visit&& visit) {
  visit("elements/softened", body.elements.softened);
  visit("elements/softening_volume", body.elements.softening_volume);
}

/// Visits the arrays of pore water. Open sides and fixed directions are recomputed from them.
template <class Body, class Visit>
void visit_water(Body& body, Visit&& visit) {
  visit("water/moments", body.water.moments);
  visit("water/volume", body.water.volume);
  visit("water/stretch", body.water.stretch);
  visit("water/mean_saturation", body.water.mean_saturation);
  visit("water/mean_pressure", body.water.mean_pressure);
  visit("water/mean_bishop", body.water.mean_bishop);
  visit("water/mean_resistance", body.water.mean_resistance);
  visit("water/surplus", body.water.surplus);
  visit("water/sums", body.water.sums);
  visit("water/motion", body.water.motion);
}

template <class Body, class Visit>
void visit_integers(Body& body, Visit&& visit) {
  visit("points/id", body.points.id);
  visit("points/block_capacity", body.points.block_capacity);
  visit("points/block_used", body.points.block_used);
  visit("points/block_materials", body.points.block_materials);
  visit("points/element", body.points.element);
  visit("points/material", body.points.material);
}

template <class Body, class Visit>
void visit_vectors(Body& body, Visit&& visit) {
  visit("points/reference", body.points.reference);
  visit("points/strain_offset", body.points.strain_offset);
  visit("nodes/displacement", body.nodes.displacement);
  visit("nodes/load", body.nodes.load);
}

/// Writes the state of the Darcy (u–p) formulation that is kept between steps, and the one a later stage starts from.
template <int D>
void put_darcy(ArchiveWriter& archive, const mpm::DarcyWater<D>& darcy) {
  if (darcy.pressure.empty()) return;
  archive.put("water/mixture/is_used", std::vector<int>{darcy.is_used ? 1 : 0});
  archive.put("water/mixture/pressure", darcy.pressure);
  archive.put("water/mixture/change", darcy.change);
  archive.put("water/mixture/own", darcy.own);
  archive.put("water/mixture/ponded", std::vector<int>(darcy.ponded.begin(), darcy.ponded.end()));
}

template <int D>
void get_darcy(const ArchiveReader& archive, mpm::DarcyWater<D>& darcy) {
  darcy = {};
  if (!archive.has("water/mixture/pressure")) return;
  darcy.is_used = archive.integers("water/mixture/is_used")[0] != 0;
  darcy.pressure = archive.reals("water/mixture/pressure");
  darcy.change = archive.reals("water/mixture/change");
  if (archive.has("water/mixture/own")) darcy.own = archive.reals("water/mixture/own");
  copy_into(darcy.ponded, archive.integers("water/mixture/ponded"));
}

/// Visits the length of a list, and its items; for reading the list gets that length.
template <class List>
void visit_list(List& list, auto&& visit, auto&& visit_item) {
  std::size_t count = list.size();
  visit(count);
  if constexpr (!std::is_const_v<List>) list.resize(count);
  for (auto& item : list) visit_item(item);
}

/// Visits the numbers of a place, and of the state of a bar. The nodes with which a place moves follow from them.
void visit_place(auto& place, auto&& visit) {
  for (auto& x : place.x) visit(x);
  for (auto& xi : place.xi) visit(xi);
  visit(place.element);
  visit_list(place.carried, visit, [&](auto& share) {
    visit(share.point);
    visit(share.weight);
  });
}
void visit_bar(auto& bar, auto&& visit) {
  visit(bar.divisor);
  for (auto& node : bar.nodes) {
    visit_place(node.soil, visit);
    visit(node.slip);
    visit(node.all_slip);
    for (auto& f : node.force) visit(f);
  }
  for (auto& piece : bar.pieces) {
    visit(piece.strain);
    visit(piece.plastic);
    visit(piece.tension);
    visit(piece.is_torn);
  }
  visit_list(bar.plate.places, visit, [&](auto& place) { visit_place(place, visit); });
  visit(bar.plate.elastic);
  visit(bar.plate.force);
  for (auto& f : bar.plate.push) visit(f);
}

/// Numbers of a bar by which it is found again: head and end as installed, number of nodes, size of its state.
constexpr std::size_t key_size = 6;
/// Distance of installed heads and ends over the length of the bar within which two bars are the same (rounding).
constexpr double same_place = 1e-6;

void put_bars(ArchiveWriter& archive, const std::vector<mpm::Bar>& bars) {
  if (bars.empty()) return;
  std::vector<double> flat, keys;
  std::string names;
  for (const mpm::Bar& bar : bars) {
    names += bar.name + '\n';
    const std::size_t before = flat.size();
    visit_bar(bar, [&](const auto& value) { flat.push_back(static_cast<double>(value)); });
    for (const Vec<2>& x : {bar.head, bar.end}) keys.insert(keys.end(), x.begin(), x.end());
    for (const std::size_t count : {bar.nodes.size(), flat.size() - before}) keys.push_back(static_cast<double>(count));
  }
  archive.put("bars/names", names);
  archive.put("bars/keys", keys);
  archive.put("bars/state", flat);
}

bool has_key(const mpm::Bar& bar, const std::string& name, const double* key) {
  const double near = same_place * norm(Vec<2>{bar.end[0] - bar.head[0], bar.end[1] - bar.head[1]});
  const Vec<2> head{key[0] - bar.head[0], key[1] - bar.head[1]}, end{key[2] - bar.end[0], key[3] - bar.end[1]};
  return bar.name == name && norm(head) <= near && norm(end) <= near && static_cast<double>(bar.nodes.size()) == key[4];
}

[[noreturn]] void throw_damaged() {
  throw Error(ExitCode::wrong_input,
              "the state of the supports in the checkpoint is damaged; run the case that has it again");
}

void read_bar(std::span<const double> state, mpm::Bar& bar) {
  std::vector<mpm::SoilPlace> installed = bar.plate.places;
  std::size_t next = 0;
  visit_bar(bar, [&]<class T>(T& to) {
    if (next == state.size()) throw_damaged();
    const double value = state[next++];
    if constexpr (std::is_same_v<T, std::size_t>)  // the length of a list, whose items follow
      if (!(value >= 0 && value <= static_cast<double>(state.size() - next))) throw_damaged();
    to = static_cast<T>(value);
  });
  if (bar.plate.places.empty()) bar.plate.places = std::move(installed);  // it had no plate
}

/// Sets the state of each bar that the archive has, by the name of its support and where it was installed. Others are
/// as installed; the points under their plates are selected anew, since the soil has moved.
void get_bars(const ArchiveReader& archive, std::vector<mpm::Bar>& bars) {
  for (mpm::Bar& bar : bars)
    for (mpm::SoilPlace& place : bar.plate.places) place.carried.clear();
  if (bars.empty() || !archive.has("bars/state")) return;
  if (!archive.has("bars/keys"))
    throw Error(ExitCode::wrong_input,
                "the forces of the supports were written by an earlier version; run the case that has them again");
  const auto &keys = archive.reals("bars/keys"), &flat = archive.reals("bars/state");
  const std::vector<std::string> names = split_lines(archive.text("bars/names"));
  if (keys.size() != names.size() * key_size) throw_damaged();
  std::span<const double> rest(flat);
  std::vector<char> is_found(bars.size(), 0);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double* key = &keys[k * key_size];
    if (!(key[5] >= 0 && key[5] <= static_cast<double>(rest.size()))) throw_damaged();
    const auto size = static_cast<std::size_t>(key[5]);
    for (std::size_t i = 0; i < bars.size(); ++i) {
      if (is_found[i] || !has_key(bars[i], names[k], key)) continue;
      is_found[i] = 1;
      read_bar(rest.first(size), bars[i]);
      break;
    }
    rest = rest.subspan(size);
  }
}

template <int D>
void put_budgets(ArchiveWriter& archive, const mpm::Water<D>& water) {
  std::vector<double> flat{water.lost_between, water.left_grid, water.pressed_in};
  for (const mpm::SurfaceBudget& b : water.budgets) flat.insert(flat.end(), {b.entered, b.left, b.supplied, b.runoff});
  archive.put("water/budgets", flat);
  archive.put("water/transpired", std::vector<double>{water.transpired});
}

template <int D>
void get_water(const ArchiveReader& archive, mpm::Body<D>& body) {
  mpm::Water<D>& water = body.water;
  const auto& flat = archive.reals("water/budgets");
  water.lost_between = flat[0];
  water.left_grid = flat[1];
  water.transpired = archive.reals("water/transpired")[0];
  water.budgets.clear();
  water.pressed_in = flat[2];
  for (std::size_t i = 3; i + 4 <= flat.size(); i += 4)
    water.budgets.push_back({flat[i], flat[i + 1], flat[i + 2], flat[i + 3]});
  water.surface_is_stale = true;
  water.newly_full.clear();
  mpm::find_held_axes(body);
}

}  // namespace

template <int D>
void put_mesh(ArchiveWriter& archive, const mesh::Mesh<D>& mesh) {
  archive.put("mesh/nodes", flatten<double>(mesh.nodes));
  archive.put("mesh/elements", flatten<int>(mesh.elements));
  archive.put("mesh/region", mesh.element_region);
  std::string names;
  for (const std::string& name : mesh.region_names) names += name + '\n';
  archive.put("mesh/region_names", names);
  std::string side_names;
  int number = 0;
  for (const auto& [name, sides] : mesh.sides) {
    side_names += name + '\n';
    archive.put(fmt::format("mesh/sides_{}", number++), flatten<int>(sides));
  }
  archive.put("mesh/side_names", side_names);
}

template <int D>
mesh::Mesh<D> get_mesh(const ArchiveReader& archive) {
  mesh::Mesh<D> mesh;
  unflatten(archive.reals("mesh/nodes"), mesh.nodes);
  unflatten(archive.integers("mesh/elements"), mesh.elements);
  mesh.element_region = archive.integers("mesh/region");
  mesh.region_names = split_lines(archive.text("mesh/region_names"));
  int number = 0;
  for (const std::string& name : split_lines(archive.text("mesh/side_names")))
    unflatten(archive.integers(fmt::format("mesh/sides_{}", number++)), mesh.sides[name]);
  mesh::finish(mesh, mesh::Order::as_given);
  return mesh;
}

template <int D>
void put_body(ArchiveWriter& archive, const mpm::Body<D>& body) {
  visit_reals(body, [&](const char* name, const auto& values) {
    archive.put(name, std::span<const double>(values.data(), values.size()));
  });
  if (body.softening_reach)
    visit_softening(body, [&](const char* name, const auto& values) {
      archive.put(name, std::span<const double>(values.data(), values.size()));
    });
  if (body.water.is_wet()) {
    visit_water(body, [&](const char* name, const auto& values) {
      archive.put(name, std::span<const double>(values.data(), values.size()));
    });
    put_budgets(archive, body.water);
    put_darcy(archive, body.water.darcy);
  }
  visit_integers(body, [&](const char* name, const auto& values) {
    const std::vector<int> plain(values.begin(), values.end());
    archive.put(name, plain);
  });
  visit_vectors(body, [&](const char* name, const auto& values) { archive.put(name, flatten<double>(values)); });
  archive.put("points/block_start", body.points.block_start);
  archive.put("points/place", body.points.place);
  std::vector<double> lost;
  for (const auto& l : body.lost) {
    lost.insert(lost.end(), {static_cast<double>(l.id), l.time, l.mass});
    lost.insert(lost.end(), l.position.begin(), l.position.end());
    lost.insert(lost.end(), l.momentum.begin(), l.momentum.end());
  }
  archive.put("lost", lost);
  put_bars(archive, body.bars);
  const std::vector<double> scalars{body.time,
                                    body.work.external,
                                    body.work.damped,
                                    body.work.dissipated,
                                    body.work.walls,
                                    body.work.mapping,
                                    body.work.drag,
                                    body.work.pore_water,
                                    body.nodes.motion_step,
                                    body.monitor.out_of_balance,
                                    body.monitor.external,
                                    body.monitor.kinetic_energy,
                                    body.monitor.speed,
                                    body.work.supports};
  archive.put("scalars", scalars);
  const std::vector<std::int64_t> counts{body.step_count, lane_width, body.monitor.fastest_node};
  archive.put("counts", counts);
}

void check_lane_width(const ArchiveReader& archive, const std::string& what, const char* purpose) {
  const std::int64_t width = archive.long_integers("counts")[1];
  if (width != lane_width) {
    throw Error(ExitCode::wrong_input,
                fmt::format("{} was written by a build for vectors of {} doubles, this one has {}; {} with the same "
                            "build (TALUS_ARCH)",
                            what, width, lane_width, purpose));
  }
}

template <int D>
void get_body(const ArchiveReader& archive, mpm::Body<D>& body) {
  check_lane_width(archive, "the checkpoint", "resume");
  const auto& counts = archive.long_integers("counts");
  visit_reals(body, [&](const char* name, auto& values) { copy_into(values, archive.reals(name)); });
  if (body.softening_reach &&
      archive.has("elements/softened"))  // absent from a result of a case without a nonlocal length
    visit_softening(body, [&](const char* name, auto& values) { copy_into(values, archive.reals(name)); });
  if (body.water.is_wet()) {
    visit_water(body, [&](const char* name, auto& values) { copy_into(values, archive.reals(name)); });
    get_water(archive, body);
    get_darcy(archive, body.water.darcy);
  }
  visit_integers(body, [&](const char* name, auto& values) { copy_into(values, archive.integers(name)); });
  visit_vectors(body, [&](const char* name, auto& values) { unflatten(archive.reals(name), values); });
  body.points.block_start = archive.long_integers("points/block_start");
  copy_into(body.points.place, archive.long_integers("points/place"));
  const auto& lost = archive.reals("lost");
  body.lost.clear();
  for (std::size_t i = 0; i + 3 + 2 * D <= lost.size(); i += 3 + 2 * D) {
    mpm::Lost<D> l;
    l.id = static_cast<int>(lost[i]);
    l.time = lost[i + 1];
    l.mass = lost[i + 2];
    for (std::size_t d = 0; d < D; ++d) {
      l.position[d] = lost[i + 3 + d];
      l.momentum[d] = lost[i + 3 + D + d];
    }
    body.lost.push_back(l);
  }
  const auto& scalars = archive.reals("scalars");
  body.time = scalars[0];
  body.work = {scalars[1], scalars[2], scalars[3], scalars[4],
               scalars[5], scalars[6], scalars[7], scalars.size() > 13 ? scalars[13] : 0};
  body.nodes.motion_step = scalars[8];
  body.monitor = {scalars[9], scalars[10], scalars[11], scalars[12], static_cast<int>(counts[2])};
  body.step_count = counts[0];
  get_bars(archive, body.bars);
  if constexpr (D == 2)
    if (body.nodes.sums.size() == static_cast<std::size_t>(body.layout->rows) * mpm::sums_stride) mpm::join_bars(body);
}

#define TALUS_INSTANTIATE(D)                                       \
  template void put_mesh<D>(ArchiveWriter&, const mesh::Mesh<D>&); \
  template mesh::Mesh<D> get_mesh<D>(const ArchiveReader&);        \
  template void put_body<D>(ArchiveWriter&, const mpm::Body<D>&);  \
  template void get_body<D>(const ArchiveReader&, mpm::Body<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
