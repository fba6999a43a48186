// SPDX-License-Identifier: MIT
// Conversion of errors of the library to the exceptions of talus/errors.py.

#include "bind.hpp"

namespace talus::python {

py::object make_exception(const Error& error) {
  py::list findings;
  if (const auto* input = dynamic_cast<const InputError*>(&error))
    for (const Diagnostic& d : input->diagnostics())
      findings.append(py::make_tuple(d.file, d.line, d.column, d.sentence, d.is_unknown_key));
  return py::module_::import("talus.errors")
      .attr("make_error")(static_cast<int>(error.code()), std::string(error.what()), findings);
}

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      const py::object exception = make_exception(error);
      PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
    }
  });
}

}  // namespace talus::python
