#include "run/fem/run_fem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/interrupt.hpp"
#include "mesh/quality.hpp"
#include "run/fem/solid_of_case.hpp"

namespace talus::run {
namespace {

/// Displacements and strains of the fields are kept to so many digits after the point: micrometres and 1e-6.
constexpr double field_digits = 1e6;

double round_to(double value, double digits) {
  return std::round(value * digits) / digits;
}

std::vector<results::Flow> list_flows(input::FlowRule rule) {
  if (rule == input::FlowRule::as_given) return {results::Flow::as_given};
  if (rule == input::FlowRule::associated) return {results::Flow::associated};
  return {results::Flow::as_given, results::Flow::associated};
}

/// Least and greatest ψ of the soils with a strength [rad].
std::array<double, 2> find_dilatancy(const input::Case& data, bool associated) {
  double low = 1e9, high = -1e9;
  for (const auto& [region, name] : data.regions) {
    const input::Material& m = data.materials.at(name);
    if (m.model == input::MaterialModel::linear_elastic) continue;
    const double psi = associated ? m.friction_angle : m.dilatancy_angle;
    low = std::min(low, psi);
    high = std::max(high, psi);
  }
  return low <= high ? std::array{low, high} : std::array{0.0, 0.0};
}

fem::ReductionOptions make_options(const input::FiniteElements& settings, int threads) {
  fem::ReductionOptions options;
  options.from = settings.from;
  options.to = settings.to;
  options.resolution = settings.resolution;
  options.solid.force_tolerance = settings.force_tolerance;
  options.solid.displacement_tolerance = settings.displacement_tolerance;
  options.solid.most_iterations = settings.iterations;
  options.solid.load_steps = settings.load_steps;
  options.solid.threads = threads;
  return options;
}

/// √(⅔ e:e) of a strain with γ as shear components.
double find_shear_strain(const std::array<double, 6>& e) {
  const double mean = (e[0] + e[1] + e[2]) / 3;
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) squares += (e[i] - mean) * (e[i] - mean);
  for (std::size_t i = 3; i < 6; ++i) squares += 0.5 * e[i] * e[i];
  return std::sqrt(2.0 / 3 * squares);
}

/// Displacement and shear strain at the nodes, and which elements yield.
template <int D>
results::ElementFields tell_fields(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state,
                                   results::Flow flow) {
  const std::size_t elements = mesh.elements.size(), per = elements > 0 ? mesh.points.size() / elements : 0;
  std::vector<double> strain(mesh.nodes.size(), 0.0), volume(mesh.nodes.size(), 0.0);
  results::ElementFields fields;
  fields.flow = flow;
  for (std::size_t e = 0; e < elements; ++e) {
    double sum = 0, weight = 0;
    std::size_t plastic = 0;
    for (std::size_t k = e * per; k < (e + 1) * per; ++k) {
      sum += mesh.weights[k] * find_shear_strain(state.strain[k]);
      weight += mesh.weights[k];
      plastic += state.yields[k] != 0 ? 1 : 0;
    }
    for (const int i : mesh.elements[e]) {
      strain[i] += sum;
      volume[i] += weight;
    }
    fields.yields.push_back(2 * plastic > per ? 1 : 0);
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    fields.shear_strain.push_back(volume[i] > 0 ? round_to(strain[i] / volume[i], field_digits) : 0);
    std::vector<double>& u = fields.displacement.emplace_back();
    for (const double c : state.displacement[i]) u.push_back(round_to(c, field_digits));
  }
  return fields;
}

results::ElementTrial tell_trial(const fem::ReductionTrial& t) {
  return {t.factor, t.converged, t.iterations, t.force_residual, t.displacement_residual, t.displacement, t.seconds};
}

template <int D>
results::ElementMesh tell_mesh(const fem::QuadraticMesh<D>& mesh) {
  results::ElementMesh told;
  for (const auto& x : mesh.nodes) {
    std::vector<double>& row = told.nodes.emplace_back();
    for (const double c : x) row.push_back(round_to(c, field_digits));
  }
  for (const auto& e : mesh.elements) told.elements.emplace_back(e.begin(), e.end());
  return told;
}

bool has_run(const results::ElementResult& result, results::Flow flow) {
  return std::any_of(result.runs.begin(), result.runs.end(), [&](const auto& run) { return run.flow == flow; });
}

template <int D>
class FemRun {
 public:
  FemRun(const input::Case& data, const FemOptions& options) : data_(data), options_(options) {}

