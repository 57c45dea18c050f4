// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::io {

/// Fills what the starter closed of stdin, stdout and stderr, so that no file that is opened takes
/// their place: what is said there is lost, and reading or printing a result fails as before. To be
/// called before anything is opened.
void fill_standard_descriptors();

}  // namespace torquewright::io
