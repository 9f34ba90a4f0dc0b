// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter for MeshLab's rewrite, with values as that host makes them of filters.json.
#include <gtest/gtest.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <wrap/io_trimesh/io_mask.h>

#include <cmath>

#include "document.h"
#include "filterparam.h"
#include "meshfilterpluginmanager.h"
#include "neuralmeshfilterplugin.h"

namespace {

const char *const reconstruct = "reconstruct_surface_by_neural_mesh";
const char *const implicit = "create_neural_mesh_from_implicit_surface";
const char *const parametric = "create_neural_mesh_from_parametric_surface";

QJsonObject declarationOf(const QString &filter)
{
    QFile file(QStringLiteral(FILTERS_JSON));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    for (const QJsonValue &declared : json.value("filters").toArray())
        if (declared.toObject().value("id") == filter)
            return declared.toObject();
    ADD_FAILURE() << filter.toStdString() << " is not declared";
    return {};
}

/// The defaults, as the host fills them in.
QVariantMap defaultsOf(const QString &filter)
{
    QVariantMap values;
    for (const QJsonValue &declared : declarationOf(filter).value("parameters").toArray()) {
        const QJsonObject parameter = declared.toObject();
        const bool isLayer = parameter.value("type") == "mesh";
        values.insert(parameter.value("id").toString(),
                      isLayer ? QVariant(-1) : parameter.value("default").toVariant());
    }
    values["targetVertNum"] = 200;
    values["randomSeed"] = 1;
    return values;
}

/// Adds a layer of 2000 points of a sphere around the origin. Returns its index.
int addSphere(Document &document, double radius = 1, const QString &name = {}, int ioMask = 0)
{
    constexpr int count = 2000;
    VCGMesh mesh;
    auto vertex = vcg::tri::Allocator<VCGMesh>::AddVertices(mesh, static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i, ++vertex) {
        const double z = 1 - (2 * i + 1.0) / count;
        const double around = i * 2.399963; // the golden angle
        const double r = std::sqrt(1 - z * z);
        vertex->P() = vcg::Point3f(float(radius * r * std::cos(around)),
                                   float(radius * r * std::sin(around)), float(radius * z));
        vertex->C() = vcg::Color4b(z > 0 ? 200 : 100, 0, 0, 255);
        vertex->Q() = float(i);
    }
    return document.addMesh(mesh, name, ioMask);
}

MeshFilterRunResult run(Document &document, const char *filter, const QVariantMap &values)
{
    MeshFilterPluginManager manager;
    registerNeuralMeshFilterPlugin(manager);
    return manager.plugins.front()->runFilter(filter, FilterParams(values), document);
}

Document &withSphere(Document &document, int ioMask = 0)
{
    document.mesh(addSphere(document, 1, "scan", ioMask)).transform.translate(10, 0, 0);
    return document;
}

TEST(MeshLab2, gets_a_closed_mesh_of_the_exact_size_where_the_layer_is)
{
    Document document;
    const MeshFilterRunResult result =
        run(withSphere(document), reconstruct, defaultsOf(reconstruct));
    ASSERT_TRUE(result.success) << result.errorMessage.toStdString();
    ASSERT_EQ(result.newMeshIndices, QVector<int>{1});
    EXPECT_EQ(result.sourceMeshIndices, QVector<int>{0});
    EXPECT_EQ(result.outputTags, QStringList{"neural mesh"});
    const VCGMesh &mesh = document.mesh(1).mesh;
    EXPECT_EQ(mesh.VN(), 200);
    EXPECT_EQ(mesh.FN(), 396);
    for (const VCGVertex &vertex : mesh.vert)
        EXPECT_NEAR((vertex.cP() - vcg::Point3f(10, 0, 0)).Norm(), 1, 0.05);
    EXPECT_EQ(result.outputValues.value("genus").toInt(), 0);
    EXPECT_GT(result.outputValues.value("valence_histogram").toList().size(), 6);
    EXPECT_EQ(document.finished, 1);
}

TEST(MeshLab2, reports_the_seed_that_it_was_given_or_drew)
{
    Document document;
    QVariantMap values = defaultsOf(reconstruct);
    values["randomSeed"] = 0;
    const MeshFilterRunResult drawn = run(withSphere(document), reconstruct, values);
    EXPECT_EQ(drawn.infoMessages.last(), "Random seed: 7");
    EXPECT_EQ(drawn.outputValues.value("seed").toInt(), 7);
    // Pinned, the same mesh.
    Document again;
    values["randomSeed"] = 7;
    run(withSphere(again), reconstruct, values);
    for (std::size_t i = 0; i < 200; ++i)
        EXPECT_EQ(document.mesh(1).mesh.vert[i].cP(), again.mesh(1).mesh.vert[i].cP());
}

TEST(MeshLab2, takes_every_option_that_it_declares)
{
    for (const QJsonValue &declared : declarationOf(reconstruct).value("parameters").toArray()) {
        const QJsonObject parameter = declared.toObject();
        const QString id = parameter.value("id").toString();
        for (const QJsonValue &option : parameter.value("enumOptions").toArray()) {
            Document document;
            QVariantMap values = defaultsOf(reconstruct);
            values["targetVertNum"] = 50;
            values[id] = option.toObject().value("id").toString();
            const QString said = run(withSphere(document), reconstruct, values).errorMessage;
            EXPECT_FALSE(said.contains("must be one of")) << said.toStdString();
        }
    }
    QVariantMap values = defaultsOf(reconstruct);
    values["source"] = "clouds";
    Document document;
    EXPECT_EQ(run(document, reconstruct, values).errorMessage,
              "source must be one of points, surface, visible_layers, point_file, not 'clouds'.");
}

TEST(MeshLab2, adds_a_layer_for_each_snapshot)
{
    Document document;
    QVariantMap values = defaultsOf(reconstruct);
    values["snapshots"] = "100, 50";
    const MeshFilterRunResult result = run(withSphere(document), reconstruct, values);
    EXPECT_EQ(result.outputTags, (QStringList{"neural mesh 50", "neural mesh 100", "neural mesh"}));
    EXPECT_EQ(document.mesh(1).mesh.VN(), 50);
    EXPECT_EQ(document.mesh(2).mesh.VN(), 100);
}

TEST(MeshLab2, carries_the_attributes_over_that_the_layer_has)
{
    using Mask = vcg::tri::io::Mask;
    Document document;
    const MeshFilterRunResult result =
        run(withSphere(document, Mask::IOM_VERTCOLOR), reconstruct, defaultsOf(reconstruct));
    ASSERT_TRUE(result.success);
    const Document::MeshEntry &layer = document.mesh(1);
    EXPECT_TRUE(layer.ioMask & Mask::IOM_VERTCOLOR);
    EXPECT_FALSE(layer.ioMask & Mask::IOM_VERTQUALITY);
    for (const VCGVertex &vertex : layer.mesh.vert) {
        if (std::abs(vertex.cP().Z()) < 0.3)
            continue; // where the colours meet
        EXPECT_EQ(int(vertex.cC()[0]), vertex.cP().Z() > 0 ? 200 : 100);
    }
}

TEST(MeshLab2, meshes_all_visible_layers_but_no_hidden_one)
{
    Document document;
    addSphere(document, 1);
    addSphere(document, 1.01);
    addSphere(document, 9);
    document.mesh(2).visible = false;
    QVariantMap values = defaultsOf(reconstruct);
    values["source"] = "visible_layers";
    const MeshFilterRunResult result = run(document, reconstruct, values);
    ASSERT_TRUE(result.success) << result.errorMessage.toStdString();
    EXPECT_EQ(result.sourceMeshIndices, (QVector<int>{0, 1}));
    EXPECT_LT(document.mesh(3).mesh.bbox.Diag(), 4);
}

TEST(MeshLab2, meshes_implicit_and_parametric_surfaces_without_a_layer)
{
    for (const char *filter : {implicit, parametric}) {
        Document document;
        const MeshFilterRunResult result = run(document, filter, defaultsOf(filter));
        ASSERT_TRUE(result.success) << filter << ": " << result.errorMessage.toStdString();
        EXPECT_EQ(document.mesh(0).mesh.VN(), 200);
    }
}

TEST(MeshLab2, leaves_the_document_as_it_was_when_cancelled_or_wrong)
{
    Document document;
    withSphere(document).cancels = true;
    EXPECT_EQ(run(document, reconstruct, defaultsOf(reconstruct)).errorMessage,
              "Cancelled: the document is as it was.");
    document.cancels = false;
    QVariantMap values = defaultsOf(reconstruct);
    values["targetVertNum"] = 100'000;
    const MeshFilterRunResult refused = run(document, reconstruct, values);
    EXPECT_FALSE(refused.success);
    EXPECT_TRUE(refused.errorMessage.startsWith("targetVertNum "))
        << refused.errorMessage.toStdString();
    EXPECT_EQ(document.meshCount(), 1);
    EXPECT_EQ(document.begun, 2);
    EXPECT_EQ(document.failed, 2);
    Document empty;
    EXPECT_EQ(run(empty, reconstruct, defaultsOf(reconstruct)).errorMessage,
              "There is no current layer: open or make a point cloud or a mesh first.");
}

TEST(MeshLab2, grows_from_a_layer_where_one_is_named)
{
    Document document;
    run(withSphere(document), reconstruct, defaultsOf(reconstruct));
    QVariantMap values = defaultsOf(reconstruct);
    values["source"] = "surface"; // of the mesh just made, which is current
    values["startMesh"] = "a_layer";
    EXPECT_EQ(run(document, reconstruct, values).errorMessage,
              "startMesh is a layer, but startLayer names none.");
    values["startLayer"] = 1;
    values["targetVertNum"] = 300;
    const MeshFilterRunResult result = run(document, reconstruct, values);
    EXPECT_TRUE(result.success) << result.errorMessage.toStdString();
    EXPECT_EQ(document.mesh(2).mesh.VN(), 300);
}

} // namespace
