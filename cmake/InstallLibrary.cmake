# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install BUILD --component library --prefix PREFIX` puts the core and the samplers, as
# static libraries with their public headers, where find_package(neuralmesh) finds them, and the
# licences of all that is compiled in, which ask to be beside every copy. Where a plugin is built,
# an installation without a component is the plugin's and leaves the library out.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(component COMPONENT library)
if(NOT NEURALMESH_HOST STREQUAL "none")
    list(APPEND component EXCLUDE_FROM_ALL)
endif()
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/neuralmesh")

set_target_properties(neuralmesh_core PROPERTIES EXPORT_NAME core)
set_target_properties(neuralmesh_samplers PROPERTIES EXPORT_NAME samplers)
set_target_properties(muparser PROPERTIES OUTPUT_NAME neuralmesh_muparser)
install(TARGETS neuralmesh_core neuralmesh_samplers muparser EXPORT neuralmesh
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" ${component}
    INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY include/neuralmesh DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" ${component})
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/THIRD_PARTY_NOTICES.txt"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/neuralmesh" ${component})
install(EXPORT neuralmesh NAMESPACE neuralmesh:: FILE neuralmesh-targets.cmake
    DESTINATION "${package_folder}" ${component})

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/neuralmesh-config.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/neuralmesh-config.cmake"
    INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/neuralmesh-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES
    "${CMAKE_CURRENT_BINARY_DIR}/neuralmesh-config.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/neuralmesh-config-version.cmake"
    DESTINATION "${package_folder}" ${component})
