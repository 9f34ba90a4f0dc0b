// SPDX-License-Identifier: GPL-3.0-or-later
// Work that Ctrl-C ends at once.
#pragma once

#include <nanobind/nanobind.h>

#include <functional>
#include <memory>
#include <utility>

#include "neuralmesh/deadline.h"
#include "neuralmesh/progress.h"

namespace neuralmesh::python {

/// What is done. It is let go of, with all that it captured, on the thread that does it: without
/// the GIL.
using Work = std::function<void(const Progress &)>;

/// Does the work on a thread of its own, without the GIL, and waits. Meanwhile, on the thread that
/// calls: every 50 ms Python's signals are looked at, and every 100 ms `progress`, unless it is
/// None, is told the fraction and the activity. Rethrows what the work throws, with the GIL.
///
/// Where a signal's handler or `progress` raises, that is rethrown at once; where `progress`
/// returns False, Cancelled. The work is told the deadline. The core then may work on for some
/// tenths of a second, until it next reports progress: joinAbandoned() waits for it.
void runInterruptibly(Work work, const nanobind::object &progress, const Deadline &deadline);

/// Waits for threads whose work was cancelled. Python calls it before it ends.
void joinAbandoned();

/// The same for work that returns something, of a type that can be made without the GIL.
template <class Value, class Function>
Value resultOf(Function function, const nanobind::object &progress, const Deadline &deadline)
{
    auto value = std::make_shared<Value>();
    runInterruptibly([value, function = std::move(function)](
                         const Progress &report) { *value = function(report); },
                     progress, deadline);
    return std::move(*value);
}

} // namespace neuralmesh::python
