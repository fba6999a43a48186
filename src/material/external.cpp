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
#include "base/foreign_code.hpp"
#include "base/user_file.hpp"

namespace talus::material {

namespace {

/// Signature of UMAT as gfortran and ifort compile it: all arguments by address, the length of CMNAME last.
using Function = void(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd,
                      double* rpl, double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran,
                      double* time, double* dtime, double* temp, double* dtemp, double* predef, double* dpred,
                      char* cmname, int* ndi, int* nshr, int* ntens, int* nstatv, double* props, int* nprops,
                      double* coords, double* drot, double* pnewdt, double* celent, double* dfgrd0, double* dfgrd1,
                      int* noel, int* npt, int* layer, int* kspt, int* kstep, int* kinc, std::size_t cmname_length);

constexpr std::size_t name_length = 80;
/// Component order: Abaqus 11 22 33 12 13 23, Talus xx yy zz xy yz zx.
constexpr std::array<std::size_t, 6> order{0, 1, 2, 3, 5, 4};

}  // namespace

struct Umat::Arguments {
  Function* function = nullptr;
  const std::vector<double> constants;
  GuardedArray stress{6}, statev, ddsdde{36}, ddsddt{6}, drplde{6}, stran{6}, dstran{6}, time{2}, predef{1}, dpred{1},
      props, coords{3}, drot{9}, dfgrd0{9}, dfgrd1{9}, cmname{name_length / sizeof(double)};
  double sse = 0, spd = 0, scd = 0, rpl = 0, drpldt = 0, dtime = 0, temp = 0, dtemp = 0, pnewdt = 1, celent = 0;
  int ndi = 3, nshr = 1, ntens = 4, nstatv = 0, nprops = 0, noel = 0, npt = 1, layer = 1, kspt = 1, kinc = 1;
  std::array<int, 4> kstep{1, 0, 0, 0};
  std::array<char, name_length> name;

  Arguments(void* umat, const std::string& material, const std::vector<double>& given, std::size_t states)
      : function(reinterpret_cast<Function*>(umat)),
        constants(given),
        statev(std::max<std::size_t>(states, 1)),  // a UMAT without state variables still gets a valid address
        props(std::max<std::size_t>(given.size(), 1)) {
    name.fill(' ');
    std::copy_n(material.begin(), std::min(material.size(), name_length), name.begin());
    nstatv = static_cast<int>(states);
    nprops = static_cast<int>(given.size());
  }

  /// Sets every argument before each call, because a UMAT may overwrite any of them.
  void set(const UmatQuestion& q) {
    // Element size and coordinates are not available here. NaN makes a UMAT that uses them fail visibly.
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const std::size_t n = q.stress.size();
    for (const GuardedArray* array : {&stress, &ddsdde, &ddsddt, &drplde, &stran, &dstran, &dpred})
      std::fill(array->begin(), array->end(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      stress[i] = q.stress[order[i]];
      stran[i] = q.strain[order[i]];
      dstran[i] = q.increment[order[i]];
    }
    std::copy(q.states.begin(), q.states.end(), statev.begin());
    std::copy(constants.begin(), constants.end(), props.begin());
    std::copy(name.begin(), name.end(), reinterpret_cast<char*>(cmname.begin()));
    std::fill(coords.begin(), coords.end(), unknown);
    for (const GuardedArray* matrix : {&drot, &dfgrd0, &dfgrd1})
      for (std::size_t i = 0; i < 9; ++i) (*matrix)[i] = i % 4 == 0 ? 1 : 0;
    time[0] = time[1] = q.time;
    predef[0] = q.saturation;
    sse = spd = scd = rpl = drpldt = temp = dtemp = 0;
    dtime = q.dt;
    pnewdt = 1;
    celent = unknown;
    ndi = 3;
    nshr = static_cast<int>(n) - ndi;
    ntens = static_cast<int>(n);
    nstatv = static_cast<int>(q.states.size());
    nprops = static_cast<int>(constants.size());
    noel = q.point + 1;
    npt = layer = kspt = 1;
    kstep = {1, 0, 0, 0};
    kinc = q.time > 0 ? 2 : 1;
  }

  void call() {
    function(stress.begin(), statev.begin(), ddsdde.begin(), &sse, &spd, &scd, &rpl, ddsddt.begin(), drplde.begin(),
             &drpldt, stran.begin(), dstran.begin(), time.begin(), &dtime, &temp, &dtemp, predef.begin(), dpred.begin(),
             reinterpret_cast<char*>(cmname.begin()), &ndi, &nshr, &ntens, &nstatv, props.begin(), &nprops,
             coords.begin(), drot.begin(), &pnewdt, &celent, dfgrd0.begin(), dfgrd1.begin(), &noel, &npt, &layer, &kspt,
             kstep.data(), &kinc, name_length);
  }
};

Umat::Umat(void* function, std::string name, const std::string& material, const std::vector<double>& constants,
           std::size_t states)
    : arguments_(std::make_unique<Arguments>(function, material, constants, states)), name_(std::move(name)) {}
Umat::~Umat() = default;

UmatAnswer Umat::ask(const UmatQuestion& question) {
  Arguments& a = *arguments_;
  UmatAnswer answer;
  const char* lost = "it did not return within a minute";
  if (is_lost_) {
    answer.trouble = lost;
    return answer;
  }
  a.set(question);
  switch (call_foreign(
      name_, [](void* data) { static_cast<Arguments*>(data)->call(); }, &a)) {
    case ForeignEnd::crashed:
      answer.trouble =
          fmt::format("it crashed ({}), as a UMAT does that writes behind its arguments", get_crash_name());
      return answer;
    case ForeignEnd::never_returned:
      is_lost_ = true;
      answer.trouble = lost;
      return answer;
    case ForeignEnd::returned:
      break;
  }
  for (std::size_t i = 0; i < question.stress.size(); ++i) answer.stress[order[i]] = a.stress[i];
  answer.states = {a.statev.begin(), question.states.size()};
  answer.step_ratio = a.pnewdt;
  answer.dissipation = a.spd;
  return answer;
}

namespace {

/// Serialises all calls: UMATs may keep static data and share it, also between libraries.
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

/// Returns dlerror() without the leading path.
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

/// The library stays open until the program ends: a Fortran runtime that has opened files or threads does not survive
/// dlclose().
class ExternalLibrary {
 public:
  explicit ExternalLibrary(const ExternalParameters& p) {
    const auto fail = [&](const std::string& what) { fail_input("the external model{} {}", of_material(p), what); };
    if (p.states < 0 || p.states > External::most_states)
      fail(fmt::format("has {} state variables; 0 to {} are possible", p.states, External::most_states));
    if (p.initial_states.size() > static_cast<std::size_t>(p.states))
      fail(fmt::format("has {} initial values for {} state variables", p.initial_states.size(), p.states));
    // The path is absolute because dlopen() searches the system's folders for a name without a slash.
    const std::string path = std::filesystem::absolute(p.find_library()).lexically_normal().string();
    if (const auto fault = find_file_fault(path, largest_file::library))
      fail(fault->is_missing
               ? fmt::format("needs the shared library '{}', which does not exist", path)
               : fmt::format("needs the shared library '{}', which cannot be read: {}", path, fault->why));
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle)
      fail(fmt::format("needs the shared library '{}', which cannot be opened: {}", path, find_reason(path)));
    void* umat = dlsym(handle, p.symbol.c_str());
    if (!umat) {
      fail(fmt::format(
          "needs the subroutine '{}', which is not in '{}'; gfortran and ifort name SUBROUTINE UMAT 'umat_'", p.symbol,
          path));
    }
    name_ = fmt::format("the external model{} ({} in {})", of_material(p), p.symbol, path);
    umat_.emplace(umat, name_, p.material, p.constants, static_cast<std::size_t>(p.states));
  }

