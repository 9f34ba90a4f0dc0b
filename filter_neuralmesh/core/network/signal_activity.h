// SPDX-License-Identifier: GPL-3.0-or-later
// What a signal counts in step 4, where it does not count 1 as in the paper.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Three quarters of what a signal counts are the sample's distance to the surface, so that
/// vertices go where the error is; its root, because the distance itself draws too many into
/// creases and noise, and relative to its running mean.
class SignalActivity {
public:
    /// For a sample at this distance, which goes into the mean.
    double count(Scalar distance);

    /// The same, given the root of the distance in means of that root.
    static double ofRelative(double relative);

private:
    double meanRoughness_ = 0;
    bool hasMean_ = false;
};

} // namespace neuralmesh
