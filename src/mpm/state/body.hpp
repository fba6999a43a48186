// SPDX-License-Identifier: MIT
#pragma once
// State of the explicit MPM engine as plain data. Functions over it are free and are in the files named after the
// phases of the step (step.hpp).
//
// Elements are grouped in blocks of lane_width consecutive elements, one element per lane. The points of a block are in
// its slots: slot k holds the k-th point of each lane, field after field, each field one pack (sliced ELL). Blocks are
// partitioned into a fixed number of chunks. A node that several chunks touch has one row in each of them, and the rows
// of a node are summed in the order of the chunks, so results do not depend on the number of threads.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/aligned.hpp"
#include "base/lane.hpp"
#include "base/vec.hpp"
#include "input/case/stage.hpp"
#include "material/law.hpp"
#include "mesh/mesh.hpp"
#include "mpm/state/bars.hpp"
#include "mpm/state/conditions.hpp"
#include "mpm/state/water.hpp"

namespace talus::mpm {

/// Number of moments Σm, Σmξ_k, Σmξ_kξ_j (k <= j) of an element, from which its consistent mass matrix follows (T2.4).
template <int D>
inline constexpr int moment_size = (D + 1) * (D + 2) / 2;

/// Number of doubles in a node row. `sums`: m, p, f; `motion`: a, v.
inline constexpr int sums_stride = 8;
template <int D>
inline constexpr int motion_stride = D == 2 ? 4 : 8;

/// Everything that follows from the mesh alone; shared by all bodies on it. [block] arrays have one pack per entry.
template <int D>
struct Layout {
  mesh::Mesh<D> mesh;
  int blocks = 0, chunks = 0, rows = 0;
  std::vector<int> chunk_start;     ///< first block of each chunk, [chunks + 1]
  AlignedVector<int> connectivity;  ///< [block][D+1][lane] node row
  std::vector<int> chunk_row;       ///< first row of each chunk, [chunks + 1]
  std::vector<int> node_start;      ///< first node whose first row is in the chunk or in a later one, [chunks + 1]
  bool is_ordered = true;           ///< nodes are in the order of the chunks of their first rows
  std::vector<int> row_start, node_rows;  ///< rows of node i: node_rows[row_start[i] … row_start[i+1])
  AlignedVector<double> gradients;        ///< [block][D*D][lane] ∂ξ_k/∂x_d [1/m]
  AlignedVector<double> volumes;          ///< [block][lane] V_e [m³, or m² per metre]

  /// Rows of a node in Nodes::motion and in averages: the same rows as in the sums, each with the full nodal value.
  TALUS_KERNEL int count_motion_rows(int node) const { return row_start[node + 1] - row_start[node]; }
  TALUS_KERNEL int motion_row(int node, int k) const { return node_rows[row_start[node] + k]; }
};

/// Fields of a slot, in packs.
template <int D>
struct PointFields {
  static constexpr int stress_size = material::stress_size<D>;
  static constexpr int xi = 0, velocity = D, stress = 2 * D, volume = 2 * D + stress_size, mass = volume + 1,
                       state = mass + 1;
};

template <int D>
struct Points : PointFields<D> {
  using PointFields<D>::stress_size, PointFields<D>::state;

  int fields = state;                           ///< packs per slot: state + state variables of the models in use
  AlignedVector<double> data;                   ///< [slot][field][lane]
  std::vector<int> id;                          ///< [slot][lane] point number
  std::vector<std::int64_t> block_start;        ///< first slot of each block
  std::vector<int> block_capacity, block_used;  ///< slots a block owns, and the highest one in use
  AlignedVector<double> count;                  ///< [block][lane] points in the element
  std::vector<std::uint32_t> block_materials;   ///< bit set of the materials in a block

  // By point number.
  std::vector<int> element;           ///< -1 when the point has left the grid, or is on another rank
  AlignedVector<std::int64_t> place;  ///< slot * lane_width + lane
  AlignedVector<std::uint8_t> material;
  AlignedVector<Vec<D>> reference;                               ///< position from which displacements are measured [m]
  AlignedVector<std::array<double, stress_size>> strain_offset;  ///< strain of the point minus that of its element [-]

