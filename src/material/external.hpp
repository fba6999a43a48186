// SPDX-License-Identifier: MIT
#pragma once
// A compiled Abaqus UMAT as a constitutive model. One call per point and step: slow, and the same for every lane type.

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "material/linear_elastic.hpp"

namespace talus::material {

// The calls of a compiled UMAT: its arguments, between pages of memory that it cannot touch, and what it answers.

/// What a UMAT is asked. Components are xx yy zz xy (yz zx), four or six; stresses [Pa].
struct UmatQuestion {
  std::span<const double> stress, strain, increment;
  std::span<const double> states;
  double saturation = 1, time = 0, dt = 0;
  int point = -1;
};

/// What it answers, as asked.
struct UmatAnswer {
  std::string trouble;  ///< why the rest holds nothing: "it crashed (Segmentation fault) …"; empty when it returned
  std::array<double, 6> stress{};
  std::span<const double> states;  ///< valid until the next question
  double step_ratio = 1;           ///< PNEWDT
  double dissipation = 0;          ///< what it added to SPD
};

class Umat {
 public:
  /// `function` is the subroutine; `name` is what messages call it, `material` its CMNAME.
  Umat(void* function, std::string name, const std::string& material, const std::vector<double>& constants,
       std::size_t states);
  ~Umat();
  Umat(const Umat&) = delete;
  Umat& operator=(const Umat&) = delete;

  /// One call at a time in the process: a UMAT may keep data between calls and share it, also between libraries. After
  /// a call that never returned all answers are that.
  UmatAnswer ask(const UmatQuestion& question);

 private:
  struct Arguments;
  std::unique_ptr<Arguments> arguments_;
  std::string name_;
  bool is_lost_ = false;
};

struct ExternalParameters {
  std::string library;                 ///< path of the shared library, as given
  std::string symbol = "umat_";        ///< name of the subroutine in it
  std::string material;                ///< CMNAME
  std::vector<double> constants;       ///< PROPS
  int states = 0;                      ///< NSTATV, at most External::most_states
  std::vector<double> initial_states;  ///< zero where not given
  double constrained_modulus = 0;      ///< for the time step [Pa]
  std::string library_file;            ///< the library as it is found from here; empty: as given

  const std::string& find_library() const { return library_file.empty() ? library : library_file; }
};
template <class Visitor>
void describe(Visitor& v, ExternalParameters& in, const Users& users) {
  v.key("library", in.library, users.need(plain()).example(R"("model.so")"),
        "The shared library that holds the UMAT; its path is relative to the case file.");
  v.key("symbol", in.symbol, users.allow(plain()),
        "Name of the subroutine in it; Fortran compilers call UMAT \"umat_\".");
  v.key("constants", in.constants, users.allow(plain()).example("[45e6, 0.3]"),
        "PROPS, the constants that the UMAT expects, in SI units (stress in Pa).");
  v.key("states", in.states, users.allow(plain().at_least(0).at_most(20)),
        "NSTATV, how many state variables each point has.");
  v.key("initial_states", in.initial_states, users.allow(plain()).example("[125e3]"),
        "STATEV at the start; zero where not given.");
  v.key("constrained_modulus", in.constrained_modulus, users.need(quantity("kPa").above(0)).example("60000"),
        "The largest stiffness in one-dimensional compression that the UMAT can have; it sets the time step.");
}

/// A call of a UMAT that led to nothing.
struct LawFailure {
  int point = -1;      ///< -1: not known
  std::string model;   ///< "the external model 'clay' (umat_ in libclay.so)"
  std::string answer;  ///< what was answered to which inputs

  /// One sentence; `place` follows the number of the point, e.g. " at (3.2, 1.5) m".
  std::string describe(const std::string& place) const;
};

class ExternalLibrary;  // the opened library and the first failure

/// State variables: 0 deviatoric plastic strain, which a UMAT does not tell: 0; 1… STATEV; behind them STRAN.
class External {
 public:
  static constexpr Traits traits{
      .word = "external",
      .meaning = "a compiled UMAT of Abaqus",
      .title = "external",
      .strength = Strength::hidden,
      .stores_always = true,
      .is_opaque = true,
      .paragraphs = {"external_model"},
      .assumption =
          "{}: a compiled UMAT gives the stress, and Talus cannot check it. It receives strain increments, not "
          "deformation gradients; its state variables are carried with the "
          "soil, and not rotated."};
  static constexpr int most_states = 20;
  static constexpr int first_strain = 1 + most_states;
  static constexpr int state_size = first_strain + 6;
  static constexpr bool is_plastic = true;

