// SPDX-License-Identifier: Apache-2.0
// The compiled part of the package torquewright: what its Python is written with, not for others.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/documents/document.hpp"
#include "io/documents/provenance.hpp"
#include "io/documents/schema.hpp"
#include "io/faults/json_text.hpp"
#include "python/interpreter.hpp"
#include "python/refusals.hpp"
#include "python/region_clip.hpp"
#include "python/text.hpp"

namespace torquewright::python {
namespace {

namespace py = pybind11;

py::tuple run_words(const std::vector<std::string>& words, const py::object& progress) {
  const Answer answer = run(words, progress);
  return py::make_tuple(static_cast<int>(answer.code), text_of(answer.text));
}

/// The document as JSON, checked against the kind that it says it is.
py::str read_file(const std::string& file) {
  return text_of(io::json_text(io::read_any_document(file).root));
}

}  // namespace
}  // namespace torquewright::python

PYBIND11_MODULE(_core, module) {
  using namespace torquewright;
  using namespace torquewright::python;
  translate_refusals();
  module.attr("version") = std::string(io::tool_version());
  module.def("run", &run_words, py::arg("words"), py::arg("progress") = py::none(),
             "Run a command of the program: its exit code and what it printed.");
  module.def("read", &read_file, "A document of any kind, checked, as JSON.");
  py::class_<RegionClip>(module, "RegionClip")
      .def(py::init<const Numbers&, const Numbers&, const Numbers&, double>())
      .def("clip", &RegionClip::clip);
}
