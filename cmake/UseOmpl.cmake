# Finds OMPL (1.5 to 2.0) for specplan's own build, says which one, and makes the target ompl::ompl.

# OMPL before 1.7 keeps what it found in the cache, where it would outlive a change of ompl_DIR.
if(DEFINED SPECPLAN_OMPL_DIR AND NOT "${ompl_DIR}" STREQUAL "${SPECPLAN_OMPL_DIR}")
  foreach(_specplan_variable OMPL_INCLUDE_DIRS OMPL_LIBRARY_DIRS OMPL_LIBRARIES OMPLAPPBASE_LIBRARY OMPLAPP_LIBRARY OMPLAPP_LIBRARIES)
    unset(${_specplan_variable} CACHE)
  endforeach()
  unset(_specplan_variable)
endif()

set(_specplan_had_ompl FALSE)
if(TARGET ompl::ompl)
  set(_specplan_had_ompl TRUE)
endif()
# No version here: OMPL's version file accepts the same major version only.
find_package(ompl REQUIRED CONFIG)
set(SPECPLAN_OMPL_DIR "${ompl_DIR}" CACHE INTERNAL "The OMPL that was found last")
include(OmplTarget)
if(SPECPLAN_OMPL_ERROR)
  message(FATAL_ERROR "${SPECPLAN_OMPL_ERROR}")
endif()
# A project that includes this one may name ompl::ompl too.
if(NOT _specplan_had_ompl)
  set_target_properties(ompl::ompl PROPERTIES IMPORTED_GLOBAL TRUE)
endif()
unset(_specplan_had_ompl)
message(STATUS "OMPL ${SPECPLAN_OMPL_VERSION} in ${ompl_DIR}")
