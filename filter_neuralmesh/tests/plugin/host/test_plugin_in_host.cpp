// SPDX-License-Identifier: GPL-3.0-or-later
// The filters as a host calls them: loaded by MeshLab's plugin manager, on layers of a document.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <cmath>

#include "common/globals.h"
#include "common/ml_document/mesh_document.h"
#include "common/mlexception.h"
#include "common/plugins/interfaces/filter_plugin.h"
#include "common/plugins/plugin_manager.h"

namespace {

constexpr int target = 300;

/// The callback of a host: false once it was called so often.
int callsLeft = 0;
bool goOn(int /*percent*/, const char * /*activity*/)
{
    return --callsLeft > 0;
}
constexpr int unlimited = 1 << 30;

FilterPlugin &plugin()
{
    static PluginManager manager;
    static auto *loaded = dynamic_cast<FilterPlugin *>(manager.loadPlugin(PLUGIN_FILE));
    return *loaded;
}

/// A document with one layer: points of the unit sphere, on a spiral from pole to pole.
class Document {
public:
    explicit Document(int points = 2000)
    {
        CMeshO cloud;
        vcg::tri::Allocator<CMeshO>::AddVertices(cloud, static_cast<std::size_t>(points));
        for (int i = 0; i < points; ++i) {
            const double z = 1 - 2 * (i + 0.5) / points;
            const double angle = i * M_PI * (3 - std::sqrt(5.0));
            const double radius = std::sqrt(1 - z * z);
            cloud.vert[static_cast<std::size_t>(i)].P() = {radius * std::cos(angle),
                                                           radius * std::sin(angle), z};
        }
        cloud_ = document_.addNewMesh(cloud, "sphere");
        cloud_->updateBoxAndNormals();
    }

    RichParameterList defaults(const QAction *filter)
    {
        RichParameterList parameters = plugin().initParameterList(filter, document_);
        parameters.setValue("TargetVertNum", IntValue(target));
        return parameters;
    }

    void apply(const QAction *filter, const RichParameterList &parameters, int calls = unlimited)
    {
        document_.setCurrentMesh(static_cast<int>(cloud_->id()));
        callsLeft = calls;
        unsigned int changed = 0;
        plugin().applyFilter(filter, parameters, document_, changed, goOn);
    }

    int layers() { return static_cast<int>(document_.meshNumber()); }
    int verticesOfCurrent() { return document_.mm()->cm.vn; }
    bool cloudIsCurrent() { return document_.mm() == cloud_; }

private:
    MeshDocument document_;
    MeshModel *cloud_ = nullptr;
};

TEST(PluginInHost, has_filters_with_parameters)
{
    ASSERT_GE(plugin().actions().size(), 3);
    Document document;
    for (const QAction *filter : plugin().actions())
        EXPECT_TRUE(document.defaults(filter).hasParameter("RandomSeed"));
}

TEST(PluginInHost, each_filter_makes_a_layer_of_as_many_vertices_as_asked_for)
{
    for (const QAction *filter : plugin().actions())
        for (const int threads : {1, 2}) {
            Document document;
            RichParameterList parameters = document.defaults(filter);
            parameters.setValue("Threads", IntValue(threads));
            document.apply(filter, parameters);
            EXPECT_EQ(document.layers(), 2);
            EXPECT_EQ(document.verticesOfCurrent(), target);
        }
}

TEST(PluginInHost, a_filter_that_is_cancelled_leaves_the_document_as_it_was)
{
    for (const QAction *filter : plugin().actions()) {
        Document document;
        EXPECT_THROW(document.apply(filter, document.defaults(filter), 1), MLException);
        EXPECT_EQ(document.layers(), 1);
        EXPECT_TRUE(document.cloudIsCurrent());
    }
}

TEST(PluginInHost, what_cannot_be_done_is_refused_and_leaves_the_document_as_it_was)
{
    for (const QAction *filter : plugin().actions()) {
        Document document;
        RichParameterList parameters = document.defaults(filter);
        parameters.setValue("TargetVertNum", IntValue(3));
        EXPECT_THROW(document.apply(filter, parameters), MLException);
        EXPECT_EQ(document.layers(), 1);
        EXPECT_TRUE(document.cloudIsCurrent());
    }
    Document few(3);
    const QAction *reconstruction = plugin().actions().front();
    EXPECT_THROW(few.apply(reconstruction, few.defaults(reconstruction)), MLException);
    EXPECT_EQ(few.layers(), 1);
}

TEST(PluginInHost, runs_one_after_the_other_each_make_their_layer)
{
    const QAction *reconstruction = plugin().actions().front();
    Document document;
    for (int run = 0; run < 10; ++run) {
        RichParameterList parameters = document.defaults(reconstruction);
        parameters.setValue("RandomSeed", IntValue(run));
        parameters.setValue("Boundaries", IntValue(run % 2));
        document.apply(reconstruction, parameters);
        EXPECT_EQ(document.layers(), run + 2);
        EXPECT_EQ(document.verticesOfCurrent(), target);
    }
}

} // namespace

int main(int count, char **arguments)
{
    testing::InitGoogleTest(&count, arguments);
    const QCoreApplication application(count, arguments);
    return RUN_ALL_TESTS();
}
