// SPDX-License-Identifier: MIT
#include "run/mpm/record/frame.hpp"

#include <algorithm>
#include <cmath>

#include "material/every_law.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/two_velocity/kernels.hpp"

namespace talus::run {

StateFields::StateFields(const std::vector<material::Law>& laws) {
  for (const material::Law& law : laws) {
    std::vector<std::size_t>& places = places_.emplace_back();
    for (const material::StateField& field : material::list_state_fields(law)) {
      const auto known = std::find_if(fields_.begin(), fields_.end(),
                                      [&](const material::StateField& f) { return f.name == field.name; });
      places.push_back(static_cast<std::size_t>(known - fields_.begin()));
      if (known == fields_.end()) fields_.push_back(field);
    }
  }
}

std::vector<double> StateFields::arrange(const material::Law& law, std::size_t number, const double* state,
                                         double saturation) const {
  std::vector<double> values(fields_.size()), shown(places_[number].size());
  for (std::size_t k = 0; k < fields_.size(); ++k) values[k] = fields_[k].elsewhere;
  if (shown.empty()) return values;
  material::show_state(law, state, saturation, shown.data());
  for (std::size_t i = 0; i < shown.size(); ++i) values[places_[number][i]] = shown[i];
  return values;
}

namespace {

/// A list of fields that is filled point by point.
class Fields {
 public:
  /// Returns the index of the new field.
  std::size_t add(const std::string& name, const std::string& unit, int components) {
    fields_.push_back({name, unit, components, {}});
    return fields_.size() - 1;
  }
  void push(std::size_t field, double value) { fields_[field].values.push_back(value); }
  std::vector<output::Field> take() { return std::move(fields_); }

 private:
  std::vector<output::Field> fields_;
};

/// Stored symmetric tensors have the order xx yy zz xy yz xz, those of the engine xx yy zz xy yz zx.
template <std::size_t N>
double component(const std::array<double, N>& tensor, std::size_t i) {
  return i < N ? tensor[i] : 0.0;
}

/// Pore pressure is written positive in compression; it is NaN at a dry point.
template <int D>
void push_water(Fields& fields, std::size_t first, const mpm::PointView<D>& p) {
  fields.push(first, p.wet ? -p.pressure : 0.0);
  fields.push(first + 1, p.wet ? p.saturation : 0.0);
  fields.push(first + 2, p.porosity);
  for (std::size_t d = 0; d < 3; ++d) fields.push(first + 3, p.wet && d < D ? p.water_velocity[d] : 0.0);
}

/// Mass of a node including its water [kg], and velocity of the soil skeleton [m/s].
template <int D>
struct Node {
  double mass = 0;
  const double* velocity = nullptr;
};

template <int D>
Node<D> read_node(const mpm::Body<D>& body, int i) {
  const int *rows = &body.layout->node_rows[body.layout->row_start[i]],
            *end = &body.layout->node_rows[0] + body.layout->row_start[i + 1];
  const std::size_t first = static_cast<std::size_t>(*rows);
  Node<D> node;
  if (!body.water.is_wet() || body.water.darcy.is_used) {
    for (; rows != end; ++rows) node.mass += body.nodes.sums[static_cast<std::size_t>(*rows) * mpm::sums_stride];
    node.velocity = &body.nodes.motion[first * mpm::motion_stride<D> + D];
    return node;
  }
  using Columns = mpm::WetColumns<D>;
  for (; rows != end; ++rows) {
    const double* sums = &body.water.sums[static_cast<std::size_t>(*rows) * mpm::wet_sums_stride<D>];
    node.mass += sums[Columns::mass] + sums[Columns::water_mass];
  }
  node.velocity = &body.water.motion[first * mpm::wet_motion_stride<D> + 2 * D];
  return node;
}

template <int D>
output::MeshFrame make_mesh_frame(const mpm::Body<D>& body, bool cells, bool nodes) {
  const auto& mesh = body.mesh();
  output::MeshFrame frame;
  frame.nodes_per_element = D + 1;
  for (const auto& x : mesh.nodes) {
    for (std::size_t d = 0; d < 3; ++d) frame.nodes.push_back(d < D ? x[d] : 0.0);
  }
  for (const auto& e : mesh.elements) frame.elements.insert(frame.elements.end(), e.begin(), e.end());
  if (cells) {
    output::Field count{"points", "-", 1, {}}, region{"region", "-", 1, {}};
    for (int e = 0; e < mesh.element_count(); ++e) {
      count.values.push_back(body.points.count[e]);
      region.values.push_back(mesh.element_region[e]);
    }
    frame.element_fields = {count, region};
  }
  if (nodes) {
    output::Field velocity{"velocity", "m/s", 3, {}}, mass{"mass", "kg", 1, {}};
    for (int i = 0; i < mesh.node_count(); ++i) {
      const Node<D> node = read_node(body, i);
      mass.values.push_back(node.mass);
      for (int d = 0; d < 3; ++d) velocity.values.push_back(d < D ? node.velocity[d] : 0.0);
    }
    frame.node_fields = {velocity, mass};
  }
  return frame;
}

}  // namespace

template <int N>
Invariants find_stress_invariants(const std::array<double, N>& s) {
  const double p = (s[0] + s[1] + s[2]) / 3;
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) squares += (s[i] - p) * (s[i] - p);
  for (std::size_t i = 3; i < N; ++i) squares += 2 * s[i] * s[i];
  return {p, std::sqrt(1.5 * squares)};
}

