// SPDX-License-Identifier: MIT
#pragma once
// A body in the memory of a device, and its steps as a sequence of kernels. Grid: TimedGrid of a HostGrid or a
// CudaGrid.

#include <algorithm>
#include <cmath>

#include "mpm/backend/device_loads.hpp"
#include "mpm/backend/device_water.hpp"
#include "mpm/backend/relocation_kernels.hpp"

namespace talus::mpm::device {

template <class Grid, int D>
class DeviceBody : public Device<D> {
 public:
  explicit DeviceBody(Grid grid) : grid_(std::move(grid)) {}
  DeviceBody(const DeviceBody&) = delete;
  DeviceBody& operator=(const DeviceBody&) = delete;

  void take(const DeviceImage<D>& image, const StepOptions<D>& options) override {
    take_mesh(image);
    take_points(image);
    take_fields(image);
    loads_.take(image);
    const std::size_t lanes = image.count.size();
    water_.take(image.water, image.mesh.nodes.size(), lanes);
    make_room(image);
    change_.assign_zeros(lanes);
    leaving_.assign_zeros(lanes + 1);  // the last entry belongs to no element: a scan writes the total there
    first_.resize(lanes + 1);
    arrivals_.assign_zeros(lanes);
    average_.resize(2 * lanes);
    node_accounts_.assign_zeros(static_cast<std::size_t>(body_.node_count));
    element_accounts_.assign_zeros(lanes);
    account_.resize(1);
    if (options.mixed) launch(body_.element_count, UpdateSurface<D>{body_, change_.view()});
    launch(body_.element_count,
           SumAnew<D>{body_, options, true, water_.mass_field(), change_.view(), element_accounts_.view()});
  }

  DeviceOutput<D> step(const DeviceInput<D>& input, const StepOptions<D>& o) override {
    DeviceOutput<D> output;
    take_conditions(input);
    if (water_.is_there()) {
      water_.begin(input, o, body_.nodes.load);
      solve_momentum(o);
      output.finds_pressures = water_.solve(o, element_accounts_.view(), output);
      if (!output.finds_pressures) return output;
    }
    solve_momentum(o);
    if (water_.is_there()) water_.count_power(body_.nodes.motion_step, node_accounts_.view());
    launch(body_.element_count, RemapElement<D>{body_, o.dt});
    launch(body_.node_count, RemapNode<D>{body_, o, node_accounts_.view()});
    if (water_.is_there()) water_.count_power(o.dt, node_accounts_.view());
    body_.nodes.motion_step = o.dt;
    if (o.smoothing != input::Smoothing::none) {
      launch(body_.element_count, AverageElement<D>{body_, o, average_.view()});
      launch(body_.node_count, AverageNode<D>{body_, average_.read()});
    }
    if (!body_.elements.nonlocal_correction.empty()) {
      launch(body_.element_count, LendSoftening<D>{body_, reach_});
      launch(body_.element_count, ClearSoftening{body_.elements});
    }
    water_.is_there() ? advance<true>(o) : advance<false>(o);
    relocate(o, output.departed);
    add_up(node_accounts_, &StepAccount::nodes);
    add_up(element_accounts_, &StepAccount::elements);
    const auto [nodes, elements] = account_.fetch_first();
    if (water_.is_there()) output.budgets = water_.fetch_budgets();
    output.work.external = nodes.external;
    output.work.damped = nodes.piece.damped;
    output.work.walls = nodes.piece.walls;
    output.work.mapping = nodes.piece.mapping + elements.shared;
    output.work.dissipated = elements.dissipated;
    output.work.pore_water = nodes.pore_water;
    output.pressed_in = elements.pressed_in;
    output.transpired = elements.transpired;
    output.monitor = {std::sqrt(nodes.piece.out_of_balance2), std::sqrt(nodes.piece.external2), nodes.piece.kinetic,
                      std::sqrt(nodes.piece.speed2), nodes.piece.fastest};
    return output;
  }

  double filter_null_modes() override {
    const FadeRows<D> rows{velocity_.view(), direction_.view(), product_.view()};
    launch(body_.node_count, StartFilter<D>{body_, rows});
    for (const FilterWeights& weights : list_filter_weights()) {
      launch(body_.element_count, MultiplyMass<D>{body_, rows});
      launch(body_.node_count, ImproveVelocity<D>{body_, rows, weights});
    }
    launch(body_.element_count, FadeElement<D>{body_, rows, water_.mass_field(), element_accounts_.view()});
    add_up(element_accounts_, &StepAccount::elements);
    return account_.fetch_first().elements.shared;
  }

