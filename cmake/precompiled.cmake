# SPDX-License-Identifier: Apache-2.0
# GoogleTest and the headers that most tests share are read once for all test programs. Libraries and
# the program gain nothing by it (docs/build.md has the figures). A file still includes what it uses:
# presets `debug` and `asan` compile without precompiled headers.

set(precompiled_libraries fmt::fmt nlohmann_json::nlohmann_json Eigen3::Eigen GTest::gtest)
# Its only purpose is the header that the test programs borrow from it.
set(unit ${CMAKE_BINARY_DIR}/precompiled_test.cpp)
if(NOT EXISTS ${unit})
  file(WRITE ${unit} "// Carries the precompiled headers of the tests.\n")
endif()
add_library(precompiled_test OBJECT ${unit})
target_link_libraries(precompiled_test PRIVATE ${precompiled_libraries})
torquewright_flags(precompiled_test -O1)
target_precompile_headers(precompiled_test PRIVATE
  <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <fstream> <functional> <limits> <map>
  <memory> <numbers> <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view>
  <tuple> <utility> <variant> <vector> <fmt/format.h> <gtest/gtest.h> <nlohmann/json.hpp>
  <Eigen/Cholesky> <Eigen/Core> <Eigen/Geometry> <Eigen/LU>)

# What is compiled with those headers needs to find them, whether it includes them or not.
function(use_precompiled target)
  target_precompile_headers(${target} REUSE_FROM precompiled_test)
  target_link_libraries(${target} PRIVATE ${precompiled_libraries})
endfunction()
