# SPDX-License-Identifier: Apache-2.0
# Run by the build (cmake -P): writes OUTPUT, the .cpp that holds every task in FOLDER.
file(GLOB tasks ${FOLDER}/*.json)
list(SORT tasks)
set(entries "")
foreach(task ${tasks})
  get_filename_component(stem ${task} NAME_WE)
  file(READ ${task} text)
  string(APPEND entries "    {\"${stem}\", R\"task(${text})task\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Written by the build from specs/training_task.
#include \"hopper/training/task/embedded_tasks.hpp\"

namespace torquewright::hopper {

std::span<const EmbeddedTask> embedded_tasks() {
  static constexpr EmbeddedTask kTasks[] = {
${entries}  };
  return kTasks;
}

}  // namespace torquewright::hopper
")
