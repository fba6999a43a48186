// SPDX-License-Identifier: MIT
#pragma once
// A compiled Abaqus UMAT as a constitutive law. It is called once per point and step, which is slow, by the same code
// for every lane type.

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

// Calls of a compiled UMAT: its arguments, which lie between guard pages, and its results.

/// Arguments of a call. Components are xx yy zz xy (yz zx), four or six; stresses [Pa].
struct UmatQuestion {
  std::span<const double> stress, strain, increment;
  std::span<const double> states;
  double saturation = 1, time = 0, dt = 0;
  int point = -1;
};

/// Results of a call, in the component order of the arguments.
struct UmatAnswer {
  std::string trouble;  ///< why the other members are not valid: "it crashed (Segmentation fault) …"; empty when the
                        ///< UMAT returned
  std::array<double, 6> stress{};
  std::span<const double> states;  ///< valid until the next call
  double step_ratio = 1;           ///< PNEWDT
  double dissipation = 0;          ///< increase of SPD
};

class Umat {
 public:
  /// `function` is the subroutine, `name` its name in messages, `material` its CMNAME.
  Umat(void* function, std::string name, const std::string& material, const std::vector<double>& constants,
       std::size_t states);
  ~Umat();
  Umat(const Umat&) = delete;
  Umat& operator=(const Umat&) = delete;

  /// Calls the UMAT. Calls must be serialised in the process, because UMATs may keep static data and share it, also
  /// between libraries. After a call that never returned, every later answer reports that.
  UmatAnswer ask(const UmatQuestion& question);

 private:
  struct Arguments;
  std::unique_ptr<Arguments> arguments_;
  std::string name_;
  bool is_lost_ = false;
};

class ExternalLibrary;  // owns the opened library and the first failure

/// State variables: 0 deviatoric plastic strain, always 0 because a UMAT does not return it; 1… STATEV; then STRAN.
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
          "deformation gradients; its state variables are carried with the soil, and not rotated."};
  static constexpr int most_states = 20;
  static constexpr int first_strain = 1 + most_states;
  static constexpr int state_size = first_strain + 6;
  static constexpr bool is_plastic = true;

  /// Opens the library. Throws Error (wrong_input) with the reason if the library or the symbol cannot be found.
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
    return 0;  // the elastic energy of a UMAT is unknown
  }

  using Input = Needs<ExternalParameters>;
  /// Throws Error (wrong_input) if the strength is to be reduced, since it is defined inside the library.
  static External make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static std::string describe_model(const Input& in);
  static double find_oedometric_modulus(const Input& in) { return in.get<ExternalParameters>().constrained_modulus; }
  /// Sets CMNAME to the name of the material and resolves the path of the library relative to the folder of the case.
  static void complete(const Input::Changeable& in, const std::string& name, const auto& find_file) {
    auto& parameters = in.get<ExternalParameters>();
    parameters.material = name;
    if (!parameters.library.empty()) parameters.library_file = find_file(parameters.library);
  }

  /// Writes state_size values; initial_states that are not given are 0.
  void set_initial_state(double* state) const;
  void set_initial_state(const Input&, const StateStart&, double* state) const { set_initial_state(state); }

  /// Updates stress and state. A point whose UMAT fails (NaN or PNEWDT < 1) keeps its stress and state; the failure
  /// with the lowest point number is kept for throw_failure(). `any_plastic` is true because states are always stored.
  /// The dissipation is the increase of SPD.
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

  /// State fields of the results: STATEV as state_1, state_2 …
  std::vector<StateField> fields() const;
  void show(const double* state, double /*saturation*/, double* values) const {
    std::copy_n(state + 1, parameters_->states, values);
  }

  /// Returns and clears the failure with the lowest point number since the last call, if there was one.
  std::optional<LawFailure> take_failure() const;
  /// Throws Error (unstable) with that failure. It is called between steps.
  void throw_failure() const;

 private:
  /// Arguments of a UMAT other than stress and strain.
  struct Call {
    double saturation;
    int point;
    double time, dt;  ///< [s]
  };
  /// Calls the UMAT once and returns its plastic work [J/m³].
  double update_point(int components, double* sigma, const double* d_epsilon, double* state, const Call& call) const;

  std::shared_ptr<const ExternalParameters> parameters_;
  std::shared_ptr<ExternalLibrary> library_;
};

}  // namespace talus::material
