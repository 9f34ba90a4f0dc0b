# SPDX-License-Identifier: GPL-3.0-or-later
# GoogleTest: the library of this machine, or for another system built from its sources, which
# Debian's package googletest puts into /usr/src.

if(NOT CMAKE_CROSSCOMPILING)
    find_package(GTest REQUIRED)
    return()
endif()

set(GOOGLETEST_SOURCE_DIR "/usr/src/googletest/googletest" CACHE PATH "GoogleTest's sources")
if(NOT EXISTS "${GOOGLETEST_SOURCE_DIR}/src/gtest-all.cc")
    message(FATAL_ERROR
        "GOOGLETEST_SOURCE_DIR is '${GOOGLETEST_SOURCE_DIR}', where src/gtest-all.cc is not to be "
        "found. Install the package googletest.")
endif()
add_library(gtest_main STATIC
    "${GOOGLETEST_SOURCE_DIR}/src/gtest-all.cc" "${GOOGLETEST_SOURCE_DIR}/src/gtest_main.cc")
target_include_directories(gtest_main PRIVATE "${GOOGLETEST_SOURCE_DIR}")
target_include_directories(gtest_main SYSTEM PUBLIC "${GOOGLETEST_SOURCE_DIR}/include")
find_package(Threads REQUIRED)
target_link_libraries(gtest_main PUBLIC Threads::Threads)
add_library(GTest::gtest_main ALIAS gtest_main)
