# SPDX-License-Identifier: Apache-2.0
# Where things go below the prefix. Libraries: where Debian looks for them, below any prefix;
# elsewhere GNUInstallDirs knows.
if(CMAKE_LIBRARY_ARCHITECTURE)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Libraries")
endif()
include(GNUInstallDirs)
