// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in, as meshfilterplugin.h is: the components that every mesh of the host has, in single
// precision.
#pragma once

#include <vcg/complex/complex.h>

class VCGVertex;
class VCGFace;

struct VCGUsedTypes
    : vcg::UsedTypes<vcg::Use<VCGVertex>::AsVertexType, vcg::Use<VCGFace>::AsFaceType> {};

class VCGVertex
    : public vcg::Vertex<VCGUsedTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
                         vcg::vertex::Color4b, vcg::vertex::Qualityf, vcg::vertex::BitFlags> {};

class VCGFace : public vcg::Face<VCGUsedTypes, vcg::face::VertexRef, vcg::face::Normal3f,
                                 vcg::face::BitFlags> {};

class VCGMesh : public vcg::tri::TriMesh<std::vector<VCGVertex>, std::vector<VCGFace>> {};
