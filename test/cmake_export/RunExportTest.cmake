# Installs specplan into a staging folder, then configures, builds and runs projects against it as users would.
# Staging through DESTDIR and using the result from where it lies shows that the package is relocatable too.
cmake_minimum_required(VERSION 3.22...3.25)
set(source_dir "${CMAKE_CURRENT_LIST_DIR}")
include("${source_dir}/../packaging/Run.cmake")

# configure(NAME SOURCE ARGUMENT...): configures a project against the staged package; its output becomes the variable output.
function(configure name source)
  run_any("${CMAKE_COMMAND}" -S "${source}" -B "${WORK_DIR}/${name}" -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
    "-DCMAKE_PREFIX_PATH=${STAGE}"
    ${ARGN}
  )
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
set(STAGE "${WORK_DIR}/stage/opt/specplan")
set(ENV{DESTDIR} "${WORK_DIR}/stage")
run("${CMAKE_COMMAND}" --install "${SPECPLAN_BINARY_DIR}" --prefix /opt/specplan --config "${CONFIG}")
unset(ENV{DESTDIR})

set(ompl "")
if(OMPL_DIR)
  set(ompl "-Dompl_DIR=${OMPL_DIR}")
endif()

# A user's programs.
configure(build "${source_dir}" ${ompl} "-DEXPECT_PLANNER=${EXPECT_PLANNER}" "-DEXPECT_FCL=${EXPECT_FCL}")
expect_success()
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config "${CONFIG}")
set(programs use_core)
if(EXPECT_PLANNER)
  list(APPEND programs use_planner)
endif()
if(EXPECT_FCL)
  list(APPEND programs use_fcl)
endif()
foreach(program IN LISTS programs)
  file(GLOB_RECURSE path "${WORK_DIR}/build/${program}")
  run("${path}")
endforeach()

# Components, asked for in all ways.
configure(components "${source_dir}/components" ${ompl} "-DEXPECT_PLANNER=${EXPECT_PLANNER}" "-DEXPECT_FCL=${EXPECT_FCL}")
expect_success()
expect_no_output("specplan|ompl")  # all of it is asked for QUIET
configure(unknown "${source_dir}/components" ${ompl} -DREQUIRE=wheels)
expect_failure("specplan has no component wheels; it has core, planner and fcl")
if(NOT EXPECT_FCL)
  configure(no_fcl "${source_dir}/components" ${ompl} -DREQUIRE=fcl)
  expect_failure("built without the component")
endif()
if(NOT EXPECT_PLANNER)
  configure(no_planner "${source_dir}/components" -DREQUIRE=planner)
  expect_failure("built without the component planner")
  return()
endif()

# Another OMPL than the one specplan was built with: one line that names both, and no harm to who can do without.
file(WRITE "${WORK_DIR}/other_ompl/omplConfig.cmake" "set(ompl_FOUND TRUE)
set(OMPL_VERSION 9.7.3)
set(OMPL_INCLUDE_DIRS /nowhere)
set(OMPL_LIBRARIES /nowhere/libompl.so)
")
set(refusal "specplan was built with OMPL ${OMPL_VERSION}, but OMPL 9.7.3 was found in ${WORK_DIR}/other_ompl; set ompl_DIR")
foreach(component "" planner fcl)
  configure("other_${component}" "${source_dir}/components" "-Dompl_DIR=${WORK_DIR}/other_ompl" -DREQUIRE=${component} -DONLY_REQUIRED=ON)
  expect_failure("${refusal}")
endforeach()
configure(other_optional "${source_dir}/components" "-Dompl_DIR=${WORK_DIR}/other_ompl" -DEXPECT_PLANNER=OFF -DEXPECT_FCL=OFF)
expect_success()
expect_no_output("specplan|ompl")

# The same, found first by its prefix, as where an environment puts another OMPL in front.
file(COPY "${WORK_DIR}/other_ompl/omplConfig.cmake" DESTINATION "${WORK_DIR}/other_prefix/lib/cmake/ompl")
set(ENV{CMAKE_PREFIX_PATH} "${WORK_DIR}/other_prefix")
configure(other_prefix "${source_dir}")
expect_failure("but OMPL 9.7.3 was found in ${WORK_DIR}/other_prefix/lib/cmake/ompl")
unset(ENV{CMAKE_PREFIX_PATH})

# Headers of another OMPL than the library's: no link, and both versions are named.
file(WRITE "${WORK_DIR}/claims/ompl/config.h" "#include_next <ompl/config.h>
#undef OMPL_MINOR_VERSION
#define OMPL_MINOR_VERSION 77
")
set(plain_flags "${CXX_FLAGS}")
set(CXX_FLAGS "-I${WORK_DIR}/claims ${plain_flags}")
configure(other_headers "${source_dir}" ${ompl} "-DEXPECT_FCL=${EXPECT_FCL}")
expect_success()
run_any("${CMAKE_COMMAND}" --build "${WORK_DIR}/other_headers" --config "${CONFIG}" --target use_planner)
string(REGEX MATCH "^[0-9]+" major "${OMPL_VERSION}")
string(REGEX REPLACE "^([0-9]+)\\.([0-9]+).*" "\\1, \\2" built "${OMPL_VERSION}")
expect_failure("BuiltWithOmpl<${built}>,[^<]*CompiledWithOmpl<${major}, 77>")
set(CXX_FLAGS "${plain_flags}")

# Without CMake.
if(PKG_CONFIG)
  set(ENV{PKG_CONFIG_PATH} "${STAGE}/${LIBDIR}/pkgconfig")
  foreach(package specplan specplan-core)
    run_any("${PKG_CONFIG}" --cflags --libs ${package})
    expect_success()
    string(STRIP "${output}" line)
    separate_arguments(flags_${package} UNIX_COMMAND "${line} ${CXX_FLAGS}")
  endforeach()
  set(rpath "-Wl,-rpath,${STAGE}/${LIBDIR}")
  run("${CXX_COMPILER}" -std=c++17 "${source_dir}/main.cpp" -o "${WORK_DIR}/by_pkg_config" ${flags_specplan} ${rpath})
  run("${WORK_DIR}/by_pkg_config")
  run("${CXX_COMPILER}" -std=c++20 "${source_dir}/core.cpp" -o "${WORK_DIR}/core_by_pkg_config" ${flags_specplan-core} ${rpath})
  run("${WORK_DIR}/core_by_pkg_config")
endif()

# As a part of another project.
configure(parent "${source_dir}/parent" ${ompl} "-DSPECPLAN_SOURCE_DIR=${SPECPLAN_SOURCE_DIR}")
expect_success()
run("${CMAKE_COMMAND}" --install "${WORK_DIR}/parent" --prefix "${WORK_DIR}/parent_stage")
file(GLOB_RECURSE installed "${WORK_DIR}/parent_stage/*")
if(installed)
  message(FATAL_ERROR "a project that includes specplan installs specplan's files: ${installed}")
endif()
