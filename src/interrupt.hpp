// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::cli {

/// From now on Ctrl-C (SIGINT) does not end the program: long work asks is_interrupted() and ends
/// with what it has. A second Ctrl-C ends it at once. Called again, it waits for another.
void catch_interrupt();
bool is_interrupted();

}  // namespace torquewright::cli
