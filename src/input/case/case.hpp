#pragma once
// The case as plain data, in SI units and radians. What each key means to a user stands in declare_*.hpp.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/case/calibration.hpp"
#include "input/case/finite_elements.hpp"
#include "input/case/limit_equilibrium.hpp"
#include "input/case/point_test.hpp"
#include "input/case/roots.hpp"
#include "input/case/sampling.hpp"
#include "input/case/water.hpp"
#include "input/language/amount.hpp"
#include "input/language/time_table.hpp"
#include "mesh/plan.hpp"

namespace talus::input {

enum class MaterialModel {
  linear_elastic,
  mohr_coulomb,
  rooted_mohr_coulomb,
  modified_cam_clay,
  rooted_cam_clay,
  external
};

/// Modified Cam-clay, bare or rooted (4.1-4.15).
struct CamClaySoil {
  double compression = 0;                        ///< λ [-]
  double swelling = 0;                           ///< κ [-]
  double critical_state_slope = 0;               ///< M_0 [-]
  double suction_hardening = 0;                  ///< b [-]
  std::optional<double> preconsolidation;        ///< p'_c0 of the saturated bare soil [Pa]; or
  std::optional<double> preconsolidation_ratio;  ///< R_0 over the mean effective stress after initial.equilibrium [-]
  double smallest_pressure = 1e3;                ///< K = (1+e) max(p', this)/κ [Pa]
};

/// What roots do to the soil, per per cent of content.
struct RootedSoil {
  double content = 0;                                                ///< m_r^ini where no [[roots]] says otherwise [%]
  double hardening = 0;                                              ///< R_p [1/%]
  double strength = 0;                                               ///< R_a [1/%]
  std::optional<double> activation;                                  ///< R_p m_r of (4.10) as one number [-]
  double breaking_strain = std::numeric_limits<double>::infinity();  ///< ε_r^peak [-]
  double breaking_range = 0.1;                                       ///< over which they break [-]
  double residual_share = 0;                                         ///< [-]
  double cohesion = 0;  ///< c_r where no [[roots]] says otherwise, rooted_mohr_coulomb [Pa]
};

/// A compiled Abaqus UMAT.
struct ExternalModel {
  std::string library;       ///< shared library, as given
  std::string library_file;  ///< the same as it is found from here
  std::string material;      ///< name of the material, for CMNAME
  std::string symbol = "umat_";
  std::vector<double> constants;       ///< PROPS
  int states = 0;                      ///< NSTATV
  std::vector<double> initial_states;  ///< zero where not given
  double constrained_modulus = 0;      ///< for the time step [Pa]
};

struct Material {
  MaterialModel model = MaterialModel::linear_elastic;
  double grain_density = 0;                ///< ρ_s [kg/m³]
  double porosity = 0;                     ///< n [-]
  std::optional<double> given_void_ratio;  ///< e_0 where the case gives it; the porosity follows from it [-]
  double young_modulus = 0;                ///< E [Pa]
  double poisson_ratio = 0;                ///< ν [-]
  double cohesion = 0;                     ///< c [Pa], Mohr–Coulomb
  double friction_angle = 0;               ///< φ [rad], Mohr–Coulomb
  double dilatancy_angle = 0;              ///< ψ [rad], Mohr–Coulomb
  double tensile_strength = 0;             ///< σ_t [Pa], Mohr–Coulomb; at most the apex c/tanφ
  CamClaySoil cam_clay;
  RootedSoil roots;
  ExternalModel external;
  PoreWater water;  ///< by default none
  SliceSoil slices;

