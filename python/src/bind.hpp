// SPDX-License-Identifier: MIT
#pragma once
// Interface between the source files of the extension module talus._core: one bind_ function for each file, and the
// conversions that they share.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "output/files/hdf5.hpp"

namespace talus::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_case(py::module_& module);
void bind_run(py::module_& module);
void bind_results(py::module_& module);

/// Returns the Python exception with the message of `error`; the exit code determines the subclass of talus.Error.
py::object make_exception(const Error& error);

/// Converts JSON to dicts, lists and numbers.
py::object to_python(const nlohmann::json& value);

/// Exclusive use of HDF5 by this thread, with the GIL held. This excludes both a run in the background and h5py, which
/// uses the same library under the GIL. The GIL is released while waiting, to avoid a deadlock.
class LibraryTurn {
 public:
  LibraryTurn() {
    const py::gil_scoped_release released;
    guard_.emplace();
  }

 private:
  std::optional<output::hdf5::Guard> guard_;
};

/// Returns a read-only array that refers to `values` without a copy and keeps `owner` alive.
template <class T>
py::array view(const std::vector<T>& values, const std::vector<py::ssize_t>& shape, const py::object& owner) {
  py::array_t<T> array(shape, values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace talus::python
