// SPDX-License-Identifier: GPL-3.0-or-later
// Text as an expression, evaluated at a few places; at times as a surface, implicit or parametric,
// from which samples are drawn. A byte says which, and in which range; three lines are expressions.
#include <cmath>

#include "fuzz/choices.h"
#include "fuzz/fuzz_target.h"
#include "neuralmesh/samplers.h"
#include "samplers/surfaces/expression.h"

namespace neuralmesh::fuzz {
namespace {

/// Reports of a sampler after which it is told to stop: a surface that is hard to find takes long.
constexpr int mostReports = 20;
constexpr std::size_t samples = 100;

void evaluate(const std::string &text)
{
    const Expression expression("expr", text, "xyz");
    for (const double x : {0.0, -1.5, 1e300, std::nan("")})
        expression.at({x, x / 2, 1});
}

void drawFrom(const Sampler &sampler)
{
    Random random(1);
    std::vector<Point> drawn;
    sampler.draw(random, samples, drawn);
    require(drawn.size() == samples, "as many samples as were asked for");
    for (const Point &sample : drawn)
        for (const double coordinate : sample)
            require(std::isfinite(coordinate), "samples are finite");
}

void run(Choices &choices)
{
    const int kind = choices.below(16);
    const double size = std::pow(10.0, choices.below(9) - 4);
    const std::string text = choices.line();
    int reports = 0;
    const Progress progress = [&](double, const char *) { return ++reports < mostReports; };
    if (kind == 1)
        drawFrom(*implicitSurfaceSampler({"expr", text},
                                         {{-size, -size, -size}, {size, size, size}}, progress));
    else if (kind == 2)
        drawFrom(
            *parametricSurfaceSampler({{{"x", text}, {"y", choices.line()}, {"z", choices.line()}}},
                                      {0, size}, {0, size}, progress));
    else
        evaluate(text);
}

} // namespace
} // namespace neuralmesh::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    neuralmesh::fuzz::Choices choices(data, size);
    return neuralmesh::fuzz::refusingOrNot([&] { neuralmesh::fuzz::run(choices); });
}
