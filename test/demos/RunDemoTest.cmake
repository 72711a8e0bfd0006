# Runs PROGRAM with the empty folder FOLDER as its argument. It has to end with 0, to print a line that says "Exact solution",
# and to leave FILES (a list) there: SVG pictures in which something is drawn.
file(REMOVE_RECURSE "${FOLDER}")
execute_process(
  COMMAND "${PROGRAM}" "${FOLDER}"
  RESULT_VARIABLE result
  OUTPUT_VARIABLE output
  ERROR_VARIABLE errors
)
message(STATUS "${output}${errors}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${result}")
endif()
if(NOT output MATCHES "Exact solution")
  message(FATAL_ERROR "${PROGRAM} does not tell of a solution")
endif()
foreach(name IN LISTS FILES)
  file(READ "${FOLDER}/${name}" picture)
  if(NOT picture MATCHES "^<svg .*<poly(line|gon) .*</svg>\n$")
    message(FATAL_ERROR "${name} is no picture")
  endif()
  if(picture MATCHES "nan|inf[^o]")
    message(FATAL_ERROR "${name} has coordinates that are no numbers")
  endif()
endforeach()
