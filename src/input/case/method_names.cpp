#include "input/case/method_names.hpp"

#include <fmt/format.h>

#include <tuple>

#include "input/case/declare_limit_equilibrium.hpp"

namespace talus::input {

std::string get_word(SliceMethod method) {
  return Codec<SliceMethod>::encode(method, {});
}

const char* get_title(SliceMethod method) {
  switch (method) {
    case SliceMethod::fellenius:
      return "Fellenius";
    case SliceMethod::bishop:
      return "Bishop simplified";
    case SliceMethod::janbu:
      return "Janbu simplified";
    case SliceMethod::janbu_corrected:
      return "Janbu corrected";
    case SliceMethod::spencer:
      return "Spencer";
    case SliceMethod::morgenstern_price:
      return "Morgenstern–Price";
    case SliceMethod::morgenstern_price_constant:
      break;
  }
  return "Morgenstern–Price, constant function";
}

bool suits_polylines(SliceMethod method) {
  return method != SliceMethod::fellenius && method != SliceMethod::bishop;
}

void add_slice_results(std::vector<ResultName>& names, const Case& data) {
  const LimitEquilibrium& lem = data.lem;
  const auto add = [&](const std::string& place, SliceMethod method, const std::string& title,
                       ResultKind kind = ResultKind::factor, const char* quantity = "factor") {
    names.push_back({fmt::format("lem.{}{}", place, get_word(method)), fmt::format("{}, {}", get_title(method), title),
                     "", kind, quantity, method});
  };
  const bool searches = lem.search != SurfaceSearch::none;
  if (searches)
    for (const SliceMethod m : lem.methods) add("", m, "factor of safety of the critical circle");
  if (searches && lem.noncircular)
    for (const SliceMethod m : lem.methods)
      if (suits_polylines(m)) add("noncircular.", m, "factor of safety of the critical polyline");
  for (const SlipSurface& surface : lem.surfaces)
    for (const SliceMethod m : lem.methods)
      add(fmt::format("surface[{}].", surface.name), m, fmt::format("factor of safety of surface '{}'", surface.name));
  if (searches && lem.yield_acceleration)
    for (const SliceMethod m : lem.methods)
      add("yield_acceleration.", m, "yield acceleration over g of the critical circle", ResultKind::yield_acceleration,
          "yield_acceleration");
  for (const auto& [method, label, title] :
       {std::tuple{Method::fem, "fem.band", "the band of the finite elements"},
        std::tuple{Method::mpm, "mpm.slip_line", "the slip line of the material points"}})
    for (const SliceMethod m : lem.methods)
      if (uses(data, method) && suits_polylines(m))
        add(fmt::format("handed[{}].", label), m, fmt::format("factor of safety on {}", title));
}

void add_element_results(std::vector<ResultName>& names, const Case& data) {
  const auto add = [&](const std::string& place, const std::string& flow) {
    names.push_back({place + "factor", "factor of safety, finite elements" + flow, ""});
    names.push_back({place + "by_displacement", "factor of safety by displacement, finite elements" + flow, ""});
  };
  if (data.fem.flow != FlowRule::associated) add("fem.", "");
  if (data.fem.flow != FlowRule::as_given) add("fem.associated.", " with ψ = φ");
}

}  // namespace talus::input
