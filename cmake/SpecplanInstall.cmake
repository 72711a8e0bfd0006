# What `cmake --install` puts where. Every destination is relative, so a prefix and DESTDIR both work. Components: runtime is what
# programs and people run, dev what builds with specplan.
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)
set(specplan_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/specplan")
set(specplan_data_dir "${CMAKE_INSTALL_DATADIR}/specplan")

# Installed programs and libraries find each other wherever the prefix is, and OMPL where it was found.
if(APPLE)
  set(specplan_here "@loader_path")
else()
  set(specplan_here "$ORIGIN")
endif()
file(RELATIVE_PATH specplan_bin_to_lib "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")

# specplan_install_libraries(EXPORT TARGET...): libraries, exported together.
function(specplan_install_libraries export)
  set_target_properties(${ARGN} PROPERTIES
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "${specplan_here}"
    INSTALL_RPATH_USE_LINK_PATH ON
  )
  install(TARGETS ${ARGN} EXPORT ${export}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
  )
  install(EXPORT ${export} NAMESPACE specplan:: DESTINATION ${specplan_config_dir} COMPONENT dev)
endfunction()

# A static planner links the core, which its public header does not show, so both are exported.
specplan_install_libraries(specplanCoreTargets specplan_core)
set(specplan_private_headers "")
if(TARGET specplan_planner)
  specplan_install_libraries(specplanPlannerTargets specplan_planner)
else()
  list(APPEND specplan_private_headers PATTERN planner EXCLUDE)
endif()
if(TARGET specplan_fcl)
  specplan_install_libraries(specplanFclTargets specplan_fcl specplan_problems)
else()
  list(APPEND specplan_private_headers PATTERN problems EXCLUDE)
endif()
foreach(folder "${PROJECT_SOURCE_DIR}/include/specplan" "${PROJECT_BINARY_DIR}/include/specplan")
  install(DIRECTORY "${folder}" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
    FILES_MATCHING PATTERN "*.h"
    ${specplan_private_headers}
  )
endforeach()

# The command. It has the name of the library specplan::specplan and is not exported.
if(TARGET specplan)
  set_target_properties(specplan PROPERTIES
    INSTALL_RPATH "${specplan_here}/${specplan_bin_to_lib}"
    INSTALL_RPATH_USE_LINK_PATH ON
  )
  install(TARGETS specplan RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
  if(EXISTS "${PROJECT_SOURCE_DIR}/demos/scenes")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/demos/scenes/" DESTINATION ${specplan_data_dir}/scenes COMPONENT runtime)
  endif()
endif()

# The CMake package.
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/specplanConfig.cmake.in" "${PROJECT_BINARY_DIR}/specplanConfig.cmake"
  INSTALL_DESTINATION ${specplan_config_dir}
)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/specplanConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/specplanConfig.cmake"
  "${PROJECT_BINARY_DIR}/specplanConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/OmplTarget.cmake"
  DESTINATION ${specplan_config_dir} COMPONENT dev
)

include(SpecplanPkgConfig)

# What ROS looks for: the package's description, and the mark that it lies under this prefix.
install(FILES "${PROJECT_SOURCE_DIR}/package.xml" DESTINATION ${specplan_data_dir} COMPONENT dev)
file(WRITE "${PROJECT_BINARY_DIR}/ament/specplan" "")
install(FILES "${PROJECT_BINARY_DIR}/ament/specplan"
  DESTINATION ${CMAKE_INSTALL_DATADIR}/ament_index/resource_index/packages COMPONENT dev
)
# Two packages cannot hold the same file.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/specplan COMPONENT runtime)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libspecplan-dev COMPONENT dev)
