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
  # Reads what the program writes; its licence, the GPL, is not one to be given away with Ipopt's.
  pkg_check_modules(DXFLIB REQUIRED IMPORTED_TARGET dxflib)
endif()
find_package(Eigen3 REQUIRED)
pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
pkg_check_modules(TINYXML2 REQUIRED IMPORTED_TARGET tinyxml2)
pkg_check_modules(NETTLE REQUIRED IMPORTED_TARGET nettle)
# Compressed logs and recordings; their headers lie where every compiler looks. matio is loaded when
# it is asked for: the build needs its header, a test its functions.
pkg_check_modules(LOG_FORMATS REQUIRED zlib minizip liblz4 libzstd sqlite3)
pkg_check_modules(MATIO REQUIRED matio)

# MuJoCo: a second engine and the tests' independent dynamics, where it is installed (Debian's
# libmujoco-dev). Its headers are not ours to warn about.
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
find_library(MUJOCO_LIBRARY mujoco)
if(MUJOCO_INCLUDE_DIR AND MUJOCO_LIBRARY)
  add_library(mujoco_library INTERFACE)
  target_include_directories(mujoco_library SYSTEM INTERFACE ${MUJOCO_INCLUDE_DIR})
  target_link_libraries(mujoco_library INTERFACE ${MUJOCO_LIBRARY})
else()
  message(STATUS "built without MuJoCo: libmujoco-dev is not installed")
endif()

# GMP (exact fractions) and MPFI (outward-rounded intervals of any precision) ship no CMake files.
add_library(exact_arithmetic INTERFACE)
target_link_libraries(exact_arithmetic INTERFACE gmpxx gmp)
add_library(precise_intervals INTERFACE)
target_link_libraries(precise_intervals INTERFACE mpfi mpfr gmp)
