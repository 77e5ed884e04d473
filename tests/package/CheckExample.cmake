# cmake -DPAGE=... -DCONSUMER=... -P CheckExample.cmake: the page shows the consumer's sources, and the part of its
# CMakeLists.txt up to the first empty line after find_package, word for word.
file(READ ${PAGE} page)
file(READ ${CONSUMER}/measure_thickness.cpp thickness)
file(READ ${CONSUMER}/use_collection.cpp collection)
file(READ ${CONSUMER}/CMakeLists.txt lists)
string(REGEX MATCH "cmake_minimum_required.*find_package[^\n]*\n([^\n]+\n)+" lists "${lists}")
foreach(shown IN ITEMS "${thickness}" "${collection}" "${lists}")
  string(FIND "${page}" "\n${shown}```" position)
  if(shown STREQUAL "" OR position EQUAL -1)
    message(FATAL_ERROR "${PAGE} does not show this as it stands in tests/package/consumer:\n${shown}")
  endif()
endforeach()
