// SPDX-License-Identifier: GPL-3.0-or-later
#include "target.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <algorithm>

#include "arrays.h"
#include "callback_sampler.h"
#include "hosts/common/error_sentences.h"
#include "hosts/common/reconstruction.h"
#include "interruptible.h"
#include "neuralmesh/samplers.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace neuralmesh::python {
namespace {

/// 0 where the points are none or not finite: samplers refuse them, with a sentence.
double diagonalOf(const std::vector<Point> &points)
{
    if (points.empty())
        return 0;
    Box box{points.front(), points.front()};
    for (const Point &point : points)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.min[axis] = std::min(box.min[axis], point[axis]);
            box.max[axis] = std::max(box.max[axis], point[axis]);
        }
    return UnitFrame(box).diagonal();
}

Target targetOf(std::unique_ptr<Sampler> sampler)
{
    const double diagonal = sampler->frame().diagonal();
    return {std::move(sampler), diagonal};
}

/// Opens a target space on a thread of its own; refusals get the words of the caller.
template <class Open>
Target opened(Open open, const nb::object &progress, const TypedNames &names,
              const Deadline &deadline = {})
{
    try {
        return resultOf<Target>(std::move(open), progress, deadline);
    } catch (const InvalidInput &error) {
        throw InvalidInput(sentenceFor(error, hostTerms(names)));
    }
}

std::vector<double> densityOf(const SharedArray *density)
{
    return density == nullptr ? std::vector<double>() : numbersOf(**density);
}

Target pointsTarget(AnyArray points, const nb::object &density, const TypedNames &names,
                    const nb::object &progress)
{
    return opened(
        [points = SharedArray(std::move(points)),
         density = optionalArray(density)](const Progress &) -> Target {
            std::vector<Point> copied = pointsOf(*points);
            const double diagonal = diagonalOf(copied);
            return {pointCloudSampler(std::move(copied), densityOf(density.get())), diagonal};
        },
        progress, names);
}

Target fileTarget(const std::string &path, const TypedNames &names, const nb::object &progress,
                  const Deadline &deadline)
{
    return opened(
        [path](const Progress &report) { return targetOf(pointFileSampler(path, report)); },
        progress, names, deadline);
}

Target surfaceTarget(AnyArray vertices, AnyArray faces, const nb::object &density,
                     const TypedNames &names, const nb::object &progress)
{
    return opened(
        [vertices = SharedArray(std::move(vertices)), faces = SharedArray(std::move(faces)),
         density = optionalArray(density)](const Progress &) -> Target {
            const Mesh mesh{pointsOf(*vertices), cornersOf(*faces)};
            return {surfaceSampler(mesh, densityOf(density.get())), diagonalOf(mesh.positions)};
        },
        progress, names);
}

Target implicitTarget(const std::string &expression, const Point &lower, const Point &upper,
                      const TypedNames &names, const nb::object &progress)
{
    return opened(
        [=](const Progress &report) {
            return targetOf(implicitSurfaceSampler({"expr", expression}, {lower, upper}, report));
        },
        progress, names);
}

Target parametricTarget(const std::array<std::string, 3> &coordinates,
                        const std::pair<double, double> &u, const std::pair<double, double> &v,
                        const TypedNames &names, const nb::object &progress)
{
    return opened(
        [=](const Progress &report) {
            return targetOf(parametricSurfaceSampler(
                {Formula{"x", coordinates[0]}, {"y", coordinates[1]}, {"z", coordinates[2]}},
                {u.first, u.second}, {v.first, v.second}, report));
        },
        progress, names);
}

Target callbackTarget(nb::object draw, const Point &lower, const Point &upper, bool isFlat)
{
    return targetOf(callbackSampler(std::move(draw), {lower, upper}, isFlat));
}

} // namespace

void defineTargets(nb::module_ &module)
{
    nb::class_<Target>(module, "Target", "A target space: what the network learns.")
        .def_ro("diagonal", &Target::diagonal)
        .def_prop_ro("outlier_remark", [](const Target &target) {
            return outlierRemark(target.sampler->outliers());
        });
    module.def("points_target", pointsTarget, "points"_a.noconvert(), "density"_a.none(), "names"_a,
               "progress"_a.none());
    module.def("file_target", fileTarget, "path"_a, "names"_a, "progress"_a.none(), "deadline"_a);
    module.def("surface_target", surfaceTarget, "vertices"_a.noconvert(), "faces"_a.noconvert(),
               "density"_a.none(), "names"_a, "progress"_a.none());
    module.def("implicit_target", implicitTarget, "expression"_a, "lower"_a, "upper"_a, "names"_a,
               "progress"_a.none());
    module.def("parametric_target", parametricTarget, "coordinates"_a, "u"_a, "v"_a, "names"_a,
               "progress"_a.none());
    module.def("callback_target", callbackTarget, "draw"_a, "lower"_a, "upper"_a, "is_flat"_a);
}

} // namespace neuralmesh::python
