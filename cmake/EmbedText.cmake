# cmake -D INPUT=FILE -D HEADER=HEADER -D NAME=NAME -D OUTPUT=FILE.cpp -P EmbedText.cmake
# Writes a source that defines specplan::command::NAME, declared in HEADER, with the text of INPUT; empty if INPUT is.
set(text "")
if(INPUT)
  file(READ "${INPUT}" text)
endif()
file(WRITE "${OUTPUT}" "// Written by EmbedText.cmake.
#include \"${HEADER}\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace specplan::command
{
namespace
{
constexpr char ${NAME}Text[] = R\"embedded(${text})embedded\";
}

constinit const std::string_view ${NAME}(${NAME}Text, sizeof(${NAME}Text) - 1);
}  // namespace specplan::command
")
