# SPDX-License-Identifier: GPL-3.0-or-later
# CMake package: find_package(shapegauge) provides the libraries of docs/developer/architecture.md.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/shapegauge)
install(EXPORT shapegauge NAMESPACE shapegauge:: FILE shapegaugeTargets.cmake DESTINATION ${package_dir}
        COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/shapegaugeConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/shapegaugeConfig.cmake INSTALL_DESTINATION ${package_dir})
# Interfaces change with major versions only (docs/reference/stability.md).
write_basic_package_version_file(${PROJECT_BINARY_DIR}/shapegaugeConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/shapegaugeConfig.cmake ${PROJECT_BINARY_DIR}/shapegaugeConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT program)
