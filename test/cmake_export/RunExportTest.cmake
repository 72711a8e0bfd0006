# Installs specplan into a staging folder, then configures, builds and runs the consumer project beside this file against it.
# Staging through DESTDIR and using the result from where it lies shows that the package is relocatable too.

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${result}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
set(ENV{DESTDIR} "${WORK_DIR}/stage")
run("${CMAKE_COMMAND}" --install "${SPECPLAN_BINARY_DIR}" --prefix /opt/specplan --config "${CONFIG}")
unset(ENV{DESTDIR})

run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${WORK_DIR}/stage/opt/specplan"
  "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DEXPECT_PLANNER=${EXPECT_PLANNER}"
  "-DEXPECT_FCL=${EXPECT_FCL}"
)
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