  void copy_back(DeviceImage<D>& image) override {
    launch(body_.node_count, SumNode<D>{body_, sums_of_nodes_.view()});
    sums_of_nodes_.download(image.sums);
    block_start_.download(image.block_start);
    block_capacity_.download(image.block_capacity);
    data_.download(image.data);
    count_.download(image.count);
    id_.download(image.id);
    strain_offset_.download(image.strain_offset);
    for (const auto& [of_image, array] : list_fields()) (this->*array).download(image.*of_image);
    moments_.download(image.moments);
    motion_.download(image.motion);
    displacement_.download(image.displacement);
    image.motion_step = body_.nodes.motion_step;
    water_.copy_back(image.water);
  }

  StepSquare find_step_square() override {
    return sum_elements<StepSquare>(StepOfElement<D>{body_, water_.mass_field()});
  }

  double find_largest_displacement() override {
    return std::sqrt(sum_elements<Farthest>(FarthestOfElement<D>{body_}).square);
  }

  Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) override {
    const auto seen = sum_elements<Seen<D>>(SeenInElement<D>{body_, gravity});
    Observation<D> observation{seen.totals, seen.water, std::sqrt(seen.farthest.square), {}};
    observation.totals.find_centre();
    wanted_.upload(points);
    views_.resize(points.size());
    launch(static_cast<int>(points.size()), SeePoint<D>{body_, wanted_.read(), views_.view()});
    observation.points = views_.download();
    return observation;
  }

  DeviceMemory find_memory() override { return grid_.find_memory(); }
  void time_kernels() override { grid_.start_timing(); }
  std::vector<KernelTime> list_times() override { return grid_.list_times(); }

 private:
  using P = PointFields<D>;
  template <class T>
  using Array = DeviceArray<Grid, T>;

  void launch(int n, const auto& kernel) {
    if (n > 0) grid_.launch(n, kernel);
  }

  /// Sums of a step over nodes and elements.
  struct StepAccount {
    NodeAccount nodes;
    ElementAccount elements;
  };
  /// Sums an array into its member of account_.
  template <class S>
  void add_up(const Array<S>& list, S StepAccount::*sum) {
    grid_.sum(static_cast<int>(list.size()), Listed<S>{list.read()}, &(account_.view().start->*sum));
  }
  /// Sum over the elements, copied to the host.
  template <class S, class Summand>
  S sum_elements(const Summand& summand) {
    sum_.resize(sizeof(S));
    grid_.sum(body_.element_count, summand, reinterpret_cast<S*>(sum_.view().start));
    S sum;
    Grid::download(&sum, sum_.view().start, sizeof sum);
    return sum;
  }

  /// Arrays of elements that change in a step, in the image and on the device.
  using Field = std::pair<std::vector<double> DeviceImage<D>::*, DeviceArray<Grid, double> DeviceBody::*>;
  static std::array<Field, 8> list_fields() {
    using I = DeviceImage<D>;
    return {{{&I::strain, &DeviceBody::strain_},
             {&I::fill_limit, &DeviceBody::fill_limit_},
             {&I::apart, &DeviceBody::apart_},
             {&I::rough, &DeviceBody::rough_},
             {&I::plastic_dilation, &DeviceBody::plastic_dilation_},
             {&I::softened, &DeviceBody::softened_},
             {&I::softening_volume, &DeviceBody::softening_volume_},
             {&I::nonlocal_correction, &DeviceBody::nonlocal_correction_}}};
  }

  void take_mesh(const DeviceImage<D>& image) {
    places_.upload(image.mesh.nodes);
    elements_.upload(image.mesh.elements);
    neighbours_.upload(image.mesh.neighbours);
    mesh_volumes_.upload(image.mesh.volumes);
    altitudes_.upload(image.mesh.altitudes);
    mesh_gradients_.upload(image.mesh.gradients);
    body_.grid = {places_.read(),       elements_.read(),  neighbours_.read(),
                  mesh_volumes_.read(), altitudes_.read(), mesh_gradients_.read()};
    body_.element_count = static_cast<int>(elements_.size());
    body_.node_count = static_cast<int>(places_.size());
    connectivity_.upload(image.connectivity);
    gradients_.upload(image.gradients);
    volumes_.upload(image.volumes);
    row_start_.upload(image.row_start);
    node_rows_.upload(image.node_rows);
    static_cast<DeviceLayout<D>&>(body_.layout) = {connectivity_.read(), gradients_.read(), volumes_.read(),
                                                   row_start_.read(), node_rows_.read()};
    reach_start_.upload(image.reach_start);
    reach_element_.upload(image.reach_element);
    reach_weight_.upload(image.reach_weight);
    reach_ = {reach_start_.read(), reach_element_.read(), reach_weight_.read()};
  }

