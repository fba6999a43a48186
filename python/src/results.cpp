// SPDX-License-Identifier: MIT
// Bindings of frames and histories; their arrays refer to the memory of the library.

#include "output/files/frames_reader.hpp"

#include <omp.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "bind.hpp"
#include "output/files/history.hpp"
#include "report/report.hpp"
#include "results/json.hpp"

namespace talus::python {
namespace {

using output::Field;

py::ssize_t size(std::size_t n) {
  return static_cast<py::ssize_t>(n);
}

py::array view_rows(const std::vector<double>& values, int columns, const py::object& owner) {
  const auto n = static_cast<std::size_t>(columns);
  if (columns == 1) return view(values, {size(values.size())}, owner);
  return view(values, {size(values.size() / n), columns}, owner);
}

/// Returns {name: (unit, array)}.
py::dict view_fields(const std::vector<Field>& fields, const py::object& owner) {
  py::dict all;
  for (const Field& f : fields) all[py::str(f.name)] = py::make_tuple(f.unit, view_rows(f.values, f.components, owner));
  return all;
}

/// Disables OpenMP threads in the calling thread: after a fork the child would wait forever for those of its parent.
/// Calculations run in a thread of their own, whose OpenMP threads end with it.
class NoThreads {
 public:
  NoThreads() : before_(omp_get_max_threads()) { omp_set_num_threads(1); }
  ~NoThreads() { omp_set_num_threads(before_); }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  int before_;
};

template <class T>
const T& get(const py::object& object) {
  return object.cast<const T&>();
}

void bind_frame(py::module_& module) {
  using output::Frame;
  using output::MeshFrame;
  py::class_<MeshFrame>(module, "MeshFrame")
      .def_property_readonly("nodes", [](const py::object& o) { return view_rows(get<MeshFrame>(o).nodes, 3, o); })
      .def_property_readonly("elements",
                             [](const py::object& o) {
                               const auto& m = get<MeshFrame>(o);
                               const int k = m.nodes_per_element;
                               return view(m.elements, {size(m.elements.size()) / k, k}, o);
                             })
      .def_property_readonly("element_fields",
                             [](const py::object& o) { return view_fields(get<MeshFrame>(o).element_fields, o); })
      .def_property_readonly("node_fields",
                             [](const py::object& o) { return view_fields(get<MeshFrame>(o).node_fields, o); });
  py::class_<Frame, std::shared_ptr<Frame>>(module, "Frame")
      .def_readonly("time", &Frame::time)
      .def_readonly("step", &Frame::step)
      .def_readonly("stage", &Frame::stage)
      .def_property_readonly("positions", [](const py::object& o) { return view_rows(get<Frame>(o).positions, 3, o); })
      .def_property_readonly("ids",
                             [](const py::object& o) {
                               const auto& ids = get<Frame>(o).ids;
                               return view(ids, {size(ids.size())}, o);
                             })
      .def_property_readonly("materials",
                             [](const py::object& o) {
                               const auto& materials = get<Frame>(o).materials;
                               return view(materials, {size(materials.size())}, o);
                             })
      .def_property_readonly("fields", [](const py::object& o) { return view_fields(get<Frame>(o).point_fields, o); })
      .def_property_readonly("mesh", [](const py::object& o) -> py::object {
        const auto& mesh = get<Frame>(o).mesh;
        if (!mesh) return py::none();
        return py::cast(&*mesh, py::return_value_policy::reference_internal, o);
      });
}

void bind_history(py::module_& module) {
  using output::HistoryTable;
  py::class_<HistoryTable, std::shared_ptr<HistoryTable>>(module, "History")
      .def_property_readonly("columns", [](const py::object& o) {
        const auto& table = get<HistoryTable>(o);
        py::dict all;
        for (std::size_t i = 0; i < table.columns.size(); ++i)
          all[py::str(table.columns[i].name)] = py::make_tuple(table.columns[i].unit, view_rows(table.values[i], 1, o));
        return all;
      });
  module.def("read_history", [](const std::filesystem::path& path) {
    return std::make_shared<HistoryTable>(output::read_history(path));
  });
}

}  // namespace

void bind_results(py::module_& module) {
  bind_frame(module);
  bind_history(module);
  module.def("write_report", [](const std::filesystem::path& folder) {
    const LibraryTurn turn;
    const NoThreads alone;
    return report::write_report(folder);
  });
  module.def("get_result_schema", &results::write_schema);
  using output::ResultsReader;
  py::class_<ResultsReader>(module, "Reader")
      .def(py::init([](const std::filesystem::path& folder) {
        const LibraryTurn turn;
        return std::make_unique<ResultsReader>(folder);
      }))
      .def_property_readonly("times", &ResultsReader::times)
      .def_property_readonly("steps", &ResultsReader::steps)
      .def_property_readonly("stages", &ResultsReader::stages)
      .def_property_readonly("field_names", &ResultsReader::field_names)
      .def("find_nearest", &ResultsReader::find_nearest)
      .def("read", [](const ResultsReader& reader, int index) {
        const LibraryTurn turn;
        return std::make_shared<output::Frame>(reader.read(index));
      });
}

}  // namespace talus::python
