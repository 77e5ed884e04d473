# SPDX-License-Identifier: GPL-3.0-or-later
# Finds every library of the project. All are packages of Debian 12 and 13 (scripts/packages.txt). What is missing is
# reported at once, with the Debian packages that have it.
set(shapegauge_missing)
set(shapegauge_missing_packages)

# shapegauge_require(DEBIAN_PACKAGE NAME arguments...): find_package(NAME arguments...).
macro(shapegauge_require debian_package name)
  find_package(${name} ${ARGN} QUIET)
  shapegauge_check_found("${name}_FOUND" ${debian_package} "${name} ${ARGN}")
endmacro()

# shapegauge_require_file(DEBIAN_PACKAGE VARIABLE COMMAND arguments...): find_path, find_file, find_library or find_program.
macro(shapegauge_require_file debian_package variable command)
  cmake_language(CALL ${command} ${variable} ${ARGN})
  shapegauge_check_found(${variable} ${debian_package} "${ARGV3}")
endmacro()

macro(shapegauge_check_found found debian_package description)
  if(NOT ${found})
    string(STRIP "${description}" shapegauge_description)
    string(REPLACE ";" " " shapegauge_description "${shapegauge_description}")
    list(APPEND shapegauge_missing "${shapegauge_description} (Debian: ${debian_package})")
    list(APPEND shapegauge_missing_packages ${debian_package})
  endif()
endmacro()

shapegauge_require(libeigen3-dev Eigen3 3.4 NO_MODULE)
shapegauge_require(libcgal-dev CGAL)
if(CGAL_FOUND AND CGAL_VERSION VERSION_LESS 5.5)
  message(FATAL_ERROR "CGAL ${CGAL_VERSION} is too old: 5.5 or later is needed")
endif()
shapegauge_require(libboost-dev Boost 1.74 CONFIG)
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  shapegauge_require(libembree-dev embree 3)
endif()
shapegauge_require(libtbb-dev TBB)
shapegauge_require(libhwy-dev hwy)
shapegauge_require(libnanoflann-dev nanoflann 1.4)
shapegauge_require_file(libspectra-dev SPECTRA_INCLUDE_DIR find_path Spectra/SymEigsShiftSolver.h)
shapegauge_require(libopenmesh-dev OpenMesh CONFIG) # not CGAL's FindOpenMesh
shapegauge_require(nlohmann-json3-dev nlohmann_json 3.11)
shapegauge_require(libvalijson-dev valijson)
shapegauge_require(libcli11-dev CLI11 2.1)
shapegauge_require(libfmt-dev fmt 9)
shapegauge_require(libarchive-dev LibArchive)
shapegauge_require_file(libmatio-dev SHAPEGAUGE_MATIO_INCLUDE find_path matio.h)
shapegauge_require_file(libcairo2-dev SHAPEGAUGE_CAIRO_INCLUDE find_path cairo.h PATH_SUFFIXES cairo)
shapegauge_require(libssl-dev OpenSSL COMPONENTS Crypto)
shapegauge_require(libpng-dev PNG)
shapegauge_require(zlib1g-dev ZLIB)
shapegauge_require_file(libmaxflow-dev SHAPEGAUGE_MAXFLOW_INCLUDE_DIR find_path maxflow.h PATH_SUFFIXES maxflow-3.0 maxflow)
shapegauge_require_file(libmaxflow-dev SHAPEGAUGE_MAXFLOW_LIBRARY find_library maxflow)
# D3, for the charts of reports, and three.js, for interactive 3D views: JavaScript files, embedded in the program.
shapegauge_require_file(node-d3 SHAPEGAUGE_D3_FILE find_file d3.min.js
                        PATHS /usr/share/nodejs/d3/dist /usr/share/javascript/d3)
shapegauge_require_file(libjs-three SHAPEGAUGE_THREE_FILE find_file three.min.js
                        PATHS /usr/share/javascript/three /usr/share/nodejs/three/build)
# esbuild, which bundles the scripts of HTML pages.
shapegauge_require_file(esbuild SHAPEGAUGE_ESBUILD find_program esbuild)
# Packaged NumPy and pytest belong to the system's interpreter, which need not be the first in the PATH.
if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
if(SHAPEGAUGE_BUILD_PYTHON)
  shapegauge_require(python3-dev Python3 COMPONENTS Interpreter Development.Module)
  shapegauge_require(pybind11-dev pybind11 2.10)
endif()
if(SHAPEGAUGE_BUILD_TESTS)
  shapegauge_require("libgtest-dev;libgmock-dev" GTest)
  shapegauge_require(librapidcheck-dev rapidcheck)
  shapegauge_require_file(nodejs SHAPEGAUGE_NODE find_program node)
endif()
if(SHAPEGAUGE_BUILD_BENCHMARKS)
  shapegauge_require(libbenchmark-dev benchmark)
endif()

if(shapegauge_missing)
  list(REMOVE_DUPLICATES shapegauge_missing_packages)
  list(JOIN shapegauge_missing "\n  " shapegauge_missing)
  list(JOIN shapegauge_missing_packages " " shapegauge_missing_packages)
  message(FATAL_ERROR "Not found:\n  ${shapegauge_missing}\n"
                      "On Debian: apt-get install --no-install-recommends ${shapegauge_missing_packages}")
endif()
