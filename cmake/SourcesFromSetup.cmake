# SPDX-License-Identifier: GPL-3.0-or-later
# Where no folder of MeshLab's or muParser's sources is given: asks scripts/setup, which knows the
# environment, the cache, and where else to get them.

foreach(package meshlab muparser)
    string(TOUPPER ${package}_SOURCE_DIR variable)
    if(NOT ${variable} AND NOT (package STREQUAL "meshlab" AND VCGLIB_DIR))
        execute_process(
            COMMAND "${PROJECT_SOURCE_DIR}/scripts/setup" --print-${package}-source
            OUTPUT_VARIABLE folder
            OUTPUT_STRIP_TRAILING_WHITESPACE
            RESULT_VARIABLE failed)
        if(NOT failed)
            set_property(CACHE ${variable} PROPERTY VALUE "${folder}")
        endif()
    endif()
endforeach()
