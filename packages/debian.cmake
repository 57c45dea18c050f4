# SPDX-License-Identifier: Apache-2.0
# cpack -G DEB, and by generator.cmake -G TGZ.
set(CPACK_GENERATOR DEB)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_SOURCE_DIR}/generator.cmake)
set(CPACK_PACKAGE_NAME torquewright)
set(CPACK_PACKAGE_VENDOR Torquewright)
set(CPACK_PACKAGE_CONTACT "Torquewright <torquewright@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "design tool for actuators and gearboxes of jumping robots")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME torquewright)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Called by the program, or loaded when it is asked for, which no library tells.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS libmatio11)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"Finds the provably best 3K or planetary gearbox of a problem, tabulates and
exports the motor operating region of an actuator, checks and plans motions of
robots against it, and identifies from measured logs which effect the model of
an actuator lacks.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtorquewright-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(development_needs libfmt-dev nlohmann-json3-dev libeigen3-dev coinor-libipopt-dev
  libnlopt-cxx-dev libtinyxml2-dev nettle-dev libminizip-dev
  zlib1g-dev liblz4-dev libzstd-dev libsqlite3-dev libmpfi-dev libmpfr-dev libgmp-dev)
if(TARGET mujoco_library)
  list(APPEND development_needs libmujoco-dev)
endif()
list(JOIN development_needs ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"Headers and static library of torquewright: documents, motor operating
regions, gearbox searches with their proofs, rigid-body dynamics, checks and
plans of motions, and identification from logs, for programs in C++20.")

set(all_packages torquewright libtorquewright-dev)

# Shared libraries are known to be needed; Python and what its own files import are not.
if(TARGET torquewright_python)
  list(APPEND all_packages python3-torquewright)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-torquewright)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.9), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_SOURCE_DIR}/python/postinst ${CMAKE_CURRENT_SOURCE_DIR}/python/prerm)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"Torquewright's answers in Python: documents and reports as dictionaries, the
motor operating region and torques cut off at it as arrays, checks of motions,
identification from logs, and gearbox searches, in ten calls.")
endif()

# A changelog and the copyright for each package.
foreach(package ${all_packages})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${package})
  file(MAKE_DIRECTORY ${folder})
  configure_file(changelog.in ${folder}/changelog @ONLY)
  add_custom_command(OUTPUT ${folder}/changelog.gz
    COMMAND gzip -9nkf ${folder}/changelog DEPENDS ${folder}/changelog VERBATIM)
  list(APPEND changelogs ${folder}/changelog.gz)
endforeach()
add_custom_target(packaged_changelogs ALL DEPENDS ${changelogs})
function(install_papers package component)
  install(FILES copyright ${CMAKE_CURRENT_BINARY_DIR}/${package}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endfunction()
install_papers(torquewright program)
install_papers(libtorquewright-dev development)
if(TARGET torquewright_python)
  install_papers(python3-torquewright python)
endif()
include(CPack)
