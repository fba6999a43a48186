// SPDX-License-Identifier: MIT
#include "material/umat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/foreign_call.hpp"

namespace talus::material {
namespace {

/// UMAT as gfortran and ifort call it: everything by address, and the length of CMNAME behind all.
using Function = void(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd,
                      double* rpl, double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran,
                      double* time, double* dtime, double* temp, double* dtemp, double* predef, double* dpred,
                      char* cmname, int* ndi, int* nshr, int* ntens, int* nstatv, double* props, int* nprops,
                      double* coords, double* drot, double* pnewdt, double* celent, double* dfgrd0, double* dfgrd1,
                      int* noel, int* npt, int* layer, int* kspt, int* kstep, int* kinc, std::size_t cmname_length);

constexpr std::size_t name_length = 80;
/// Abaqus counts 11 22 33 12 13 23, Talus xx yy zz xy yz zx.
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
        statev(std::max<std::size_t>(states, 1)),  // never without address
        props(std::max<std::size_t>(given.size(), 1)) {
    name.fill(' ');
    std::copy_n(material.begin(), std::min(material.size(), name_length), name.begin());
    nstatv = static_cast<int>(states);
    nprops = static_cast<int>(given.size());
  }

  /// A UMAT may change all that it is given, so everything is set before each call.
  void set(const UmatQuestion& q) {
    // Element size and place are not known here. A UMAT that needs them shall fail, not compute with a number made up.
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

}  // namespace talus::material