  void take_points(const DeviceImage<D>& image) {
    host_laws_ = image.laws;
    laws_.upload(image.laws);
    int states = 0;
    for (const StoredLaw& law : image.laws) states = std::max(states, law.states);
    body_.laws = {laws_.view().start, static_cast<std::uint32_t>(laws_.size()), states};
    capacity_ = image.block_capacity;
    const std::size_t room = find_room(image.id.size() / device_width);
    data_.reserve(room * static_cast<std::size_t>(image.fields) * device_width);
    data_.upload(image.data);
    id_.reserve(room * device_width);
    id_.upload(image.id);
    block_start_.upload(image.block_start);
    block_capacity_.upload(image.block_capacity);
    count_.upload(image.count);
    material_.upload(image.material);
    reference_.upload(image.reference);
    soil_.resize(image.count.size());
    strain_offset_.upload(image.strain_offset);
    std::vector<int> element(static_cast<std::size_t>(image.point_count), -1);
    std::vector<std::int64_t> place(element.size(), -1);
    for (std::size_t b = 0; b < image.block_start.size(); ++b) {
      for (std::int64_t i = 0; i < static_cast<std::int64_t>(image.block_capacity[b]) * device_width; ++i) {
        const std::int64_t at = image.block_start[b] * device_width + i;
        const int point = image.id[static_cast<std::size_t>(at)];
        if (point < 0) continue;
        element[static_cast<std::size_t>(point)] =
            static_cast<int>(b) * device_width + static_cast<int>(i % device_width);
        place[static_cast<std::size_t>(point)] = at;
      }
    }
    element_.upload(element);
    place_.upload(place);
    DevicePoints<D>& points = body_.points;
    points.fields = image.fields;
    points.data = data_.view();
    points.id = id_.view();
    points.block_start = block_start_.read();
    points.block_capacity = block_capacity_.read();
    points.count = count_.view();
    points.element = element_.view();
    points.place = place_.view();
    points.material = material_.read();
    points.reference = reference_.read();
    points.soil = soil_.view();
    points.strain_offset = strain_offset_.view();
  }

  void take_fields(const DeviceImage<D>& image) {
    for (const auto& [of_image, array] : list_fields()) (this->*array).upload(image.*of_image);
    held_saturation_.upload(image.held_saturation);
    moments_.assign_zeros(image.count.size() * moment_size<D>);
    body_.elements = {moments_.view(),
                      strain_.view(),
                      fill_limit_.view(),
                      apart_.view(),
                      rough_.view(),
                      plastic_dilation_.view(),
                      softened_.view(),
                      softening_volume_.view(),
                      nonlocal_correction_.view(),
                      held_saturation_.view()};
    sums_.assign_zeros(image.count.size() * (D + 1) * sums_stride);
    motion_.upload(image.motion);
    smoothed_.assign_zeros(places_.size());
    displacement_.upload(image.displacement);
    body_.nodes = {sums_.view(), motion_.view(), smoothed_.view(), {}, displacement_.view(), image.motion_step};
    body_.smallest_mass = image.smallest_mass;
    constraint_of_node_.upload(image.constraint_of_node);
    constraints_.upload(image.constraints);
    pressed_.assign_zeros(image.constraints.size());
  }

  void take_conditions(const DeviceInput<D>& input) {
    body_.time = input.time;
    body_.nodes.load = loads_.find(body_, input.load_factors);
    factors_.upload(input.factors);
    body_.conditions = {constraint_of_node_.read(), constraints_.read(), pressed_.view(), factors_.read()};
  }

  void solve_momentum(const StepOptions<D>& o) {
    launch(body_.node_count, SolveNode<D>{body_, o, node_accounts_.view()});
  }

  /// G2P and P2G: the pass over the points, one kernel for each kind of law and one for elements with several soils.
  template <bool Wet>
  void advance(const StepOptions<D>& o) {
    std::uint64_t done = 0;  // bit set of kinds
    for (const StoredLaw& law : host_laws_) {
      const std::uint64_t kind = std::uint64_t{1} << law.kind;
      if ((done & kind) == 0) law.visit([&]<class L>(const L&) { advance_kind<L, Wet>(o, done == 0); });
      done |= kind;
    }
    if (host_laws_.size() > 1) advance_kind<AnyLaw, Wet>(o, false);
  }
  template <class L, bool Wet>
  void advance_kind(const StepOptions<D>& o, bool first) {
    const auto run = [&]<bool Mixed>(std::bool_constant<Mixed>) {
      launch(body_.element_count,
             AdvanceElement<D, L, Mixed, Wet>{body_, o, first, leaving_.view(), element_accounts_.view()});
    };
    o.mixed ? run(std::true_type()) : run(std::false_type());
  }

