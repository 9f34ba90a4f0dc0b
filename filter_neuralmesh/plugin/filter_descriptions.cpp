// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_descriptions.h"

namespace {

QString withReference(const QString &text)
{
    return text + "<br><br>See:<br>"
                  "<i>I. Ivrissimtzis, W.-K. Jeong, H.-P. Seidel</i><br>"
                  "<b>\"Using Growing Cell Structures for Surface Reconstruction\"</b><br>"
                  "Shape Modeling International 2003";
}

} // namespace

QString aboutReconstruction()
{
    return withReference(
        "Reconstructs a surface from points with a growing neural network: a coarse mesh of the "
        "points' own handles and parts is moved by random samples of the points and grows by "
        "vertex splits until it has exactly the number of vertices asked for."
        "<br>For points without normals, with noise or in great number (the running time does not "
        "depend on it), and where the number of vertices matters. The points are those of the "
        "current layer, of its surface, of all visible layers, or of a file on disk. The result is "
        "a two-manifold with even triangles, closed or with the boundaries of the points.");
}

QString aboutImplicitSurface()
{
    return withReference(
        "Makes a mesh of exactly the number of vertices asked for from the surface on which "
        "a function of x, y and z is zero, with a growing neural network: a coarse mesh of the "
        "surface that is moved by random points of it, uniform by area, and grows by vertex splits."
        "<br>Unlike marching cubes it makes even triangles. The result has the handles and parts "
        "of the surface. Where the surface leaves the box, it is closed, or open if you like.");
}

QString aboutParametricSurface()
{
    return withReference(
        "Makes a mesh of exactly the number of vertices asked for from the surface that x, "
        "y and z as functions of u and v describe, with a growing neural network: a coarse mesh of "
        "the surface that is moved by random points of it, uniform by area, and grows by vertex "
        "splits."
        "<br>The result has the handles and parts of the surface. Where the surface has a "
        "boundary, it is closed, or open if you like.");
}
