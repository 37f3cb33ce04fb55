#include "files/gltf_instancing.h"

#include "files/gltf_elements.h"
#include "files/gltf_model.h"
#include "files/gltf_transform.h"

namespace torrance {
namespace {

class InstanceAttributes
{
public:
    InstanceAttributes(const tinygltf::Value& source, const std::vector<GltfAccessor>& all, const std::string& name,
                       LoadReport& messages)
        : attributes(source.Get("attributes")), accessors(all), item(name), report(messages)
    {
        for (const std::string& semantic : attributes.Keys()) {
            const GltfAccessor& accessor = accessorOf(semantic);
            if (count != 0 && accessor.count != count)
                report.fail(item, "has attributes of unequal counts", kRepair);
            count = accessor.count;
        }
    }

    template <int N>
    std::vector<glm::vec<N, float>> read(const char* semantic, const glm::vec<N, float>& otherwise) const
    {
        if (!attributes.Has(semantic))
            return std::vector<glm::vec<N, float>>(count, otherwise);
        const GltfAccessor& accessor = accessorOf(semantic);
        const bool real = accessor.component == ComponentType::float32;
        const bool compact = accessor.normalized &&
                             (accessor.component == ComponentType::int8 || accessor.component == ComponentType::int16);
        if (!accessor.isVector(N) || !(real || (N == 4 && compact)))
            report.fail(item + "/" + semantic, "has a format that EXT_mesh_gpu_instancing does not allow", kRepair);
        return readVectors<N>(accessor, report);
    }

    std::size_t count = 0;

private:
    const GltfAccessor& accessorOf(const std::string& semantic) const
    {
        return accessors[static_cast<std::size_t>(attributes.Get(semantic).GetNumberAsInt())];
    }

    const tinygltf::Value& attributes;
    const std::vector<GltfAccessor>& accessors;
    std::string item;
    LoadReport& report;
};

} // namespace

std::optional<std::vector<dmat4>> instanceTransforms(const tinygltf::Node& node,
                                                     const std::vector<GltfAccessor>& accessors, std::size_t most,
                                                     const std::string& item, LoadReport& report)
{
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end())
        return std::nullopt;
    const InstanceAttributes attributes(extension->second, accessors, item + "/extensions/EXT_mesh_gpu_instancing",
                                        report);
    if (attributes.count > most)
        report.fail(item,
                    "asks for " + std::to_string(attributes.count) + " instances where " + std::to_string(most) +
                        " is the most",
                    "split the model");
    const std::vector<vec3> translations = attributes.read<3>("TRANSLATION", vec3(0.0f));
    const std::vector<vec4> rotations = attributes.read<4>("ROTATION", vec4(0.0f, 0.0f, 0.0f, 1.0f));
    const std::vector<vec3> scales = attributes.read<3>("SCALE", vec3(1.0f));
    std::vector<dmat4> transforms;
    transforms.reserve(attributes.count);
    for (std::size_t i = 0; i < attributes.count; ++i) {
        const double length = glm::length(dvec4(rotations[i]));
        if (!(length > 0.0))
            report.fail(item + "/extensions/EXT_mesh_gpu_instancing/ROTATION",
                        "has a quaternion without a direction at " + std::to_string(i), kRepair);
        transforms.push_back(composeTransform(dvec3(translations[i]), dvec4(rotations[i]) / length, dvec3(scales[i])));
    }
    return transforms;
}

} // namespace torrance
