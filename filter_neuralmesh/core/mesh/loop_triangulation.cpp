// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/loop_triangulation.h"

#include <utility>

namespace neuralmesh {
namespace {

/// A square of values by pairs of places, in rows.
template <class T> class PairTable {
public:
    explicit PairTable(int size) : size_(static_cast<std::size_t>(size)), values_(size_ * size_) {}
    T *row(int i) { return values_.data() + static_cast<std::size_t>(i) * size_; }

private:
    std::size_t size_;
    std::vector<T> values_;
};

} // namespace

LoopTriangulation triangulateLoop(int size,
                                  const std::function<double(int, int, int)> &weightOfTriangle)
{
    // For i < j, the part of the loop from i to j, closed by the diagonal (i, j): its least weight,
    // held as (i, j) and (j, i) so that the inner loop runs along two rows, and the third corner of
    // the triangle at that diagonal.
    PairTable<double> least(size);
    PairTable<int> apexes(size);
    for (int span = 2; span < size; ++span)
        for (int i = 0; i + span < size; ++i) {
            const int j = i + span;
            const double *fromI = least.row(i);
            const double *toJ = least.row(j);
            double best = std::numeric_limits<double>::infinity();
            int apexOfBest = -1;
            for (int apex = i + 1; apex < j; ++apex) {
                const double sides = fromI[apex] + toJ[apex];
                if (!(sides < best))
                    continue;
                const double weight = sides + weightOfTriangle(i, apex, j);
                if (weight < best) {
                    best = weight;
                    apexOfBest = apex;
                }
            }
            least.row(i)[j] = least.row(j)[i] = best;
            apexes.row(i)[j] = apexOfBest;
        }

    LoopTriangulation found;
    found.weight = least.row(0)[size - 1];
    if (apexes.row(0)[size - 1] < 0)
        return found;
    std::vector<std::pair<int, int>> open{{0, size - 1}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j - i < 2)
            continue;
        const int apex = apexes.row(i)[j];
        found.triangles.push_back({i, apex, j});
        open.push_back({i, apex});
        open.push_back({apex, j});
    }
    return found;
}

} // namespace neuralmesh
