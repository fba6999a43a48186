// SPDX-License-Identifier: MIT
#include "material/external.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <mutex>
#include <span>
#include <utility>

#include "base/error.hpp"

namespace talus::material {
namespace {

/// UMAT as gfortran and ifort call it: everything by address, and the length of CMNAME behind all.
using Umat = void(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
                  double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time,
                  double* dtime, double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi,
                  int* nshr, int* ntens, int* nstatv, double* props, int* nprops, double* coords, double* drot,
                  double* pnewdt, double* celent, double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer,
                  int* kspt, int* kstep, int* kinc, std::size_t cmname_length);

constexpr std::size_t name_length = 80;
/// Numbers behind STATEV that a UMAT must not touch, and what stands in them.
constexpr std::size_t guards = 16;
constexpr double guard_value = -1.2345678912345e300;
/// Abaqus counts 11 22 33 12 13 23, Talus xx yy zz xy yz zx.
constexpr std::array<std::size_t, 6> order{0, 1, 2, 3, 5, 4};

/// UMATs may keep data between calls and share it, also between libraries: never two at once.
std::mutex& get_umat_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::string list(std::span<const double> values) {
  return fmt::format("({:.9g})", fmt::join(values, ", "));
}
bool is_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

std::string of_material(const ExternalParameters& p) {
  return p.material.empty() ? "" : fmt::format(" of material '{}'", p.material);
}

/// dlerror() without the path that it begins with.
std::string find_reason(const std::string& path) {
  const char* text = dlerror();
  std::string reason = text ? text : "no reason is known";
  if (reason.rfind(path + ": ", 0) == 0) reason.erase(0, path.size() + 2);
  return reason;
}

}  // namespace

std::string LawFailure::describe(const std::string& place) const {
  const std::string where = point < 0 ? "a point" : fmt::format("point {}", point);
  return fmt::format("{} failed in {}{}: {}", model, where, place, answer);
}

/// The library stays open until the program ends: a Fortran library that has opened files or threads does not survive
/// being closed.
class ExternalLibrary {
 public:
  explicit ExternalLibrary(const ExternalParameters& p) {
    const auto fail = [&](const std::string& what) {
      throw Error(ExitCode::wrong_input, fmt::format("the external model{} {}", of_material(p), what));
    };
    if (p.states < 0 || p.states > External::most_states)
      fail(fmt::format("has {} state variables; 0 to {} are possible", p.states, External::most_states));
    if (p.initial_states.size() > static_cast<std::size_t>(p.states))
      fail(fmt::format("has {} initial values for {} state variables", p.initial_states.size(), p.states));
    // Absolute: without a slash dlopen() would look through the system's folders instead.
    const std::string path = std::filesystem::absolute(p.find_library()).lexically_normal().string();
    if (!std::filesystem::is_regular_file(path))
      fail(fmt::format("needs the shared library '{}', which does not exist", path));
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle)
      fail(fmt::format("needs the shared library '{}', which cannot be opened: {}", path, find_reason(path)));
    umat_ = reinterpret_cast<Umat*>(dlsym(handle, p.symbol.c_str()));
    if (!umat_) {
      fail(fmt::format(
          "needs the subroutine '{}', which is not in '{}'; gfortran and ifort name SUBROUTINE UMAT 'umat_'", p.symbol,
          path));
    }
    name_ = fmt::format("the external model{} ({} in {})", of_material(p), p.symbol, path);
    std::copy_n(p.material.begin(), std::min(p.material.size(), name_length), material_.begin());
  }

  Umat* umat() const { return umat_; }
  const std::array<char, name_length>& material() const { return material_; }

  /// Called with get_umat_mutex() held, as take() does for itself.
  void keep(int point, const std::string& answer) {
    if (failure_ && failure_->point <= point) return;
    failure_ = {point, name_, answer};
  }
  std::optional<LawFailure> take() {
    const std::lock_guard lock(get_umat_mutex());
    return std::exchange(failure_, std::nullopt);
  }

 private:
  Umat* umat_ = nullptr;
  std::string name_;
  std::array<char, name_length> material_ = [] {
    std::array<char, name_length> blank;
    blank.fill(' ');
    return blank;
  }();
  std::optional<LawFailure> failure_;
};

External External::make(const Input& in, const StrengthChange& change) {
  const ExternalParameters& p = in.get<ExternalParameters>();
  if (change.factor != 1)
    throw Error(ExitCode::wrong_input,
                fmt::format("the strength of the external model '{}' cannot be divided by {:g}: only the library "
                            "knows it; give its reduced constants instead",
                            p.library, change.factor));
  return External(p);
}

void External::check(const Input& in, const SoilFindings& findings) {
  const ExternalParameters& p = in.get<ExternalParameters>();
  if (findings.is_sound("library") && !std::filesystem::is_regular_file(p.library_file))
    findings.add("library",
                 fmt::format("there is no library '{}'; its path is relative to the case file", p.library_file));
  if (findings.is_sound("states") && findings.is_sound("initial_states") &&
      p.initial_states.size() > static_cast<std::size_t>(p.states))
    findings.add("initial_states",
                 fmt::format("'initial_states' has {} numbers, but 'states' is {}", p.initial_states.size(), p.states));
}

Properties External::list_properties(const Input& in) {
  const ExternalParameters& p = in.get<ExternalParameters>();
  Properties list;
  for (std::size_t i = 0; i < p.constants.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    list.push_back({"constants_" + number,
                    "constant " + number + " of the UMAT",
                    "PROPS(" + number + ")",
                    ShownAs::si,
                    p.constants[i],
                    {}});
  }
  list.push_back({"constrained_modulus",
                  "largest constrained modulus, for the time step",
                  "Ec",
                  ShownAs::stiffness,
                  p.constrained_modulus,
                  {}});
  return list;
}

