# SPDX-License-Identifier: GPL-3.0-or-later
# Finds the folder of libmeshlab-common.so in the pymeshlab of a Python, unless it is given.

if(NEURALMESH_HOST STREQUAL "pymeshlab")
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    if(NOT PYMESHLAB_LIB_DIR)
        execute_process(
            COMMAND "${Python3_EXECUTABLE}" -c
                "from importlib.util import find_spec; print(find_spec('pymeshlab').origin, end='')"
            OUTPUT_VARIABLE pymeshlab_init
            RESULT_VARIABLE failed)
        if(failed)
            message(FATAL_ERROR
                "${Python3_EXECUTABLE} has no pymeshlab: give the folder of its libraries with "
                "-DPYMESHLAB_LIB_DIR=FOLDER, or another Python with -DPython3_EXECUTABLE=FILE.")
        endif()
        cmake_path(GET pymeshlab_init PARENT_PATH pymeshlab_folder)
        set_property(CACHE PYMESHLAB_LIB_DIR PROPERTY VALUE "${pymeshlab_folder}/lib")
    endif()
endif()
