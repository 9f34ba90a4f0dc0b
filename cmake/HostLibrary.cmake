# SPDX-License-Identifier: GPL-3.0-or-later
# What systems differ in when a plugin is linked: link_with_host(TARGET). Needs Qt5 to be found.
#
# Linux: the plugin names the host's library, which is loaded already: PyMeshLab's interpreter has it
# privately, so that a plugin has to name it to see it, and only a plugin that finds it can be told
# that it has the wrong precision. An empty library of that name does for the linker. Of Qt, headers
# are enough.
#
# Windows and macOS: the linker wants every symbol, so MESHLAB_COMMON_LIBRARY is the library (on
# Windows its import library) that MeshLab's own build makes of the same sources in the same
# precision, and Qt is linked. .github/workflows/plugins.yml shows how.

set(MESHLAB_COMMON_LIBRARY "" CACHE FILEPATH
    "MeshLab's library meshlab-common, which Windows and macOS link the plugin with")

function(link_with_host target)
    set(components Core Gui Widgets OpenGL Xml Network)
    if(WIN32 OR APPLE)
        if(NOT EXISTS "${MESHLAB_COMMON_LIBRARY}")
            message(FATAL_ERROR
                "MESHLAB_COMMON_LIBRARY is '${MESHLAB_COMMON_LIBRARY}', which is no file. Build "
                "meshlab-common of MeshLab ${MESHLAB_VERSION} and give it.")
        endif()
        list(TRANSFORM components PREPEND Qt5::)
        target_link_libraries(${target} PRIVATE "${MESHLAB_COMMON_LIBRARY}" ${components})
        # Beside the host's libraries, where the host itself puts its plugins.
        set_target_properties(${target} PROPERTIES
            SKIP_BUILD_RPATH OFF
            BUILD_WITH_INSTALL_RPATH ON
            INSTALL_RPATH "@loader_path/../Frameworks")
        return()
    endif()
    foreach(component ${components})
        target_include_directories(${target} SYSTEM PRIVATE ${Qt5${component}_INCLUDE_DIRS})
    endforeach()
    file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/empty.cpp" "")
    add_library(host_library SHARED "${CMAKE_CURRENT_BINARY_DIR}/empty.cpp")
    set_target_properties(host_library PROPERTIES OUTPUT_NAME meshlab-common)
    target_link_libraries(${target} PRIVATE host_library)
    target_link_options(${target} PRIVATE -Wl,--no-as-needed -Wl,--allow-shlib-undefined)
endfunction()
