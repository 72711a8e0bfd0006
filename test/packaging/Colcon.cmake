# Builds the source tree as ROS does, the core alone to be quick, and looks at what an overlay would see.
cmake_minimum_required(VERSION 3.22...3.25)
include("${CMAKE_CURRENT_LIST_DIR}/Run.cmake")

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}/src")
file(CREATE_LINK "${SOURCE_DIR}" "${WORK_DIR}/src/specplan" SYMBOLIC)
run("${CMAKE_COMMAND}" -E chdir "${WORK_DIR}" "${COLCON}" --log-base "${WORK_DIR}/log" build
  --paths "${WORK_DIR}/src/specplan"
  --build-base "${WORK_DIR}/build"
  --install-base "${WORK_DIR}/install"
  --cmake-args -D SPECPLAN_BUILD_PLANNER=OFF -D BUILD_TESTING=OFF -D CMAKE_BUILD_TYPE=Debug -D CMAKE_UNITY_BUILD=ON
)
set(prefix "${WORK_DIR}/install/specplan")
foreach(file share/specplan/package.xml share/ament_index/resource_index/packages/specplan include/specplan/Version.h)
  if(NOT EXISTS "${prefix}/${file}")
    message(FATAL_ERROR "colcon build left no ${file}")
  endif()
endforeach()
if(EXISTS "${WORK_DIR}/build/specplan/test")
  message(FATAL_ERROR "BUILD_TESTING=OFF, but tests were built")
endif()
