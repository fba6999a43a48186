// SPDX-License-Identifier: MIT
#include "input/case/support.hpp"
#include "report/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/content/choices.hpp"
#include "report/content/materials.hpp"
#include "report/content/water.hpp"
#include "report/folder/numbers.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

void add_soil_methods(const input::Case& data, json& methods) {
  for (int i = 0; i < material::model_count; ++i) {
    const material::Traits& law = material::get_traits(material::Model(i));
    if (std::none_of(data.materials.begin(), data.materials.end(),
                     [&](const auto& named) { return named.second.traits().word == law.word; }))
      continue;
    for (const char* paragraph : law.paragraphs)
      if (paragraph && std::find(methods.begin(), methods.end(), paragraph) == methods.end())
        methods.push_back(paragraph);
  }
}

/// Adds the paragraphs of a wet case.
void add_water_methods(const input::Case& data, json& methods) {
  const std::vector<WaterPart> parts = list_water_parts(data);
  const auto some = [&](auto holds) { return std::any_of(parts.begin(), parts.end(), holds); };
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  const bool flows = some([](const WaterPart& p) { return p.flows(); });
  const auto is = [&](input::WaterMotion motion) {
    return some([motion](const WaterPart& p) { return p.step.water == motion; });
  };
  add_if(is(input::WaterMotion::flows), "two_phase");
  add_if(is(input::WaterMotion::flows), "water_storage");
  add_if(is(input::WaterMotion::seeps), "seeping");
  methods.push_back("soil_water");
  add_if(some([](const WaterPart& p) { return p.flows() && p.step.pressure_smoothing; }), "pressure_smoothing");
  add_if(flows, "hydraulic_conditions");
  add_if(some([](const WaterPart& p) { return !p.flows(); }), "held_pressures");
  add_if(data.initial.water.pressure == input::InitialPressure::seepage, "steady_seepage");
}

/// Adds the paragraphs of LEM.
void add_slice_methods(const results::RunResult& run, json& methods) {
  using S = SliceMethod;
  methods.push_back("limit_equilibrium");
  if (!run.slices) return;
  const results::SliceResult& slices = *run.slices;
  const auto add = [&](const char* paragraph, auto... wanted) {
    if (std::any_of(slices.methods.begin(), slices.methods.end(), [&](S m) { return ((m == wanted) || ...); }))
      methods.push_back(paragraph);
  };
  add("fellenius", S::fellenius);
  add("bishop", S::bishop);
  add("janbu", S::janbu, S::janbu_corrected);
  add("spencer", S::spencer);
  add("morgenstern_price", S::morgenstern_price, S::morgenstern_price_constant);
  add("force_equilibrium", S::corps_1, S::corps_2, S::lowe_karafiath, S::modified_swedish);
  if (slices.search && slices.search->tried > 0) methods.push_back("slip_search");
  if (slices.drawdown) methods.push_back("rapid_drawdown");
  if (std::any_of(slices.critical.begin(), slices.critical.end(),
                  [](const auto& surface) { return surface.yield_acceleration.has_value(); }))
    methods.push_back("yield_acceleration");
}

}  // namespace

json list_methods(const ResultFolder& folder) {
  const results::RunResult& run = folder.run;
  const StepChoices choices = gather_step_choices(folder.data);
  json methods = json::array();
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  const bool moves_points = asks_for(folder, Method::mpm), by_elements = asks_for(folder, Method::fem);
  if (asks_for(folder, Method::lem)) add_slice_methods(run, methods);
  add_if(by_elements, "finite_elements");
  add_if(by_elements, "finite_element_reduction");
  add_if(asks_for(folder, Method::bounds), "limit_analysis");
  add_if(run.methods && run.methods->partial_factors, "partial_factors");
  if (!moves_points) {
    if (by_elements) add_soil_methods(folder.data, methods);
    return methods;
  }
  methods.push_back("material_point_method");
  methods.push_back("time_step");
  add_if(choices.integrations.contains(input::Integration::mixed), "mixed_integration");
  add_if(choices.integrations.contains(input::Integration::points), "point_integration");
  add_if(choices.smoothings.contains(input::Smoothing::strain), "strain_smoothing");
  add_if(choices.smoothings.contains(input::Smoothing::stable), "stable_smoothing");
  add_if(choices.largest_damping > 0, "local_damping");
  add_if(choices.largest_mass_scaling > 1, "mass_scaling");
  add_soil_methods(folder.data, methods);
  add_if(choices.is_reduction, "strength_reduction");
  add_if(choices.has_curve, "displacement_curve");
  add_if(choices.has_frozen, "frozen_factor");
  add_if(run.runout || (run.runouts && !run.runouts->empty()), "runout");
  if (is_wet(folder)) add_water_methods(folder.data, methods);
  return methods;
}

