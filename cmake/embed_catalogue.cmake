# SPDX-License-Identifier: Apache-2.0
# Run by the build (cmake -P): writes OUTPUT, the .cpp that holds every actuator in FOLDER.
file(GLOB drives ${FOLDER}/*.json)
list(SORT drives)
set(entries "")
foreach(drive ${drives})
  get_filename_component(stem ${drive} NAME_WE)
  file(READ ${drive} text)
  string(APPEND entries "    {\"${stem}\", R\"drive(${text})drive\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Written by the build from specs/catalogue.
#include \"actuator/catalogue/embedded_catalogue.hpp\"

namespace torquewright::actuator {

std::span<const EmbeddedDrive> embedded_catalogue() {
  static constexpr EmbeddedDrive kDrives[] = {
${entries}  };
  return kDrives;
}

}  // namespace torquewright::actuator
")