  /// Allocates what the steps need beside the body, so that a lack of memory is detected before the first step.
  void make_room(const DeviceImage<D>& image) {
    const auto nodes = static_cast<std::size_t>(body_.node_count);
    velocity_.resize(nodes * filter_stride);
    direction_.resize(nodes * D);
    product_.resize(image.count.size() * (D + 1) * D);
    sums_of_nodes_.resize(nodes * sums_stride);
    room_.resize(capacity_.size());
    reserve_movers(static_cast<std::size_t>(image.point_count) / mover_share);
  }
  void reserve_movers(std::size_t n) {
    mover_fields_.reserve(n * static_cast<std::size_t>(body_.points.fields));
    for (Array<int>* list : {&mover_id_, &mover_from_, &mover_order_}) list->reserve(n);
    for (Array<unsigned>* list : {&mover_to_, &mover_sorted_}) list->reserve(n);
  }

  void relocate(const StepOptions<D>& o, std::vector<Departed<D>>& departed) {
    if (!o.moving) return;
    grid_.scan(leaving_.view().start, first_.view().start, body_.element_count + 1);
    const int count = first_.fetch_one(static_cast<std::size_t>(body_.element_count));
    if (count == 0) return;
    const Movers movers = make_room_for_movers(count);
    launch(body_.element_count, TakeOut<D>{body_, leaving_.read(), first_.read(), movers, change_.view()});
    signals_.assign_zeros(1);
    launch(count, Walk<D>{body_, movers, signals_.view()});
    grid_.sort(movers.to.start, movers.sorted.start, movers.order.start, count);
    const View<const unsigned> sorted{movers.sorted.start, movers.sorted.count};
    launch(count, AskForRoom<D>{body_, sorted, arrivals_.view(), signals_.view()});
    const Signals signals = signals_.fetch_first();
    if (signals.leave_grid != 0) list_departed(count, departed);
    if (signals.overflow != 0) grow();
    launch(count, PutIn<D>{body_, movers, arrivals_.view(), change_.view()});
    if (o.mixed) launch(body_.element_count, UpdateSurface<D>{body_, change_.view()});
    launch(body_.element_count,
           SumAnew<D>{body_, o, false, water_.mass_field(), change_.view(), element_accounts_.view()});
  }

  Movers make_room_for_movers(int count) {
    const auto n = static_cast<std::size_t>(count);
    if (n > mover_id_.room()) reserve_movers(n + n / 4);
    mover_fields_.resize(n * static_cast<std::size_t>(body_.points.fields));
    mover_id_.resize(n);
    mover_from_.resize(n);
    mover_to_.resize(n);
    mover_order_.resize(n);
    mover_sorted_.resize(n);
    return {mover_fields_.view(), mover_id_.view(),    mover_from_.view(),
            mover_to_.view(),     mover_order_.view(), mover_sorted_.view()};
  }

  /// The points that left the grid, in the order of their removal.
  void list_departed(int count, std::vector<Departed<D>>& departed) {
    const std::vector<unsigned> to = mover_to_.download();
    const std::vector<int> id = mover_id_.download(), from = mover_from_.download();
    const std::vector<double> fields = mover_fields_.download();
    const auto stride = static_cast<std::size_t>(count);
    for (std::size_t m = 0; m < stride; ++m) {
      if (to[m] != static_cast<unsigned>(body_.element_count)) continue;
      const int water = water_.mass_field();
      Departed<D> point{id[m],
                        from[m],
                        fields[P::mass * stride + m],
                        water < 0 ? 0.0 : fields[static_cast<std::size_t>(water) * stride + m],
                        {},
                        {}};
      for (std::size_t d = 0; d < D; ++d) {
        point.xi[d] = fields[(P::xi + d) * stride + m];
        point.velocity[d] = fields[(P::velocity + d) * stride + m];
      }
      departed.push_back(point);
    }
  }