using nlohmann::json;

namespace {

/// Unbalanced force over the external force above which a stage counts as not at rest.
constexpr double restless = 0.01;

/// Collects the sentences on one run.
class Assumptions {
 public:
  explicit Assumptions(const ResultFolder& folder)
      : folder_(folder), choices_(gather_step_choices(data_)), dimension_(get_dimension(run_)) {}

  json collect() {
    if (run_.input.is_empty()) return sentences_;
    if (asks_for(folder_, Method::lem)) add_slices();
    if (asks_for(folder_, Method::fem)) add_elements();
    if (asks_for(folder_, Method::bounds)) add_bounds();
    if (!asks_for(folder_, Method::mpm)) {
      if (asks_for(folder_, Method::lem) || asks_for(folder_, Method::fem) || asks_for(folder_, Method::bounds))
        add_models();
      return sentences_;
    }
    add_ground();
    add_soils();
    add_mesh();
    add_factor();
    add_motion();
    add_walls();
    return sentences_;
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> text, Values&&... values) {
    sentences_.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  void add_slices() {
    add("LEM: the mass above a slip surface slides as one body in a plane, and the strength is reached along all of "
        "that surface at once. Deformation, the stress before failure and the dilatancy angle play no part. The "
        "resistance at the sides of a slide is neglected.");
    if (run_.slices && run_.slices->search)
      add("The critical surface is the weakest of those that were tried and then improved; a weaker one of another "
          "shape is possible.");
    add("A factor of Spencer or Morgenstern–Price is not shown with λ above {:g}, since the forces between the slices "
        "would be steeper than soil can bear, nor with λ below {:g}, since the upper part would hold up the lower.",
        data_.lem.largest_lambda, data_.lem.smallest_lambda);
    if (!data_.supports.empty())
      add("Supports act where the slip surface crosses them, each with its resistance there: their deformation is "
          "neglected. A support without prestress has no force where it would drive the mass, and none has one across "
          "an open tension crack.");
    if (data_.lem.drawdown)
      add("The drawdown is instantaneous: no soil that holds its water drains or swells while the level falls, and "
          "soil "
          "that drains does so at once.");
    if (data_.earthquake.horizontal != 0 || data_.earthquake.vertical != 0)
      add("The earthquake is a constant acceleration (pseudo-static): its duration and the pore pressures that it "
          "causes are neglected.");
  }

  void add_elements() {
    add("FEM: small strains on the undeformed geometry. A shear band is as wide as an element, so that a "
        "finer mesh gives a slightly lower factor.");
    if (!run_.elements) return;
    const auto& runs = run_.elements->runs;
    const auto is_adapted = [](const auto& run) { return run.interval && run.meshes && run.meshes->size() > 2; };
    if (std::any_of(runs.begin(), runs.end(), is_adapted))
      add("The factor by FEM is extrapolated to element size zero from meshes that are refined where the soil shears. "
          "Its interval holds the error of the mesh for the order of convergence that they show, and the brackets of "
          "the search.");
    else if (std::any_of(runs.begin(), runs.end(), [](const auto& run) { return run.interval.has_value(); }))
      add("The factor by FEM is extrapolated from two meshes to element size zero. Its interval holds the "
          "error of the mesh for orders of convergence of 0.42 and more, and the brackets of the search.");
    else if (!runs.empty())
      add("The factor by FEM is that of one mesh, and the mesh error is not known.");
    if (data_.fem.softening == input::FemSoftening::progressive && !runs.empty())
      add("Soil that softens loses strength in the trials of FEM by the plastic shear strain of their equilibria. The "
          "factor divides c and tan φ at every strain and lies between those with residual and with peak strength.");
    for (const results::ElementRun& run : runs)
      if (run.davis)
        add("{} replaces soil with ψ < φ by a weaker one with associated flow, so that the factor depends less on the "
            "mesh: c and tan φ times cos ψ cos φ/(1 − sin ψ sin φ), {}.",
            results::name_flow(run),
            run.davis == results::Davis::a   ? "by the angles as given"
            : run.davis == results::Davis::b ? "by the angles reduced by the factor"
                                             : "by the reduced φ and ψ as given");
      else if (run.flow == results::Flow::associated)
        add("With associated flow (ψ = φ) the factor can be compared with LEM and limit analysis; with ψ as given it "
            "should agree with that of MPM.");
  }

  void add_bounds() {
    add("Limit analysis: rigid, perfectly plastic soil in plane strain with ψ = φ, strength and pore pressures linear "
        "in "
        "the triangles of the first mesh, and the undeformed geometry. A stress field in equilibrium that nowhere "
        "exceeds the strength proves the lower bound, a mechanism that obeys the flow rule the upper bound. Both "
        "fields "
        "were checked by themselves. Soil with less cohesion or tensile strength than a millionth of the largest load "
        "is "
        "taken to have as much.");
    if (data_.bounds.flow == input::BoundsFlow::davis)
      add("They are those of soil with the strength of Davis, which is weaker where ψ < φ: of the soil as given they "
          "prove nothing.");
  }

  void add_ground() {
    if (dimension_ == 2)
      add("Plane strain: a section without sides, per {} of thickness. A slide between flanks is stronger than its "
          "section.",
          read_units(run_).span.name == "ft" ? "foot" : "metre");
    else
      add("Three dimensions: the section is extruded along z between walls. Tetrahedra lock more than triangles, and "
          "factors of safety in 3D have not been compared with other methods beyond a slab and an upper bound.");
    if (is_wet(folder_))
      for (std::string& sentence : list_water_assumptions(folder_)) sentences_.push_back(std::move(sentence));
    else
      add("Dry soil in one phase: no pore pressure, no seepage, no suction. Undrained ground can be calculated with "
          "total stresses only (φ = 0, c = su).");
    const input::Initial& initial = data_.initial;
    if (!initial.result.empty())
      add("The initial state is the end of the results in '{}'.", initial.result);
    else if (initial.stress == input::InitialStress::elements)
      add("The initial stress is in equilibrium with weight, water and loads by FEM, which starts from K0 = {}.",
          initial.k0 ? show_number(*initial.k0) : "ν/(1−ν) of each soil");
    else if (initial.stress == input::InitialStress::none)
      add("There is no initial stress: the first stage brings the weight on, and the horizontal stress of the settled "
          "ground is about ν/(1−ν) times the vertical one, a matter of Poisson's ratio.");
    else if (initial.k0)
      add("The initial stress is geostatic with K0 = {}, as under a level ground; the first stage brings it into "
          "balance.",
          show_number(*initial.k0));
    else
      add("The initial stress is geostatic with K0 = ν/(1−ν) of each soil, as under a level ground; the first stage "
          "brings it into balance.");
  }

  void add_soils() {
    std::vector<std::string> elastic, tensile;
    std::size_t with_strength = 0, plain = 0;
    for (const auto& [name, soil] : data_.materials) {
      const material::Traits& traits = soil.traits();
      if (traits.strength == material::Strength::none) elastic.push_back(name);
      is_plastic_ = is_plastic_ || traits.strength == material::Strength::known;
      if (!soil.traits().has_friction) continue;
      ++with_strength;
      if (!traits.softens && !material::needs<material::BeddingInput>(soil.model)) ++plain;
      if (soil.tensile_strength > 0) tensile.push_back(name);
      add_dilatancy(name, soil);
    }
    if (plain > 0)
      add("{} perfectly plastic: no softening, no rate effect, the same in all directions. With peak "
          "strength a slide stops too early, with residual strength it starts too early.",
          plain == with_strength ? "The strength is" : "The strength of the other soils is");
    if (!tensile.empty())
      add("A tensile strength is kept in {}: ground may hang together in tension where real ground would crack.",
          join_words(tensile));
    if (tensile.size() < with_strength)
      add("{} no tensile strength: it opens freely, and separated soil swells a little.",
          tensile.empty() ? "The soil has" : "The other soil has");
    add_models();
    add_softening();
    for (std::string& sentence : list_root_assumptions(folder_)) sentences_.push_back(std::move(sentence));
    if (!elastic.empty()) add("Without any limit of strength (linear elastic): {}.", join_words(elastic));
  }

  /// Adds the assumptions of the constitutive laws, once for all materials of a family.
  void add_models() {
    for (int i = 0; i < material::model_count; ++i) {
      const material::Traits& law = material::get_traits(material::Model(i));
      if (!law.assumption || (i > 0 && law.assumption == material::get_traits(material::Model(i - 1)).assumption))
        continue;
      std::vector<std::string> names;
      for (const auto& [name, soil] : data_.materials)
        if (soil.traits().assumption == law.assumption) names.push_back(name);
      if (names.empty()) continue;
      sentences_.push_back(fmt::format(fmt::runtime(law.assumption), join_words(names)));
      if (choices_.is_reduction && law.reduction) sentences_.push_back(law.reduction);
    }
    std::vector<std::string> kept;
    for (const auto& [name, soil] : data_.materials)
      if (!soil.reduced) kept.push_back(name);
    if (!kept.empty())
      add("No factor of safety divides the strength of {} (reduced = false): the factors refer to the other soils.",
          join_words(kept));
  }

  void add_softening() {
    if (std::none_of(data_.materials.begin(), data_.materials.end(),
                     [](const auto& material) { return material.second.traits().softens; }))
      return;
    if (const auto length = data_.softening_length)
      add("What softens does so over a length of {}: a choice about the calculation, not a property of the soil. "
          "Longer ones move later.",
          show(*length, read_units(run_).length));
    else
      add("What softens does so in bands as thick as the elements are: onset and depth of a movement depend on their "
          "size.");
  }

  void add_dilatancy(const std::string& name, const input::Material& soil) {
    const double psi = soil.dilatancy_angle, phi = soil.friction_angle;
    if (phi <= 0) return;
    // Without a factor of safety there is nothing to compare with LEM.
    const bool compares = choices_.is_reduction;
    if (psi <= 0)
      add("{}: the plastic flow keeps its volume (ψ = 0, φ = {:.3g}°).{}", name, phi / degree,
          compares ? " LEM assumes ψ = φ in effect and gives a higher factor, by about 3 to 5 % on the slopes that "
                     "were compared."
                   : "");
    else if (psi < phi - 1e-9)
      add("{}: the plastic flow dilates with ψ = {:.3g}° below φ = {:.3g}°{}.", name, psi / degree, phi / degree,
          compares ? "; the factor lies between those of ψ = 0 and ψ = φ" : "");
    else
      add("{}: associated flow (ψ = φ = {:.3g}°){}; real soil dilates less{}.", name, phi / degree,
          compares ? ", comparable with LEM and limit analysis" : "", compares ? ", which gives a lower factor" : "");
  }

  void add_mesh() {
    const double size = run_.mesh ? run_.mesh->mean_size : 0, height = run_.slope_height.value_or(0);
    if (size > 0 && height > 0) {
      const double across = height / size;
      add("The mean size of the elements is {} the height of the slope.{}",
          across > 1.5 ? fmt::format("1/{:.0f} of", across) : show_number(1 / across, 2) + " times",
          is_plastic_ ? " Shear bands are one or two elements thick whatever their size: strains inside them depend on "
                        "the mesh."
                      : "");
    }
    if (is_plastic_) add_locking();
  }

  /// Adds the sentence on volumetric locking, which needs plastic flow.
  void add_locking() {
    const char* simplex = dimension_ == 2 ? "triangles" : "tetrahedra";
    const std::string lock =
        fmt::format("linear {} without smoothing lock in plastic flow at constant volume", simplex);
    if (choices_.has_curve && !choices_.curve_is_smoothed)
      add("The displacement curve: {}. They are too strong: factors of the curve come out some 5 to 15 % too high, and "
          "displacements too small.",
          lock);
    else if (!choices_.is_reduction && !choices_.stages_are_smoothed)
      add("The stages: {}. They are too strong, and displacements come out too small.", lock);
    if (choices_.smoothings.contains(input::Smoothing::strain))
      add("Plain strain smoothing is used; with dilatancy (ψ > 0) it can become unstable.");
    if (choices_.smoothings.contains(input::Smoothing::stable))
      add("Locking of linear {} is relieved by stable strain smoothing, not removed: finer meshes still give {}.",
          simplex, choices_.is_reduction ? "lower factors" : "larger displacements");
  }

  void add_factor() {
    if (!choices_.is_reduction) return;
    if (run_.factor_of_safety && run_.factor_of_safety->frozen) {
      const results::FrozenFactor& frozen = *run_.factor_of_safety->frozen;
      add("The factor of safety is decided at frozen geometry (small strains): a trial comes to rest or runs away. "
          "It does not include deformation before failure.");
      if (frozen.extrapolated)
        add("It is extrapolated from {} meshes to element size zero. Its interval holds the brackets of the search, "
            "± {:.3f}, and what the mesh does, ± {:.3f}.",
            frozen.list_found().size(), frozen.bracket, frozen.mesh_effect.value_or(0));
      else if (frozen.factor)
        add("It is that of one mesh and not extrapolated: {} % too high at elements of H/13, {} % at H/27 on the {}.",
            dimension_ == 2 ? "up to 5" : "7", dimension_ == 2 ? "2.5" : "4.5",
            dimension_ == 2 ? "slopes that were compared" : "vertical cut that was compared");
      for (const results::MeshFactor& m : frozen.meshes)
        if (m.undecided)
          add("At h = {} a trial was neither at rest nor run away when its time was over; it counts as failed.",
              show(m.size, read_units(run_).length));
    }
    if (choices_.has_curve)
      add("Displacements of the curve are those after {:g} s with damping {:g}: other times and damping give other "
          "displacements, and the constructions on the curve are conventions.",
          data_.strength_reduction.curve.window, data_.strength_reduction.curve.step_settings.damping);
    if (!run_.stages || run_.stages->empty() || run_.stages->size() != data_.stages.size()) return;
    if (const double force_ratio = run_.stages->back().force_ratio; force_ratio > restless)
      add("The last stage was still moving when the strength reduction began (unbalanced force {:.2g} of the weight): "
          "displacements of the trials contain that motion.",
          force_ratio);
  }

  void add_motion() {
    if (run_.supports)
      add("MPM carries supports with the soil as bars in tension, which do not resist bending; soil does not flow past "
          "them sideways. The factor divides their bond where their sense is given as passive, and never their "
          "strength.");
    if (has_moved())
      add("Runout: moved volume and largest displacement are robust to about ±15 to 20 % from H/10 on, the position of "
          "the front is not: it converges slowly, and each halving of the mesh may move it by a tenth. Behind ± stands "
          "three times the difference from elements twice as large. Kinetic energy is lost in the mapping at impacts: "
          "pressures on walls are not valid.");
    if (choices_.largest_damping > 0.1 && !choices_.is_reduction)
      add("Local damping of up to {:g} is used, for coming to rest. In a stage that runs out it would stop the soil "
          "too early.",
          choices_.largest_damping);
    if (choices_.largest_mass_scaling > 1)
      add("The inertia is multiplied by up to {:g} in some stages: their times and speeds have no physical meaning.",
          choices_.largest_mass_scaling);
    if (const std::size_t lost = run_.budgets ? run_.budgets->lost.points : 0; lost > 0)
      add("{} {} the grid and {} no longer calculated.", lost, lost == 1 ? "point left" : "points left",
          lost == 1 ? "is" : "are");
  }

  /// Returns true if any soil moved, so that there is a runout.
  bool has_moved() const {
    const auto moves = [](const results::Runout& runout) { return runout.moved_volume > 0; };
    if (run_.runout && moves(*run_.runout)) return true;
    return run_.runouts && std::any_of(run_.runouts->begin(), run_.runouts->end(),
                                       [&](const results::RunoutTrial& r) { return moves(r.runout); });
  }

  void add_walls() {
    if (std::any_of(data_.boundaries.begin(), data_.boundaries.end(),
                    [](const input::Boundary& b) { return b.fix == input::Fix::friction; }))
      add("Walls with friction follow Coulomb's law with one coefficient and no cohesion.");
  }

  const ResultFolder& folder_;
  const results::RunResult& run_ = folder_.run;
  const input::Case& data_ = folder_.data;
  StepChoices choices_;
  std::size_t dimension_;
  bool is_plastic_ = false;  ///< some soil has a strength limit
  json sentences_ = json::array();
};

}  // namespace

json list_assumptions(const ResultFolder& folder) {
  return Assumptions(folder).collect();
}

}  // namespace talus::report
