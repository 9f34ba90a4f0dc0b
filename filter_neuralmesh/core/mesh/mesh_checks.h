// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and figures of the network's connectivity, for tests and for the report to the user.
#pragma once

#include <string>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// The first broken invariant in words, or an empty string where the mesh is an oriented
/// two-manifold with or without boundaries: every ring has three or more distinct live neighbours,
/// on a boundary two or more, neighbourhood is mutual, the two faces at each edge agree on their
/// orientation, and the rings at both ends of an edge agree on its being one of a boundary.
std::string findDefect(const NeuralMesh &mesh);

/// Throws std::logic_error with the first broken invariant.
void validate(const NeuralMesh &mesh);

struct TopologyFigures {
    int vertices = 0;
    int edges = 0;
    int faces = 0;
    int components = 0;
    int boundaryLoops = 0;
    /// Sum of the components' genera: components - (V - E + F + boundaryLoops) / 2.
    int genus = 0;
};

/// By vertex id: the number of the vertex's component, from 0; -1 for removed vertices.
std::vector<int> labelComponents(const NeuralMesh &mesh);

TopologyFigures measureTopology(const NeuralMesh &mesh);

/// Entry k counts the vertices of valence k.
std::vector<int> valenceHistogram(const NeuralMesh &mesh);

/// Signed volume inside a closed mesh: negative where it is turned inside out. Summed about the
/// mesh itself, wherever it lies.
double signedVolume(const NeuralMesh &mesh);

/// The same of each component, by the labels of labelComponents().
std::vector<double> signedVolumes(const NeuralMesh &mesh, const std::vector<int> &labels);

} // namespace neuralmesh
