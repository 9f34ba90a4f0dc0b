// SPDX-License-Identifier: GPL-3.0-or-later
// Reconstructs a sphere from points and prints it as an OBJ file.
#include <cmath>
#include <cstdio>

#include <neuralmesh/reconstruct.h>
#include <neuralmesh/samplers.h>

int main()
{
    std::vector<neuralmesh::Point> points; // along a spiral
    for (int i = 0; i < 5000; ++i) {
        const double z = (i + 0.5) / 2500 - 1;
        const double radius = std::sqrt(1 - z * z);
        points.push_back({radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), z});
    }
    neuralmesh::GrowthParameters parameters;
    parameters.targetVertexCount = 1000;
    const auto sampler = neuralmesh::pointCloudSampler(points);
    const auto [mesh, report] = neuralmesh::reconstruct(*sampler, parameters);
    for (const neuralmesh::Point &p : mesh.positions)
        std::printf("v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    for (const neuralmesh::Corners &f : mesh.triangles)
        std::printf("f %u %u %u\n", f[0] + 1, f[1] + 1, f[2] + 1);
    return mesh.positions.size() == 1000 && report.genus == 0 ? 0 : 1;
}
