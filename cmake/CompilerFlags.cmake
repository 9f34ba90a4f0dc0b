# SPDX-License-Identifier: GPL-3.0-or-later
# Flags of all our own targets, as the interface library neuralmesh_flags.

add_library(neuralmesh_flags INTERFACE)
# No fused multiply-add and no fast-math: the same seed gives the same mesh, whatever the compiler
# makes of the processor. The error number of sqrt() is nothing that anyone reads.
if(MSVC)
    target_compile_options(neuralmesh_flags INTERFACE
        /W3 /fp:precise /utf-8 /bigobj $<$<BOOL:${NEURALMESH_WERROR}>:/WX>)
    # VCGlib says std::min, and names functions of C that this compiler would warn of.
    target_compile_definitions(neuralmesh_flags INTERFACE NOMINMAX _CRT_SECURE_NO_WARNINGS)
    set(no_warnings /w)
else()
    target_compile_options(neuralmesh_flags INTERFACE
        -Wall -Wextra -Wconversion -Wshadow -ffp-contract=off -fno-math-errno
        $<$<BOOL:${NEURALMESH_WERROR}>:-Werror>)
    set(no_warnings -w) # for what is not ours
endif()
if(NEURALMESH_SANITIZE_THREADS)
    target_compile_options(neuralmesh_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(neuralmesh_flags INTERFACE -fsanitize=thread)
endif()
if(NEURALMESH_SANITIZE)
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all)
    if(NOT NEURALMESH_FUZZ)
        # Checks at each pointer take up to a third of the tests' time. What they would find, the
        # address sanitizer mostly does, too; the fuzz targets keep them.
        list(APPEND sanitizers -fno-sanitize=null,alignment,pointer-overflow,vptr)
    endif()
    target_compile_options(neuralmesh_flags INTERFACE ${sanitizers} -fno-omit-frame-pointer)
    target_link_options(neuralmesh_flags INTERFACE ${sanitizers})
endif()
if(NEURALMESH_FUZZ)
    target_compile_options(neuralmesh_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
