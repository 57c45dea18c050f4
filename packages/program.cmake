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

install(TARGETS torquewright RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY ${texts}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(FILES ${texts}/torquewright.bash RENAME torquewright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${texts}/torquewright.zsh RENAME _torquewright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${texts}/torquewright.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/specs
  DESTINATION ${CMAKE_INSTALL_DATADIR}/torquewright COMPONENT program)
