// SPDX-License-Identifier: GPL-3.0-or-later
// What any host tells its user about a reconstruction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hosts/common/host_terms.h"
#include "neuralmesh/reconstruct.h"

namespace neuralmesh {

struct Reconstruction {
    Result result;
    std::vector<Mesh> snapshots; ///< by vertex count, ascending
    std::uint64_t seed = 0;
    double diagonal = 1; ///< of the input's bounding box
    double seconds = 0;
};

/// Calls put(name, value) for each figure that scripts get, with the names of the interface. Values
/// are int, bool, double and vectors of int and double.
template <class Put> void forEachResult(const Reconstruction &reconstruction, const Put &put)
{
    const Report &report = reconstruction.result.report;
    put("vertices", report.vertices);
    put("faces", report.faces);
    put("genus", report.genus);
    put("components", report.components);
    put("boundary_loops", report.boundaryLoops);
    put("splits", static_cast<int>(report.splitCount));
    put("collapses", static_cast<int>(report.collapseCount));
    put("self_intersections", report.selfIntersections);
    put("seed", static_cast<int>(reconstruction.seed));
    put("signals", static_cast<double>(report.signalCount));
    put("seconds", reconstruction.seconds);
    put("reached_target", report.reachedTarget);
    put("rms_error", report.rmsError);
    put("max_error", report.maxError);
    put("coverage", report.coverage);
    put("unsupported_area", report.unsupportedArea);
    put("convergence", report.convergence);
    put("valence_histogram", report.valenceHistogram);
}

/// Plain text: figures, topology, whether idle vertices were kept, and what is not to be trusted.
std::string summary(const Reconstruction &reconstruction, const HostTerms &terms);

/// A line about the points that were taken for outliers; empty where there were none.
std::string outlierRemark(const Outliers &outliers);

} // namespace neuralmesh
