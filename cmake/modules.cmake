# SPDX-License-Identifier: Apache-2.0
# Every target of ours is warned about alike; other people's headers are not. What runs once per
# command asks for less optimisation than what runs in loops: a level is the last argument.
# (Switched off in Release: what GCC 12 finds inside std::string's own operator+, GCC bug 105651.)
function(torquewright_flags target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
    -Wno-restrict $<$<CONFIG:Release>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;${ARGN}>)
endfunction()

# What a program of another language loads (python/) is linked of the same objects as the program:
# code that may stand anywhere, in which our functions still call one another directly.
function(torquewright_relocatable target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# One static library per module; a module links only what stands before it in CMakeLists.txt.
# PLUGINS are files of one kind that call their parts by the same names (law, gradient, write): they
# are compiled one by one, where preset `release` compiles SOURCES several at a time.
# What reads or writes documents (*_spec, *_json, DOCUMENTS; with EDGE the whole module) runs once
# per command and is made of other people's templates: it asks for little optimisation.
function(add_module name)
  cmake_parse_arguments(arg "EDGE" "" "SOURCES;PLUGINS;DOCUMENTS;LINKS" ${ARGN})
  set(documents ${arg_SOURCES})
  if(NOT arg_EDGE)
    list(FILTER documents INCLUDE REGEX "_(spec|json)\\.cpp$")
  endif()
  list(REMOVE_ITEM arg_SOURCES ${documents})
  list(APPEND documents ${arg_DOCUMENTS})
  add_library(${name} STATIC ${arg_SOURCES} ${arg_PLUGINS})
  set_property(GLOBAL APPEND PROPERTY TORQUEWRIGHT_MODULES ${name})
  set_source_files_properties(${arg_PLUGINS} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${arg_LINKS})
  torquewright_flags(${name})
  torquewright_relocatable(${name})
  if(documents)
    add_library(${name}_documents OBJECT ${documents})
    target_include_directories(${name}_documents PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name}_documents PRIVATE ${arg_LINKS})
    torquewright_flags(${name}_documents -O1)
    torquewright_relocatable(${name}_documents)
    target_sources(${name} PRIVATE $<TARGET_OBJECTS:${name}_documents>)
  endif()
endfunction()

# One GoogleTest program; CTest runs each of its suites in a process of its own, so that what a suite
# prepares once (a search, a log) is prepared once. (gtest_discover_tests makes a process per TEST.)
function(add_module_test name)
  cmake_parse_arguments(arg "" "COST" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE TORQUEWRIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  torquewright_flags(${name} -O1)
  use_precompiled(${name})
  set(suites ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${name}> -DOUTPUT=${suites}
            "-DCOST=${arg_COST}" -P ${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake
    BYPRODUCTS ${suites} VERBATIM)
  if(NOT EXISTS ${suites})
    file(WRITE ${suites} "add_test([=[${name}: not built]=] ${name}-not-built)\n")
  endif()
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${suites})
endfunction()
