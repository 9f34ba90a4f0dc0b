// SPDX-License-Identifier: GPL-3.0-or-later
// Steps 2 to 4 for a whole batch of samples at once.
//
// One by one, a vertex that wins k samples in a row keeps (1 - α_w)^k of its place, and one whose
// neighbours win m of them is smoothed m times as often as equation 5 says. In a network that has
// found its shape the order of a batch is chance, and so is what one sample changes for the winner
// of the next. A batch takes both away: all winners are those of the network as it is, and each
// vertex moves once.
#pragma once

#include <vector>

#include "core/network/sample_locator.h"
#include "core/parallel/workers.h"
#include "neuralmesh/parameters.h"

namespace neuralmesh {

/// What a batch means for a vertex.
struct Wins {
    int signals = 0;
    Scalar activity = 0;  ///< what the signals count, equation 6
    Point3 pull{0, 0, 0}; ///< from the vertex to the samples it won, summed
};

/// How a batch is learned from.
struct BatchRules {
    bool countsByDistance; ///< so that signals count by the samples' distances from the surface
    Scalar reachOfBorder; ///< samples further than that from a winner on a boundary are passed over
};

class BatchLearning {
public:
    /// `bounds` are those of the samples.
    BatchLearning(const NeuralMesh &mesh, const Box3 &bounds, Workers &workers)
        : mesh_(mesh), bounds_(bounds), workers_(workers)
    {
    }

    /// Step 2, and 4: what each vertex won, by id.
    const std::vector<Wins> &win(const std::vector<Point3> &samples, const BatchRules &rules);

    /// Step 3: where each vertex goes, by id: its share of the way to the mean of its samples, k
    /// times equation 2 in one, then the smoothing that its neighbours' wins ask for, equations 3
    /// to 5, in one step from where all winners are by then.
    const std::vector<Point3> &move(const GrowthParameters &parameters);

private:
    struct Signal {
        VertexId winner;  ///< noVertex where the sample is passed over
        Scalar roughness; ///< the root of its distance from the surface
    };

    Signal signal(const SampleLocator &locator, VertexId nearest, const Point3 &sample,
                  const BatchRules &rules) const;
    Scalar meanRoughness() const;
    Point3 pulled(VertexId v, const std::vector<double> &left) const;
    Point3 smoothed(VertexId v, const std::vector<double> &left) const;

    const NeuralMesh &mesh_;
    const Box3 bounds_;
    Workers &workers_;
    std::vector<Signal> signals_; ///< of each sample
    std::vector<Wins> wins_;
    std::vector<Point3> pulled_; ///< where winners are
    std::vector<Point3> moved_;
};

} // namespace neuralmesh
