// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::python {

/// Makes io::SpecError come out as torquewright.Refusal, with its faults, from now on.
void translate_refusals();

}  // namespace torquewright::python
