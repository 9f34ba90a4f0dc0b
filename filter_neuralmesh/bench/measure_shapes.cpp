// SPDX-License-Identifier: GPL-3.0-or-later
// How accurate meshes are of shapes that nothing was tuned on, and what they take: a row for each
// shape and seed. The shapes have distance functions, so errors are exact.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/measured_shapes.h"
#include "neuralmesh/reconstruct.h"

namespace neuralmesh {
namespace {

struct Figures {
    double rms = 0;      ///< both ways, in per cent of the diagonal
    double greatest = 0; ///< likewise
    double valence6 = 0; ///< share of the vertices, in per cent
    double seconds = 0;  ///< of this process's own
    int crossings = 0;   ///< faces that intersect another
};

double percentOfValence6(const Report &report)
{
    const std::vector<int> &histogram = report.valenceHistogram;
    return histogram.size() > 6 ? 100.0 * histogram[6] / report.vertices : 0;
}

Figures measure(const bench::Target &target)
{
    const std::clock_t start = std::clock();
    const Result result = reconstruct(*target.sampler(), target.parameters);
    Figures figures;
    figures.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const test::WorldFaces faces = bench::facesOf(result.mesh);
    const test::Deviation there = test::pointsToFaces(target.clean, faces);
    const test::Deviation back =
        target.isSeenFromOneSide ? there : test::facesToShape(faces, target.shape);
    const double percent = 100 / bench::diagonalOf(target.clean);
    figures.rms = percent * std::hypot(there.rms, back.rms) / std::sqrt(2.0);
    figures.greatest = percent * std::max(there.largest, back.largest);
    figures.valence6 = percentOfValence6(result.report);
    figures.crossings = result.report.selfIntersections;
    return figures;
}

/// What the command line asks for.
struct Request {
    int vertices = 0;
    std::vector<std::uint64_t> seeds;
    std::vector<std::string> shapes; ///< none: all
    std::vector<std::pair<std::string, double>> parameters;
};

void set(GrowthParameters &parameters, const std::string &name, double value)
{
    if (name == "winnerRate")
        parameters.winnerRate = value;
    else if (name == "smoothingRate")
        parameters.smoothingRate = value;
    else if (name == "smoothingPasses")
        parameters.smoothingPasses = static_cast<int>(value);
    else if (name == "signalsPerSplit")
        parameters.signalsPerSplit = static_cast<int>(value);
    else if (name == "inactivityFactor")
        parameters.inactivityFactor = static_cast<int>(value);
    else if (name == "counterDecay")
        parameters.counterDecay = value;
    else
        throw std::invalid_argument("There is no parameter " + name + ".");
}

/// Throws std::invalid_argument for numbers that are none.
Request read(int argc, const char *const *argv)
{
    Request request;
    request.vertices = std::stoi(argv[1]);
    std::istringstream seeds(argv[2]);
    for (std::string seed; std::getline(seeds, seed, ',');)
        request.seeds.push_back(std::stoull(seed));
    for (int i = 3; i < argc; ++i) {
        const std::string word = argv[i];
        if (const std::size_t equals = word.find('='); equals != std::string::npos)
            request.parameters.emplace_back(word.substr(0, equals),
                                            std::stod(word.substr(equals + 1)));
        else
            request.shapes.push_back(word);
    }
    return request;
}

bool asksFor(const Request &request, const std::string &shape)
{
    return request.shapes.empty() ||
           std::find(request.shapes.begin(), request.shapes.end(), shape) != request.shapes.end();
}

void run(const Request &request)
{
    std::printf("shape\tseed\trms\tgreatest\tvalence6\tseconds\tcrossings\n");
    for (const bench::MeasuredShape &shape : bench::measuredShapes()) {
        if (!asksFor(request, shape.name))
            continue;
        for (const std::uint64_t seed : request.seeds) {
            bench::Target target = shape.make(seed);
            target.parameters.targetVertexCount = request.vertices;
            target.parameters.seed = seed;
            for (const auto &[name, value] : request.parameters)
                set(target.parameters, name, value);
            const Figures f = measure(target);
            std::printf("%s\t%d\t%.6g\t%.6g\t%.6g\t%.6g\t%d\n", shape.name.c_str(),
                        static_cast<int>(seed), f.rms, f.greatest, f.valence6, f.seconds,
                        f.crossings);
            std::fflush(stdout);
        }
    }
}

int usage(const char *program)
{
    std::fprintf(stderr,
                 "Usage: %s VERTICES SEED[,SEED...] [SHAPE...] [PARAMETER=VALUE...]\n\n"
                 "Without a shape: all of",
                 program);
    for (const bench::MeasuredShape &shape : bench::measuredShapes())
        std::fprintf(stderr, " %s", shape.name.c_str());
    std::fprintf(stderr, "\nParameters are those of GrowthParameters that are rates and counts.\n");
    return 2;
}

} // namespace
} // namespace neuralmesh

int main(int argc, const char *const *argv)
{
    try {
        if (argc < 3)
            return neuralmesh::usage(argv[0]);
        neuralmesh::run(neuralmesh::read(argc, argv));
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