  /// Opens the library. Throws Error (wrong_input) with the reason when it or the symbol cannot be found.
  explicit External(ExternalParameters parameters);

  const ExternalParameters& parameters() const { return *parameters_; }
  double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return parameters_->constrained_modulus;
  }
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const {
    return LinearElastic::from_constrained_modulus(constrained_modulus(), 0.3);
  }
  template <int NS>
  double elastic_energy(const double*, const double* = nullptr) const {
    return 0;  // a UMAT's is not known
  }

  using Input = Needs<ExternalParameters>;
  /// Throws Error (wrong_input) when the strength is to be reduced: only the library knows it.
  static External make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static std::string describe_model(const Input& in);
  static double find_oedometric_modulus(const Input& in) { return in.get<ExternalParameters>().constrained_modulus; }
  /// Names the material to the UMAT, and finds its library from the folder of the case.
  template <class FindFile>
  static void complete(const Input::Changeable& in, const std::string& name, const FindFile& find_file) {
    auto& parameters = in.get<ExternalParameters>();
    parameters.material = name;
    if (!parameters.library.empty()) parameters.library_file = find_file(parameters.library);
  }

  /// Writes state_size numbers; initial_states that are not given are 0.
  void set_initial_state(double* state) const;
  void set_initial_state(const Input&, const StateStart&, double* state) const { set_initial_state(state); }

  /// A point whose UMAT fails (no number, or PNEWDT < 1) keeps its stress and state; the failure with the lowest point
  /// number is kept for throw_failure(). States are stored always, so `any_plastic` is true. The dissipation is what
  /// the UMAT adds to SPD.
  template <int NS, class T>
  Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                     const Surroundings<T>& around = {}) const {
    Response<T> response{true, T(0.0), T(0.0)};
    if constexpr (std::is_same_v<T, double>) {
      const Call call{around.saturation, around.points ? around.points[0] : -1, around.time, around.dt};
      if (active) response.dissipation = update_point(NS, sigma, d_epsilon, state, call);
    } else {
      for (int l = 0; l < LaneTraits<T>::width; ++l) {
        if (!active[l]) continue;
        double s[NS], d[NS], q[state_size];
        for (int i = 0; i < NS; ++i) s[i] = sigma[i][l];
        for (int i = 0; i < NS; ++i) d[i] = d_epsilon[i][l];
        for (int i = 0; i < state_size; ++i) q[i] = state[i][l];
        const Call call{around.saturation[l], around.points ? around.points[l] : -1, around.time, around.dt};
        response.dissipation.value[l] = update_point(NS, s, d, q, call);
        for (int i = 0; i < NS; ++i) sigma[i].value[l] = s[i];
        for (int i = 0; i < state_size; ++i) state[i].value[l] = q[i];
      }
    }
    return response;
  }

  /// What results show: STATEV, as state_1, state_2 …
  std::vector<StateField> fields() const;
  void show(const double* state, double /*saturation*/, double* values) const {
    std::copy_n(state + 1, parameters_->states, values);
  }

  /// The failure with the lowest point number since the last look, if there was one.
  std::optional<LawFailure> take_failure() const;
  /// Throws Error (unstable) with it. Called between steps.
  void throw_failure() const;

 private:
  /// What a UMAT is told beside stress and strain.
  struct Call {
    double saturation;
    int point;
    double time, dt;  ///< [s]
  };
  /// One call of the UMAT; the plastic work that it names [J/m³].
  double update_point(int components, double* sigma, const double* d_epsilon, double* state, const Call& call) const;

  std::shared_ptr<const ExternalParameters> parameters_;
  std::shared_ptr<ExternalLibrary> library_;
};

}  // namespace talus::material
