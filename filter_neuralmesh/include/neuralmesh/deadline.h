// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace neuralmesh {

/// The moment at which a run ends with the mesh so far. It is the only clock of the core; what is
/// made before it does not depend on it.
class Deadline {
public:
    /// None: it never comes.
    Deadline() = default;

    /// So many seconds from now on; 0: none. Throws InvalidParameter where they are negative or no
    /// number.
    static Deadline in(double seconds);

    bool operator()() const { return hasPassed(); }
    bool hasPassed() const { return isSet_ && Clock::now() >= moment_; }

private:
    using Clock = std::chrono::steady_clock;

    bool isSet_ = false;
    Clock::time_point moment_;
};

} // namespace neuralmesh
