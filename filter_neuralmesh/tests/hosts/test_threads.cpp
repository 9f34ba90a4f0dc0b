// SPDX-License-Identifier: GPL-3.0-or-later
#include "hosts/common/threads.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace neuralmesh {
namespace {

/// An empty value takes the variable away on Windows, and is one elsewhere.
void setVariable(const char *name, const char *value)
{
#ifdef _WIN32
    _putenv_s(name, value);
#else
    setenv(name, value, 1);
#endif
}

void removeVariable(const char *name)
{
#ifdef _WIN32
    _putenv_s(name, "");
#else
    unsetenv(name);
#endif
}

class ThreadsAllowed : public ::testing::Test {
protected:
    ThreadsAllowed()
    {
        if (const char *text = std::getenv("OMP_NUM_THREADS"))
            before_ = text;
    }
    ~ThreadsAllowed() override { setVariable("OMP_NUM_THREADS", before_.c_str()); }

    static int allowed(int asked, const char *variable)
    {
        setVariable("OMP_NUM_THREADS", variable);
        return threadsAllowed(asked);
    }

private:
    std::string before_;
};

TEST_F(ThreadsAllowed, are_those_asked_for_whatever_the_environment_says)
{
    EXPECT_EQ(allowed(3, "1"), 3);
    EXPECT_EQ(allowed(-1, "1"), -1); // refused later
}

TEST_F(ThreadsAllowed, are_those_of_the_environment_where_none_are_asked_for)
{
    EXPECT_EQ(allowed(0, "2"), 2);
    EXPECT_EQ(allowed(0, "4,2"), 4);
}

TEST_F(ThreadsAllowed, are_all_where_the_environment_says_nothing_of_use)
{
    for (const char *useless : {"", "0", "-2", "two", "2 cores", "99999999999999999999"})
        EXPECT_EQ(allowed(0, useless), 0) << useless;
    removeVariable("OMP_NUM_THREADS");
    EXPECT_EQ(threadsAllowed(0), 0);
}

} // namespace
} // namespace neuralmesh
