// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_parameters.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "host_versions.h"
#include "hosts/common/threads.h"
#include "neuralmesh/errors.h"
#include "origins.h"
#include "parameter_names.h"
#include "target_space.h"

namespace {

constexpr bool advanced = true;

std::uint64_t readSeed(const RichParameterList &parameters)
{
    const int seed = parameters.getInt("RandomSeed");
    if (seed < 0)
        throw neuralmesh::InvalidInput(named("RandomSeed") +
                                       " must be 0 (a fresh seed) or positive, not " +
                                       std::to_string(seed) + ".");
    if (seed > 0)
        return static_cast<std::uint64_t>(seed);
    // Positive and within an int, so that the seed reported can be given back.
    std::random_device device;
    return (device() & 0x7ffffffeU) + 1;
}

void addGrowthParameters(RichParameterList &list)
{
    const neuralmesh::GrowthParameters d;
    const auto real = [](double value) { return static_cast<Scalarm>(value); };
    list.addParam(RichInt("Threads", d.threads, "Threads",
                          "Processor cores that share the work; 0 takes all, or as many as "
                          "OMP_NUM_THREADS allows. The mesh is the same for any number.",
                          advanced));
    list.addParam(RichFloat("TimeLimit", 0, "Time limit",
                            "Seconds after which the filter ends with the mesh so far; 0: none. "
                            "The result says by reached_target, and the log in words, that it was "
                            "cut short. With a limit, the mesh depends on the machine.",
                            advanced));
    list.addParam(RichFloat("WinnerRate", real(d.winnerRate), "Winner rate",
                            "How far the vertex nearest to a sample moves towards it, as a share "
                            "of the distance (the paper's alpha_w). Between 0 and 1.",
                            advanced));
    list.addParam(RichFloat("SmoothingRate", real(d.smoothingRate), "Smoothing rate",
                            "Share of the tangential Laplacian by which the winner's neighbours "
                            "move in each pass (the paper's alpha_n). Between 0 and 1.",
                            advanced));
    list.addParam(RichInt("SmoothingPasses", d.smoothingPasses, "Smoothing passes",
                          "How often the winner's neighbours are smoothed for each sample. At "
                          "least 1.",
                          advanced));
    list.addParam(RichInt("SignalsPerSplit", d.signalsPerSplit, "Signals per split",
                          "Samples for each new vertex (the paper's lambda): more take longer and "
                          "settle the mesh better. At least 1.",
                          advanced));
    list.addParam(RichInt("InactivityFactor", d.inactivityFactor, "Inactivity factor",
                          "A vertex that was nearest to none of the last mu times n samples, n "
                          "being the number of vertices, is removed (the paper's mu). At least 1.",
                          advanced));
    list.addParam(RichFloat("CounterDecay", real(d.counterDecay), "Counter decay",
                            "Factor by which the signal counters fade while the network receives "
                            "as many samples as it has vertices. Between 0 and 1; near 1 is a "
                            "long memory.",
                            advanced));
    list.addParam(RichEnum("SplitRule", static_cast<int>(d.splitRule),
                           {"Balanced valences", "As in the paper"}, "Split rule",
                           "How the star of a vertex is divided when it is split along its longest "
                           "edge: so that valences come out even, and signals count more where the "
                           "error is; or in halves, with every signal counting the same, as in the "
                           "paper.",
                           advanced));
    list.addParam(RichBool("EdgeFlips", d.edgeFlips, "Edge flips",
                           "Flips edges after each split where that evens out the valences and "
                           "neither folds the surface nor loses a crease.",
                           advanced));
}

// Growth has room to settle with two points a vertex; close to one it may not reach its target.
// Up to 8 vertices are the cube with which hosts ask for the defaults without a document.
int sensibleTarget(const MeshDocument &document)
{
    constexpr int verticesOfHostsCube = 8;
    const int general = neuralmesh::GrowthParameters().targetVertexCount;
    const MeshModel *layer = inputLayer(document, Source::pointsOfLayer);
    if (layer == nullptr || layer->cm.vn <= verticesOfHostsCube)
        return general;
    return std::min(general, layer->cm.vn / 2);
}

void addResultParameters(RichParameterList &list, int targetVertexCount)
{
    list.addParam(RichInt("TargetVertNum", targetVertexCount, "Target number of vertices",
                          "Exact number of vertices of the result, at least 4 and at most the "
                          "number of distinct input points. A closed mesh of genus 0 has twice as "
                          "many faces, less 4. By default 5000, or half the points of the current "
                          "layer where that is less."));
}

void addCommonParameters(RichParameterList &list)
{
    const neuralmesh::GrowthParameters d;
    list.addParam(RichString("Snapshots", "", "Snapshots",
                             "Vertex counts on the way to the target, separated by commas, such as "
                             "20,100,1000: each becomes a layer of its own. They are finished by "
                             "the surface fit like the result; without it they are the growing "
                             "network as it is."));
    list.addParam(RichBool("SurfaceFit", d.surfaceFit, "Surface fit",
                           "At the end, moves the vertices so that the faces fit the points: "
                           "several times more accurate, for a fifth more time."));
    list.addParam(RichInt("RandomSeed", static_cast<int>(d.seed), "Random seed",
                          "The same seed gives the same mesh. 0 takes a fresh seed and reports "
                          "it."));
}

/// Of a length that the host makes of a percentage, which may be of single precision.
constexpr Scalarm roundingOfHost = static_cast<Scalarm>(1e-6);

/// Of the document's bounding box: what percentages are of in the host.
Scalarm diagonalOf(const MeshDocument &document)
{
    const Box3m box = document.bbox();
    // Points that are not finite are refused later, in words of their own.
    return !box.IsNull() && std::isfinite(box.Diag()) ? box.Diag() : 1;
}

Scalarm defaultHoleSize(const MeshDocument &document)
{
    const neuralmesh::GrowthParameters d;
    return static_cast<Scalarm>(d.maxHoleSize) * diagonalOf(document);
}

void addTopologyParameters(RichParameterList &list, const MeshDocument &document)
{
    const neuralmesh::GrowthParameters d;
    list.addParam(RichEnum("Topology", static_cast<int>(d.topology),
                           {"That of the starting mesh", "Learned from the data"}, "Topology",
                           "Handles and components of the result: those of the points, which "
                           "growth starts from a coarse mesh of; or those of the starting mesh, as "
                           "in the paper."));
    list.addParam(RichEnum("Boundaries", static_cast<int>(d.boundaries), {"Closed", "Open"},
                           "Boundaries",
                           "Closed is watertight, holes in the data are filled, and an open sheet "
                           "becomes two back to back; open has no surface where there are no "
                           "points. Without effect unless the topology is learned."));
    list.addParam(RichPercentage("MaxHoleSize", defaultHoleSize(document), 0, diagonalOf(document),
                                 "Maximal hole size",
                                 "Smaller gaps in the data are closed. In per cent of the diagonal "
                                 "of the document's bounding box. Without effect unless the "
                                 "topology is learned."));
}

void addStartParameters(RichParameterList &list, const MeshDocument &document)
{
    const neuralmesh::GrowthParameters d;
    const MeshModel *current = document.mm();
    const auto startLayer = static_cast<unsigned int>(current == nullptr ? 0 : current->id());
    list.addParam(RichEnum("StartMesh", static_cast<int>(d.startMesh),
                           {"Tetrahedron", "Octahedron", "Icosahedron", "A layer", "From the data"},
                           "Starting mesh",
                           "What the network grows from, and whose topology the result has. The "
                           "tetrahedron is without "
                           "effect where the topology is learned: growth starts from the data.",
                           advanced));
    list.addParam(RichMesh("StartLayer", startLayer, &document, "Starting layer",
                           "A closed two-manifold, with as many handles and components as the "
                           "result shall have, roughly in place. Without effect unless the "
                           "starting mesh is a layer.",
                           advanced));
}

/// "20, 100,1000", in any order. Empty: none.
std::vector<int> readSnapshots(const RichParameterList &parameters)
{
    std::vector<int> counts;
    const QString text = parameters.getString("Snapshots").trimmed();
    if (text.isEmpty())
        return counts;
    for (const QString &entry : text.split(',')) {
        bool isCount = false;
        counts.push_back(entry.trimmed().toInt(&isCount));
        if (!isCount)
            throw neuralmesh::InvalidInput(
                named("Snapshots") +
                " must be vertex counts separated by commas, such as 20,100,1000: '" +
                entry.trimmed().toStdString() + "' is none.");
    }
    std::sort(counts.begin(), counts.end());
    return counts;
}

} // namespace