  /// Makes room for arriving points: blocks with too few slots move behind the others.
  void grow() {
    room_.resize(capacity_.size());
    launch(static_cast<int>(capacity_.size()), CountRoom<D>{body_, arrivals_.read(), room_.view()});
    const std::vector<int> needed = room_.download();
    std::vector<MovedBlock> full;
    auto end = static_cast<std::int64_t>(id_.size() / device_width);
    for (std::size_t b = 0; b < needed.size(); ++b) {
      if (needed[b] <= capacity_[b]) continue;
      capacity_[b] = needed[b] + spare_slots;
      full.push_back({static_cast<int>(b), capacity_[b], end});
      end += capacity_[b];
    }
    const auto slots = static_cast<std::size_t>(end);
    if (slots * device_width > id_.room()) return pack();
    data_.extend(slots * static_cast<std::size_t>(body_.points.fields) * device_width);
    id_.extend(slots * device_width);
    body_.points.data = data_.view();
    body_.points.id = id_.view();
    move_blocks(full, body_.points);
  }

  /// Packs all blocks one after another into new arrays, which frees the old places of moved blocks.
  void pack() {
    std::vector<MovedBlock> all;
    std::int64_t end = 0;
    for (std::size_t b = 0; b < capacity_.size(); ++b) {
      all.push_back({static_cast<int>(b), capacity_[b], end});
      end += capacity_[b];
    }
    Array<double> data;
    Array<int> id;
    const auto slots = static_cast<std::size_t>(end), fields = static_cast<std::size_t>(body_.points.fields);
    data.reserve(find_room(slots) * fields * device_width);
    data.extend(slots * fields * device_width);  // no kernel reads beyond `count`
    id.reserve(find_room(slots) * device_width);
    id.extend(slots * device_width);
    DevicePoints<D> packed = body_.points;
    packed.data = data.view();
    packed.id = id.view();
    move_blocks(all, packed);
    data_.swap(data);
    id_.swap(id);
    body_.points.data = packed.data;
    body_.points.id = packed.id;
  }

  void move_blocks(const std::vector<MovedBlock>& blocks, const DevicePoints<D>& to) {
    moved_.upload(blocks);
    launch(static_cast<int>(blocks.size()) * device_width, MoveSlots<D>{body_, moved_.read(), to});
    launch(static_cast<int>(blocks.size()), NoteMoved{moved_.read(), block_start_.view(), block_capacity_.view()});
  }

  Grid grid_;
  ThreadBody<D> body_;
  DeviceLoads<Grid, D> loads_{grid_};
  DeviceWaterBody<Grid, D> water_{grid_, body_};
  std::vector<StoredLaw> host_laws_;
  std::vector<int> capacity_;  ///< host copy of block_capacity_
  SofteningList reach_;

  // The mesh.
  Array<int> connectivity_, row_start_, node_rows_;
  Array<double> gradients_, volumes_, mesh_volumes_, altitudes_;
  Array<Vec<D>> places_;
  Array<std::array<int, D + 1>> elements_, neighbours_;
  Array<std::array<double, D * D>> mesh_gradients_;
  // The points.
  Array<double> data_, count_;
  Array<int> id_, block_capacity_, element_;
  Array<std::int64_t> block_start_, place_;
  Array<std::uint8_t> material_, soil_;
  Array<std::array<double, P::stress_size>> strain_offset_;
  Array<StoredLaw> laws_;
  // Elements and nodes.
  Array<double> moments_, strain_, fill_limit_, apart_, rough_, plastic_dilation_, softened_, softening_volume_,
      nonlocal_correction_, held_saturation_;
  Array<double> sums_, motion_, smoothed_, average_, sums_of_nodes_;
  Array<Vec<D>> displacement_;
  Array<std::int64_t> reach_start_;
  Array<int> reach_element_;
  Array<double> reach_weight_;
  // Conditions.
  Array<int> constraint_of_node_;
  Array<Constraint<D>> constraints_;
  Array<std::uint8_t> pressed_;
  Array<GivenFactor> factors_;
  // Work arrays of a step.
  Array<int> leaving_, first_, arrivals_, change_, room_;
  Array<MovedBlock> moved_;
  Array<double> velocity_, direction_, product_;  // of the null-mode filter
  Array<NodeAccount> node_accounts_;
  Array<ElementAccount> element_accounts_;
  Array<StepAccount> account_;
  Array<unsigned char> sum_;
  // Observed points.
  Array<int> wanted_;
  Array<PointView<D>> views_;
  Array<Vec<D>> reference_;
  Array<Signals> signals_;
  Array<double> mover_fields_;
  Array<int> mover_id_, mover_from_, mover_order_;
  Array<unsigned> mover_to_, mover_sorted_;
};

}  // namespace talus::mpm::device
