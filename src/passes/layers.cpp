#include "passes/layers.h"

namespace torrance {
namespace {

Layer take(const char* name, const Image& target, int first, std::vector<std::string> channels)
{
    const int count = static_cast<int>(channels.size());
    Layer layer = {name, std::move(channels), Image(target.width, target.height, count)};
    for (int y = 0; y < target.height; ++y)
        for (int x = 0; x < target.width; ++x)
            std::copy_n(target.at(x, y) + first, count, layer.image.at(x, y));
    return layer;
}

void addEye(Image& positions, const Image& coverage, const dvec3& eye)
{
    for (int y = 0; y < positions.height; ++y)
        for (int x = 0; x < positions.width; ++x)
            for (int c = 0; c < 3 && coverage.at(x, y)[3] > 0.0f; ++c)
                positions.at(x, y)[c] = static_cast<float>(positions.at(x, y)[c] + eye[c]);
}

} // namespace

std::vector<std::string> layerNames()
{
    std::vector<std::string> names;
    const std::vector<Image> nothing(kLayerTargets, Image(0, 0, 4));
    for (const Layer& layer : splitLayers(nothing, dvec3(0.0)))
        names.push_back(layer.name);
    return names;
}

std::vector<Layer> splitLayers(std::span<const Image> targets, const dvec3& eye)
{
    const std::vector<std::string> xyz = {"X", "Y", "Z"}, rgb = {"R", "G", "B"}, scalar = {"V"};
    std::vector<Layer> layers = {
        take("depth", targets[0], 3, scalar),       take("position", targets[0], 0, xyz),
        take("normal", targets[1], 0, xyz),         take("geometric_normal", targets[2], 0, xyz),
        take("base_color", targets[3], 0, rgb),     take("metallic", targets[2], 3, scalar),
        take("roughness", targets[1], 3, scalar),   take("occlusion", targets[3], 3, scalar),
        take("emissive", targets[4], 0, rgb),       take("object_id", targets[5], 0, scalar),
        take("material_id", targets[5], 1, scalar),
    };
    addEye(layers[1].image, targets[4], eye);
    return layers;
}

} // namespace torrance
