# SPDX-License-Identifier: Apache-2.0
# The program, the pages and completions that it prints of itself, its schemas and examples.
set(texts ${CMAKE_CURRENT_BINARY_DIR}/texts)
add_custom_command(
  OUTPUT ${texts}/written
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:torquewright> -DFOLDER=${texts}
          -P ${CMAKE_CURRENT_SOURCE_DIR}/write_texts.cmake
  DEPENDS torquewright write_texts.cmake
  VERBATIM)
add_custom_target(packaged_texts ALL DEPENDS ${texts}/written)

# By component and the folder for what no processor runs; further words are install's.
function(install_texts component share)
  set(how COMPONENT ${component} ${ARGN})
  install(DIRECTORY ${texts}/man1 DESTINATION ${share}/man ${how})
  install(FILES ${texts}/torquewright.bash RENAME torquewright
    DESTINATION ${share}/bash-completion/completions ${how})
  install(FILES ${texts}/torquewright.zsh RENAME _torquewright
    DESTINATION ${share}/zsh/vendor-completions ${how})
  install(FILES ${texts}/torquewright.fish DESTINATION ${share}/fish/vendor_completions.d ${how})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/specs DESTINATION ${share}/torquewright ${how})
endfunction()
install(TARGETS torquewright RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install_texts(program ${CMAKE_INSTALL_DATADIR})
