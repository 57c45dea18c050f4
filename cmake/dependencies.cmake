# SPDX-License-Identifier: Apache-2.0
# Everything comes from the system (packages.txt); nothing is downloaded or vendored.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(valijson REQUIRED)
if(BUILD_TESTING)
  find_package(GTest REQUIRED)
  find_package(benchmark REQUIRED)
endif()
find_package(Eigen3 REQUIRED)
pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
pkg_check_modules(TINYXML2 REQUIRED IMPORTED_TARGET tinyxml2)
pkg_check_modules(NETTLE REQUIRED IMPORTED_TARGET nettle)

# GMP (exact fractions) and MPFI (outward-rounded intervals of any precision) ship no CMake files.
add_library(exact_arithmetic INTERFACE)
target_link_libraries(exact_arithmetic INTERFACE gmpxx gmp)
add_library(precise_intervals INTERFACE)
target_link_libraries(precise_intervals INTERFACE mpfi mpfr gmp)
