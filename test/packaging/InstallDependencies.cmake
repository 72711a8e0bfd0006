# scripts/install-dependencies on machines of our making: dpkg-query, apt-get and the rest are scripts that look into a folder.
cmake_minimum_required(VERSION 3.22...3.25)
include("${CMAKE_CURRENT_LIST_DIR}/Run.cmake")

set(bin "${WORK_DIR}/bin")

# program(NAME TEXT): a program for the machine.
function(program name text)
  file(WRITE "${bin}/${name}" "#!/bin/bash\n${text}")
  file(CHMOD "${bin}/${name}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()

# machine(ARCHIVE...): one with nothing installed and these packages in its archive; `all` for every package.
function(machine)
  file(REMOVE_RECURSE "${WORK_DIR}")
  file(MAKE_DIRECTORY "${WORK_DIR}/installed" "${WORK_DIR}/archive")
  foreach(package IN LISTS ARGN)
    file(WRITE "${WORK_DIR}/archive/${package}" "")
  endforeach()
  set(in_archive "[[ -e ${WORK_DIR}/archive/all || -e ${WORK_DIR}/archive/$package ]]")
  program(dpkg-query "for package in \"$@\"; do :; done\n[[ -e ${WORK_DIR}/installed/$package ]] && echo -n installed\n")
  program(apt-cache "package=$2\nif ${in_archive}; then echo '  Candidate: 1'; else echo '  Candidate: (none)'; fi\n")
  program(sudo "exec \"$@\"\n")
  program(apt-get "echo apt-get \"$@\" >>${WORK_DIR}/log
[[ \"$1\" == install ]] || exit 0
packages=()
for package in \"\${@:2}\"; do
  if [[ $package == -* ]]; then continue; fi
  ${in_archive} || exit 100
  packages+=(\"$package\")
done
for package in \"\${packages[@]}\"; do touch ${WORK_DIR}/installed/$package; done
")
endfunction()

# call(ARGUMENT...): the script on that machine.
macro(call)
  run_any("${CMAKE_COMMAND}" -E env --unset=ompl_DIR --unset=CMAKE_PREFIX_PATH ${environment} "PATH=${bin}:$ENV{PATH}"
    "${SOURCE_DIR}/scripts/install-dependencies" ${ARGV})
endmacro()

function(expect_installed package)
  if(NOT EXISTS "${WORK_DIR}/installed/${package}")
    message(FATAL_ERROR "${package} was not installed:\n${output}")
  endif()
endfunction()

function(expect_missing package)
  if(EXISTS "${WORK_DIR}/installed/${package}")
    message(FATAL_ERROR "${package} was installed:\n${output}")
  endif()
endfunction()

# Everything is in the archive; a second call finds nothing to do.
set(environment "")
machine(all)
call(--dev)
expect_success()
foreach(package g++ libompl-dev libfcl-dev libjs-three ompl-demos colcon)
  expect_installed(${package})
endforeach()
expect_no_output("warning")
file(REMOVE "${WORK_DIR}/log")
call(--dev)
expect_success()
if(EXISTS "${WORK_DIR}/log")
  message(FATAL_ERROR "nothing was missing, but apt-get was called")
endif()

# An optional package is not in the archive: the others are installed, and one line says what goes without it.
machine(g++ cmake ninja-build libboost-dev libeigen3-dev libompl-dev libgtest-dev libfcl-dev)
call()
expect_success()
expect_installed(libompl-dev)
expect_installed(libgtest-dev)
expect_installed(libfcl-dev)
if(NOT output MATCHES "warning: libjs-three could not be installed; without it: pages in 3-D")
  message(FATAL_ERROR "no warning of libjs-three:\n${output}")
endif()

# A required one is not.
machine(g++ cmake ninja-build libboost-dev libeigen3-dev)
call()
if(result EQUAL 0)
  message(FATAL_ERROR "libompl-dev is not in the archive, and nobody says so:\n${output}")
endif()

# OMPL comes from elsewhere.
machine(all)
call(--without-ompl --dev)
expect_success()
expect_missing(libompl-dev)
expect_missing(ompl-demos)
expect_installed(libfcl-dev)
machine(all)
file(WRITE "${WORK_DIR}/ros/lib/x86_64-linux-gnu/cmake/ompl/omplConfig.cmake" "")
set(environment "CMAKE_PREFIX_PATH=${WORK_DIR}/nothing:${WORK_DIR}/ros")
call()
expect_success()
expect_missing(libompl-dev)
set(environment "ompl_DIR=${WORK_DIR}/ros/lib/x86_64-linux-gnu/cmake/ompl")
machine(all)
file(WRITE "${WORK_DIR}/ros/lib/x86_64-linux-gnu/cmake/ompl/omplConfig.cmake" "")
call()
expect_missing(libompl-dev)
