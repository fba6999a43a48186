// SPDX-License-Identifier: MIT
// The extension module talus._core: what the Python layer needs of the library, and nothing that users call.

#include <hdf5.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/lane.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "bind.hpp"

namespace talus::python {

py::object to_python(const nlohmann::json& value) {
  return py::module_::import("json").attr("loads")(value.dump());
}

}  // namespace talus::python

PYBIND11_MODULE(_core, module) {
  using namespace talus;
  // The program asks HDF5 not to tidy up at its exit. Here h5py may rely on that: once the library is open the request
  // comes too late.
  H5open();
  module.attr("version") = version;
  module.attr("commit") = commit;
  module.attr("level") = instruction_level;
  module.def("default_threads", &default_threads);
  module.def("get_si_factor", &units::get_si_factor);
  python::bind_errors(module);
  python::bind_case(module);
  python::bind_run(module);
  python::bind_results(module);
}
