# Finds every library of the project. All are Debian 12 packages.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(CGAL 5.5 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(embree 3 REQUIRED)
find_package(TBB REQUIRED)
find_package(hwy REQUIRED)
find_package(nanoflann 1.4 REQUIRED)
find_path(SPECTRA_INCLUDE_DIR Spectra/SymEigsShiftSolver.h DOC "Spectra 1.0 or later (Debian: libspectra-dev)" REQUIRED)
find_package(OpenMesh REQUIRED CONFIG) # not CGAL's FindOpenMesh
find_package(nlohmann_json 3.11 REQUIRED)
find_package(valijson REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(LibArchive REQUIRED)
find_path(SHAPEGAUGE_MATIO_INCLUDE matio.h DOC "matio.h (Debian: libmatio-dev)" NO_CACHE REQUIRED)
find_path(SHAPEGAUGE_CAIRO_INCLUDE cairo.h PATH_SUFFIXES cairo DOC "cairo.h (Debian: libcairo2-dev)" REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
if(SHAPEGAUGE_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
# C interface of MPI only: the C++ bindings were removed from the standard, and Open MPI's headers of them cause
# warnings.
set(MPI_CXX_SKIP_MPICXX ON)
if(SHAPEGAUGE_MPI STREQUAL "AUTO")
  find_package(MPI QUIET COMPONENTS CXX)
  if(NOT MPI_CXX_FOUND)
    message(STATUS "No MPI found: runs of several processes are left out (SHAPEGAUGE_MPI)")
  endif()
elseif(SHAPEGAUGE_MPI)
  find_package(MPI REQUIRED COMPONENTS CXX)
endif()
# D3, for the charts of reports: one JavaScript file, embedded in the program.
find_file(SHAPEGAUGE_D3_FILE d3.min.js PATHS /usr/share/nodejs/d3/dist /usr/share/javascript/d3
          DOC "d3.min.js of D3 5 or later (Debian: node-d3)" NO_CACHE REQUIRED)
# three.js, for interactive 3D views: one JavaScript file, embedded in the program.
find_file(SHAPEGAUGE_THREE_FILE three.min.js PATHS /usr/share/javascript/three /usr/share/nodejs/three/build
          DOC "three.min.js of three.js, release 110 to 150 (Debian: libjs-three)" NO_CACHE REQUIRED)
# esbuild, which bundles the scripts of HTML pages.
find_program(SHAPEGAUGE_ESBUILD esbuild DOC "esbuild 0.12 or later (Debian: esbuild)" REQUIRED)
if(SHAPEGAUGE_BUILD_TESTS)
  find_program(SHAPEGAUGE_NODE NAMES node nodejs DOC "Node.js 18 or later, which runs the tests of scripts (Debian: nodejs)"
               REQUIRED)
endif()
