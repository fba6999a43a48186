#pragma once
// A compiled Abaqus UMAT as a constitutive model. One call per point and step: slow, and the same for every lane type.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "material/linear_elastic.hpp"

namespace talus::material {

struct ExternalParameters {
  std::string library;            ///< path of the shared library
  std::string symbol = "umat_";   ///< name of the subroutine in it
  std::string material;           ///< CMNAME
  std::vector<double> constants;  ///< PROPS
  int states = 0;                 ///< NSTATV, at most External::most_states
  std::vector<double> initial_states;
  double constrained_modulus = 0;  ///< for the time step [Pa]
};

/// A call of a UMAT that led to nothing.
struct ExternalFailure {
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
  static constexpr int most_states = 20;
  static constexpr int first_strain = 1 + most_states;
  static constexpr int state_size = first_strain + 6;
  static constexpr bool is_plastic = true;

  /// Opens the library. Throws Error (wrong_input) with the reason when it or the symbol cannot be found.
  explicit External(ExternalParameters parameters);

  const ExternalParameters& parameters() const { return *parameters_; }
  double constrained_modulus() const { return parameters_->constrained_modulus; }
  template <int NS>
  double elastic_energy(const double*) const {
    return 0;  // a UMAT's is not known
  }

  /// Writes state_size numbers; initial_states that are not given are 0.
  void set_initial_state(double* state) const;

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

  /// The failure with the lowest point number since the last look, if there was one.
  std::optional<ExternalFailure> take_failure() const;
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
