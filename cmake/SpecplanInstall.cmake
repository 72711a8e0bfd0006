# What `cmake --install` puts where. Every destination is relative, so a prefix and DESTDIR both work.
include(CMakePackageConfigHelpers)

set(specplan_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/specplan")
set(specplan_data_dir "${CMAKE_INSTALL_DATADIR}/specplan")

# Libraries. A static planner links the core, which its public header does not show, so both are exported.
set(specplan_libraries specplan_core)
if(TARGET specplan_planner)
  list(APPEND specplan_libraries specplan_planner)
endif()
set_target_properties(${specplan_libraries} PROPERTIES
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  INSTALL_RPATH "$ORIGIN"
)
install(TARGETS ${specplan_libraries}
  EXPORT specplanTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
)
set(specplan_private_headers "")
if(TARGET specplan_fcl)
  set_target_properties(specplan_fcl PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set_target_properties(specplan_fcl PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(TARGETS specplan_fcl specplan_problems
    EXPORT specplanFclTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  )
  install(EXPORT specplanFclTargets NAMESPACE specplan:: DESTINATION ${specplan_config_dir})
else()
  list(APPEND specplan_private_headers PATTERN problems EXCLUDE)
endif()
if(NOT TARGET specplan_planner)
  list(APPEND specplan_private_headers PATTERN planner EXCLUDE)
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/specplan"
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h"
  ${specplan_private_headers}
)

# The command. It has the name of the library specplan::specplan and is not exported.
if(TARGET specplan)
  file(RELATIVE_PATH specplan_bin_to_lib "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
  set_target_properties(specplan PROPERTIES INSTALL_RPATH "$ORIGIN/${specplan_bin_to_lib}")
  install(TARGETS specplan RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

# The CMake package.
install(EXPORT specplanTargets NAMESPACE specplan:: DESTINATION ${specplan_config_dir})
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/specplanConfig.cmake.in" "${PROJECT_BINARY_DIR}/specplanConfig.cmake"
  INSTALL_DESTINATION ${specplan_config_dir}
)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/specplanConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/specplanConfig.cmake"
  "${PROJECT_BINARY_DIR}/specplanConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/OmplTarget.cmake"
  DESTINATION ${specplan_config_dir}
)

# Data.
install(FILES "${PROJECT_SOURCE_DIR}/package.xml" DESTINATION ${specplan_data_dir})
if(TARGET specplan AND EXISTS "${PROJECT_SOURCE_DIR}/demos/scenes")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/demos/scenes/" DESTINATION ${specplan_data_dir}/scenes)
endif()
