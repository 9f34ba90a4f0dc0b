# SPDX-License-Identifier: GPL-3.0-or-later
# Finds MeshLab's sources and their version; defines the interface library vcglib. Where no plugin is
# built, VCGlib alone does: VCGLIB_DIR.

if(VCGLIB_DIR)
    set(vcglib_folder "${VCGLIB_DIR}")
else()
    set(vcglib_folder "${MESHLAB_SOURCE_DIR}/src/vcglib")
endif()
if(NOT EXISTS "${vcglib_folder}/vcg/complex/complex.h")
    message(FATAL_ERROR
        "MESHLAB_SOURCE_DIR is '${MESHLAB_SOURCE_DIR}', where src/vcglib is not to be found. "
        "Run scripts/setup, or give the folder of MeshLab's sources with "
        "-DMESHLAB_SOURCE_DIR=FOLDER.")
endif()
if(NOT VCGLIB_DIR)
    file(READ "${MESHLAB_SOURCE_DIR}/ML_VERSION" MESHLAB_VERSION)
    string(STRIP "${MESHLAB_VERSION}" MESHLAB_VERSION)
endif()

add_library(vcglib INTERFACE)
target_include_directories(vcglib SYSTEM INTERFACE "${vcglib_folder}")
# Eigen: that of the system, or where it has none the one that a clone of VCGlib brings.
find_package(Eigen3 QUIET NO_MODULE)
if(TARGET Eigen3::Eigen)
    target_link_libraries(vcglib INTERFACE Eigen3::Eigen)
elseif(EXISTS "${vcglib_folder}/eigenlib/Eigen/Core")
    target_include_directories(vcglib SYSTEM INTERFACE "${vcglib_folder}/eigenlib")
else()
    message(FATAL_ERROR "Eigen 3 is missing: install it, or give Eigen3_DIR.")
endif()
