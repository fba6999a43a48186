// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a body in the memory of a device, and its part of the Darcy step. Grid: HostGrid or CudaGrid.

#include "mpm/backend/device.hpp"
#include "mpm/backend/device_array.hpp"
#include "mpm/backend/water_kernels.hpp"

namespace talus::mpm::device {

template <class Grid, int D>
class DeviceWaterBody {
 public:
  DeviceWaterBody(Grid& grid, ThreadBody<D>& body) : grid_(grid), body_(body) {}

  bool is_there() const { return body_.water.is_wet(); }
  /// Field of the water's mass in a slot; -1: no water.
  int mass_field() const { return is_there() ? body_.water.first_field + WaterFields<D>::mass : -1; }

  /// Copies the water to the device. `nodes`, `lanes`: numbers of nodes and of lanes.
  void take(const WaterImage<D>& image, std::size_t nodes, std::size_t lanes) {
    body_.water = {};
    laws_.upload(image.laws);
    if (image.laws.empty()) return;
    host_laws_ = image.laws;
    surfaces_ = image.surfaces;
    loads_ = image.loads;
    take_conditions(image);
    take_arrays(image, nodes, lanes);
    surface_is_stale_ = true;
  }

  void copy_back(WaterImage<D>& image) const {
    if (!is_there()) return;
    for (const auto& [of_image, array] : list_fields()) (this->*array).download(image.*of_image);
    ponded_.download(image.ponded);
  }

  /// Phases of the step before the grid solve: contents, surface, flow, and forces of the pressures at the start.
  /// `tractions`: those of the step; nodes.load becomes their sum with the forces of outside water.
  void begin(const DeviceInput<D>& input, const StepOptions<D>& o, View<const Vec<D>> tractions) {
    of_step_.upload(input.surfaces);
    body_.water.surfaces = of_step_.read();
    rates_.upload(input.uptake_rates);
    signals_.assign_zeros(1);
    launch(elements(), SumContents<D>{body_, o.mixed, signals_.view()});
    launch(nodes(), StartNode<D>{body_, is_first_});
    is_first_ = false;
    if (surface_is_stale_ || signals_.fetch_first().turned != 0) find_open_sides();
    if (loads_) launch(elements(), LoadElement<D>{body_, o, open_.read(), load_rows_.view()});
    launch(nodes(), LoadNode<D>{body_, tractions, load_rows_.read(), load_.view()});
    body_.nodes.load = load_.read();
    for (std::size_t k = 0; k < host_laws_.size(); ++k)
      if (host_laws_[k].wet)
        launch(nodes(), FindRelative<D>{body_, k, find_relative_at(host_laws_[k], 0.0), relative_});
    launch(elements(), FindFlow<D>{body_, o, relative_});
    pore_force_.assign_zeros(pore_force_.size());
    launch(nodes(), PressNode<D>{body_});
  }

  /// Solves for the pressures at the end of the step, after the grid solve with those of its start. Returns false
  /// without convergence.
  bool solve(const StepOptions<D>& o, View<ElementAccount> accounts, DeviceOutput<D>& output) {
    launch(elements(), FindOwnMass<D>{body_});
    launch(nodes(), PredictNode<D>{body_, o});
    if (o.moving && uptakes_.size() > 0)
      launch(elements(), DrawElement<D>{body_, uptakes_.read(), rates_.read(), o.dt, accounts});
    const PressureSystem<D> system = assemble(o);
    for_nodes<NodeLine::start_line>(system);
    Gradients found;
    found.unsettled = 1;
    for (output.rounds = 1; output.rounds <= most_rounds; ++output.rounds) {
      if (found.unsettled != 0) start_residual(system);
      found = solve_round(system, output.rounds - 1);
      if (found.rounds < output.rounds) return false;  // no convergence, or NaN
      output.iterations += found.last_iterations;
      if (found.unsettled == 0 && found.unfit == 0) break;
    }
    launch(nodes(), FlowOfNode<D>{system, body_.water.darcy.change});
    for_nodes<NodeLine::find_passed>(system);
    for_nodes<NodeLine::find_out>(system);
    launch(elements(), ForElements<D, ElementLine::distribute_water>{system});
    for_nodes<NodeLine::keep_own>(system);
    for (int s = 0; s < surfaces_; ++s) grid_.sum(nodes(), WaterOfNode<D>{system, s}, budgets_.view().start + s);
    launch(nodes(), EndNode<D>{system});
    launch(elements(), ForElements<D, ElementLine::find_end>{system});
    launch(nodes(), PressNode<D>{body_});
    return true;
  }