template <int N>
Invariants find_strain_invariants(const std::array<double, N>& e) {
  const double volumetric = e[0] + e[1] + e[2];
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) squares += (e[i] - volumetric / 3) * (e[i] - volumetric / 3);
  for (std::size_t i = 3; i < N; ++i) squares += 0.5 * e[i] * e[i];
  return {volumetric, std::sqrt(2.0 / 3 * squares)};
}

template <int D>
output::Frame make_frame(const mpm::Body<D>& body, const std::string& stage, bool cells, bool nodes) {
  constexpr int NS = material::stress_size<D>;
  output::Frame frame;
  frame.time = body.time;
  frame.step = static_cast<long>(body.step_count);
  frame.stage = stage;
  Fields fields;
  fields.add("displacement", "m", 3);
  fields.add("velocity", "m/s", 3);
  fields.add("stress", "Pa", 6);
  fields.add("mean_stress", "Pa", 1);
  fields.add("deviatoric_stress", "Pa", 1);
  fields.add("strain", "-", 6);
  fields.add("volumetric_strain", "-", 1);
  fields.add("deviatoric_strain", "-", 1);
  fields.add("plastic_strain", "-", 1);
  fields.add("volume", "m3", 1);
  if (body.water.is_wet()) {
    fields.add("pore_pressure", "Pa", 1);
    fields.add("saturation", "-", 1);
    fields.add("porosity", "-", 1);
    fields.add("water_velocity", "m/s", 3);
  }
  const StateFields states(body.laws);
  std::vector<std::size_t> of_state;
  for (const material::StateField& f : states.list()) of_state.push_back(fields.add(f.name, f.unit, 1));
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    frame.ids.push_back(id);
    frame.materials.push_back(p.material);
    for (std::size_t d = 0; d < 3; ++d) {
      frame.positions.push_back(d < D ? p.position[d] : 0.0);
      fields.push(0, d < D ? p.displacement[d] : 0.0);
      fields.push(1, d < D ? p.velocity[d] : 0.0);
    }
    for (std::size_t i = 0; i < 6; ++i) {
      fields.push(2, component(p.stress, i));
      fields.push(5, component(p.strain, i) * (i < 3 ? 1.0 : 0.5));
    }
    const Invariants stress = find_stress_invariants<NS>(p.stress), strain = find_strain_invariants<NS>(p.strain);
    fields.push(3, stress.mean);
    fields.push(4, stress.deviatoric);
    fields.push(6, strain.mean);
    fields.push(7, strain.deviatoric);
    fields.push(8, p.plastic_strain);
    fields.push(9, p.volume);
    if (body.water.is_wet()) push_water<D>(fields, 10, p);
    if (of_state.empty()) continue;
    const std::vector<double> values = states.read(body, p);
    for (std::size_t k = 0; k < values.size(); ++k) fields.push(of_state[k], values[k]);
  }
  frame.point_fields = fields.take();
  if (cells || nodes) frame.mesh = make_mesh_frame(body, cells, nodes);
  return frame;
}

template Invariants find_stress_invariants<4>(const std::array<double, 4>&);
template Invariants find_stress_invariants<6>(const std::array<double, 6>&);
template Invariants find_strain_invariants<4>(const std::array<double, 4>&);
template Invariants find_strain_invariants<6>(const std::array<double, 6>&);
template output::Frame make_frame<2>(const mpm::Body<2>&, const std::string&, bool, bool);
template output::Frame make_frame<3>(const mpm::Body<3>&, const std::string&, bool, bool);

}  // namespace talus::run