RichParameterList reconstructionParameters(const MeshDocument &document)
{
    RichParameterList list;
    addResultParameters(list, sensibleTarget(document));
    list.addParam(RichEnum("Source", static_cast<int>(Source::pointsOfLayer), sourceLabels(),
                           "Source",
                           "What is sampled: vertices, each as likely as any other, or faces, "
                           "uniformly by area. Layers are taken with their matrices. A file on "
                           "disk is not loaded, however large it is."));
    list.addParam(RichFileOpen("PointFile", "", {"*.ply *.las *.npy", "*.ply", "*.las", "*.npy"},
                               "Point file",
                               "Binary PLY, LAS, or NumPy's NPY (N by 3, float32 or float64), read "
                               "in place. No layer is needed. Colours and other properties of the "
                               "file are not looked at. To be empty unless the Source is a point "
                               "file."));
    addTopologyParameters(list, document);
    addCommonParameters(list);
    list.addParam(RichBool("TransferAttributes", true, "Transfer attributes",
                           "Gives the result the vertex colours and quality of the input's layers, "
                           "where they have any: averaged over the points nearest to each vertex. "
                           "Without effect where the Source is a point file."));
    addStartParameters(list, document);
    list.addParam(RichBool("DensityFromQuality", false, "Density from quality",
                           "Samples points in proportion to vertex quality, so that vertices go "
                           "where it is high. None may be negative.",
                           advanced));
    addGrowthParameters(list);
    return list;
}