  /// Water that passed the surfaces in the step, by condition.
  std::vector<SurfaceBudget> fetch_budgets() const { return budgets_.download(); }

  void count_power(double seconds, View<NodeAccount> accounts) {
    launch(nodes(), CountPorePower<D>{body_, seconds, accounts});
  }

 private:
  template <class T>
  using Array = DeviceArray<Grid, T>;
  using Field = std::pair<std::vector<double> WaterImage<D>::*, Array<double> DeviceWaterBody::*>;
  /// Smallest number of iterations between two checks of convergence on the host.
  static constexpr int iterations_ahead = 2;

  /// Arrays that change and are copied back.
  static std::array<Field, 7> list_fields() {
    using I = WaterImage<D>;
    return {{{&I::volume, &DeviceWaterBody::volume_},
             {&I::stretch, &DeviceWaterBody::stretch_},
             {&I::mean_saturation, &DeviceWaterBody::mean_saturation_},
             {&I::mean_pressure, &DeviceWaterBody::mean_pressure_},
             {&I::pressure, &DeviceWaterBody::pressure_},
             {&I::own, &DeviceWaterBody::own_},
             {&I::change, &DeviceWaterBody::change_}}};
  }

  void launch(int n, const auto& kernel) {
    if (n > 0) grid_.launch(n, kernel);
  }
  template <NodeLine Line>
  void for_nodes(const PressureSystem<D>& system) {
    launch(nodes(), ForWetNodes<D, Line>{system});
  }
  int nodes() const { return body_.node_count; }
  int elements() const { return body_.element_count; }

  void take_conditions(const WaterImage<D>& image) {
    surface_of_node_.upload(image.surface_of_node);
    constraint_of_node_.upload(image.constraint_of_node);
    constraints_.upload(image.constraints);
    weights_.clear();
    std::vector<DeviceUptake> uptakes = image.uptakes;
    for (DeviceUptake& uptake : uptakes) {
      weights_.emplace_back().upload(uptake.weight);
      uptake.weight = weights_.back().read();
    }
    uptakes_.upload(uptakes);
    node_size_.upload(image.node_size);
    row_start_.upload(image.row_start);
    row_ends_.upload(image.row_ends);
    column_.upload(image.column);
    place_.upload(image.place);
    DeviceWater<D>& water = body_.water;
    water.laws = laws_.read();
    water.density = image.density;
    water.first_field = image.first_field;
    water.surface_of_node = surface_of_node_.read();
    water.constraint_of_node = constraint_of_node_.read();
    water.constraints = constraints_.read();
    DeviceGraph<D>& graph = water.darcy.graph;
    graph.touch_start = body_.layout.row_start;
    graph.element.rows = graph.local.rows = body_.layout.node_rows;
    graph.size = node_size_.read();
    graph.row_start = row_start_.read();
    graph.row_ends = row_ends_.read();
    graph.column = column_.read();
    graph.place = place_.read();
  }