  /// e_0 = n/(1-n) [-].
  double void_ratio() const { return porosity / (1 - porosity); }
  /// Bulk density of the dry soil (1-n)ρ_s [kg/m³].
  double density() const { return (1 - porosity) * grain_density; }
  /// E_c of (2.84) of a soil with a Young's modulus [Pa].
  double constrained_modulus() const;
};

enum class Fix { full, normal, plane, friction, velocity };

struct Boundary {
  std::string on;  ///< a named side or line
  Fix fix = Fix::full;
  std::array<double, 3> normal{};    ///< plane: motion along it is suppressed (unit after reading)
  double friction = 0;               ///< friction: Coulomb's μ [-] of a wall that may be left but not crossed
  std::array<double, 3> velocity{};  ///< velocity: prescribed [m/s], times `factor`
  TimeTable factor{};
};

enum class Carrier { sides, points };

struct Traction {
  std::string on;                     ///< a named side or line
  Carrier carrier = Carrier::points;  ///< mesh sides (fixed in space) or the material points beside them (2.31-2.32)
  std::array<double, 3> traction{};   ///< [Pa], times `factor`
  TimeTable factor{};
};

struct Gravity {
  double acceleration = 9.81;                 ///< [m/s²]
  std::array<double, 3> direction{0, -1, 0};  ///< unit after reading
};

enum class InitialStress { none, k0 };

struct Initial {
  InitialStress stress = InitialStress::none;
  std::optional<double> k0;                               ///< K0 [-]; by default ν/(1-ν) of each material
  std::map<std::string, std::array<double, 3>> velocity;  ///< by region [m/s]
  InitialWater water;
  std::string equilibrium;    ///< stage at whose end preconsolidation_ratio is applied; empty: the first
  std::string result;         ///< folder of results whose end is the start, as given; empty: none
  std::string result_folder;  ///< the same as it is found from here
};

enum class Until { time, rest };
enum class Integration { points, mixed };
enum class Smoothing { none, strain, stable };
enum class Geometry { moving, frozen };
enum class Drag { implicit_at_nodes, explicit_at_nodes };
enum class DampedForce { net, without_drag };
enum class WaterMotion { flows, held };

/// How a stretch of time is calculated. Shared by stages and by the trials of the strength reduction.
struct StepSettings {
  double damping = 0;       ///< α of (2.89) [-]
  double mass_scaling = 1;  ///< β of (2.91) [-]
  Integration integration = Integration::mixed;
  Smoothing smoothing = Smoothing::none;
  Geometry geometry = Geometry::moving;
  bool objective_rate = true;  ///< rotate the stress with the soil (Hughes and Winget)
  double courant = 0.9;        ///< fraction of (2.84) [-]
  // Soil with pore water only.
  WaterMotion water = WaterMotion::flows;  ///< held: pore pressures stay as they are (drained), frozen geometry only
  Drag drag = Drag::implicit_at_nodes;
  double water_damping = 0;                     ///< α of the water (2.89) [-]
  DampedForce damped_force = DampedForce::net;  ///< what damping takes its share of (docs/theory/14)
  bool pressure_smoothing = false;              ///< (2.96-2.97)
  bool water_exchange = true;                   ///< against pressures that no node feels (T14.9)
  double conductivity_factor = 1;               ///< multiplies every conductivity [-]
};

struct RestCriterion {
  double force_ratio = 1e-3;   ///< ‖F_ext+G-F_int‖/‖F_ext+G‖ [-]
  double speed_ratio = 1e-4;   ///< largest nodal speed over √(gH) [-], H: height of the soil
  double energy_ratio = 1e-2;  ///< kinetic energy over external work [-]
  double hold = 0.5;           ///< how long all must hold [s]
};

struct Stage {
  std::string name;
  double duration = 0;  ///< [s]; with until = rest the longest time allowed
  Until until = Until::time;
  StepSettings step;
  double gravity_ramp = 0;         ///< gravity grows linearly from its last value over this time [s]
  std::optional<double> cohesion;  ///< overrides the cohesion of every Mohr–Coulomb material in this stage [Pa]
  std::optional<double> strength_factor;  ///< divides c and tanφ, (3.14-3.15), in this stage [-]
  bool reset_displacement = false;        ///< count displacements from the start of this stage
};

enum class AnalysisKind { run, strength_reduction };
using talus::Method;

/// The displacement–SRF curve on moving geometry and the constructions on it (chapter 3 of the source).
struct Curve {
  bool enabled = true;
  double from = 1.0, to = 1.75, step = 0.05;  ///< strength reduction factors [-]
  bool refine = true;                         ///< halve the intervals where the curve bends
  double refine_step = 0.01;                  ///< smallest interval [-]
  double window = 5;                          ///< observation time of a trial [s]
  StepSettings step_settings{.damping = 0.05, .courant = 0.98};
  std::vector<double> initial_branch;  ///< [lo, hi] SRF of the first line; empty: chosen from the data
  std::vector<double> final_branch;    ///< [lo, hi] SRF of the second line; empty: chosen from the data
  double displacement_ratio = 0.03;    ///< u/H that counts as failure in the second criterion [-]
  std::vector<double> runout;          ///< factors whose trials go on until rest [-]
  double runout_time = 60;             ///< longest time of such a trial [s]
};

/// Talus's factor of safety: rest or run-away at frozen geometry (strength-reduction theory page).
struct FrozenFactor {
  bool enabled = true;
  double from = 1.0, to = 2.0;  ///< bracket to start from [-]; widened when it does not hold the factor
  double resolution = 0.01;     ///< width of the final bracket [-]
  int meshes = 2;               ///< 1: one mesh of the case's size; 2: and one of half its size, extrapolated linearly
  mesh::Algorithm algorithm = mesh::Algorithm::meshadapt;  ///< of both meshes
  double window = 60;                ///< a trial without decision by then is reported as undecided [s]
  double failed_displacement = 0.1;  ///< u/H that decides "failed" [-]
  StepSettings step_settings{
      .damping = 0.2, .smoothing = Smoothing::stable, .geometry = Geometry::frozen, .water = WaterMotion::held};
  RestCriterion rest;
};

struct StrengthReduction {
  Curve curve;
  FrozenFactor frozen;
};

struct Monitor {
  std::string name;
  std::array<double, 3> at{};  ///< the nearest material point at the start is followed [m]
};

/// A line through the soil along which the fields of the stored frames are taken.
struct Section {
  std::string name;
  std::array<double, 3> from{}, to{};  ///< [m]
  std::optional<double> width;         ///< of the band around the line whose points count [m]; not given: element size
};

struct Output {
  double frame_interval = 0;        ///< simulated time between stored frames [s]; 0: only at the end of stages
  double history_interval = 0;      ///< simulated time between history rows [s]; 0: 200 rows a stage
  double checkpoint_interval = 60;  ///< wall time between checkpoints [s]
  bool cells = false;               ///< store element fields as well
  bool nodes = false;               ///< store nodal fields as well
  std::string count_from;           ///< stage at whose start the clock of onset, sections and pictures is zero
  double onset_ratio = 0.01;        ///< displacement over the relief of the ground that counts as movement [-]; or
  std::optional<double> onset_displacement;  ///< as a length [m]
  std::vector<double> shown_times;           ///< of sections and pictures in the report [s]; empty: evenly spread
  std::vector<Monitor> monitors;
  std::vector<Section> sections;
  std::string length_unit = "m", displacement_unit = "mm", stress_unit = "kPa";
};

struct Vary {
  std::string key;                  ///< dotted path of the key, as for --set
  std::vector<std::string> values;  ///< TOML texts of the values
  std::vector<std::string> names;   ///< of the values for people, as TOML texts; empty: "key = value"
};

enum class StudyMode { one_at_a_time, grid, together, sample };

struct Study {
  StudyMode mode = StudyMode::one_at_a_time;
  std::vector<Vary> vary;
  std::vector<double> factors;     ///< strength reduction factors whose displacement the table lists [-]
  std::string base_name = "base";  ///< of the case as the file has it
  std::string reference = "base";  ///< the variant that displacements of monitors are divided by
  std::string extrapolate;         ///< key, such as mesh.size, to whose zero the factors are extrapolated; empty: none
  Sampling sampling;               ///< mode = sample
};

/// What the title block of a report shows besides the title.
struct Project {
  std::string name, client, author, checked_by, revision, notes;
};

/// A published or measured value that a result is held against.
struct Compare {
  std::string name;  ///< of the result, see result_names.hpp
  Amount value;
  Amount tolerance;  ///< in per cent of the value, or in its unit
  std::string source;
};

struct Case {
  std::string title;
  Project project;
  mesh::Plan mesh;
  int points_per_element = 3;
  std::map<std::string, Material> materials;
  std::map<std::string, std::string> regions;  ///< region → material
  std::vector<Boundary> boundaries;
  std::vector<Traction> tractions;
  std::vector<Hydraulic> hydraulics;
  Water water;
  std::vector<Roots> roots;
  Gravity gravity;
  Initial initial;
  std::vector<Stage> stages;
  RestCriterion rest;
  AnalysisKind analysis = AnalysisKind::run;
  std::vector<Method> methods{Method::mpm};
  LimitEquilibrium lem;
  FiniteElements fem;
  std::vector<Surcharge> surcharges;
  Earthquake earthquake;
  PartialFactors partial_factors;
  StrengthReduction strength_reduction;
  Output output;
  std::vector<Compare> compare;
  std::vector<PointTest> tests;
  std::vector<Material> test_soils;  ///< of each test: its material with what the test sets
  Study study;
  std::optional<Calibration> calibration;
};

/// Whether `method` is one of those that answer.
bool uses(const Case& data, Method method);

}  // namespace talus::input
