# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFILES=<name=path;...> -DOUTPUT=<source> -P WritePageFiles.cmake: writes the functions of page_files
# (html_page.h), each of which returns the text of a file. A library has its licence in front: <name=licence|path>.
set(source "#include \"shapegauge/pages/html_page.h\"\n\nnamespace shapegauge::page_files {\n")
foreach(file IN LISTS FILES)
  string(REGEX MATCH "^([^=]*)=([^|]*)[|]?(.*)$" file "${file}")
  file(READ "${CMAKE_MATCH_2}" text)
  if(CMAKE_MATCH_3)
    file(READ "${CMAKE_MATCH_3}" library)
    set(text "/*\n${text}*/\n${library}")
  endif()
  string(APPEND source "\nstd::string_view ${CMAKE_MATCH_1}() {\n  return R\"~~~~(${text})~~~~\";\n}\n")
endforeach()
file(WRITE "${OUTPUT}" "${source}\n}  // namespace shapegauge::page_files\n")
