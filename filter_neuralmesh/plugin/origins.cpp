// SPDX-License-Identifier: GPL-3.0-or-later
#include "origins.h"

#include <cstdint>

namespace {

constexpr const char *attribute = "neural mesh: made of";

struct Note {
    Origin origin;
    std::uint64_t content = 0;
};

/// FNV-1a over coordinates, corners and the matrix: whoever changes a result makes it his own.
class Content {
public:
    template <class Value> void add(const Value &value)
    {
        const auto *bytes = reinterpret_cast<const unsigned char *>(&value);
        for (std::size_t k = 0; k < sizeof value; ++k)
            hash_ = (hash_ ^ bytes[k]) * 1099511628211U;
    }

    [[nodiscard]] std::uint64_t hash() const { return hash_; }

private:
    std::uint64_t hash_ = 14695981039346656037U;
};

std::uint64_t contentOf(const MeshModel &layer)
{
    Content content;
    for (int k = 0; k < 16; ++k)
        content.add(layer.cm.Tr.V()[k]);
    for (const CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD())
            for (int axis = 0; axis < 3; ++axis)
                content.add(vertex.cP()[axis]);
    for (const CFaceO &face : layer.cm.face)
        if (!face.IsD())
            for (int corner = 0; corner < 3; ++corner)
                content.add(vcg::tri::Index(layer.cm, face.cV(corner)));
    return content.hash();
}

} // namespace

void remember(MeshModel &result, const Origin &origin)
{
    auto note = vcg::tri::Allocator<CMeshO>::GetPerMeshAttribute<Note>(result.cm, attribute);
    note() = {origin, contentOf(result)};
}

std::optional<Origin> originOf(const MeshModel &layer)
{
    const auto note = vcg::tri::Allocator<CMeshO>::FindPerMeshAttribute<Note>(layer.cm, attribute);
    if (!vcg::tri::Allocator<CMeshO>::IsValidHandle(layer.cm, note) ||
        note().content != contentOf(layer))
        return {};
    return note().origin;
}

const MeshModel *inputLayer(const MeshDocument &document, Source source)
{
    const MeshModel *current = document.mm();
    if (current == nullptr)
        return nullptr;
    const std::optional<Origin> origin = originOf(*current);
    if (!origin || origin->source != source)
        return current;
    const MeshModel *input = document.getMesh(origin->layer);
    return input == nullptr ? current : input;
}

std::string remarkOnOrigin(const MeshDocument &document, Source source)
{
    const MeshModel *current = document.mm();
    if (current == nullptr || !originOf(*current))
        return {};
    const MeshModel *input = inputLayer(document, source);
    if (input != current)
        return "The current layer is the result of an earlier run: its input, '" +
               input->label().toStdString() + "', was taken again.";
    if (source != Source::pointsOfLayer)
        return {}; // its surface is as good as any
    return "Warning: the current layer is the result of an earlier run, so the points are the "
           "vertices of a mesh. Make the scan the current layer.";
}