  /// Requires get_umat_mutex() to be held.
  UmatAnswer ask(const UmatQuestion& question) { return umat_->ask(question); }

  /// Requires get_umat_mutex() to be held; take() locks it itself.
  void keep(int point, const std::string& answer) {
    if (failure_ && failure_->point <= point) return;
    failure_ = {point, name_, answer};
  }
  std::optional<LawFailure> take() {
    const std::lock_guard lock(get_umat_mutex());
    return std::exchange(failure_, std::nullopt);
  }

 private:
  std::optional<Umat> umat_;
  std::string name_;
  std::optional<LawFailure> failure_;
};

External External::make(const Input& in, const StrengthChange& change) {
  const ExternalParameters& p = in.get<ExternalParameters>();
  if (change.factor != 1)
    fail_input(
        "the strength of the external model '{}' cannot be divided by {:g}: only the library knows it; give its "
        "reduced constants instead",
        p.library, change.factor);
  return External(p);
}

void External::check(const Input& in, const SoilFindings& findings) {
  const ExternalParameters& p = in.get<ExternalParameters>();
  const auto fault =
      findings.is_sound("library") ? find_file_fault(p.library_file, largest_file::library) : std::nullopt;
  if (fault)
    findings.add("library",
                 fault->is_missing
                     ? fmt::format("there is no library '{}'; its path is relative to the case file", p.library_file)
                     : fmt::format("the library '{}' cannot be read: {}", p.library_file, fault->why));
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

std::string External::describe_model(const Input& in) {
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
  const UmatQuestion question{
      {sigma, n}, {state + first_strain, n}, {d_epsilon, n}, {state + 1, states}, call.saturation, call.time, call.dt,
      call.point};
  const std::lock_guard lock(get_umat_mutex());
  const UmatAnswer answer = library_->ask(question);
  const std::span stress(answer.stress.data(), n);
  std::string fault = answer.trouble;
  if (!fault.empty()) {
    // The call did not return, so there is no answer to check.
  } else if (!is_finite(stress)) {
    fault = "it returned a stress that is NaN or infinite";
  } else if (!is_finite(answer.states)) {
    fault = "it answered state variables that are no numbers";
  } else if (!(answer.step_ratio >= 1)) {
    fault = fmt::format("it answered that the step is too long (PNEWDT = {:g})", answer.step_ratio);
  }
  if (!fault.empty()) {
    std::string said = fmt::format(
        "{}; inputs: stress {} Pa ({}), strain increment {}, state variables {}, saturation {:g}, t = {:g} s, step "
        "{:g} s",
        fault, list(question.stress), n == 4 ? "xx yy zz xy" : "xx yy zz xy yz zx", list(question.increment),
        list(question.states), call.saturation, call.time, call.dt);
    if (answer.trouble.empty())
      said += fmt::format("; answer: stress {} Pa, state variables {}, PNEWDT = {:g}", list(stress),
                          list(answer.states), answer.step_ratio);
    library_->keep(call.point, said);
    return 0;
  }
  std::copy_n(answer.stress.begin(), n, sigma);
  std::copy(answer.states.begin(), answer.states.end(), state + 1);
  for (std::size_t i = 0; i < n; ++i) state[first_strain + i] += d_epsilon[i];
  return std::isfinite(answer.dissipation) ? answer.dissipation : 0;
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
