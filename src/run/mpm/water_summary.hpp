#pragma once
// Pore water in the summary: its budget, and the steady seepage that a run starts from.

#include <nlohmann/json.hpp>

#include "fem/seepage/seepage.hpp"
#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::run {

/// Water at the start and now, and what passed each condition [kg], [Pa]. `initial` is its mass at the start. The
/// error of the budget is what the sums leave unexplained, as a share of the water in the model.
template <int D>
nlohmann::json describe_water(const input::Case& data, const mpm::Body<D>& body, double initial);

/// Discharges [m³/s], greatest suction and its place, the water table, where water comes out, and how it was found.
template <int D>
nlohmann::json describe_seepage(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& seepage);

}  // namespace talus::run
