# Looks for three.js, which `specplan plan --html` puts into its pages: SPECPLAN_HAS_THREE_JS. Its orbit control is a file of its own.
find_file(SPECPLAN_THREE_JS three.min.js
  PATHS /usr/share/javascript/three /usr/local/share/javascript/three
  DOC "three.js as a plain script, for specplan plan --html; Debian and Ubuntu: libjs-three"
)
set(SPECPLAN_HAS_THREE_JS FALSE)
if(SPECPLAN_THREE_JS)
  get_filename_component(_specplan_three_dir "${SPECPLAN_THREE_JS}" DIRECTORY)
  set(SPECPLAN_ORBIT_CONTROLS_JS "${_specplan_three_dir}/examples/js/controls/OrbitControls.js")
  if(EXISTS "${SPECPLAN_THREE_JS}" AND EXISTS "${SPECPLAN_ORBIT_CONTROLS_JS}")
    set(SPECPLAN_HAS_THREE_JS TRUE)
  endif()
  unset(_specplan_three_dir)
endif()
if(NOT SPECPLAN_HAS_THREE_JS)
  message(STATUS "three.js (libjs-three) not found: specplan plan is built without --html")
endif()
