// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "gearbox/problem.hpp"
#include "io/documents/document.hpp"

namespace torquewright::gearbox {

/// A design of a gearbox_result with the problem that it answers.
struct ReadDesign {
  Problem problem;
  Design design;
  std::vector<double> face_width_mm;  ///< By layer, as chosen or stated; may be empty.
};

/// The design with this number, from 1. Throws io::SpecError where there is none.
ReadDesign read_design(const io::Document& result, std::size_t number);

}  // namespace torquewright::gearbox
