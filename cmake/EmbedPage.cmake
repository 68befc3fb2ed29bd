# SPDX-License-Identifier: BSD-3-Clause
# Writes a page as C++ source: the function that STAGE/NAME.hpp declares. usage:
# cmake -D PAGE=FILE -D MARKER=WORD -D STAGE=STAGE -D NAME=FUNCTION -D OUTPUT=FILE -P EmbedPage.cmake
# @WORD@ is the place for the data of the page. Without PAGE, the page is empty. Compilers need not accept
# literals of more than 65536 bytes.
set(marker "@${MARKER}@")
set(piece_size 60000)

# Appends a list of raw literals. They are views of known size, since string_view would search for their end. The page
# is ASCII, so no cut divides a character.
function(append_pieces name text)
  string(LENGTH "${text}" length)
  set(pieces "constexpr std::string_view ${name}[] = {\"\"sv")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} ${piece_size} piece)
    string(APPEND pieces ",\nR\"page(${piece})page\"sv")
    math(EXPR at "${at} + ${piece_size}")
  endwhile()
  file(APPEND ${OUTPUT} "${pieces}};\n")
endfunction()

file(WRITE ${OUTPUT} "// Made by cmake/EmbedPage.cmake.\n#include \"${STAGE}/${NAME}.hpp\"\n\n"
  "namespace smurf {\nusing namespace std::string_view_literals;\n")
if(PAGE)
  file(READ ${PAGE} page)
  string(FIND "${page}" ${marker} middle)
  if(middle EQUAL -1)
    message(FATAL_ERROR "${PAGE} has no ${marker}")
  endif()
  string(LENGTH ${marker} marker_size)
  math(EXPR after "${middle} + ${marker_size}")
  string(SUBSTRING "${page}" 0 ${middle} head)
  string(SUBSTRING "${page}" ${after} -1 tail)
  file(APPEND ${OUTPUT} "namespace {\n")
  append_pieces(kHead "${head}")
  append_pieces(kTail "${tail}")
  file(APPEND ${OUTPUT} "}  // namespace\nEmbeddedPage ${NAME}() { return {kHead, kTail}; }\n")
else()
  file(APPEND ${OUTPUT} "EmbeddedPage ${NAME}() { return {}; }\n")
endif()
file(APPEND ${OUTPUT} "}  // namespace smurf\n")
