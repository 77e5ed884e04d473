# SPDX-License-Identifier: GPL-3.0-or-later
# cpack -G DEB: the Debian packages shapegauge, libshapegauge-dev and python3-shapegauge
# (docs/install.md). Included last, as the variables must be there before CPack.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
if(SHAPEGAUGE_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "shapegauge developers <developers@shapegauge.invalid>")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(purpose
    "shapegauge measures the shape diameter function (thickness) of meshes and
point clouds, turns it into signatures, compares shapes by them, cuts shapes
into parts, and evaluates any retrieval method the way the SHREC contests do.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME shapegauge)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "${purpose}

This package has the program, its documentation and its configurations.")

# Measures need Eigen and TBB only; other libraries need more, which find_package(shapegauge) reports.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libshapegauge-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libtbb-dev (>= 2021)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
    "libarchive-dev, libboost-dev, libcairo2-dev, libcgal-dev (>= 5.5), libembree-dev (>= 3), libfmt-dev (>= 9), libhwy-dev, libmatio-dev, libmaxflow-dev, libnanoflann-dev, libopenmesh-dev, libpng-dev, libssl-dev, libtinygltf-dev, libvalijson-dev, nlohmann-json3-dev (>= 3.11), zlib1g-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "${purpose}

This package has the C++ libraries with their headers, and the CMake package.
The libraries of measures need what the package depends on, the others what it
recommends.")

if(SHAPEGAUGE_BUILD_PYTHON)
  math(EXPR next_python "${SHAPEGAUGE_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-shapegauge)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # The module is built for one minor version of Python, whose package has its interpreter for others beside it.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${SHAPEGAUGE_PYTHON_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
      "${purpose}

This package has the Python module, which works on NumPy arrays.")
endif()

# Files that Debian requires of every package: copyright and changelog.
set(debian_dir ${CMAKE_CURRENT_BINARY_DIR}/debian)
file(WRITE ${debian_dir}/changelog
     "shapegauge (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md in the package shapegauge.\n\n"
     " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  Thu, 01 Jan 1970 00:00:00 +0000\n")
if(SHAPEGAUGE_GZIP)
  execute_process(COMMAND ${SHAPEGAUGE_GZIP} -9nf ${debian_dir}/changelog)
endif()
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} name)
  set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME})
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/debian_copyright DESTINATION ${doc_dir} RENAME copyright COMPONENT ${component})
  install(FILES ${debian_dir}/changelog.gz DESTINATION ${doc_dir} COMPONENT ${component} OPTIONAL)
endforeach()

include(CPack)