  ElementOutcome run() {
    const auto start = Clock::now();
    const double before = options_.known ? options_.known->result.seconds.value_or(0) : 0;
    show("mesh");
    SolidOfCase<D> solid = make_solid<D>(data_);
    const fem::QuadraticMesh<D> mesh = fem::make_quadratic<D>(*solid.mesh);
    ElementOutcome outcome = options_.known ? *options_.known : begin(solid, mesh);
    if (options_.ready) options_.ready();
    for (const results::Flow flow : list_flows(data_.fem.flow)) {
      if (has_run(outcome.result, flow)) continue;
      throw_if_interrupted();
      if (flow == results::Flow::associated) set_associated_flow<D>(data_, solid);
      reduce(flow, solid, mesh, outcome);
      outcome.result.seconds = before + std::chrono::duration<double>(Clock::now() - start).count();
      if (options_.keep) options_.keep(outcome);
    }
    if (options_.progress) options_.progress->clear();
    return outcome;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& what) const {
    if (options_.progress) options_.progress->show("finite elements: " + what);
  }

  ElementOutcome begin(const SolidOfCase<D>& solid, const fem::QuadraticMesh<D>& mesh) const {
    ElementOutcome outcome;
    outcome.mesh = tell_mesh<D>(mesh);
    results::ElementResult& result = outcome.result;
    result.elements = mesh.elements.size();
    result.nodes = mesh.nodes.size();
    result.size = mesh::measure_quality(*solid.mesh).mean_size;
    result.element = D == 2 ? "T6" : "T10";
    result.warnings = solid.notes;
    result.fields_file = "fem.json";
    result.seepage = solid.seepage;
    return outcome;
  }

  void reduce(results::Flow flow, const SolidOfCase<D>& solid, const fem::QuadraticMesh<D>& mesh,
              ElementOutcome& outcome) {
    const bool associated = flow == results::Flow::associated;
    const char* words = associated ? "ψ = φ" : "ψ as given";
    show(fmt::format("{}, equilibrium at full strength", words));
    const auto found = fem::reduce_strength<D>(
        solid.model, make_options(data_.fem, options_.threads), [&](const fem::ReductionTrial& t) {
          show(fmt::format("{}, strength divided by {:.4g}: {} after {} iterations", words, t.factor,
                           t.converged ? "stands" : "fails", t.iterations));
        });
    results::ElementRun run;
    run.flow = flow;
    run.psi = find_dilatancy(data_, associated);
    run.factor = found.factor;
    run.stable = found.stable;
    run.failed = found.failed;
    if (found.by_displacement > 0) run.by_displacement = found.by_displacement;
    run.seconds = found.seconds;
    for (const fem::ReductionTrial& t : found.trials) run.trials.push_back(tell_trial(t));
    if constexpr (D == 2) {
      run.slip_line = fem::find_slip_line(solid.model, mesh, found.mechanism);
      if (run.slip_line.empty()) run.warnings.push_back("the shear strain shows no band from the ground to the ground");
    }
    for (const fem::ReductionTrial& t : found.trials)
      if (t.factor == found.failed && !t.flows)
        run.warnings.push_back(
            fmt::format("the trial that failed, at {:.4g}, ran out of iterations ({}) before its soil flowed: with "
                        "more `iterations` under [fem] the factor may be higher",
                        t.factor, t.iterations));
    if (found.stable < 1)
      run.warnings.push_back("the slope does not stand with its full strength: the factor is below 1");
    outcome.result.unknowns = found.unknowns;
    outcome.result.runs.push_back(std::move(run));
    outcome.mesh.runs.push_back(tell_fields<D>(mesh, found.at_failure, flow));
  }

  const input::Case& data_;
  const FemOptions& options_;
};

}  // namespace

ElementOutcome run_fem(const input::Case& data, const FemOptions& options) {
  if (data.mesh.dimension == 2) return FemRun<2>(data, options).run();
  return FemRun<3>(data, options).run();
}

}  // namespace talus::run