  int size() const { return static_cast<int>(element.size()); }
  double* slot(std::int64_t s) { return data.data() + s * fields * lane_width; }
  const double* slot(std::int64_t s) const { return data.data() + s * fields * lane_width; }
};

/// Number of slots of block `b` that hold points.
template <int D>
TALUS_KERNEL int count_slots(const Points<D>& points, int b) {
  return points.block_used[b];
}

/// [block][…][lane] arrays of the elements.
template <int D>
struct Elements {
  AlignedVector<double> moments;     ///< [moment_size] [kg]
  AlignedVector<double> strain;      ///< [stress_size] sum of the strain increments of the element since the start [-]
  AlignedVector<double> fill_limit;  ///< mixed integration: an element is full when ΣV_p exceeds this [m³]
  AlignedVector<double> apart;       ///< 1 where a point keeps a gap; such elements take no part in nodal averages
  AlignedVector<double> rough;  ///< r_e of (T4.5), elastic volume increment that averaging removed in the last step [-]
  AlignedVector<double> plastic_dilation;  ///< Δθ_e, V_p-weighted mean plastic dilation of the last step (T4.4) [-]
  // With nonlocal averaging (kernels/softening.hpp), else empty; values of the last step.
  AlignedVector<double> softened, softening_volume;  ///< Σ V_p Δε and Σ V_p of points of soil that softens [m³]
  AlignedVector<double> nonlocal_correction;         ///< nonlocal correction of the dilation, ε̄_e - ε_e (T23.2) [-]
  AlignedVector<double> held_saturation;  ///< S of hydrostatic pore water, one phase moving [-]; empty: no water
};

template <int D>
struct Nodes {
  AlignedVector<double> sums;        ///< [row][sums_stride]: m [kg], p [kg m/s], -f_int [N]
  AlignedVector<double> motion;      ///< [row][motion_stride]: a [m/s²], v [m/s]
  AlignedVector<double> average;     ///< [row][2]: Σ value V_e, Σ V_e of a nodal average
  AlignedVector<double> smoothed;    ///< [row] nodal average
  std::vector<Vec<D>> load;          ///< tractions at the start of the step [N]; empty when there are none
  double motion_step = 0;            ///< Δt of the step that computed `motion` [s]
  std::vector<Vec<D>> displacement;  ///< frozen geometry: summed v Δt [m]
};

/// Work and dissipation since the start of the run [J, per metre in 2D]; theory 9. Positive when energy enters the
/// soil, except `dissipated` and `damped`, which are energy lost.
struct Work {
  double external = 0;    ///< gravity and tractions
  double damped = 0;      ///< local damping (2.89)
  double dissipated = 0;  ///< plastic work
  double walls = 0;       ///< friction of walls, and motion that walls and supports stop; negative where a wall pushes
  double mapping = 0;     ///< mapping loss between points and nodes (T9.1)
  double drag = 0;        ///< drag between water and grains
  double pore_water = 0;  ///< work on the pore water: stored by compression or suction, or carried out with it (T9.2)
  double supports = 0;    ///< work on the bars in the soil: stored, or dissipated by bond and yielding

  Work operator-(const Work& o) const {
    return {external - o.external, damped - o.damped, dissipated - o.dissipated, walls - o.walls,
            mapping - o.mapping,   drag - o.drag,     pore_water - o.pore_water, supports - o.supports};
  }
};

/// Measures of rest and failure in the last step (theory 5); nodal, over free directions.
struct Monitor {
  double out_of_balance = 0;  ///< ‖F_ext+G-F_int‖₂ [N]
  double external = 0;        ///< ‖F_ext+G‖₂ [N]
  double kinetic_energy = 0;  ///< ½Σ m_i v_i² [J]
  double speed = 0;           ///< largest nodal speed [m/s]
  int fastest_node = -1;
};

/// Wall time of the phases of the step [s].
struct Timing {
  double solve_momentum = 0, remap_momentum = 0, smooth_strain = 0, advance_points = 0, relocate = 0;
  double device = 0, transfer = 0;  ///< whole steps on a device, and transfers of the body to and from it

