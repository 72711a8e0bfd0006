# Running programs and looking at what they say, for tests written in CMake.

# run_any(COMMAND...): sets result and output, which is stdout and stderr together.
macro(run_any)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
endmacro()

function(expect_success)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}):\n${output}")
  endif()
endfunction()

# expect_failure(REGEX): the last command failed with this in its output, however its lines are broken.
function(expect_failure regex)
  string(REGEX REPLACE "[ \n]+" " " flat "${output}")
  if(result EQUAL 0)
    message(FATAL_ERROR "succeeded, but should have failed with \"${regex}\":\n${output}")
  elseif(NOT flat MATCHES "${regex}")
    message(FATAL_ERROR "failed without \"${regex}\":\n${output}")
  endif()
endfunction()

function(expect_no_output regex)
  string(REGEX REPLACE "-- (Build files|The CXX|Detecting|Check|Configuring|Generating)[^\n]*" "" rest "${output}")
  string(REGEX REPLACE "Not searching for unused variables[^\n]*" "" rest "${rest}")
  if(rest MATCHES "${regex}")
    message(FATAL_ERROR "says something about \"${regex}\":\n${rest}")
  endif()
endfunction()

# run(COMMAND...): the command has to succeed.
function(run)
  run_any(${ARGV})
  expect_success()
endfunction()
