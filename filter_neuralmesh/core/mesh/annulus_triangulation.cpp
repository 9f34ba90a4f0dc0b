// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/annulus_triangulation.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// The best way round from one rung back to itself: shortest paths in a grid of rungs.
class WayRound {
public:
    WayRound(int first, int second, const AnnulusWeights &weights)
        : first_(first), second_(second), least_(at(first + 1, 0))
    {
        for (int i = 0; i < first; ++i)
            for (int j = 0; j < second; ++j) {
                forward_.push_back(weights.forwardOnFirst(i, j));
                back_.push_back(weights.backOnSecond(i, j));
            }
    }

    /// Its weight, from place 0 of the first and `start` of the second.
    double measure(int start)
    {
        for (int i = 0; i <= first_; ++i)
            for (int k = 0; k <= second_; ++k)
                least_[at(i, k)] = i == 0 && k == 0 ? 0
                                                    : std::min(throughFirst(start, i, k),
                                                               throughSecond(start, i, k));
        return least_[at(first_, second_)];
    }

    /// The rungs of the way measured last.
    std::vector<std::pair<int, int>> trace(int start) const
    {
        std::vector<std::pair<int, int>> rungs;
        int i = first_;
        int k = second_;
        while (i > 0 || k > 0) {
            if (throughFirst(start, i, k) <= throughSecond(start, i, k))
                --i;
            else
                --k;
            rungs.emplace_back(i % first_, onSecond(start, k));
        }
        std::reverse(rungs.begin(), rungs.end());
        return rungs;
    }

private:
    static constexpr double never = std::numeric_limits<double>::infinity();

    static std::size_t place(int row, int width, int column)
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
    std::size_t at(int i, int k) const { return place(i, second_ + 1, k); }
    std::size_t rung(int i, int j) const { return place(i, second_, j); }
    int onSecond(int start, int k) const { return (start - k + 2 * second_) % second_; }

    double throughFirst(int start, int i, int k) const
    {
        return i == 0 ? never : least_[at(i - 1, k)] + forward_[rung(i - 1, onSecond(start, k))];
    }
    double throughSecond(int start, int i, int k) const
    {
        return k == 0 ? never
                      : least_[at(i, k - 1)] + back_[rung(i % first_, onSecond(start, k - 1))];
    }

    int first_, second_;
    std::vector<double> forward_, back_; ///< by rung
    std::vector<double> least_;          ///< by steps on the first and on the second
};

} // namespace

AnnulusTriangulation triangulateAnnulus(int first, int second, const AnnulusWeights &weights)
{
    AnnulusTriangulation found;
    WayRound way(first, second, weights);
    // Every triangulation has a rung at place 0 of the first loop.
    int best = -1;
    for (int start = 0; start < second; ++start)
        if (const double weight = way.measure(start); weight < found.weight) {
            found.weight = weight;
            best = start;
        }
    if (best < 0)
        return found;
    way.measure(best);
    found.rungs = way.trace(best);
    // A fan round one corner that takes in the whole other loop comes back to where it started.
    std::vector<std::pair<int, int>> sorted = found.rungs;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        return {};
    return found;
}

} // namespace neuralmesh