  Timing& operator+=(const Timing& other) {
    solve_momentum += other.solve_momentum;
    remap_momentum += other.remap_momentum;
    smooth_strain += other.smooth_strain;
    advance_points += other.advance_points;
    relocate += other.relocate;
    device += other.device;
    transfer += other.transfer;
    return *this;
  }
};

/// A point that has left the grid.
template <int D>
struct Lost {
  int id = 0;
  double time = 0, mass = 0;      ///< [s], [kg]
  Vec<D> position{}, momentum{};  ///< [m], [kg m/s]
};

/// Neighbours of each element within the nonlocal reach, and their weights w_ef without volumes (T23.1).
struct SofteningReach {
  std::vector<std::int64_t> start;  ///< of element e: [start[e], start[e + 1])
  std::vector<int> element;
  std::vector<double> weight;
};

template <int D>
struct Partition;  // partition.hpp

template <int D>
struct Body {
  // Out of line, so that the laws are known by name only.
  Body();
  Body(const Body&);
  Body(Body&&) noexcept;
  Body& operator=(const Body&);
  Body& operator=(Body&&) noexcept;
  ~Body();

  // Interface that the kernels of the step require of a body; ThreadBody has it on a GPU.
  static constexpr int dimension = D, width = lane_width;  ///< elements of a block
  static constexpr bool adds_to_sums = true;               ///< rows of sums are shared by several elements
  using Lanes = Pack;

  std::shared_ptr<const Layout<D>> layout;
  std::vector<material::Law> laws;  ///< by material number
  std::vector<std::string> material_names;
  Conditions<D> conditions;
  std::vector<Bar> bars;  ///< in plane soil only
  Points<D> points;
  std::shared_ptr<const Partition<D>> partition;          ///< part of this rank; null: the whole body is computed here
  std::shared_ptr<const SofteningReach> softening_reach;  ///< null: softening is local
  Elements<D> elements;
  Nodes<D> nodes;
  Water<D> water;
  std::vector<Lost<D>> lost;
  Work work;
  Monitor monitor;
  Timing timing;
  double time = 0;  ///< [s]
  std::int64_t step_count = 0;
  double smallest_mass = 0;  ///< of a point [kg]; nodes far below it do not move

  const mesh::Mesh<D>& mesh() const { return layout->mesh; }
};

// Options of one step, and the lists of points that leave their element in it.

template <int D>
struct StepOptions {
  double dt = 0;            ///< [s]
  Vec<D> gravity{};         ///< [m/s²]
  double damping = 0;       ///< α of (2.89)
  double mass_scaling = 1;  ///< β of (2.91)
  bool mixed = false;       ///< mixed integration (2.92-2.93)
  input::Smoothing smoothing = input::Smoothing::none;
  bool moving = true;     ///< false: frozen geometry, small strain
  bool objective = true;  ///< rotate stresses with the soil
  bool monitor = false;   ///< fill Body::monitor in this step
  bool jacks = false;     ///< anchors keep their prestress
  int threads = 1;
  // The options below are for soil with pore water.
  bool darcy = false;                ///< Darcy (u-p) formulation: one velocity, pressures at the nodes (darcy_step.hpp)
  double pressure_tolerance = 1e-5;  ///< residual of the pressure equation over its right-hand side [-]
  bool implicit_drag = true;
  double water_damping = 0;  ///< α of (2.89) for the water
  bool net_damping = true;  ///< damp the net force, drag and skin included (T14.10); false: without drag, as the source
  bool smooth_pressure = false;    ///< (2.96-2.97)
  bool exchange_water = false;     ///< between elements, against spurious pressure modes (T14.9)
  double conductivity_factor = 1;  ///< factor on k [-]
};

/// Points of one slot of a block that left their element in advance_points(); input of relocate().
struct Mover {
  int block, slot;
  unsigned lanes;  ///< bit set of the lanes concerned
};
using MoverLists = std::vector<std::vector<Mover>>;  ///< by chunk

// Nodal forces of tractions.

/// Nodal forces of the tractions (2.37) for the step that starts at body.time. Writes nodes.load.
template <int D>
void gather_loads(Body<D>& body);

}  // namespace talus::mpm
