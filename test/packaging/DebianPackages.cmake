# Makes Debian packages of what was built, unpacks them into an empty folder, runs the command from there and builds a user's program.
cmake_minimum_required(VERSION 3.22...3.25)
include("${CMAKE_CURRENT_LIST_DIR}/Run.cmake")

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")
run(cpack -G DEB --config "${BINARY_DIR}/CPackConfig.cmake" -B "${WORK_DIR}")
file(GLOB packages "${WORK_DIR}/*.deb")
list(LENGTH packages count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "expected specplan and libspecplan-dev, found ${packages}")
endif()

set(root "${WORK_DIR}/root")
set(all_files "")
if(EXPECT_SHARED)
  set(ENV{LD_LIBRARY_PATH} "${root}${PREFIX}/${LIBDIR}")  # where a linker of a system would look
endif()
foreach(package IN LISTS packages)
  run(dpkg-deb --extract "${package}" "${root}")
  run(dpkg-deb --extract "${package}" "${WORK_DIR}/one")
  file(GLOB_RECURSE files RELATIVE "${WORK_DIR}/one" "${WORK_DIR}/one/*")
  file(REMOVE_RECURSE "${WORK_DIR}/one")
  foreach(file IN LISTS files)
    if(file IN_LIST all_files)
      message(FATAL_ERROR "${file} is in both packages, so they cannot be installed together")
    endif()
  endforeach()
  list(APPEND all_files ${files})
  run_any(dpkg-deb --field "${package}" Package Depends)
  expect_success()
  message(STATUS "${output}")
  if(output MATCHES "Package: specplan\n" AND EXPECT_COMMAND AND NOT output MATCHES "Depends: .*libompl")
    message(FATAL_ERROR "specplan does not depend on the library of OMPL:\n${output}")
  elseif(output MATCHES "Package: libspecplan-dev\n" AND OMPL_DIR MATCHES "^/usr/" AND NOT output MATCHES "Depends: .*libompl-dev \\(<<")
    message(FATAL_ERROR "libspecplan-dev does not depend on this version of libompl-dev:\n${output}")
  endif()
endforeach()

if(EXPECT_COMMAND)
  set(command "${root}${PREFIX}/bin/specplan")
  set(scenes "${root}${PREFIX}/share/specplan/scenes")
  run("${command}" plan "${scenes}/city-64.map" --scen "${scenes}/city-64.map.scen" --index last --json)
  if(EXPECT_FCL)
    run("${command}" plan "${scenes}/office.cfg" --json)
  endif()
endif()

run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/test/cmake_export" -B "${WORK_DIR}/consumer" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-Dspecplan_DIR=${root}${PREFIX}/${LIBDIR}/cmake/specplan"
  "-Dompl_DIR=${OMPL_DIR}"
  "-DEXPECT_FCL=${EXPECT_FCL}"
)
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/consumer" --target use_planner)
run("${WORK_DIR}/consumer/use_planner")
