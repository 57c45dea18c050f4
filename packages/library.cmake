# SPDX-License-Identifier: Apache-2.0
# The library as others use it: all modules below src/ in one archive, their headers, and what
# CMake and pkg-config need to find them (decision 0023).
include(CMakePackageConfigHelpers)

add_library(torquewright_library STATIC)
set_target_properties(torquewright_library PROPERTIES
  OUTPUT_NAME torquewright EXPORT_NAME torquewright LINKER_LANGUAGE CXX)
set(header_folder ${CMAKE_INSTALL_INCLUDEDIR}/torquewright)
get_property(modules GLOBAL PROPERTY TORQUEWRIGHT_MODULES)
foreach(module ${modules})
  get_target_property(folder ${module} SOURCE_DIR)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
  if(folder MATCHES "^(src|tests|bench|python)(/|$)")
    continue()
  endif()
  target_sources(torquewright_library PRIVATE $<TARGET_OBJECTS:${module}>)
  if(TARGET ${module}_documents)
    target_sources(torquewright_library PRIVATE $<TARGET_OBJECTS:${module}_documents>)
  endif()
  string(REGEX REPLACE "/.*" "" room ${folder})
  list(APPEND rooms ${room})
endforeach()
list(REMOVE_DUPLICATES rooms)
foreach(room ${rooms})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${header_folder}
    COMPONENT development FILES_MATCHING PATTERN "*.hpp")
endforeach()

# What programs that link the archive need besides. Shared libraries know what they need in turn.
set(library_links ipopt nlopt tinyxml2 nettle minizip z lz4 zstd sqlite3 mpfi mpfr gmpxx gmp)
if(TARGET mujoco_library)
  list(APPEND library_links mujoco)
endif()
target_compile_features(torquewright_library INTERFACE cxx_std_20)
target_include_directories(torquewright_library INTERFACE $<INSTALL_INTERFACE:${header_folder}>)
target_link_libraries(torquewright_library INTERFACE
  fmt::fmt nlohmann_json::nlohmann_json Eigen3::Eigen Threads::Threads ${library_links})
install(TARGETS torquewright_library EXPORT TorquewrightTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)

set(cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Torquewright)
install(EXPORT TorquewrightTargets NAMESPACE Torquewright::
  DESTINATION ${cmake_folder} COMPONENT development)
configure_package_config_file(TorquewrightConfig.cmake.in TorquewrightConfig.cmake
  INSTALL_DESTINATION ${cmake_folder})
write_basic_package_version_file(TorquewrightConfigVersion.cmake COMPATIBILITY SameMinorVersion)

list(TRANSFORM library_links PREPEND -l OUTPUT_VARIABLE library_flags)
list(JOIN library_flags " " library_flags)
# From where the file lies to the prefix, which is known only when it is installed.
file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" up "${up}")
configure_file(torquewright.pc.in torquewright.pc @ONLY)

install(FILES ${CMAKE_CURRENT_BINARY_DIR}/TorquewrightConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/TorquewrightConfigVersion.cmake
  DESTINATION ${cmake_folder} COMPONENT development)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/torquewright.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/library/
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/../libtorquewright-dev/examples COMPONENT development)
