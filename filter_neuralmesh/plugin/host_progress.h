// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <wrap/callback.h>

#include "neuralmesh/deadline.h"
#include "neuralmesh/progress.h"

/// The host's callback as the core's progress, passed on at most ten times a second. Hosts ask to
/// cancel by returning false.
neuralmesh::Progress throttledProgress(vcg::CallBackPos *callback,
                                       const neuralmesh::Deadline &deadline = {});
