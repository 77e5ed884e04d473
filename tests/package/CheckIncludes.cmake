# cmake -DINCLUDE=<installed include folder> -DLIBRARY=metrics -DALLOWED=<regular expression> -DCOMPILER=... -DEIGEN=...
#       -DWORK=... -P CheckIncludes.cmake: what the installed headers of a library include, directly or not, is its own,
# what is allowed of shapegauge, Eigen, TBB and the compiler's.
file(GLOB headers RELATIVE ${INCLUDE} ${INCLUDE}/shapegauge/${LIBRARY}/*.h)
if(NOT headers)
  message(FATAL_ERROR "there are no headers in ${INCLUDE}/shapegauge/${LIBRARY}")
endif()
set(source "")
foreach(header IN LISTS headers)
  string(APPEND source "#include \"${header}\"\n")
endforeach()
file(WRITE ${WORK}/includes_of_${LIBRARY}.cpp "${source}")
execute_process(COMMAND ${COMPILER} -std=c++20 -M -I ${INCLUDE} -isystem ${EIGEN} ${WORK}/includes_of_${LIBRARY}.cpp
                OUTPUT_VARIABLE included COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[\\\n ]+" ";" included "${included}")
foreach(file IN LISTS included)
  string(REPLACE "${INCLUDE}/" "" ours "${file}")
  if(ours MATCHES "^shapegauge/" AND NOT ours MATCHES "${ALLOWED}")
    message(FATAL_ERROR "the headers of ${LIBRARY} include ${ours}")
  endif()
  if(file MATCHES "/(CGAL|boost|embree3|OpenMesh|nlohmann|fmt|hwy|nanoflann|valijson|CLI|openssl)[/.]")
    message(FATAL_ERROR "the headers of ${LIBRARY} include ${file}")
  endif()
endforeach()
