// SPDX-License-Identifier: GPL-3.0-or-later
// What libFuzzer, and replay.cpp in its place, call.
#pragma once

#include <cstddef>
#include <cstdint>

/// Does what the bytes say. Crashes, or throws what nobody catches, where a promise is broken.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);
