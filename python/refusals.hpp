// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::python {

/// From now on io::SpecError comes out as torquewright.Refusal, with its faults.
void translate_refusals();

}  // namespace torquewright::python
