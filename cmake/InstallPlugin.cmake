# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install BUILD` puts the plugin where its host looks at its start: for the desktop the
# user's folder of extra plugins, for PyMeshLab the plugin folder of the installed wheel. Inside
# `pip install .` (scikit-build-core) it goes into our own Python package, with its type stub.

# Where Qt's AppDataLocation is, which MeshLab asks for, and where PyMeshLab has its plugins.
set(pymeshlab_plugins "${PYMESHLAB_LIB_DIR}/plugins")
if(WIN32)
    file(TO_CMAKE_PATH "$ENV{APPDATA}" user_data)
elseif(APPLE)
    set(user_data "$ENV{HOME}/Library/Application Support")
    set(pymeshlab_plugins "${PYMESHLAB_LIB_DIR}/../PlugIns")
elseif(DEFINED ENV{XDG_DATA_HOME})
    set(user_data "$ENV{XDG_DATA_HOME}")
else()
    set(user_data "$ENV{HOME}/.local/share")
endif()
set(extra_plugins "${user_data}/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins/${MESHLAB_VERSION}")

if(DEFINED SKBUILD)
    set(destination pymeshlab_neuralmesh)
    set(stub "${CMAKE_CURRENT_BINARY_DIR}/__init__.pyi")
    set(python_sources "${CMAKE_SOURCE_DIR}/python")
    add_custom_command(OUTPUT "${stub}"
        COMMAND "${Python3_EXECUTABLE}" "${python_sources}/make_stub.py"
            "$<TARGET_FILE:filter_neuralmesh>" "${stub}"
        DEPENDS filter_neuralmesh "${python_sources}/make_stub.py"
            "${python_sources}/pymeshlab_neuralmesh/_documentation.py")
    add_custom_target(stub ALL DEPENDS "${stub}")
    install(FILES "${stub}" DESTINATION "${destination}")
elseif(NEURALMESH_HOST STREQUAL "meshlab")
    set(destination "${extra_plugins}")
else()
    set(destination "${pymeshlab_plugins}")
endif()
set(NEURALMESH_INSTALL_DIR "${destination}" CACHE PATH "Where cmake --install puts the plugin")
install(TARGETS filter_neuralmesh LIBRARY DESTINATION "${NEURALMESH_INSTALL_DIR}")
