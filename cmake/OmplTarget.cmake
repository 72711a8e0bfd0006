# Finds OMPL (1.5 to 2.0) and makes sure that the target ompl::ompl exists.
#
# OMPL exports that target from 1.7 on. Before, it only sets OMPL_INCLUDE_DIRS and OMPL_LIBRARIES, and there OMPL_LIBRARIES names
# libraries that a distribution need not install for developers (a bare "ode", Boost's unversioned libraries). libompl itself
# records what it needs, so the others are linked only where they are present: Boost.Serialization, for instance, is wanted by
# programs that use ompl::base::PlannerDataStorage.

# No version here: OMPL's version file accepts the same major version only.
find_package(ompl REQUIRED CONFIG)

if(NOT DEFINED OMPL_VERSION)
  set(OMPL_VERSION "${ompl_VERSION}")
endif()
if(OMPL_VERSION VERSION_LESS 1.5)
  message(FATAL_ERROR "specplan needs OMPL 1.5 or newer, found \"${OMPL_VERSION}\" in ${ompl_DIR}")
endif()

if(NOT TARGET ompl::ompl)
  add_library(ompl::ompl INTERFACE IMPORTED)

  # Directories of imported targets are system directories; /usr/include as one of them breaks the compiler's #include_next.
  set(_specplan_ompl_include_dirs ${OMPL_INCLUDE_DIRS})
  list(REMOVE_ITEM _specplan_ompl_include_dirs "" /usr/include)

  set(_specplan_ompl_libraries "")
  foreach(_specplan_library IN LISTS OMPL_LIBRARIES)
    if(TARGET ${_specplan_library} OR (IS_ABSOLUTE "${_specplan_library}" AND EXISTS "${_specplan_library}"))
      list(APPEND _specplan_ompl_libraries "${_specplan_library}")
    endif()
  endforeach()
  if(NOT _specplan_ompl_libraries)
    message(FATAL_ERROR "OMPL ${OMPL_VERSION} in ${ompl_DIR} names no library that exists: \"${OMPL_LIBRARIES}\"")
  endif()

  set_target_properties(ompl::ompl PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${_specplan_ompl_include_dirs}"
    INTERFACE_LINK_LIBRARIES "${_specplan_ompl_libraries}"
  )
  unset(_specplan_ompl_include_dirs)
  unset(_specplan_ompl_libraries)
  unset(_specplan_library)
endif()