  void take_arrays(const WaterImage<D>& image, std::size_t nodes, std::size_t lanes) {
    for (const auto& [of_image, array] : list_fields()) (this->*array).upload(image.*of_image);
    is_first_ = image.own.empty();
    if (is_first_) own_.assign_zeros(nodes);
    if (image.pressure.empty()) pressure_.upload(std::vector<double>(nodes, NAN));
    if (image.change.empty()) change_.assign_zeros(nodes);
    image.ponded.empty() ? ponded_.assign_zeros(nodes) : ponded_.upload(image.ponded);
    const std::size_t soils = laws_.size();
    DeviceDarcy<D>& m = body_.water.darcy;
    const auto put_table = [soils](Array<double>& array, std::size_t columns) {
      array.assign_zeros(soils * columns);
      return TableView{array.view().start, soils, columns};
    };
    m.pores = put_table(pores_, lanes);
    m.volume = put_table(volumes_, lanes);
    m.node_pores = put_table(node_pores_, nodes);
    relative_ = put_table(relatives_, nodes);
    const auto put = [](auto& array, std::size_t size) {
      array.assign_zeros(size);
      return array.view();
    };
    m.water = put(content_, lanes);
    m.share = put(share_, lanes);
    for (std::size_t d = 0; d < D; ++d) m.flux[d] = put(flux_[d], lanes);
    m.drawn = put(drawn_, lanes);
    m.saturated = put(saturated_, lanes);
    m.effective = put(effective_, lanes);
    m.coupling = put(coupling_, lanes);
    m.conductive = put(conductive_, lanes);
    m.soft = put(soft_, lanes);
    m.pressing = put(pressing_, lanes);
    m.own_mass = put(own_mass_, lanes * (D + 1));
    m.node_water = put(node_water_, nodes);
    m.out = put(out_, nodes);
    m.passed = put(passed_, nodes);
    m.mobility = put(mobility_, nodes);
    m.velocity = put(velocity_, nodes);
    m.acceleration = put(acceleration_, nodes);
    m.pore_force = put(pore_force_, nodes);
    m.area = put(area_, nodes);
    m.pressure = pressure_.view();
    m.own = own_.view();
    m.change = change_.view();
    m.ponded = ponded_.view();
    DeviceWater<D>& water = body_.water;
    water.volume = volume_.view();
    water.stretch = stretch_.view();
    water.mean_saturation = mean_saturation_.view();
    water.mean_pressure = mean_pressure_.view();
    touches_.resize(nodes);
    outside_.resize(lanes);
    open_.assign_zeros(lanes);
    load_.resize(nodes);
    load_rows_.assign_zeros(loads_ ? lanes * (D + 1) : 0);
    for (Array<double>* array :
         {&drive_, &storage_, &diagonal_, &inverse_, &of_node_, &r_, &z_, &q_, &grown_, &drained_, &d_})
      array->assign_zeros(nodes);
    carried_.assign_zeros(nodes);
    fixed_.assign_zeros(nodes);
    surface_.resize(nodes);
    lines_.resize(nodes);
    for (Array<double>* array : {&growth_of_, &lost_}) array->resize(lanes);
    for (int d = 0; d < D; ++d) {
      seeping_[d].resize(lanes);
      lift_[d].resize(lanes);
    }
    through_.resize(column_.size());
    growth_.resize(column_.size() * D);
    push_.resize(column_.size() * D);
    gradients_.assign_zeros(1);
    budgets_.resize(static_cast<std::size_t>(surfaces_));
  }

  /// Finds the open sides. Only the spread of the outside around obstacles takes further launches.
  void find_open_sides() {
    surface_is_stale_ = false;
    launch(nodes(), MarkWetNode<D>{body_, touches_.view()});
    launch(elements(), StartOutside<D>{body_, touches_.read(), outside_.view()});
    do {
      signals_.assign_zeros(1);
      launch(elements(), SpreadOutside<D>{body_, outside_.view(), signals_.view()});
    } while (signals_.fetch_first().spread != 0);
    launch(elements(), FindOpenSides<D>{body_, outside_.read(), open_.view()});
    launch(nodes(), FindArea<D>{body_, open_.read()});
  }

  PressureSystem<D> assemble(const StepOptions<D>& o) {
    for (Array<double>* array : {&through_, &growth_, &push_, &d_}) array->assign_zeros(array->size());
    PressureSystem<D> system{body_,
                             o,
                             {through_.view(),
                              growth_.view(),
                              push_.view(),
                              drive_.view(),
                              storage_.view(),
                              diagonal_.view(),
                              inverse_.view(),
                              grown_.view(),
                              drained_.view(),
                              of_node_.view(),
                              r_.view(),
                              z_.view(),
                              d_.view(),
                              q_.view(),
                              carried_.view(),
                              fixed_.view(),
                              surface_.view(),
                              lines_.view(),
                              growth_of_.view(),
                              {},
                              {},
                              lost_.view(),
                              {}},
                             gradients_.view()};
    for (int d = 0; d < D; ++d) {
      system.arrays.flux[d] = seeping_[d].view();
      system.arrays.lift[d] = lift_[d].view();
    }
    launch(nodes(), SumPores<D>{system});
    for_nodes<NodeLine::find_surface>(system);
    launch(elements(), ForElements<D, ElementLine::assemble>{system});
    for_nodes<NodeLine::find_source>(system);
    for_nodes<NodeLine::assemble>(system);
    for_nodes<NodeLine::find_diagonal>(system);
    return system;
  }

