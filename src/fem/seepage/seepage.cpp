// SPDX-License-Identifier: MIT
// Validation of a seepage model.
#include "fem/seepage/seepage.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace talus::fem {

namespace {

template <int D>
void check_soil(const HydraulicSoil<D>& soil, const ShownUnits& units) {
  const std::string who = "The soil \"" + soil.name + "\"";
  if (!(soil.porosity > 0 && soil.porosity < 1))
    fail_input("{} has a porosity of {:g}; between 0 and 1 is possible.", who, soil.porosity);
  for (double k : soil.conductivity) {
    if (!(k > 0 && std::isfinite(k)))
      fail_input("{} has a hydraulic conductivity of {}; it must be above 0.", who, format_value(k, units.speed()));
  }
  if (!(soil.cross_conductivity * soil.cross_conductivity < soil.conductivity[0] * soil.conductivity[1]))
    fail_input(
        "{} has a conductivity of {} between its axes; its square must be below the product of those along them.", who,
        format_value(soil.cross_conductivity, units.speed()));
  if (!(soil.water_modulus > 0))
    fail_input("{} has a bulk modulus of water of {:g} Pa; it must be above 0.", who, soil.water_modulus);
  if (!(soil.skeleton_compressibility >= 0))
    fail_input("{} has a compressibility of {:g} 1/Pa; it must be 0 or above.", who, soil.skeleton_compressibility);
  if (const auto fault = material::find_fault(soil.retention)) fail_input(who + ": " + *fault);
  if (const auto fault = material::find_fault(soil.relative)) fail_input(who + ": " + *fault);
}

template <int D>
void check_boundary(const SeepageModel<D>& model, const HydraulicBoundary<D>& b) {
  const std::string who = "The hydraulic boundary \"" + b.name + "\"";
  if (b.sides.empty()) fail_input(who + " has no sides.");
  if (!std::isfinite(b.value)) fail_input(who + " has a value that is not finite.");
  for (std::size_t i = 0; i < b.history.size(); ++i) {
    if (!std::isfinite(b.history[i][0]) || !std::isfinite(b.history[i][1]))
      fail_input(who + " has a table with a value that is not finite.");
    if (i > 0 && b.history[i][0] < b.history[i - 1][0])
      fail_input("{} has a table whose times do not increase: {:g} s comes after {:g} s.", who, b.history[i][0],
                 b.history[i - 1][0]);
  }
  if (b.kind != HydraulicKind::total_head && b.kind != HydraulicKind::reservoir) return;
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& x : model.mesh->nodes) lowest = std::min(lowest, x[static_cast<std::size_t>(model.up)]);
  const auto check = [&](double head) {
    if (head < lowest)
      fail_input("{} has a head of {}, which lies below the model, whose lowest point is at {}.", who,
                 format_value(head, model.units.length), format_value(lowest, model.units.length));
  };
  if (b.history.empty()) check(b.value);
  for (const auto& pair : b.history) check(pair[1]);
}

template <int D>
void check_sink(const SeepageModel<D>& model, const RootSink& sink) {
  const std::string who = "The roots \"" + sink.name + "\"";
  const auto& s = sink.reduction.suctions;
  if (!(s[0] <= s[1] && s[1] <= s[2] && s[2] < s[3]))
    fail_input("{} have suctions of {:g}, {:g}, {:g} and {:g} Pa; they must increase.", who, s[0], s[1], s[2], s[3]);
  if (sink.weights.size() != model.mesh->nodes.size())
    throw Error(ExitCode::internal_error, who + " have not as many weights as the mesh has nodes.");
  for (double rate : sink.rate.value) {
    if (!(rate >= 0 && std::isfinite(rate)))
      fail_input("{} have a potential transpiration of {}; it must be 0 or above.", who,
                 format_value(rate, model.units.speed()));
  }
}

}  // namespace

template <int D>
void check_model(const SeepageModel<D>& model) {
  if (!(model.unit_weight > 0)) fail_input("The unit weight of water must be above 0.");
  bool any = false;
  for (int region : model.mesh->element_region) {
    if (region == mesh::empty_region) continue;
    any = true;
    if (region < 0 || region >= static_cast<int>(model.soils.size()))
      fail_input("Region {} of the mesh has no hydraulic soil.", region);
  }
  if (!any) fail_input("No element of the mesh holds soil, so no water can flow.");
  for (const auto& soil : model.soils) check_soil(soil, model.units);
  for (const auto& b : model.boundaries) check_boundary(model, b);
  for (const auto& sink : model.sinks) check_sink(model, sink);
}

template <int D>
void check_storage(const SeepageModel<D>& model) {
  std::vector<bool> takes_part(model.soils.size(), false);  // a region of dry soil has no element left
  for (const int region : model.mesh->element_region)
    if (region != mesh::empty_region) takes_part[static_cast<std::size_t>(region)] = true;
  for (std::size_t i = 0; i < model.soils.size(); ++i) {
    const auto& soil = model.soils[i];
    if (!takes_part[i]) continue;
    const bool flat = std::visit(
        [](const auto& c) {
          return std::is_same_v<std::decay_t<decltype(c)>, material::ConstantSaturation> || c.minimum == c.maximum;
        },
        soil.retention);
    if (flat && std::isinf(soil.water_modulus) && soil.skeleton_compressibility == 0)
      fail_input(
          "The soil \"" + soil.name +
          "\" can take up no water: its retention curve has no slope while water and skeleton are incompressible.");
  }
}

template <int D>
std::string describe_inner_side(const SeepageModel<D>& model, const std::string& boundary,
                                const typename mesh::Mesh<D>::Side& side) {
  std::array<double, D> x{};
  for (int node : side) {
    for (std::size_t d = 0; d < D; ++d) x[d] += model.mesh->nodes[static_cast<std::size_t>(node)][d] / D;
  }
  return fmt::format("The hydraulic boundary \"{}\" at {} {} is no surface: there is soil on both sides.", boundary,
                     format_point(x, model.units.length), model.units.length.name);
}

template <int D>
std::string describe_contradiction(const SeepageModel<D>& model, int node, const std::string& one, double one_head,
                                   const std::string& other, double other_head) {
  const ShownUnit& length = model.units.length;
  return fmt::format("The hydraulic boundaries \"{}\" and \"{}\" meet at {} {} with different heads, {:g} and {}.", one,
                     other, format_point(model.mesh->nodes[static_cast<std::size_t>(node)], length), length.name,
                     one_head / length.si, format_value(other_head, length));
}

#define TALUS_INSTANTIATE(D)                                                                              \
  template void check_model<D>(const SeepageModel<D>&);                                                   \
  template void check_storage<D>(const SeepageModel<D>&);                                                 \
  template std::string describe_inner_side<D>(const SeepageModel<D>&, const std::string&,                 \
                                              const typename mesh::Mesh<D>::Side&);                       \
  template std::string describe_contradiction<D>(const SeepageModel<D>&, int, const std::string&, double, \
                                                 const std::string&, double);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::fem
