# SPDX-License-Identifier: GPL-3.0-or-later
# Finds MeshLab's sources and their version; defines the interface library vcglib.

if(NOT EXISTS "${MESHLAB_SOURCE_DIR}/src/vcglib/vcg/complex/complex.h")
    message(FATAL_ERROR
        "MESHLAB_SOURCE_DIR is '${MESHLAB_SOURCE_DIR}', where src/vcglib is not to be found. "
        "Run scripts/setup, or give the folder of MeshLab's sources with "
        "-DMESHLAB_SOURCE_DIR=FOLDER.")
endif()
file(READ "${MESHLAB_SOURCE_DIR}/ML_VERSION" MESHLAB_VERSION)
string(STRIP "${MESHLAB_VERSION}" MESHLAB_VERSION)

find_package(Eigen3 REQUIRED NO_MODULE)
add_library(vcglib INTERFACE)
target_include_directories(vcglib SYSTEM INTERFACE "${MESHLAB_SOURCE_DIR}/src/vcglib")
target_link_libraries(vcglib INTERFACE Eigen3::Eigen)
