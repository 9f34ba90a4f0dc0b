// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/free_memory.h"

#include <gtest/gtest.h>

#include "neuralmesh/too_little_memory.h"

namespace neuralmesh {
namespace {

TEST(FreeMemory, what_cannot_fit_is_refused_with_numbers)
{
    EXPECT_NO_THROW(requireMemory(1000, 1000000000));
    try {
        requireMemory(2000000000, 3000000000);
        FAIL();
    } catch (const TooLittleMemory &error) {
        EXPECT_STREQ(error.what(), "2000000000 vertices need about 4000.0 GB of memory, of which "
                                   "3.0 GB are free.");
        EXPECT_EQ(error.sentence([](Parameter) { return std::string("TargetVertNum"); }),
                  "TargetVertNum: 2000000000 vertices need about 4000.0 GB of memory, of which 3.0 "
                  "GB are free.");
    }
}

TEST(FreeMemory, there_is_some)
{
    EXPECT_GT(freeMemory(), 1000000U);
}

} // namespace
} // namespace neuralmesh
