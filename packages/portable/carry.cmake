# SPDX-License-Identifier: Apache-2.0
# Run when the portable archive is made: copies every library that the loader would give
# `carried_program`, and the loader, into `carried_folder`, the licences of all of them and of
# `carried_headers` into share/doc/torquewright, and a list beside them. Debian's dpkg tells whose a
# file is.
set(root $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX})
set(papers ${root}/share/doc/torquewright)
file(MAKE_DIRECTORY ${root}/${carried_folder} ${papers}/licences/common)

# The package that a file belongs to. Below /usr, or where that is /'s own folder, without it.
function(find_package_of file result)
  string(REGEX REPLACE "^/usr/" "/" short ${file})
  foreach(name ${file} ${short})
    execute_process(COMMAND dpkg-query --search ${name}
      OUTPUT_VARIABLE answer ERROR_QUIET RESULT_VARIABLE code)
    if(code EQUAL 0)
      string(REGEX REPLACE "[:,].*" "" package ${answer})
      set(${result} ${package} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "${file} is of no Debian package: its licence cannot be carried with it")
endfunction()

# Copies the package's copyright, once; sets `version_of_package`.
function(carry_papers package)
  execute_process(COMMAND dpkg-query --show "--showformat=\${Version}\n" ${package}
    OUTPUT_VARIABLE versions COMMAND_ERROR_IS_FATAL ANY)
  # Several where it is installed for other processors too.
  string(REGEX REPLACE "\n.*" "" versions "${versions}")
  set(version_of_package ${versions} PARENT_SCOPE)
  if(NOT EXISTS ${papers}/licences/${package})
    file(REAL_PATH /usr/share/doc/${package}/copyright copyright)
    file(COPY_FILE ${copyright} ${papers}/licences/${package})
  endif()
endfunction()

function(append_row file package)
  carry_papers(${package})
  string(LENGTH "${file}" length)
  math(EXPR missing "32 - ${length}")
  string(REPEAT " " ${missing} blanks)
  set(rows "${rows}${file}${blanks}${package} ${version_of_package}\n" PARENT_SCOPE)
endfunction()

execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ldd ${carried_program}
  OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
if(needed MATCHES "([^ \t\n]+) => not found")
  message(FATAL_ERROR "${CMAKE_MATCH_1}: needed by ${carried_program}, and not found")
endif()
string(REGEX MATCHALL "/[^ \n]+ \\(0x" libraries "${needed}")
list(TRANSFORM libraries REPLACE " .*" "")
list(SORT libraries COMPARE NATURAL)
foreach(library ${libraries})
  get_filename_component(name ${library} NAME)
  file(REAL_PATH ${library} real)
  if(real MATCHES "openblas")
    message(FATAL_ERROR "${real}: the archive carries the reference BLAS, which answers alike on "
      "every processor; update-alternatives --auto is not enough, choose it by --config")
  endif()
  file(COPY_FILE ${real} ${root}/${carried_folder}/${name})
  find_package_of(${real} package)
  append_row(${name} ${package})
endforeach()
foreach(package ${carried_headers})
  append_row("(compiled in)" ${package})
endforeach()

# Copyrights refer to licences that only a Debian has in that place.
file(GLOB copyrights LIST_DIRECTORIES false ${papers}/licences/*)
foreach(copyright ${copyrights})
  file(READ ${copyright} text)
  string(REGEX MATCHALL "/usr/share/common-licenses/[A-Za-z0-9.+-]*[A-Za-z0-9]" named "${text}")
  foreach(licence ${named})
    get_filename_component(name ${licence} NAME)
    if(EXISTS ${licence} AND NOT EXISTS ${papers}/licences/common/${name})
      file(REAL_PATH ${licence} licence)
      file(COPY_FILE ${licence} ${papers}/licences/common/${name})
    endif()
  endforeach()
endforeach()

file(WRITE ${papers}/CARRIED
"What torquewright ${carried_version} for Linux on x86-64 carries

bin/torquewright starts lib/torquewright/torquewright by the loader and with the libraries that lie
beside it: nothing of the system's is needed. The folder may be moved, and bin/torquewright be
linked to. A library may be replaced by another of its name. For --plot and pictures gnuplot is
called, which is not carried; nor is libmatio, for MATLAB's files: a system's own libmatio.so.11 is
taken where it can be loaded.

Everything is Debian's, unchanged; `apt-get source PACKAGE=VERSION` or snapshot.debian.org has the
sources. licences/PACKAGE is what Debian says of each, licences/common has the licences that it
refers to as /usr/share/common-licenses. Torquewright itself: LICENSE.

${rows}")
