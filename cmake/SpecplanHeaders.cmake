# Headers that tell versions, written into the build folder.
set(SPECPLAN_OMPL_SERIES "")
configure_file("${PROJECT_SOURCE_DIR}/cmake/templates/Version.h.in" "${PROJECT_BINARY_DIR}/include/specplan/Version.h" @ONLY)
if(SPECPLAN_BUILD_PLANNER)
  set(SPECPLAN_OMPL_SERIES "${SPECPLAN_OMPL_VERSION_MAJOR}.${SPECPLAN_OMPL_VERSION_MINOR}")
  configure_file(
    "${PROJECT_SOURCE_DIR}/cmake/templates/BuiltWithOmpl.h.in" "${PROJECT_BINARY_DIR}/include/specplan/planner/BuiltWithOmpl.h" @ONLY
  )
endif()
