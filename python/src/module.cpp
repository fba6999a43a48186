// SPDX-License-Identifier: MIT
// The extension module talus._core, the interface of the Python package to the library. It is not public.

#include <hdf5.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/lane.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "bind.hpp"
#include "results/about.hpp"

namespace talus::python {

py::object to_python(const nlohmann::json& value) {
  return py::module_::import("json").attr("loads")(value.dump());
}

}  // namespace talus::python

PYBIND11_MODULE(_core, module) {
  using namespace talus;
  // Opens HDF5 now. Otherwise the library would disable HDF5's clean-up at exit, on which h5py may rely; after the
  // opening that request has no effect.
  H5open();
  module.attr("version") = version;
  module.attr("commit") = commit;
  module.attr("level") = instruction_level;
  module.attr("result_format") = results::result_format;
  module.def("default_threads", &default_threads);
  module.def("get_si_factor", &units::get_si_factor);
  python::bind_errors(module);
  python::bind_case(module);
  python::bind_run(module);
  python::bind_results(module);
}
