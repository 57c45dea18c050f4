# SPDX-License-Identifier: Apache-2.0
# Run by the build (cmake -P): PROGRAM writes into FOLDER its pages for man, compressed, and its
# completions. Pages of commands that are no more go.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/man1)
execute_process(COMMAND ${PROGRAM} man --all ${FOLDER}/man1 COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages ${FOLDER}/man1/*)
execute_process(COMMAND gzip -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
foreach(shell bash zsh fish)
  execute_process(COMMAND ${PROGRAM} completion ${shell} -o ${FOLDER}/torquewright.${shell}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(WRITE ${FOLDER}/written "")
