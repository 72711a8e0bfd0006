# Writes and installs specplan-core.pc and, with the planner, specplan.pc. Prefix and folders are relative to the file, so that the
# installed package may be moved.
set(specplan_pkgconfig_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH specplan_pc_prefix "/${specplan_pkgconfig_dir}" "/")
string(REGEX REPLACE "/$" "" specplan_pc_prefix "${specplan_pc_prefix}")

# A static planner leaves the core to link.
set(specplan_pc_libs "-lspecplan_planner")
get_target_property(specplan_core_type specplan_core TYPE)
if(specplan_core_type STREQUAL "STATIC_LIBRARY")
  string(APPEND specplan_pc_libs " -lspecplan_core")
endif()

# OMPL's own file would do, but before 1.7 it asks for C++14 and for libraries that need not be there.
set(specplan_pc_requires "")
set(specplan_pc_ompl_cflags "")
set(specplan_pc_ompl_libs "")
if(SPECPLAN_BUILD_PLANNER)
  math(EXPR specplan_next_minor "${SPECPLAN_OMPL_VERSION_MINOR} + 1")
  if(SPECPLAN_OMPL_VERSION VERSION_LESS 1.7)
    set(specplan_pc_requires "eigen3")
    foreach(directory IN LISTS OMPL_INCLUDE_DIRS)
      if(NOT directory STREQUAL "" AND NOT directory STREQUAL "/usr/include")
        string(APPEND specplan_pc_ompl_cflags " -I${directory}")
      endif()
    endforeach()
    foreach(library IN LISTS OMPL_LIBRARIES)
      if(IS_ABSOLUTE "${library}" AND EXISTS "${library}")
        string(APPEND specplan_pc_ompl_libs " ${library}")
      endif()
    endforeach()
  else()
    set(specplan_pc_requires
      "ompl >= ${SPECPLAN_OMPL_SERIES}, ompl < ${SPECPLAN_OMPL_VERSION_MAJOR}.${specplan_next_minor}"
    )
  endif()
endif()

set(specplan_pc_names specplan-core)
if(SPECPLAN_BUILD_PLANNER)
  list(APPEND specplan_pc_names specplan)
endif()
foreach(name IN LISTS specplan_pc_names)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/templates/${name}.pc.in" "${PROJECT_BINARY_DIR}/${name}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION ${specplan_pkgconfig_dir} COMPONENT dev)
endforeach()
