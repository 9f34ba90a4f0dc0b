// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/stump_bridge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/annulus_triangulation.h"
#include "core/topology/filling_cost.h"

namespace neuralmesh {
namespace {

/// Band and samples must come so much nearer to each other than the stumps were, in squared
/// distance.
constexpr double leastGain = 0.5;

std::size_t place(int i)
{
    return static_cast<std::size_t>(i);
}

/// What the faces of a band cost. Most bands are given up after a few of them, and the samples
/// nearest to its rungs are what takes time: each is looked up when it is asked for.
class Band {
public:
    Band(const NeuralMesh &mesh, const FillingCost &cost, const Stump &first, const Stump &second)
        : mesh_(mesh), cost_(cost), first_(first), second_(second),
          distances_(first.patch.rim.size() * second.patch.rim.size(), unknown)
    {
    }

    int onFirst() const { return static_cast<int>(first_.patch.rim.size()); }
    int onSecond() const { return static_cast<int>(second_.patch.rim.size()); }

    /// As AnnulusWeights has them.
    double forwardOnFirst(int i, int j)
    {
        const int next = i + 1 < onFirst() ? i + 1 : 0;
        return cost_.weight({first(i), first(next), second(j)}, first_.rimDistances[place(i)],
                            distance(next, j), distance(i, j));
    }
    double backOnSecond(int i, int j)
    {
        const int next = j > 0 ? j - 1 : onSecond() - 1;
        return cost_.weight({second(next), second(j), first(i)}, second_.rimDistances[place(next)],
                            distance(i, j), distance(i, next));
    }

    /// Whether a band may weigh less than so much: each edge of the rims is one of a face of its
    /// own.
    bool mayWeighLess(double most)
    {
        double least = 0;
        for (int i = 0; i < onFirst() && least < most; ++i) {
            double lightest = std::numeric_limits<double>::infinity();
            for (int j = 0; j < onSecond(); ++j)
                lightest = std::min(lightest, forwardOnFirst(i, j));
            least += lightest;
        }
        for (int j = 0; j < onSecond() && least < most; ++j) {
            double lightest = std::numeric_limits<double>::infinity();
            for (int i = 0; i < onFirst(); ++i)
                lightest = std::min(lightest, backOnSecond(i, j));
            least += lightest;
        }
        return least < most;
    }

    std::vector<Corners> faces(const std::vector<std::pair<int, int>> &rungs) const
    {
        std::vector<Corners> found;
        for (std::size_t k = 0; k < rungs.size(); ++k) {
            const auto &[i, j] = rungs[k];
            const auto &[nextI, nextJ] = rungs[(k + 1) % rungs.size()];
            found.push_back({first(i), i != nextI ? first(nextI) : second(nextJ), second(j)});
        }
        return found;
    }

private:
    static constexpr double unknown = -1;

    VertexId first(int i) const { return first_.patch.rim[place(i)]; }
    VertexId second(int j) const { return second_.patch.rim[place(j)]; }

    /// Of the rung, squared. Infinite where it is an edge already.
    double distance(int i, int j)
    {
        double &found = distances_[place(i * onSecond() + j)];
        if (found == unknown)
            found = mesh_.ring(first(i)).contains(second(j))
                        ? std::numeric_limits<double>::infinity()
                        : cost_.squaredDistanceOfEdge(first(i), second(j));
        return found;
    }

    const NeuralMesh &mesh_;
    const FillingCost &cost_;
    const Stump &first_, &second_;
    std::vector<double> distances_;
};

double weightOf(const FillingCost &cost, const Stump &first, const Stump &second)
{
    double sum = 0;
    for (const Stump *stump : {&first, &second})
        for (std::size_t k = 0; k < stump->faces.size(); ++k) {
            const auto &[a, b, c] = stump->distances[k];
            sum += cost.weight(stump->faces[k], a, b, c);
        }
    return sum;
}

} // namespace

Stump::Stump(const NeuralMesh &mesh, const FaceTable &table, const SampleSupport &support,
             Patch itsPatch)
    : patch(std::move(itsPatch))
{
    const FillingCost cost(mesh, support, patch.rim);
    for (const FaceId face : patch.faces) {
        const Corners &c = table.corners(face);
        faces.push_back(c);
        distances.push_back({cost.squaredDistanceOfEdge(c[0], c[1]),
                             cost.squaredDistanceOfEdge(c[1], c[2]),
                             cost.squaredDistanceOfEdge(c[2], c[0])});
    }
    for (std::size_t i = 0; i < patch.rim.size(); ++i) {
        rimDistances.push_back(
            cost.squaredDistanceOfEdge(patch.rim[i], patch.rim[(i + 1) % patch.rim.size()]));
        bounds.Add(mesh.position(patch.rim[i]));
    }
}

std::optional<Bridge> betterBridge(const NeuralMesh &mesh, const SampleSupport &support,
                                   const Stump &first, const Stump &second)
{
    const FillingCost cost(mesh, support, first.patch.rim);
    const double weightNow = weightOf(cost, first, second);
    Band band(mesh, cost, first, second);
    if (!band.mayWeighLess(leastGain * weightNow))
        return std::nullopt;
    const AnnulusTriangulation best =
        triangulateAnnulus(band.onFirst(), band.onSecond(),
                           {[&](int i, int j) { return band.forwardOnFirst(i, j); },
                            [&](int i, int j) { return band.backOnSecond(i, j); }});
    if (!(best.weight < leastGain * weightNow))
        return std::nullopt;
    std::vector<Corners> before = first.faces;
    before.insert(before.end(), second.faces.begin(), second.faces.end());
    const FillingCost::Missed missed = cost.missed(before, band.faces(best.rungs));
    const double now = weightNow + missed.before;
    const double then = best.weight + missed.after;
    if (!(then < leastGain * now))
        return std::nullopt;
    return Bridge{best.rungs, now - then};
}

} // namespace neuralmesh
