// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the plugin named on the command line through MeshLab's plugin manager, and runs each of its
// filters on good and on bad input. Exit codes: 0 all is as it has to be, 1 something is not.
#include <QCoreApplication>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>

#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>

/// VCG's meshes do not free their attributes, of which remember() gives one to each result.
extern "C" const char *__lsan_default_suppressions()
{
    return "leak:remember";
}

namespace {

constexpr int vertices = 60;

/// Points of the unit sphere, on a spiral from pole to pole.
void addSphere(MeshDocument &document, int count)
{
    MeshModel &layer = *document.addNewMesh("", "sphere");
    auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(layer.cm, count);
    for (int i = 0; i < count; ++i, ++vertex) {
        const Scalarm z = 1 - (2 * i + Scalarm(1)) / count;
        const Scalarm r = std::sqrt(1 - z * z);
        vertex->P() = Point3m(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z);
    }
    layer.updateBoxAndNormals();
}

void addTriangle(MeshDocument &document)
{
    addSphere(document, 3);
    CMeshO &mesh = document.mm()->cm;
    vcg::tri::Allocator<CMeshO>::AddFace(mesh, &mesh.vert[0], &mesh.vert[1], &mesh.vert[2]);
}

/// What is asked for in place of the defaults.
using Changes = std::function<void(RichParameterList &, MeshDocument &)>;

class Host {
public:
    explicit Host(const QString &path)
    {
        MeshLabPlugin *plugin = manager_.loadPlugin(path);
        filters_ = dynamic_cast<FilterPlugin *>(plugin);
        if (filters_ == nullptr)
            throw MLException(path + " has no filters.");
    }

    /// Runs a filter, whose layers have to be those that were there and `layers` more.
    void expectLayers(const char *filter, int layers, const Changes &changes)
    {
        expect(filter, layers, "", changes);
    }

    /// Runs a filter that has to refuse by a sentence with these words, and to change nothing.
    void expectRefusal(const char *filter, const std::string &words, const Changes &changes)
    {
        expect(filter, 0, words, changes);
    }

    int failures() const { return failures_; }

private:
    void expect(const char *filter, int layers, const std::string &words, const Changes &changes)
    {
        MeshDocument document;
        QAction *action = filters_->getFilterAction(filter);
        RichParameterList parameters = filters_->initParameterList(action, document);
        parameters.setValue("TargetVertNum", IntValue(vertices));
        changes(parameters, document);
        const auto before = static_cast<int>(document.meshNumber());
        std::string refusal;
        try {
            unsigned int mask = 0;
            filters_->applyFilter(action, parameters, document, mask, &isToGoOn);
        } catch (const MLException &error) {
            refusal = error.what();
        }
        const auto added = static_cast<int>(document.meshNumber()) - before;
        const bool isRefused = !words.empty() && refusal.find(words) != std::string::npos;
        const bool isMade = words.empty() && refusal.empty() && document.mm()->cm.vn == vertices;
        if (added != layers || (!isRefused && !isMade)) {
            ++failures_;
            std::printf("%s: %d layers more, \"%s\"\n", filter, added, refusal.c_str());
        }
    }

    static bool isToGoOn(int, const char *) { return true; }

    PluginManager manager_;
    FilterPlugin *filters_ = nullptr;
    int failures_ = 0;
};

constexpr const char *reconstruction = "Surface Reconstruction: Neural Mesh";
constexpr const char *byOldName = "Neural Mesh Reconstruction";
constexpr const char *implicit = "Neural Mesh from Implicit Surface";
constexpr const char *parametric = "Neural Mesh from Parametric Surface";

void runOnLayers(Host &host)
{
    const auto sphere = [](RichParameterList &, MeshDocument &document) {
        addSphere(document, 400);
    };
    host.expectLayers(reconstruction, 1, sphere);
    host.expectLayers(byOldName, 1, sphere);
    host.expectLayers(reconstruction, 3, [](RichParameterList &parameters, MeshDocument &document) {
        addSphere(document, 400);
        parameters.setValue("Snapshots", StringValue("20,40"));
        parameters.setValue("Boundaries", IntValue(1));
    });
    host.expectRefusal(reconstruction, "There is no current layer",
                       [](RichParameterList &, MeshDocument &) {});
    host.expectRefusal(reconstruction, "Only 3 distinct points",
                       [](RichParameterList &, MeshDocument &document) { addTriangle(document); });
    host.expectRefusal(reconstruction, "1 of 400 points have coordinates that are NaN",
                       [](RichParameterList &, MeshDocument &document) {
                           addSphere(document, 400);
                           document.mm()->cm.vert[7].P().X() =
                               std::numeric_limits<Scalarm>::quiet_NaN();
                       });
    host.expectRefusal(reconstruction, "must be at least 4",
                       [](RichParameterList &parameters, MeshDocument &document) {
                           addSphere(document, 400);
                           parameters.setValue("TargetVertNum", IntValue(3));
                       });
    host.expectRefusal(reconstruction, "the file cannot be opened",
                       [](RichParameterList &parameters, MeshDocument &) {
                           parameters.setValue("Source", IntValue(3));
                           parameters.setValue("PointFile", StringValue("/no such file.ply"));
                       });
}

void runOnFunctions(Host &host)
{
    const auto byDefault = [](RichParameterList &, MeshDocument &) {};
    host.expectLayers(implicit, 1, byDefault);
    host.expectLayers(parametric, 1, byDefault);
    host.expectRefusal(implicit, "does not parse",
                       [](RichParameterList &parameters, MeshDocument &) {
                           parameters.setValue("expr", StringValue("x*x +"));
                       });
    host.expectRefusal(parametric, "does not parse",
                       [](RichParameterList &parameters, MeshDocument &) {
                           parameters.setValue("x", StringValue("w"));
                       });
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    try {
        Host host(argc > 1 ? argv[1] : "");
        runOnLayers(host);
        runOnFunctions(host);
        std::printf("%d failures\n", host.failures());
        return host.failures() > 0 ? 1 : 0;
    } catch (const MLException &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