RichParameterList implicitParameters(const MeshDocument &document)
{
    RichParameterList list;
    list.addParam(RichString("expr", "x*x+y*y+z*z-0.5", "Function =",
                             "Expression in x, y and z whose zeros are the surface, in the syntax "
                             "of muParser, as in the filter Implicit Surface."));
    const QString meaning = "Box in which the surface is looked for. Where the surface leaves the "
                            "box it is open.";
    for (const QString axis : {"X", "Y", "Z"})
        list.addParam(RichFloat("min" + axis, -1, "Min " + axis, meaning));
    for (const QString axis : {"X", "Y", "Z"})
        list.addParam(RichFloat("max" + axis, 1, "Max " + axis, meaning));
    addResultParameters(list, neuralmesh::GrowthParameters().targetVertexCount);
    addTopologyParameters(list, document);
    addCommonParameters(list);
    addStartParameters(list, document);
    addGrowthParameters(list);
    return list;
}

RichParameterList parametricParameters(const MeshDocument &document)
{
    RichParameterList list;
    const QString meaning = "Expression in u and v, in the syntax of muParser.";
    list.addParam(RichString("x", "cos(u)*sin(v)", "x =", meaning));
    list.addParam(RichString("y", "sin(u)*sin(v)", "y =", meaning));
    list.addParam(RichString("z", "cos(v)", "z =", meaning));
    const auto pi = static_cast<Scalarm>(3.14159265358979323846); // not every <cmath> has M_PI
    const QString range = "Range of the parameter. Where it does not close, the surface has a "
                          "boundary.";
    list.addParam(RichFloat("minU", 0, "Min U", range));
    list.addParam(RichFloat("maxU", 2 * pi, "Max U", range));
    list.addParam(RichFloat("minV", 0, "Min V", range));
    list.addParam(RichFloat("maxV", pi, "Max V", range));
    addResultParameters(list, neuralmesh::GrowthParameters().targetVertexCount);
    addTopologyParameters(list, document);
    addCommonParameters(list);
    addStartParameters(list, document);
    addGrowthParameters(list);
    return list;
}

neuralmesh::GrowthParameters readGrowthParameters(const RichParameterList &parameters)
{
    neuralmesh::GrowthParameters growth;
    growth.targetVertexCount = parameters.getInt("TargetVertNum");
    growth.winnerRate = parameters.getFloat("WinnerRate");
    growth.smoothingRate = parameters.getFloat("SmoothingRate");
    growth.smoothingPasses = parameters.getInt("SmoothingPasses");
    growth.signalsPerSplit = parameters.getInt("SignalsPerSplit");
    growth.inactivityFactor = parameters.getInt("InactivityFactor");
    growth.threads = neuralmesh::threadsAllowed(parameters.getInt("Threads"));
    growth.counterDecay = parameters.getFloat("CounterDecay");
    growth.splitRule = static_cast<neuralmesh::SplitRule>(parameters.getEnum("SplitRule"));
    growth.surfaceFit = parameters.getBool("SurfaceFit");
    growth.edgeFlips = parameters.getBool("EdgeFlips");
    growth.maxHoleSize = parameters.getAbsPerc("MaxHoleSize");
    growth.boundaries = static_cast<neuralmesh::BoundaryRule>(parameters.getEnum("Boundaries"));
    growth.topology = static_cast<neuralmesh::Topology>(parameters.getEnum("Topology"));
    growth.startMesh = static_cast<neuralmesh::StartMesh>(parameters.getEnum("StartMesh"));
    growth.snapshots = readSnapshots(parameters);
    growth.seed = readSeed(parameters);
    return growth;
}

double holeSizeInFrame(const RichParameterList &parameters, const MeshDocument &document,
                       double diagonal)
{
    const Scalarm size = parameters.getAbsPerc("MaxHoleSize");
    const Scalarm usual = defaultHoleSize(document);
    const bool isDefault = std::abs(size - usual) <= roundingOfHost * usual;
    if (isDefault || size > diagonal)
        return size / diagonalOf(document);
    return size / diagonal;
}
