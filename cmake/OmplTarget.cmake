# Of the OMPL that find_package(ompl) has found: its version, SPECPLAN_OMPL_VERSION with _MAJOR and _MINOR, and the target
# ompl::ompl. What is wrong with it, in one line: SPECPLAN_OMPL_ERROR; empty if nothing is. Specplan's own build and the installed
# package both use this.
#
# OMPL exports that target from 1.7 on. Before, it only sets OMPL_INCLUDE_DIRS and OMPL_LIBRARIES, and there OMPL_LIBRARIES names
# libraries that a distribution need not install for developers (a bare "ode", Boost's unversioned libraries). libompl itself
# records what it needs, so the others are linked only where they are present: Boost.Serialization, for instance, is wanted by
# programs that use ompl::base::PlannerDataStorage.
set(SPECPLAN_OMPL_ERROR "")
set(SPECPLAN_OMPL_VERSION "${ompl_VERSION}")
if(NOT SPECPLAN_OMPL_VERSION)
  set(SPECPLAN_OMPL_VERSION "${OMPL_VERSION}")
endif()
if(SPECPLAN_OMPL_VERSION MATCHES "^([0-9]+)\\.([0-9]+)")
  set(SPECPLAN_OMPL_VERSION_MAJOR "${CMAKE_MATCH_1}")
  set(SPECPLAN_OMPL_VERSION_MINOR "${CMAKE_MATCH_2}")
endif()
if(SPECPLAN_OMPL_VERSION VERSION_LESS 1.5)
  set(SPECPLAN_OMPL_ERROR "specplan needs OMPL 1.5 or newer, but OMPL \"${SPECPLAN_OMPL_VERSION}\" was found in ${ompl_DIR}")
  return()
endif()
if(TARGET ompl::ompl)
  return()
endif()

# Directories of imported targets are system directories; /usr/include as one of them breaks the compiler's #include_next.
set(_specplan_ompl_include_dirs ${OMPL_INCLUDE_DIRS})
list(REMOVE_ITEM _specplan_ompl_include_dirs "" /usr/include)

set(_specplan_ompl_libraries "")
foreach(_specplan_library IN LISTS OMPL_LIBRARIES)
  if(TARGET ${_specplan_library} OR (IS_ABSOLUTE "${_specplan_library}" AND EXISTS "${_specplan_library}"))
    list(APPEND _specplan_ompl_libraries "${_specplan_library}")
  endif()
endforeach()
if(_specplan_ompl_libraries)
  add_library(ompl::ompl INTERFACE IMPORTED)
  set_target_properties(ompl::ompl PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${_specplan_ompl_include_dirs}"
    INTERFACE_LINK_LIBRARIES "${_specplan_ompl_libraries}"
  )
else()
  set(SPECPLAN_OMPL_ERROR
    "OMPL ${SPECPLAN_OMPL_VERSION} in ${ompl_DIR} names no library that exists: \"${OMPL_LIBRARIES}\""
  )
endif()
unset(_specplan_ompl_include_dirs)
unset(_specplan_ompl_libraries)
unset(_specplan_library)
