# Packages by CPack: `cpack -G DEB` makes specplan (the command) and libspecplan-dev; `cpack -G TGZ` works anywhere. Debian's paths
# want CMAKE_INSTALL_PREFIX=/usr at configure time; scripts/package does all of it.
file(STRINGS "${PROJECT_SOURCE_DIR}/package.xml" specplan_maintainer REGEX "<maintainer ")
string(REGEX REPLACE ".*email=\"([^\"]*)\">([^<]*)<.*" "\\2 <\\1>" specplan_maintainer "${specplan_maintainer}")
set(CPACK_PACKAGE_NAME specplan)
set(CPACK_PACKAGE_VENDOR "specplan developers")
set(CPACK_PACKAGE_CONTACT "${specplan_maintainer}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_COMPONENTS_ALL runtime dev)
set(CPACK_STRIP_FILES ON)

set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME specplan)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "Plans on grid maps, for rigid bodies and for arms, and measures\nwhat speculative validity checks bring."
)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libspecplan-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers, libraries, CMake package and pkg-config files to build with specplan.")

# Headers and static libraries have no dependencies that dpkg-shlibdeps could see. An OMPL that is no package cannot be named.
set(specplan_deb_depends "")
get_target_property(specplan_core_type specplan_core TYPE)
if(specplan_core_type STREQUAL "SHARED_LIBRARY")
  list(APPEND specplan_deb_depends "specplan (= ${PROJECT_VERSION})")
endif()
if(SPECPLAN_BUILD_PLANNER AND ompl_DIR MATCHES "^/usr/(share|lib)/")
  math(EXPR specplan_next_minor "${SPECPLAN_OMPL_VERSION_MINOR} + 1")
  list(APPEND specplan_deb_depends
    "libompl-dev (>= ${SPECPLAN_OMPL_SERIES})" "libompl-dev (<< ${SPECPLAN_OMPL_VERSION_MAJOR}.${specplan_next_minor})"
  )
endif()
if(TARGET specplan_fcl)
  list(APPEND specplan_deb_depends libfcl-dev libassimp-dev libeigen3-dev)
  if(SPECPLAN_HAS_OCTOMAP)
    list(APPEND specplan_deb_depends liboctomap-dev)
  endif()
endif()
list(JOIN specplan_deb_depends ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
include(CPack)

# `check_packages` makes them, unpacks them into an empty folder and tries them; scripts/package and a test do that.
if(SPECPLAN_BUILD_PLANNER)
  set(SPECPLAN_CHECK_PACKAGES
    ${CMAKE_COMMAND}
    -D "SOURCE_DIR=${PROJECT_SOURCE_DIR}"
    -D "BINARY_DIR=${PROJECT_BINARY_DIR}"
    -D "WORK_DIR=${PROJECT_BINARY_DIR}/packages"
    -D "CXX_COMPILER=${CMAKE_CXX_COMPILER}"
    -D "GENERATOR=${CMAKE_GENERATOR}"
    -D "OMPL_DIR=${ompl_DIR}"
    -D "LIBDIR=${CMAKE_INSTALL_LIBDIR}"
    -D "PREFIX=${CMAKE_INSTALL_PREFIX}"
    -D "EXPECT_COMMAND=$<TARGET_EXISTS:specplan>"
    -D "EXPECT_FCL=$<TARGET_EXISTS:specplan_fcl>"
    -D "EXPECT_SHARED=$<STREQUAL:${specplan_core_type},SHARED_LIBRARY>"
    -P "${PROJECT_SOURCE_DIR}/test/packaging/DebianPackages.cmake"
  )
  add_custom_target(check_packages COMMAND ${SPECPLAN_CHECK_PACKAGES} VERBATIM)
endif()
