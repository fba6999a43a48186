// SPDX-License-Identifier: MIT
#include "results/slices.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, Circle& r) {
  v.key("centre", r.centre, {"m", "centre"});
  v.key("radius", r.radius, {"m", "radius"});
}

void describe(Visitor& v, SlipSurface& r) {
  v.key("method", r.method, {"", "method"});
  v.key("title", r.title, {"", "name of the method"});
  v.key("circular", r.circular, {"", "whether it is a circle"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("circle", r.circle, {"", "the circle"});
  v.key("points", r.points, {"m", "its points"});
  v.maybe("name", r.name, {"", "name in the case"});
}

void describe(Visitor& v, SurfaceChecks& r) {
  v.key("smallest_m_alpha", r.smallest_m_alpha, {"", "smallest m_α", can_be_nan});
  v.key("tensile_share", r.tensile_share, {"", "share of the base in tension"});
  v.key("thrust_outside", r.thrust_outside, {"", "share of the sides with the thrust outside the mass"});
  v.key("residual", r.residual, {"", "what is left of forces and moments, over the weight"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
}

void describe(Visitor& v, SliceTable& r) {
  v.key("left", r.left, {"m", "x of the left side"});
  v.key("right", r.right, {"m", "x of the right side"});
  v.key("base_left", r.base_left, {"m", "left end of the base"});
  v.key("base_right", r.base_right, {"m", "right end of the base"});
  v.key("top_left", r.top_left, {"m", "y of the ground at the left side"});
  v.key("top_right", r.top_right, {"m", "y of the ground at the right side"});
  v.key("soil", r.soil, {"", "soil at the base"});
  v.key("alpha", r.alpha, {"rad", "inclination of the base"});
  v.key("length", r.length, {"m", "length of the base"});
  v.key("weight", r.weight, {"N/m", "weight"});
  v.key("surface_load", r.surface_load, {"N/m", "vertical load on the ground"});
  v.key("surface_thrust", r.surface_thrust, {"N/m", "horizontal load on the ground"});
  v.key("earthquake", r.earthquake, {"N/m", "horizontal force of the earthquake"});
  v.key("pore_pressure", r.pore_pressure, {"Pa", "pore pressure at the base"});
  v.key("cohesion", r.cohesion, {"Pa", "cohesion at the base"});
  v.key("root_cohesion", r.root_cohesion, {"Pa", "cohesion of roots"});
  v.key("suction_strength", r.suction_strength, {"Pa", "strength by suction"});
  v.key("tan_friction", r.tan_friction, {"", "tangent of the friction angle"});
  v.key("normal", r.normal, {"N/m", "normal force on the base", can_be_nan});
  v.key("shear", r.shear, {"N/m", "shear force on the base", can_be_nan});
  v.key("m_alpha", r.m_alpha, {"", "m_α", can_be_nan});
  v.key("normal_right", r.normal_right, {"N/m", "normal force on the right side", can_be_nan});
  v.key("shear_right", r.shear_right, {"N/m", "shear force on the right side", can_be_nan});
  v.key("thrust_right", r.thrust_right, {"m", "y of the thrust on the right side", can_be_nan});
}

void describe(Visitor& v, DrawnSurface& r) {
  v.key("factor_before", r.factor_before, {"", "factor of safety before drawdown"});
  v.maybe("undrained_factor", r.undrained_factor, {"", "factor of safety of the second stage of three"});
  v.key("normal", r.normal, {"Pa", "effective normal stress on the base before drawdown"});
  v.key("shear", r.shear, {"Pa", "shear stress on the base before drawdown"});
  v.key("strength", r.strength, {"Pa", "undrained strength of the base"});
  v.key("counts", r.counts, {"", "which strength of the base counts"});
}

void describe(Visitor& v, SupportForce& r) {
  v.key("support", r.support, {"", "name of the support"});
  v.key("kind", r.kind, {"", "kind of the support"});
  v.key("row", r.row, {"", "row from the top of the pattern"});
  v.key("is_active", r.is_active, {"", "whether the force is a load, which the factor does not divide"});
  v.key("head", r.head, {"m", "head of the bar"});
  v.key("end", r.end, {"m", "end of the bar"});
  v.key("crossing", r.crossing, {"m", "where the surface crosses the bar"});
  v.key("distance", r.distance, {"m", "distance of the crossing from the head"});
  v.key("resistance", r.resistance, {"N/m", "resistance of the bar there, per metre of slope"});
  v.key("force", r.force, {"N/m", "force on the sliding mass, per metre of slope"});
  v.maybe("required", r.required, {"N/m", "force that equilibrium would require, where the factor is below 1"});
  v.key("direction", r.direction, {"", "unit vector of that force"});
  v.key("tension", r.tension, {"N/m", "tensile strength"});
  v.key("pull_out", r.pull_out, {"N/m", "pull-out resistance behind the surface"});
  v.key("stripping", r.stripping, {"N/m", "resistance of head and bond in front of the surface"});
  v.key("limit", r.limit, {"", "which limit governs"});
}

void describe(Visitor& v, CriticalSurface& r) {
  describe(v, r.surface);
  v.key("lambda", r.lambda, {"", "λ, the inclination of the forces between slices"});
  v.key("correction", r.correction, {"", "f₀ of Janbu"});
  v.key("area", r.area, {"m2", "area of the mass"});
  v.key("depth", r.depth, {"m", "greatest depth"});
  v.maybe("crack", r.crack, {"m", "depth of the dry tension crack that the search added"});
  v.key("volume_note", r.volume_note, {"", "meaning of the area"});
  v.key("slides_left", r.slides_left, {"", "whether it slides towards smaller x"});
  v.key("yield_acceleration", r.yield_acceleration, {"", "yield acceleration over gravity"});
  v.maybe("drawdown", r.drawdown, {"", "rapid drawdown; the factor is after it"});
  v.maybe("supports", r.supports, {"", "forces of the supports that it crosses"});
  v.key("checks", r.checks, {"", "checks of admissibility"});
  v.maybe("verdict", r.verdict, {"", "what limit analysis proves of the factor"});
  v.key("slices", r.slices, {"", "its slices"});
  v.key("warnings", r.warnings, {"", "warnings"});
}

void describe(Visitor& v, GridRange& r) {
  v.key("from", r.from, {"m", "one corner"});
  v.key("to", r.to, {"m", "other corner"});
  v.key("columns", r.columns, {"", "columns"});
  v.key("rows", r.rows, {"", "rows"});
  v.key("radii", r.radii, {"", "radii at each centre"});
  v.key("levels", r.levels, {"m", "lowest and highest tangent"});
}

void describe(Visitor& v, SearchRanges& r) {
  v.maybe("exit", r.exit, {"m", "where surfaces leave the ground"});
  v.maybe("entry", r.entry, {"m", "where surfaces enter the ground"});
  v.maybe("exits", r.exits, {"", "exits"});
  v.maybe("entries", r.entries, {"", "entries"});
  v.maybe("depths", r.depths, {"", "circles between an entry and an exit"});
  v.maybe("grid", r.grid, {"", "grid of centres"});
}

void describe(Visitor& v, SearchShape& r) {
  v.key("name", r.name, {"", "name in the case"});
  v.key("points", r.points, {"m", "a point, a polyline, corners of a polygon, or two corners of a box"});
  v.key("is_box", r.is_box, {"", "whether the points are two corners of a box"});
}

void describe(Visitor& v, BlockRange& r) {
  v.maybe("along", r.along, {"", "layer or line that the surfaces follow"});
  v.key("windows", r.windows, {"", "windows, each with a vertex of every surface"});
  v.key("active", r.active, {"rad", "least and greatest inclination of the upper end"});
  v.key("passive", r.passive, {"rad", "least and greatest inclination of the lower end"});
  v.key("angles", r.angles, {"", "inclinations in each range"});
}

void describe(Visitor& v, TangentRange& r) {
  v.maybe("levels", r.levels, {"m", "lowest and highest level of the deepest point of circles"});
  v.maybe("layer", r.layer, {"", "layer or line that circles touch"});
  v.key("is_top", r.is_top, {"", "whether they touch its top; else its bottom"});
}

void describe(Visitor& v, SearchRestrictions& r) {
  v.maybe("block", r.block, {"", "polylines of a search for blocks"});
  v.maybe("tangent", r.tangent, {"", "what every circle is tangent to"});
  v.key("excluded", r.excluded, {"", "areas that no surface enters"});
  v.key("through", r.through, {"", "windows that every surface passes"});
  v.key("impenetrable", r.impenetrable, {"", "materials whose top surfaces follow"});
  v.maybe("slides_left", r.slides_left, {"", "whether only masses that slide towards smaller x count; else larger x"});
  v.maybe("smallest_area", r.smallest_area, {"m2", "smallest area of a sliding mass"});
  v.maybe("smallest_weight", r.smallest_weight, {"N/m", "smallest weight of a sliding mass"});
}

void describe(Visitor& v, LimitHit& r) {
  v.key("method", r.method, {"", "name of the method"});
  v.key("limit", r.limit, {"", "which limit"});
}

void describe(Visitor& v, SliceSearch& r) {
  v.key("kind", r.kind, {"", "how circles were chosen"});
  v.key("tried", r.tried, {"", "circles that were tried"});
  v.key("refused", r.refused, {"", "refused surfaces by method and reason"});
  v.key("limits", r.limit_hits, {"", "critical surfaces at a limit of the search"});
  v.key("ranges", r.ranges, {"", "where it looked"});
  v.maybe("restrictions", r.restrictions, {"", "which surfaces the case asked for"});
  v.key("smallest_depth", r.smallest_depth, {"m", "smallest depth of a mass that it took"});
  v.key("seconds", r.seconds, {"s", "seconds"});
  v.key("circles_per_second", r.circles_per_second, {"1/s", "circles per second"});
}

void describe(Visitor& v, SliceResult& r) {
  v.maybe("error", r.error, {"", "why there is no answer"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("methods", r.methods, {"", "methods of slices"});
  v.key("slices", r.slices, {"", "slices of a surface"});
  v.maybe("drawdown", r.drawdown, {"", "method of rapid drawdown; factors are after it"});
  v.key("critical", r.critical, {"", "critical circles"});
  v.key("noncircular", r.noncircular, {"", "critical polylines"});
  v.key("given", r.given, {"", "surfaces that the case gives"});
  v.key("minima", r.minima, {"", "local minima by method"});
  v.maybe("referee", r.referee, {"", "limit analysis of the soil of limit equilibrium"});
  v.maybe("search", r.search, {"", "what the search did"});
  v.maybe("trials_file", r.trials_file, {"", "file of the trials"});
  v.key("seconds", r.seconds, {"s", "seconds"});
}

void describe(Visitor& v, FactorMap& r) {
  v.key("from", r.from, {"m", "one corner"});
  v.key("to", r.to, {"m", "other corner"});
  v.key("columns", r.columns, {"", "columns"});
  v.key("rows", r.rows, {"", "rows"});
  v.key("factor", r.factor, {"", "smallest factor, row by row"});
}

void describe(Visitor& v, SliceTrials& r) {
  v.key("methods", r.methods, {"", "methods of slices"});
  v.key("trials", r.trials, {"", "centre x, y, radius, from, to [m], and the factor by each method"});
  v.key("maps", r.maps, {"", "smallest factor over the centres"});
}

void describe(Visitor& v, SliceFile& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "limit equilibrium"});
  v.merge("trials", r.trials);
}

}  // namespace talus::results
