# How specplan's own targets are compiled. Nothing here reaches a target of a project that includes or links specplan.

# specplan_warnings(TARGET): the project's warnings, private to TARGET.
function(specplan_warnings target)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    return()
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wswitch-enum
    $<$<BOOL:${SPECPLAN_WERROR}>:-Werror>
  )
  # GCC 12 reports overlaps in std::string's operator+ that do not exist (GCC bug 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
endfunction()

# specplan_add_directories(DIR...): adds each folder that has a CMakeLists.txt.
function(specplan_add_directories)
  foreach(directory IN LISTS ARGN)
    if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${directory}/CMakeLists.txt")
      add_subdirectory(${directory})
    endif()
  endforeach()
endfunction()

# specplan_embed(TARGET HEADER NAME FILE): the text of FILE as specplan::command::NAME, which HEADER declares, in TARGET; empty if
# FILE is.
function(specplan_embed target header name file)
  set(script "${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  add_custom_command(OUTPUT "${source}"
    COMMAND ${CMAKE_COMMAND} -D "INPUT=${file}" -D "HEADER=${header}" -D NAME=${name} -D "OUTPUT=${source}" -P "${script}"
    DEPENDS ${file} "${script}"
    VERBATIM
  )
  target_sources(${target} PRIVATE "${source}")
  set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# A sanitizer has to see every object of a program, so its flags hold for all targets from here down.
set(SPECPLAN_SANITIZE_FLAGS "")
if(SPECPLAN_SANITIZE STREQUAL "address")
  set(SPECPLAN_SANITIZE_FLAGS -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
elseif(SPECPLAN_SANITIZE STREQUAL "thread")
  set(SPECPLAN_SANITIZE_FLAGS -fsanitize=thread -fno-omit-frame-pointer)
elseif(SPECPLAN_SANITIZE)
  message(FATAL_ERROR "SPECPLAN_SANITIZE is \"${SPECPLAN_SANITIZE}\"; it must be empty, address or thread")
endif()
add_compile_options(${SPECPLAN_SANITIZE_FLAGS})
add_link_options(${SPECPLAN_SANITIZE_FLAGS})
