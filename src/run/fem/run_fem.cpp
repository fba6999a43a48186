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

using nlohmann::json;

/// Displacements and strains of the fields are kept to so many digits after the point: micrometres and 1e-6.
constexpr double field_digits = 1e6;

double round_to(double value, double digits) {
  return std::round(value * digits) / digits;
}

struct Flow {
  const char* name;
  bool associated;
};

std::vector<Flow> list_flows(input::FlowRule rule) {
  const Flow given{"as_given", false}, associated{"associated", true};
  if (rule == input::FlowRule::as_given) return {given};
  if (rule == input::FlowRule::associated) return {associated};
  return {given, associated};
}

/// Least and greatest ψ of the soils with a strength [rad].
json find_dilatancy(const input::Case& data, bool associated) {
  double low = 1e9, high = -1e9;
  for (const auto& [region, name] : data.regions) {
    const input::Material& m = data.materials.at(name);
    if (m.model == input::MaterialModel::linear_elastic) continue;
    const double psi = associated ? m.friction_angle : m.dilatancy_angle;
    low = std::min(low, psi);
    high = std::max(high, psi);
  }
  return low <= high ? json{low, high} : json{0, 0};
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
json describe_fields(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state) {
  const std::size_t elements = mesh.elements.size(), per = elements > 0 ? mesh.points.size() / elements : 0;
  std::vector<double> strain(mesh.nodes.size(), 0.0), volume(mesh.nodes.size(), 0.0);
  json displacement = json::array(), yields = json::array(), shear = json::array();
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
    yields.push_back(2 * plastic > per ? 1 : 0);
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    shear.push_back(volume[i] > 0 ? round_to(strain[i] / volume[i], field_digits) : 0);
    json u = json::array();
    for (const double c : state.displacement[i]) u.push_back(round_to(c, field_digits));
    displacement.push_back(std::move(u));
  }
  return {{"displacement", std::move(displacement)}, {"shear_strain", std::move(shear)}, {"yields", std::move(yields)}};
}

json to_json(const fem::ReductionTrial& t) {
  return {{"factor", t.factor},
          {"converged", t.converged},
          {"iterations", t.iterations},
          {"force_residual", t.force_residual},
          {"displacement_residual", t.displacement_residual},
          {"displacement", t.displacement},
          {"seconds", t.seconds}};
}

template <int D>
json describe_mesh(const fem::QuadraticMesh<D>& mesh) {
  json nodes = json::array(), elements = json::array();
  for (const auto& x : mesh.nodes) {
    json row = json::array();
    for (const double c : x) row.push_back(round_to(c, field_digits));
    nodes.push_back(std::move(row));
  }
  for (const auto& e : mesh.elements) elements.push_back(json(e));
  return {{"nodes", std::move(nodes)}, {"elements", std::move(elements)}};
}

bool has_run(const json& block, const char* flow) {
  for (const json& run : block.value("runs", json::array()))
    if (run.value("flow", "") == flow) return true;
  return false;
}

template <int D>
class FemRun {
 public:
  FemRun(const input::Case& data, const FemOptions& options) : data_(data), options_(options) {}

  FemResult run() {
    const auto start = Clock::now();
    const double before = options_.known.block.is_object() ? options_.known.block.value("seconds", 0.0) : 0;
    show("mesh");
    SolidOfCase<D> solid = make_solid<D>(data_);
    const fem::QuadraticMesh<D> mesh = fem::make_quadratic<D>(*solid.mesh);
    FemResult result = options_.known;
    if (!result.block.is_object()) {
      result.block = {{"elements", mesh.elements.size()},
                      {"nodes", mesh.nodes.size()},
                      {"unknowns", 0},
                      {"size", mesh::measure_quality(*solid.mesh).mean_size},
                      {"element", D == 2 ? "T6" : "T10"},
                      {"runs", json::array()},
                      {"warnings", solid.notes},
                      {"fields_file", "fem.json"}};
      if (!solid.seepage.is_null()) result.block["seepage"] = solid.seepage;
      result.file = describe_mesh<D>(mesh);
      result.file["runs"] = json::array();
    }
    if (options_.ready) options_.ready();
    for (const Flow& flow : list_flows(data_.fem.flow)) {
      if (has_run(result.block, flow.name)) continue;
      throw_if_interrupted();
      if (flow.associated) set_associated_flow<D>(data_, solid);
      reduce(flow, solid, mesh, result);
      result.block["seconds"] = before + std::chrono::duration<double>(Clock::now() - start).count();
      if (options_.keep) options_.keep(result);
    }
    if (options_.progress) options_.progress->clear();
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& what) const {
    if (options_.progress) options_.progress->show("finite elements: " + what);
  }

  void reduce(const Flow& flow, const SolidOfCase<D>& solid, const fem::QuadraticMesh<D>& mesh, FemResult& result) {
    const char* words = flow.associated ? "ψ = φ" : "ψ as given";
    show(fmt::format("{}, equilibrium at full strength", words));
    const auto found = fem::reduce_strength<D>(
        solid.model, make_options(data_.fem, options_.threads), [&](const fem::ReductionTrial& t) {
          show(fmt::format("{}, strength divided by {:.4g}: {} after {} iterations", words, t.factor,
                           t.converged ? "stands" : "fails", t.iterations));
        });
    json trials = json::array(), warnings = json::array(), line = json::array();
    for (const fem::ReductionTrial& t : found.trials) trials.push_back(to_json(t));
    if constexpr (D == 2) {
      for (const auto& x : fem::find_slip_line(solid.model, mesh, found.mechanism)) line.push_back({x[0], x[1]});
      if (line.empty()) warnings.push_back("the shear strain shows no band from the ground to the ground");
    }
    for (const fem::ReductionTrial& t : found.trials)
      if (t.factor == found.failed && !t.flows)
        warnings.push_back(
            fmt::format("the trial that failed, at {:.4g}, ran out of iterations ({}) before its soil flowed: with "
                        "more `iterations` under [fem] the factor may be higher",
                        t.factor, t.iterations));
    if (found.stable < 1) warnings.push_back("the slope does not stand with its full strength: the factor is below 1");
    result.block["unknowns"] = found.unknowns;
    result.block["runs"].push_back(
        {{"flow", flow.name},
         {"psi", find_dilatancy(data_, flow.associated)},
         {"factor", found.factor},
         {"stable", found.stable},
         {"failed", found.failed},
         {"by_displacement", found.by_displacement > 0 ? json(found.by_displacement) : json()},
         {"trials", std::move(trials)},
         {"slip_line", std::move(line)},
         {"seconds", found.seconds},
         {"warnings", std::move(warnings)}});
    json fields = describe_fields<D>(mesh, found.at_failure);
    fields["flow"] = flow.name;
    result.file["runs"].push_back(std::move(fields));
  }

  const input::Case& data_;
  const FemOptions& options_;
};

}  // namespace

FemResult run_fem(const input::Case& data, const FemOptions& options) {
  if (data.mesh.dimension == 2) return FemRun<2>(data, options).run();
  return FemRun<3>(data, options).run();
}

}  // namespace talus::run
