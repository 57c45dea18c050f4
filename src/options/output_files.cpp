// SPDX-License-Identifier: Apache-2.0
#include "src/options/output_files.hpp"

namespace torquewright::cli {

void add_output_options(command_line::Command& command, OutputFiles& files) {
  command.add_option("-o,--output", files.result, "Write the result as JSON here").names_a_file();
  command.add_option("--draw", files.drawing, "Draw the gearbox to this SVG file").names_a_file();
}

}  // namespace torquewright::cli