std::string External::tell_model(const Input& in) {
  const ExternalParameters& p = in.get<ExternalParameters>();
  return fmt::format("external: UMAT '{}' of {}", p.symbol, p.library);
}

External::External(ExternalParameters parameters)
    : parameters_(std::make_shared<const ExternalParameters>(std::move(parameters))),
      library_(std::make_shared<ExternalLibrary>(*parameters_)) {}

void External::set_initial_state(double* state) const {
  std::fill(state, state + state_size, 0.0);
  std::copy(parameters_->initial_states.begin(), parameters_->initial_states.end(), state + 1);
}

double External::update_point(int components, double* sigma, const double* d_epsilon, double* state,
                              const Call& call) const {
  const std::size_t n = static_cast<std::size_t>(components);
  const std::size_t states = static_cast<std::size_t>(parameters_->states);
  // Element size and place are not known here. A UMAT that needs them shall fail, not compute with a number made up.
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  std::array<double, 6> stress{}, stran{}, dstran{}, ddsddt{}, drplde{};
  std::array<double, 36> ddsdde{};
  std::array<double, most_states + guards> statev;
  for (std::size_t i = 0; i < n; ++i) {
    stress[i] = sigma[order[i]];
    stran[i] = state[first_strain + order[i]];
    dstran[i] = d_epsilon[order[i]];
  }
  std::copy_n(state + 1, states, statev.begin());
  std::fill(statev.begin() + parameters_->states, statev.end(), guard_value);
  double sse = 0, spd = 0, scd = 0, rpl = 0, drpldt = 0, dtime = call.dt, temp = 0, dtemp = 0, pnewdt = 1;
  std::array<double, 2> time{call.time, call.time};
  std::array<double, 1> predef{call.saturation}, dpred{};
  std::array<double, 3> coords{unknown, unknown, unknown};
  double celent = unknown;
  std::array<double, 9> drot{1, 0, 0, 0, 1, 0, 0, 0, 1}, dfgrd0 = drot, dfgrd1 = drot;
  int ndi = 3, nshr = components - 3, ntens = components, nstatv = parameters_->states;
  int nprops = static_cast<int>(parameters_->constants.size());
  int noel = call.point + 1, npt = 1, layer = 1, kspt = 1, kinc = call.time > 0 ? 2 : 1;
  std::array<int, 4> kstep{1, 0, 0, 0};
  std::vector<double> props = parameters_->constants;
  props.push_back(0);  // never without address
  std::array<char, name_length> name = library_->material();

  const std::lock_guard lock(get_umat_mutex());
  library_->umat()(stress.data(), statev.data(), ddsdde.data(), &sse, &spd, &scd, &rpl, ddsddt.data(), drplde.data(),
                   &drpldt, stran.data(), dstran.data(), time.data(), &dtime, &temp, &dtemp, predef.data(),
                   dpred.data(), name.data(), &ndi, &nshr, &ntens, &nstatv, props.data(), &nprops, coords.data(),
                   drot.data(), &pnewdt, &celent, dfgrd0.data(), dfgrd1.data(), &noel, &npt, &layer, &kspt,
                   kstep.data(), &kinc, name_length);

  std::array<double, 6> result{}, old_stress{}, increment{};
  for (std::size_t i = 0; i < n; ++i) {
    result[order[i]] = stress[i];
    old_stress[i] = sigma[i];
    increment[i] = d_epsilon[i];
  }
  const std::span answered(statev.data(), states);
  std::string fault;
  if (!is_finite({result.data(), n}))
    fault = "a stress that is no number";
  else if (!is_finite(answered))
    fault = "state variables that are no numbers";
  else if (!(pnewdt >= 1))
    fault = fmt::format("that the step is too long (PNEWDT = {:g})", pnewdt);
  else if (std::any_of(statev.begin() + parameters_->states, statev.end(), [](double x) { return x != guard_value; }))
    fault = fmt::format("more state variables than the {} it has (NSTATV)", states);
  if (!fault.empty()) {
    library_->keep(call.point,
                   fmt::format("it answered {}; inputs: stress {} Pa ({}), strain increment {}, state variables {}, "
                               "saturation {:g}, t = {:g} s, step {:g} s; answer: stress {} Pa, state variables {}, "
                               "PNEWDT = {:g}",
                               fault, list({old_stress.data(), n}), n == 4 ? "xx yy zz xy" : "xx yy zz xy yz zx",
                               list({increment.data(), n}), list({state + 1, states}), call.saturation, call.time,
                               call.dt, list({result.data(), n}), list(answered), pnewdt));
    return 0;
  }
  std::copy_n(result.begin(), n, sigma);
  std::copy_n(statev.begin(), states, state + 1);
  for (std::size_t i = 0; i < n; ++i) state[first_strain + i] += d_epsilon[i];
  return std::isfinite(spd) ? spd : 0;
}

std::vector<StateField> External::fields() const {
  static constexpr std::array<const char*, most_states> names{
      "state_1",  "state_2",  "state_3",  "state_4",  "state_5",  "state_6",  "state_7",
      "state_8",  "state_9",  "state_10", "state_11", "state_12", "state_13", "state_14",
      "state_15", "state_16", "state_17", "state_18", "state_19", "state_20"};
  std::vector<StateField> list;
  for (std::size_t i = 0; i < static_cast<std::size_t>(parameters_->states); ++i) list.push_back({names[i], "-"});
  return list;
}

std::optional<LawFailure> External::take_failure() const {
  return library_->take();
}

void External::throw_failure() const {
  if (const auto failure = take_failure()) throw Error(ExitCode::unstable, failure->describe(""));
}

}  // namespace talus::material
