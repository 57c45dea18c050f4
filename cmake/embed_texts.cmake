# SPDX-License-Identifier: Apache-2.0
# Run by the build (cmake -P): writes OUTPUT, the .cpp that holds the texts of a page.
function(literal variable file)
  file(READ ${FOLDER}/${file} text)
  set(${variable} "R\"text(${text})text\"" PARENT_SCOPE)
endfunction()
literal(script hopper_page.js)
literal(style hopper_page.css)
literal(replay_style replay_page.css)
file(WRITE ${OUTPUT} "// Written by the build from src/report/hopper_page.js and .css and replay_page.css.
#include \"src/report/parts/embedded_page.hpp\"

namespace torquewright::report {

const char* const kHopperScript = ${script};
const char* const kHopperStyle = ${style};
const char* const kReplayStyle = ${replay_style};

}  // namespace torquewright::report
")
