// SPDX-License-Identifier: MIT
#pragma once
// The pieces of the extension module talus._core, one function for each file.

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

/// The Python exception with the same sentence: a subclass of talus.Error by the exit code.
py::object make_exception(const Error& error);

/// The same value as dicts, lists and numbers.
py::object to_python(const nlohmann::json& value);

/// HDF5 for this thread alone, with Python's lock held: neither a run in the background nor h5py, which uses the same
/// library and holds Python's lock, is in it meanwhile. Python's lock is let go while waiting, or two threads could
/// wait for each other.
class LibraryTurn {
 public:
  LibraryTurn() {
    const py::gil_scoped_release released;
    guard_.emplace();
  }

 private:
  std::optional<output::hdf5::Guard> guard_;
};

/// The values where they are, as an array that keeps `owner` alive and cannot be written to: no copy.
template <class T>
py::array view(const std::vector<T>& values, const std::vector<py::ssize_t>& shape, const py::object& owner) {
  py::array_t<T> array(shape, values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace talus::python
