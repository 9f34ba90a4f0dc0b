# SPDX-License-Identifier: GPL-3.0-or-later
# muParser, which evaluates expressions, as the static library muparser: the plugin carries it, so
# that it also loads where the host has none. Its symbols stay inside, apart from the host's own.

if(NOT EXISTS "${MUPARSER_SOURCE_DIR}/src/muParser.cpp")
    message(FATAL_ERROR
        "MUPARSER_SOURCE_DIR is '${MUPARSER_SOURCE_DIR}', where src/muParser.cpp is not to be found. "
        "Run scripts/setup, or give the folder of muParser's sources with "
        "-DMUPARSER_SOURCE_DIR=FOLDER.")
endif()

set(muparser_sources muParser muParserBase muParserBytecode muParserCallback muParserError
    muParserTokenReader)
list(TRANSFORM muparser_sources REPLACE "(.+)" "${MUPARSER_SOURCE_DIR}/src/\\1.cpp")
add_library(muparser STATIC ${muparser_sources})
target_include_directories(muparser SYSTEM PUBLIC
    $<BUILD_INTERFACE:${MUPARSER_SOURCE_DIR}/include>)
target_compile_definitions(muparser PUBLIC MUPARSER_STATIC)
target_link_libraries(muparser PRIVATE $<BUILD_INTERFACE:neuralmesh_flags>)
target_compile_options(muparser PRIVATE ${no_warnings}) # not ours to mend
set_target_properties(muparser PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
