# SPDX-License-Identifier: Apache-2.0
# cpack -G TGZ: one archive for every Linux on x86-64, whatever its C library. Debian has Ipopt,
# NLopt, MuJoCo, fmt and tinyxml2 as shared libraries alone, so no program can be linked statically;
# the archive carries the program, its libraries and the loader, and a launcher that needs none.
add_executable(torquewright_launcher portable/launcher.cpp)
torquewright_flags(torquewright_launcher -Os)
target_compile_options(torquewright_launcher PRIVATE -fno-sanitize=all)
target_link_options(torquewright_launcher PRIVATE -static -fno-sanitize=all)
set_target_properties(torquewright_launcher PROPERTIES
  RUNTIME_OUTPUT_NAME torquewright RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/launcher)

# What of other people's is compiled in, being headers: its licences are carried too.
set(compiled_in nlohmann-json3-dev libcli11-dev libvalijson-dev libeigen3-dev libfmt-dev libc6-dev
  libstdc++-12-dev)
string(REGEX MATCH "^[0-9]+" compiler ${CMAKE_CXX_COMPILER_VERSION})
list(TRANSFORM compiled_in REPLACE "libstdc\\+\\+-12-dev" "libstdc++-${compiler}-dev")

set(library_folder lib/torquewright)
install(TARGETS torquewright_launcher RUNTIME DESTINATION bin COMPONENT portable EXCLUDE_FROM_ALL)
install(TARGETS torquewright RUNTIME DESTINATION ${library_folder} COMPONENT portable
  EXCLUDE_FROM_ALL)
install_texts(portable share EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION share/doc/torquewright COMPONENT portable EXCLUDE_FROM_ALL)
install(CODE "
  set(carried_program \"$<TARGET_FILE:torquewright>\")
  set(carried_version ${PROJECT_VERSION})
  set(carried_folder ${library_folder})
  set(carried_headers ${compiled_in})
  include(${CMAKE_CURRENT_SOURCE_DIR}/portable/carry.cmake)"
  COMPONENT portable EXCLUDE_FROM_ALL)

# What the archive needs, and no more.
add_custom_target(portable)
add_dependencies(portable torquewright torquewright_launcher packaged_texts)