  template <Scalar Meaning>
  void sum(const PressureSystem<D>& system, Total Gradients::*total) {
    grid_.sum(nodes(), OfNode<D, Meaning>{system}, &(gradients_.view().start->*total));
  }
  void multiply(const PressureSystem<D>& system, View<double> x, When when) {
    launch(nodes(), PushNode<D>{system, x, when});
    launch(nodes(), MultiplyNode<D>{system, x, when});
  }

  /// Sums with which a round starts. `round`: the one that ends, -1: none.
  void start_round(const PressureSystem<D>& system, int round) {
    sum<Scalar::scale>(system, &Gradients::scale);
    sum<Scalar::residual>(system, &Gradients::residual);
    launch(1, StartRound{gradients_.view(), round, system.options.pressure_tolerance});
  }
  /// Residual with the pressures that the surface prescribes.
  void start_residual(const PressureSystem<D>& system) {
    for_nodes<NodeLine::fix>(system);
    multiply(system, body_.water.darcy.change, When::always);
    for_nodes<NodeLine::start_residual>(system);
    start_round(system, -1);
  }

  /// Solves one round for the change of the pressures, then updates the surface and the lines of the water content.
  Gradients solve_round(const PressureSystem<D>& system, int round) {
    launch(1, ClearUnsettled{gradients_.view()});
    Gradients g;
    int& expected = iterations_of_round_[static_cast<std::size_t>(round)];
    do {
      // Three quarters of the iterations of the last step at once, then a few at a time; launches after convergence
      // return at once.
      for (int n = 0; n < std::max(3 * expected / 4 - g.iterations, iterations_ahead); ++n) {
        multiply(system, d_.view(), When::on_the_way);
        sum<Scalar::curvature>(system, &Gradients::curvature);
        launch(nodes(), GoOn<D>{system});
        sum<Scalar::residual>(system, &Gradients::residual);
        launch(1, TakeResidual{gradients_.view()});
        launch(nodes(), Turn<D>{system});
      }
      launch(nodes(), SettleNode<D>{system, round});
      sum<Scalar::error>(system, &Gradients::error);
      start_round(system, round);
      g = gradients_.fetch_first();
    } while (g.rounds != round + 1 && g.is_running());
    expected = g.last_iterations;
    return g;
  }

  Grid& grid_;
  ThreadBody<D>& body_;
  std::vector<WaterLaw> host_laws_;
  int surfaces_ = 0;
  std::array<int, most_rounds> iterations_of_round_{};
  bool loads_ = false, is_first_ = false, surface_is_stale_ = true;

  Array<WaterLaw> laws_;
  // Conditions and graph.
  Array<int> surface_of_node_, constraint_of_node_, row_start_, row_ends_, column_, place_;
  Array<WaterConstraint<D>> constraints_;
  Array<DeviceSurface> of_step_;
  Array<DeviceUptake> uptakes_;
  std::vector<Array<double>> weights_;
  Array<double> rates_, node_size_;
  // By element.
  Array<double> volume_, stretch_, mean_saturation_, mean_pressure_, pores_, volumes_, content_, share_, flux_[D],
      drawn_, saturated_, effective_, coupling_, conductive_, soft_, pressing_, own_mass_, growth_of_, lost_,
      seeping_[D], lift_[D];
  Array<Vec<D>> load_rows_;
  Array<std::uint8_t> outside_, open_;
  // By node.
  Array<double> pressure_, own_, change_, node_pores_, relatives_, node_water_, out_, passed_, mobility_, drive_,
      storage_, diagonal_, inverse_, grown_, drained_, of_node_, r_, z_, d_, q_;
  TableView relative_;
  Array<Vec<D>> velocity_, acceleration_, pore_force_, area_, load_;
  Array<std::array<double, 4>> carried_;
  Array<std::uint8_t> ponded_, touches_, fixed_;
  Array<SurfaceWater> surface_;
  Array<HeldLine> lines_;
  // The matrix.
  Array<double> through_, growth_, push_;
  Array<Gradients> gradients_;
  Array<SurfaceBudget> budgets_;
  Array<WaterSignals> signals_;
};

}  // namespace talus::mpm::device
