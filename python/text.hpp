// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace torquewright::python {

/// Returns bytes as Python holds text. A sentence may quote bytes of a file that are no UTF-8: they
/// become the replacement character.
inline pybind11::str text_of(const std::string& bytes) {
  return pybind11::reinterpret_steal<pybind11::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

}  // namespace torquewright::python
