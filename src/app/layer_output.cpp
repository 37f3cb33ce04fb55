#include "app/layer_output.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/nearest_name.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace torrance {
namespace {

std::vector<std::string> splitNames(const std::string& names)
{
    std::vector<std::string> list;
    std::istringstream stream(names);
    for (std::string name; std::getline(stream, name, ',');)
        list.push_back(name);
    return list;
}

std::string layerFile(const std::string& output, const std::string& layer)
{
    return std::filesystem::path(output).replace_extension(layer + ".exr").string();
}

} // namespace

void checkLayerNames(const std::string& names, const std::vector<std::string>& known)
{
    for (const std::string& name : splitNames(names))
        if (name != "all" && std::ranges::find(known, name) == known.end()) {
            const std::string nearest = nearestName(name, known);
            throw usageError("--aov: unknown layer " + name,
                             nearest.empty() ? "'all' takes every layer" : "did you mean " + nearest + "?");
        }
}

std::vector<ImageLayer> chosenLayers(const std::string& names, const Picture& picture)
{
    const std::vector<std::string> wanted = splitNames(names);
    const bool all = std::ranges::find(wanted, "all") != wanted.end();
    std::vector<ImageLayer> layers;
    for (const Layer& layer : picture.layers)
        if (all || std::ranges::find(wanted, layer.name) != wanted.end())
            layers.push_back({layer.name, layer.channels, layer.image});
    return layers;
}

std::vector<std::string> writeWithLayers(const std::string& output, const Picture& picture,
                                         const std::string& layerNames, const WriteSettings& settings)
{
    const std::vector<ImageLayer> layers = chosenLayers(layerNames, picture);
    std::vector<std::string> written = {output};
    if (layers.empty() || imageFormatOf(output) == ImageFormat::exr) {
        writePicture(output, picture.color, layers, settings);
        return written;
    }
    if (output == "-")
        throw usageError("--aov: standard output takes one picture", "name a file with --output");
    writePicture(output, picture.color, {}, settings);
    for (const ImageLayer& layer : layers) {
        const std::string file = layerFile(output, layer.name);
        writeFile(file, encodeExr(std::span(&layer, 1), {}));
        written.push_back(file);
    }
    return written;
}

} // namespace torrance
