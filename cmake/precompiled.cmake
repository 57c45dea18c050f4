# SPDX-License-Identifier: Apache-2.0
# What other people wrote is read once for all targets that are compiled alike, not once for each
# (docs/build.md has the figures). A file still includes what it uses: presets `debug` and `asan`
# compile without precompiled headers.

# An object library whose only purpose is the precompiled headers that targets borrow from it.
function(add_precompiled name)
  cmake_parse_arguments(arg "" "OPTIMIZATION" "HEADERS;LINKS" ${ARGN})
  set(unit ${CMAKE_BINARY_DIR}/${name}.cpp)
  if(NOT EXISTS ${unit})
    file(WRITE ${unit} "// Carries the precompiled headers of ${name}.\n")
  endif()
  add_library(${name} OBJECT ${unit})
  target_link_libraries(${name} PRIVATE ${arg_LINKS})
  torquewright_flags(${name} ${arg_OPTIMIZATION})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# What is compiled with those headers needs to find them, whether it includes them or not.
function(use_precompiled target from)
  target_precompile_headers(${target} REUSE_FROM ${from})
  target_link_libraries(${target} PRIVATE ${precompiled_libraries})
endfunction()

set(precompiled_libraries fmt::fmt nlohmann_json::nlohmann_json Eigen3::Eigen)
set(standard_headers <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <fstream>
  <functional> <limits> <map> <memory> <numbers> <numeric> <optional> <set> <span> <sstream>
  <stdexcept> <string> <string_view> <tuple> <utility> <variant> <vector>)

add_precompiled(precompiled_library
  HEADERS ${standard_headers} <fmt/format.h> <fmt/ranges.h> <gmpxx.h> <nlohmann/json.hpp>
    <Eigen/Cholesky> <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry> <Eigen/LU> <Eigen/QR>
  LINKS ${precompiled_libraries})
add_precompiled(precompiled_edge OPTIMIZATION -O1
  HEADERS ${standard_headers} <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>
  LINKS ${precompiled_libraries})
if(BUILD_TESTING)
  add_precompiled(precompiled_test OPTIMIZATION -O1
    HEADERS ${standard_headers} <fmt/format.h> <gtest/gtest.h> <nlohmann/json.hpp>
      <Eigen/Cholesky> <Eigen/Core> <Eigen/Geometry> <Eigen/LU>
    LINKS ${precompiled_libraries} GTest::gtest)
endif()
