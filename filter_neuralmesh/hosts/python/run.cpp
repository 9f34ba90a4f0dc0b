// SPDX-License-Identifier: GPL-3.0-or-later
#include "run.h"

#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <chrono>

#include "arrays.h"
#include "hosts/common/error_sentences.h"
#include "hosts/common/reconstruction.h"
#include "hosts/common/threads.h"
#include "interruptible.h"
#include "neuralmesh/attribute_transfer.h"
#include "target.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace neuralmesh::python {
namespace {

nb::object toPython(int value)
{
    return nb::int_(value);
}

nb::object toPython(bool value)
{
    return nb::bool_(value);
}

nb::object toPython(double value)
{
    return nb::float_(value);
}

template <class T> nb::object toPython(const std::vector<T> &values)
{
    return arrayOf(values);
}

nb::dict infoOf(const Reconstruction &reconstruction)
{
    nb::dict info;
    forEachResult(reconstruction,
                  [&](const char *name, const auto &value) { info[name] = toPython(value); });
    return info;
}

nb::tuple arraysOf(Mesh mesh)
{
    return nb::make_tuple(arrayOf(std::move(mesh.positions)), arrayOf(std::move(mesh.triangles)));
}

/// What the worker makes; everything it needs, it holds.
struct Run {
    std::shared_ptr<const Sampler> sampler;
    GrowthParameters parameters;
    std::shared_ptr<const Mesh> start;

    Reconstruction operator()(const Progress &progress) const
    {
        const auto begin = std::chrono::steady_clock::now();
        Reconstruction made;
        made.seed = parameters.seed;
        made.diagonal = sampler->frame().diagonal();
        const auto keep = [&](Mesh snapshot) { made.snapshots.push_back(std::move(snapshot)); };
        made.result = start ? reconstructFrom(*start, *sampler, parameters, progress, keep)
                            : reconstruct(*sampler, parameters, progress, keep);
        made.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return made;
    }
};

/// Wants max_hole_size as a length. `start` is None or (vertices, faces).
nb::tuple run(const Target &target, GrowthParameters parameters, const nb::object &start,
              const TypedNames &names, const nb::object &progress, const Deadline &deadline)
{
    parameters.maxHoleSize /= target.sampler->frame().diagonal();
    parameters.threads = threadsAllowed(parameters.threads);
    Run run{target.sampler, std::move(parameters), nullptr};
    if (!start.is_none())
        run.start = std::make_shared<const Mesh>(
            Mesh{pointsOf(nb::cast<AnyArray>(start[0])), cornersOf(nb::cast<AnyArray>(start[1]))});
    Reconstruction made;
    try {
        made = resultOf<Reconstruction>(std::move(run), progress, deadline);
    } catch (const InvalidInput &error) {
        throw InvalidInput(sentenceFor(error, hostTerms(names)));
    }
    const nb::dict info = infoOf(made);
    const std::string text = summary(made, hostTerms(names));
    nb::list snapshots;
    for (Mesh &snapshot : made.snapshots)
        snapshots.append(arraysOf(std::move(snapshot)));
    return nb::make_tuple(arraysOf(std::move(made.result.mesh)), info, snapshots, text);
}

/// From now on.
Deadline deadlineIn(double seconds, const TypedNames &names)
{
    try {
        return Deadline::in(seconds);
    } catch (const InvalidInput &error) {
        throw InvalidInput(sentenceFor(error, hostTerms(names)));
    }
}

void check(const GrowthParameters &parameters, const TypedNames &names)
{
    try {
        parameters.validate();
    } catch (const InvalidInput &error) {
        throw InvalidInput(sentenceFor(error, hostTerms(names)));
    }
}

/// Of points, or where there are faces, of places all over them: `values` of each, red, green,
/// blue, alpha and quality, averaged onto the vertices of the mesh. The filter looks at as many.
nb::object transferAttributes(AnyArray points, const nb::object &faces, AnyArray values,
                              AnyArray meshVertices, AnyArray meshFaces, const Deadline &deadline)
{
    const auto average =
        [points = SharedArray(std::move(points)), faces = optionalArray(faces),
         values = SharedArray(std::move(values)),
         mesh = Mesh{pointsOf(meshVertices), cornersOf(meshFaces)}](const Progress &progress) {
            AttributeTransfer transfer(mesh);
            const std::vector<Point> places = pointsOf(*points);
            const std::vector<AttributeValues> given = attributesOf(*values);
            if (faces)
                transfer.addSurface({places, cornersOf(**faces)}, given,
                                    AttributeTransfer::pointsPerVertex * mesh.positions.size(),
                                    progress);
            else
                transfer.addPoints(places, given, 1, progress);
            return transfer.average();
        };
    return arrayOf(resultOf<std::vector<AttributeValues>>(average, nb::none(), deadline));
}

} // namespace

