// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of the algorithm: the paper's, and those that measuring added.
#pragma once

#include <cstdint>
#include <vector>

namespace neuralmesh {

/// Decides between two sets of rules, of which the split is one: core/network/learning_rules.h has
/// them side by side.
enum class SplitRule {
    /// Of all splits along the longest edge, the one that leaves the evenest valences, and what
    /// else measured better than the paper's rules.
    balanced,
    /// The split that halves the star, and all other rules as in the paper.
    paper
};

enum class StartMesh {
    tetrahedron,
    octahedron,
    icosahedron,
    /// The closed two-manifold that the caller gives, whose topology stays.
    given,
    /// A coarse mesh of the samples' own handles and parts.
    fromData
};

enum class BoundaryRule {
    /// Watertight: holes in the data are filled.
    closed,
    /// Where there is no data, there is no surface.
    open
};

enum class Topology {
    /// That of the starting mesh, as in the paper.
    ofStart,
    /// That of the samples: growth starts from the data, unless another starting mesh than the
    /// tetrahedron is chosen.
    learned
};

/// Where a default is a measurement, it is RMS error to the mesh in per cent of the diagonal, the
/// geometric mean of four seeds. With the defaults, dino has 0.022, homer
/// 0.022 and camel 0.060:
///     scripts/benchmark.py --quality --models dino,homer,camel --conditions clean --methods ours
///         --seeds 1,2,3,4 --summary --ours inactivityfactor=20 --ours inactivityfactor=8
///         --ours counterdecay=0.95 --ours counterdecay=0.999
struct GrowthParameters {
    /// Vertices of the result, at least 4.
    int targetVertexCount = 5000;
    /// α_w, equation 2: how far the winner moves towards the sample, in (0, 1). Paper: 0.06.
    double winnerRate = 0.06;
    /// α_n, equation 5: weight of the tangential smoothing of the winner's neighbours, in (0, 1).
    /// Paper: 0.05.
    double smoothingRate = 0.05;
    /// How often the neighbours are smoothed for each sample, at least 1. Paper: 5.
    int smoothingPasses = 5;
    /// λ: signals for each vertex split, at least 1. Paper: 100.
    int signalsPerSplit = 100;
    /// μ: a vertex that has not won in the last μ·n signals is removed, at least 1. Paper: 20, with
    /// which dino has 0.024, homer 0.021, camel 0.086. With 8: 0.020, 0.025, 0.087.
    int inactivityFactor = 12;
    /// α, equation 7: factor by which the counters decay while the network of n vertices receives
    /// n signals, in (0, 1). The paper applies its 0.95 at every signal, which makes a counter
    /// forget all but the last 20 signals and does not reproduce its Table 1. With 0.95 here, dino
    /// has 0.023, homer 0.022, camel 0.066; with 0.999, 0.023, 0.026, 0.078.
    double counterDecay = 0.995;
    SplitRule splitRule = SplitRule::balanced;
    /// Whether edges are flipped after each split where that evens out valences.
    bool edgeFlips = true;
    /// Whether growth closes with the surface fit.
    bool surfaceFit = true;
    Topology topology = Topology::learned;
    /// What the network starts from; with Topology::learned, from the tetrahedron only where the
    /// data tell no shape. Paper: a tetrahedron, "or any closed manifold" (§3).
    StartMesh startMesh = StartMesh::tetrahedron;
    /// With Topology::learned.
    BoundaryRule boundaries = BoundaryRule::closed;
    /// With open boundaries: gaps in the data up to this width are closed, in diagonals of the
    /// samples' bounding box.
    double maxHoleSize = 0.1;
    /// Vertex counts, ascending, at which the network is shown on its way.
    std::vector<int> snapshots;
    std::uint64_t seed = 1;
    /// Threads that share the work, at most 256; 0: one for each core. The mesh is the same, bit
    /// for bit, for any number.
    int threads = 0;

    /// Throws InvalidInput, naming the parameter and its range.
    void validate() const;
};

} // namespace neuralmesh
