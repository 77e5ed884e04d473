# SPDX-License-Identifier: GPL-3.0-or-later
# shapegauge_include_folder(TARGET FOLDER): the target includes headers of the folder as "FOLDER/...". Nothing else of the
# project is reachable through its include directory, <build>/include/FOLDER.
function(shapegauge_include_folder target folder)
  set(include_root ${PROJECT_BINARY_DIR}/include/${folder})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${include_root}/${folder} SYMBOLIC)
  target_include_directories(${target} PUBLIC ${include_root})
endfunction()

# shapegauge_add_library(NAME FOLDER [INTERNAL] [SOURCES sources...] [USES targets...] [USES_PRIVATELY targets...]
# [PRIVATE_HEADERS headers...]): the library shapegauge_NAME, alias shapegauge::NAME, of sources in a folder of the
# project and those below it, and its installation. INTERNAL: it is not installed. PRIVATE_HEADERS: headers that only its
# own sources and tests include; they are not installed.
#
# A library has the headers of its sources' folders. It sees those of the libraries that it uses and no others: each
# library's headers are reachable only through an include directory of its own, <build>/include/NAME, which has a link
# to each. An include across a border that docs/developer/architecture.md does not have is therefore a build error
# (tests/borders).
function(shapegauge_add_library name folder)
  cmake_parse_arguments(arg "INTERNAL" "" "SOURCES;USES;USES_PRIVATELY;PRIVATE_HEADERS" ${ARGN})
  add_library(shapegauge_${name} STATIC)
  add_library(shapegauge::${name} ALIAS shapegauge_${name})
  set(source_folders ${PROJECT_SOURCE_DIR}/${folder})
  foreach(source IN LISTS arg_SOURCES)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} NORMALIZE)
    target_sources(shapegauge_${name} PRIVATE ${source})
    cmake_path(GET source PARENT_PATH source_folder)
    list(APPEND source_folders ${source_folder})
  endforeach()
  target_link_libraries(shapegauge_${name} PUBLIC ${arg_USES} PRIVATE ${arg_USES_PRIVATELY})
  set_target_properties(shapegauge_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  shapegauge_configure_target(shapegauge_${name})
  shapegauge_precompile_headers(shapegauge_${name})

  set_property(GLOBAL APPEND PROPERTY SHAPEGAUGE_LIBRARIES ${name})
  set(include_root ${PROJECT_BINARY_DIR}/include/${name})
  file(REMOVE_RECURSE ${include_root})
  file(MAKE_DIRECTORY ${include_root})
  target_include_directories(shapegauge_${name} PUBLIC $<BUILD_INTERFACE:${include_root}>
                                                       $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # Highway includes a source once for each instruction set, by its name.
  foreach(source IN LISTS arg_SOURCES)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} NORMALIZE)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name_there)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${name_there} OR name_there MATCHES "^\\.\\.")
      continue() # made by the build
    endif()
    cmake_path(GET name_there PARENT_PATH source_folder)
    file(MAKE_DIRECTORY ${include_root}/shapegauge/${source_folder})
    file(CREATE_LINK ${source} ${include_root}/shapegauge/${name_there} SYMBOLIC)
  endforeach()
  list(REMOVE_DUPLICATES source_folders)
  foreach(source_folder IN LISTS source_folders)
    file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${source_folder}/*.h)
    foreach(header IN LISTS headers)
      cmake_path(GET header PARENT_PATH header_folder)
      file(MAKE_DIRECTORY ${include_root}/shapegauge/${header_folder})
      file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${header} ${include_root}/shapegauge/${header} SYMBOLIC)
      set_property(GLOBAL PROPERTY SHAPEGAUGE_HEADER_OF_${name} shapegauge/${header})
      cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${folder} OUTPUT_VARIABLE header_in_library)
      if(NOT arg_INTERNAL AND NOT header_in_library IN_LIST arg_PRIVATE_HEADERS)
        set_property(GLOBAL APPEND PROPERTY SHAPEGAUGE_INSTALLED_HEADERS ${PROJECT_SOURCE_DIR}/${header})
        install(FILES ${PROJECT_SOURCE_DIR}/${header} COMPONENT development
                DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/shapegauge/${header_folder})
      endif()
    endforeach()
  endforeach()
  if(NOT arg_INTERNAL)
    install(TARGETS shapegauge_${name} EXPORT shapegauge ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            COMPONENT development)
  endif()
endfunction()
# Settings of all targets of the project: language standard, warnings, sanitizers and, if enabled, unity batches. Names
# in anonymous namespaces must therefore differ within a target.
function(shapegauge_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF UNITY_BUILD ${SHAPEGAUGE_UNITY_BUILD}
                                             UNITY_BUILD_BATCH_SIZE 24)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast
                                           -Wcast-align -Woverloaded-virtual
                                           $<$<BOOL:${SHAPEGAUGE_WARNINGS_AS_ERRORS}>:-Werror>)
  if(SHAPEGAUGE_UNITY_BUILD)
    # Shadowing of names between the sources of a batch is harmless.
    target_compile_options(${target} PRIVATE -Wno-shadow)
  endif()
  # GCC collects its garbage less often: a tenth less time, a tenth more memory.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=500000>)
  # Warnings that GCC bases on its optimiser are wrong in code inlined from libraries, and differ between its versions
  # (such as GCC bug 105651); Clang and the sanitizers look for the same faults.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
                                             -Wno-maybe-uninitialized -Wno-free-nonheap-object)
    # References to entries of registries, found by the name in a temporary string.
    if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
      target_compile_options(${target} PRIVATE -Wno-dangling-reference)
    endif()
  endif()
  # A page is one literal, longer than the minimum that the standard requires of compilers.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(${target} PRIVATE -Wno-overlength-strings)
  endif()
  if(SHAPEGAUGE_SANITIZE)
    target_compile_options(
      ${target}
      PUBLIC -fsanitize=${SHAPEGAUGE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
             $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/tests/support/sanitizer_ignorelist.txt>)
    target_link_options(${target} PUBLIC -fsanitize=${SHAPEGAUGE_SANITIZE})
  endif()
endfunction()
# Less optimisation than CMake's -O3: -O1 for code without hot loops (options, messages, tables, JSON), which saves a third
# of the compile time, and -O2 for code whose hot loops are in other libraries or memory-bound.
function(shapegauge_optimise_little)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    shapegauge_precompile_headers(${target} -O1)
  endforeach()
endfunction()
function(shapegauge_optimise_moderately)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O2>)
  endforeach()
endfunction()
# The heaviest headers, parsed once for all targets of a build in batches, and once more for those at -O1
# (another argument), since GCC 13 and later refuse headers precompiled with more optimisation; the sources still include
# what they use. A compiler cache is more efficient without them.
function(shapegauge_precompile_headers target)
  if(NOT SHAPEGAUGE_UNITY_BUILD OR CMAKE_CXX_COMPILER_LAUNCHER OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  set(headers shapegauge_common_headers${ARGN})
  if(NOT TARGET ${headers})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/common_headers.cpp CONTENT "")
    add_library(${headers} OBJECT ${PROJECT_BINARY_DIR}/common_headers.cpp)
    shapegauge_configure_target(${headers})
    target_compile_options(${headers} PRIVATE $<$<CONFIG:Release>:${ARGN}>)
    set_target_properties(${headers} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${headers} PRIVATE Eigen3::Eigen TBB::tbb nlohmann_json::nlohmann_json)
    target_precompile_headers(${headers} PRIVATE <Eigen/Dense> <Eigen/SparseCore> <nlohmann/json.hpp>
                              <tbb/parallel_for.h> <tbb/parallel_reduce.h> <algorithm> <filesystem> <fstream>
                              <functional> <map> <memory> <mutex> <optional> <string> <vector>)
  endif()
  target_compile_options(${target} PRIVATE -fPIC) # as those headers are, also in programs
  target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()
