// SPDX-License-Identifier: Apache-2.0
#include "python/refusals.hpp"

#include <pybind11/pybind11.h>

#include <exception>

#include "io/faults/spec_error.hpp"
#include "python/text.hpp"

namespace torquewright::python {
namespace {

void raise_refusal(const io::SpecError& error) {
  pybind11::list faults;
  for (const io::Fault& fault : error.faults()) {
    faults.append(
        pybind11::make_tuple(text_of(fault.file), text_of(fault.path), text_of(fault.message)));
  }
  const pybind11::object type = pybind11::module_::import("torquewright._refusal").attr("Refusal");
  PyErr_SetObject(type.ptr(), type(faults).ptr());
}

}  // namespace

void translate_refusals() {
  pybind11::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const io::SpecError& error) {
      raise_refusal(error);
    }
  });
}

}  // namespace torquewright::python
