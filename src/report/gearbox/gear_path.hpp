// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::report {

/// The gear's outline about the origin, a tooth (internal: a space) on the x axis, as the data of
/// an SVG path of cubic curves. They leave the true flanks by less than 3e-7 module and tips and
/// roots by less than 3e-5; coordinates are rounded to 1e-6 millimetre on paper.
std::string gear_path(const gearbox::ToothForm& form, double paper_mm_per_module);

/// A circle about the origin as path data, to be cut out of or filled around an outline.
std::string circle_path(double radius_mm);

}  // namespace torquewright::report