void defineReconstruction(nb::module_ &module)
{
    nb::enum_<SplitRule>(module, "SplitRule")
        .value("balanced", SplitRule::balanced)
        .value("paper", SplitRule::paper);
    nb::enum_<StartMesh>(module, "StartMesh")
        .value("tetrahedron", StartMesh::tetrahedron)
        .value("octahedron", StartMesh::octahedron)
        .value("icosahedron", StartMesh::icosahedron)
        .value("given", StartMesh::given)
        .value("from_data", StartMesh::fromData);
    nb::enum_<BoundaryRule>(module, "Boundaries")
        .value("closed", BoundaryRule::closed)
        .value("open", BoundaryRule::open);
    nb::enum_<Topology>(module, "Topology")
        .value("of_start", Topology::ofStart)
        .value("learned", Topology::learned);
    nb::class_<GrowthParameters>(module, "Parameters", "Parameters, with the filter's defaults.")
        .def(nb::init<>())
        .def_rw("vertices", &GrowthParameters::targetVertexCount)
        .def_rw("winner_rate", &GrowthParameters::winnerRate)
        .def_rw("smoothing_rate", &GrowthParameters::smoothingRate)
        .def_rw("smoothing_passes", &GrowthParameters::smoothingPasses)
        .def_rw("signals_per_split", &GrowthParameters::signalsPerSplit)
        .def_rw("inactivity_factor", &GrowthParameters::inactivityFactor)
        .def_rw("threads", &GrowthParameters::threads)
        .def_rw("counter_decay", &GrowthParameters::counterDecay)
        .def_rw("split_rule", &GrowthParameters::splitRule)
        .def_rw("edge_flips", &GrowthParameters::edgeFlips)
        .def_rw("surface_fit", &GrowthParameters::surfaceFit)
        .def_rw("topology", &GrowthParameters::topology)
        .def_rw("start_mesh", &GrowthParameters::startMesh)
        .def_rw("boundaries", &GrowthParameters::boundaries)
        .def_rw("max_hole_size", &GrowthParameters::maxHoleSize)
        .def_rw("snapshots", &GrowthParameters::snapshots)
        .def_rw("random_seed", &GrowthParameters::seed)
        .def("check", check, "names"_a, "Raise InvalidInput where one is out of its range.");
    nb::class_<Deadline>(module, "Deadline",
                         "When a run ends with the mesh so far; never if unset.")
        .def(nb::init<>())
        .def_prop_ro("has_passed", &Deadline::hasPassed);
    module.def("deadline_in", deadlineIn, "seconds"_a, "names"_a,
               "Return the deadline that comes in so many seconds; 0: none.");
    module.def("reconstruct", run, "target"_a, "parameters"_a, "start"_a.none(), "names"_a,
               "progress"_a.none(), "deadline"_a);
    module.def("transfer_attributes", transferAttributes, "points"_a, "faces"_a.none(), "values"_a,
               "mesh_vertices"_a, "mesh_faces"_a, "deadline"_a);
    module.attr("POINTS_PER_VERTEX") = AttributeTransfer::pointsPerVertex;
}

} // namespace neuralmesh::python
