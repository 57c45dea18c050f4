// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::report {

/// The texts of hopper_page.js and hopper_page.css, compiled in by the build.
extern const char* const kHopperScript;
extern const char* const kHopperStyle;
/// three.js of Debian's libjs-three with its licence, and turning_view.js, which draws by it.
extern const char* const kThreeScript;
extern const char* const kTurningScript;
/// The text of replay_page.css.
extern const char* const kReplayStyle;

}  // namespace torquewright::report
