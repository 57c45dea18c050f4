# SPDX-License-Identifier: Apache-2.0
# Run by the build (cmake -P): writes OUTPUT, the .cpp that holds the texts of a page.
function(literal variable)
  set(text "")
  foreach(file ${ARGN})
    file(READ ${file} part)
    string(APPEND text "${part}")
  endforeach()
  set(${variable} "R\"text(${text})text\"" PARENT_SCOPE)
endfunction()
literal(script ${FOLDER}/hopper_page.js)
literal(style ${FOLDER}/hopper_page.css)
literal(replay_style ${FOLDER}/replay_page.css)
literal(three ${FOLDER}/three_licence.js ${THREE})
literal(turning ${FOLDER}/turning_view.js)
file(WRITE ${OUTPUT} "// Written by the build from src/report/*.js and .css, and from three.js.
#include \"src/report/parts/embedded_page.hpp\"

namespace torquewright::report {

const char* const kHopperScript = ${script};
const char* const kHopperStyle = ${style};
const char* const kReplayStyle = ${replay_style};
const char* const kThreeScript = ${three};
const char* const kTurningScript = ${turning};

}  // namespace torquewright::report
")
