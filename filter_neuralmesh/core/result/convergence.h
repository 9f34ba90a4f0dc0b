// SPDX-License-Identifier: GPL-3.0-or-later
// The error of the growing network at each doubling of its vertex count.
#pragma once

#include <vector>

#include "core/network/growing_network.h"
#include "neuralmesh/random.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Root mean square distances of samples, in the unit frame: entry k is of 8 * 2^k vertices.
class Convergence {
public:
    Convergence(const Sampler &sampler, Random &random) : sampler_(sampler), random_(random) {}

    /// Of counts below that of the starting mesh: those of the start, cut down to so many.
    void noteStart(const NeuralMesh &start, const GrowthParameters &parameters);

    /// At the first time that the network has the next count.
    void note(const GrowingNetwork &network);

    const std::vector<double> &errors() const { return errors_; }

private:
    double errorOf(const GrowingNetwork &network);

    const Sampler &sampler_;
    Random &random_;
    std::vector<double> errors_;
};

} // namespace neuralmesh
