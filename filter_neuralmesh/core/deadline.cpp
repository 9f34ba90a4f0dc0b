// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/deadline.h"

#include "neuralmesh/errors.h"

namespace neuralmesh {

Deadline Deadline::in(double seconds)
{
    // A year: more would not fit into the clock's numbers for ever.
    constexpr double longest = 365.0 * 24 * 3600;
    // Written so that NaN is refused too.
    if (!(seconds >= 0))
        throw InvalidParameter(Parameter::timeLimit, InvalidParameter::Problem::belowLeast, seconds,
                               0);
    Deadline deadline;
    if (seconds == 0 || seconds > longest)
        return deadline;
    deadline.isSet_ = true;
    deadline.moment_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                          std::chrono::duration<double>(seconds));
    return deadline;
}

} // namespace neuralmesh
