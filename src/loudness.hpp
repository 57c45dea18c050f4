// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::cli {

/// How much is said beside the answer.
struct Loudness {
  bool is_quiet = false;    ///< Nothing: no progress, no notes, and of the answer its first line.
  bool is_verbose = false;  ///< Also what is assumed, and what one screen leaves out.
};

/// That of the command that runs, as its -q and -v say.
Loudness& loudness();

}  // namespace torquewright::cli
