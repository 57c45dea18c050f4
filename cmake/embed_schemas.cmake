# SPDX-License-Identifier: Apache-2.0
# Run by the build (cmake -P): writes OUTPUT, the .cpp that holds every schema in FOLDER.
file(GLOB schemas ${FOLDER}/*.json)
list(SORT schemas)
set(entries "")
foreach(schema ${schemas})
  get_filename_component(kind ${schema} NAME_WE)
  file(READ ${schema} text)
  string(APPEND entries "    {\"${kind}\", R\"schema(${text})schema\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Written by the build from specs/schema.
#include \"io/documents/embedded_schemas.hpp\"

namespace torquewright::io {

std::span<const EmbeddedSchema> embedded_schemas() {
  static constexpr EmbeddedSchema kSchemas[] = {
${entries}  };
  return kSchemas;
}

}  // namespace torquewright::io
")
