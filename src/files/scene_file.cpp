#include "files/scene_file.h"

#include "files/gltf_extensions.h"
#include "files/gltf_facts.h"
#include "files/gltf_items.h"
#include "files/gltf_open.h"
#include "files/gltf_scene.h"
#include "files/obj_scene.h"

namespace torrance {
namespace {

LoadedScene build(const OpenedGltf& opened, const std::filesystem::path& path, const LoadOptions& options,
                  LoadReport& report)
{
    const nlohmann::json& document = opened.document;
    const int number = sceneNumber(document, options.scene, report);
    checkExtensions(document, report);
    const GltfOrigin origin{path.parent_path(), options.allowExternal};
    const GltfNodeTree tree = checkNodeTree(document, report);
    const GltfBuffers buffers = readBuffers(document, opened.container, origin, report);
    const std::vector<GltfAccessor> accessors = checkAccessors(document, buffers, report);
    if (!itemsOf(document, "animations").empty())
        report.warn("", "has animations, which are not played: it is drawn at rest");
    if (number < 0)
        report.warn("", "has no scenes: all of its nodes are drawn");

    LoadedScene loaded;
    GltfScene built = buildScene(
        {path.stem().string(), document, buffers, accessors, tree, origin, options.limits, options.stop, options.known},
        number, report);
    loaded.scene = std::move(built.scene);
    loaded.items = std::move(built.items);
    loaded.encodedImages = std::move(built.encodedImages);
    loaded.facts = factsOfDocument(document, opened.container, opened.bytes.size());
    addSceneFacts(loaded.facts, loaded.scene);
    loaded.facts.scene = number;
    loaded.facts.bufferBytes = buffers.totalBytes;
    return loaded;
}

LoadedScene finished(LoadedScene loaded, LoadReport& report)
{
    loaded.facts.replacedNumbers = report.nonFiniteNumbers;
    if (report.nonFiniteNumbers > 0)
        report.warn("", "holds " + std::to_string(report.nonFiniteNumbers) +
                            " numbers that are NaN or infinite: 0 is used");
    loaded.warnings = std::move(report.warnings);
    return loaded;
}

} // namespace

LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options)
{
    LoadReport report;
    const bool isObj = isObjFile(path);
    const std::filesystem::path& own = isObj || options.readAs.empty() ? path : options.readAs;
    report.file = own.string();
    try {
        return finished(
            isObj ? loadObj(path, options, report) : build(openGltf(path, report.file), own, options, report), report);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw inputError(report.file, "", "does not fit into memory", "split the model");
    } catch (const std::exception& failure) // of the libraries behind us, on what no check of ours foresaw
    {
        throw inputError(report.file, "", failure.what(), kRepair);
    }
}

SceneFacts readFacts(const std::filesystem::path& path, const LoadOptions& options)
{
    if (isObjFile(path))
        return readObjFacts(path, options);
    LoadReport report;
    report.file = path.string();
    const OpenedGltf opened = openGltf(path, report.file);
    SceneFacts facts = factsOfDocument(opened.document, opened.container, opened.bytes.size());
    facts.scene = sceneNumber(opened.document, options.scene, report);
    return facts;
}

SceneFacts factsOfScene(const Scene& scene)
{
    SceneFacts facts;
    facts.container = "primitive";
    facts.scene = -1;
    facts.primitives = scene.primitives.size();
    for (const Primitive& primitive : scene.primitives)
        facts.meshes.names.push_back(primitive.name);
    addSceneFacts(facts, scene);
    return facts;
}

} // namespace torrance
