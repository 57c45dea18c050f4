# SPDX-License-Identifier: Apache-2.0
# Every target of ours is warned about alike; other people's headers are not.
# (-Wno-restrict: GCC 12 in Release finds overlaps inside std::string's own operator+, GCC bug 105651.)
function(torquewright_flags target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
    -Wno-restrict)
endfunction()

# One static library per module; a module links only what stands before it in CMakeLists.txt.
# PLUGINS are files of one kind that call their parts by the same names (law, gradient, write): they
# are compiled one by one, where preset `release` compiles SOURCES several at a time.
function(add_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;PLUGINS;LINKS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES} ${arg_PLUGINS})
  set_source_files_properties(${arg_PLUGINS} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${arg_LINKS})
  torquewright_flags(${name})
endfunction()

# One GoogleTest program per folder of tests.
function(add_module_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE TORQUEWRIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  torquewright_flags(${name})
  # Values in names would be bytes and addresses; an index is the same in every build.
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES)
endfunction()
