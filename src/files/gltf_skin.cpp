#include "files/gltf_skin.h"

#include "files/gltf_elements.h"
#include "files/gltf_model.h"
#include "files/gltf_transform.h"

#include <cmath>

namespace torrance {
namespace {

struct Influences
{
    std::vector<std::vector<vec4>> joints;
    std::vector<std::vector<vec4>> weights;
};

Influences readInfluences(const GltfAttributes& attributes, const std::string& item, const LoadReport& report)
{
    Influences influences;
    for (int set = 0; attributes.has("JOINTS_" + std::to_string(set)); ++set) {
        influences.joints.push_back(attributes.read<4>("JOINTS_" + std::to_string(set)));
        influences.weights.push_back(attributes.read<4>("WEIGHTS_" + std::to_string(set)));
        if (influences.weights.back().empty())
            report.fail(item, "has JOINTS_" + std::to_string(set) + " and no weights for it", kRepair);
    }
    if (influences.joints.empty())
        report.fail(item, "is skinned and has no JOINTS_0", kRepair);
    return influences;
}

dmat4 blended(const Influences& influences, std::size_t vertex, const std::vector<dmat4>& joints,
              const std::string& item, const LoadReport& report)
{
    dmat4 sum(0.0);
    double total = 0.0;
    for (std::size_t set = 0; set < influences.joints.size(); ++set)
        for (int k = 0; k < 4; ++k) {
            const double weight = std::max(static_cast<double>(influences.weights[set][vertex][k]), 0.0);
            const auto joint = static_cast<std::size_t>(influences.joints[set][vertex][k]);
            if (weight == 0.0)
                continue;
            if (joint >= joints.size())
                report.fail(item + "/JOINTS_" + std::to_string(set),
                            "moves a vertex by joint " + std::to_string(joint) + " of a skin of " +
                                std::to_string(joints.size()),
                            kRepair);
            sum += weight * joints[joint];
            total += weight;
        }
    if (total > 0.0)
        return sum / total;
    return joints[std::min(static_cast<std::size_t>(influences.joints[0][vertex][0]), joints.size() - 1)];
}

} // namespace

std::vector<dmat4> jointTransforms(const tinygltf::Model& model, int index, const std::vector<dmat4>& worlds,
                                   const std::vector<GltfAccessor>& accessors, LoadReport& report)
{
    const tinygltf::Skin& skin = model.skins[static_cast<std::size_t>(index)];
    const std::string item = itemName("skins", static_cast<std::size_t>(index));
    if (skin.joints.empty())
        report.fail(item, "has no joints", kRepair);
    std::vector<dmat4> joints;
    for (const int joint : skin.joints)
        joints.push_back(worlds[static_cast<std::size_t>(joint)]);
    if (skin.inverseBindMatrices < 0)
        return joints; // absent: all identity

    const GltfAccessor& accessor = accessors[static_cast<std::size_t>(skin.inverseBindMatrices)];
    if (accessor.columns != 4 || accessor.component != ComponentType::float32 || accessor.count < joints.size())
        report.fail(item, "does not have a float matrix of 4 x 4 for each of its joints", kRepair);
    const std::vector<float> numbers = readNumbers(accessor, report);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        dmat4 inverseBind(1.0); // the bottom row is 0 0 0 1 by definition
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row)
                inverseBind[column][row] =
                    static_cast<double>(numbers[i * 16 + static_cast<std::size_t>(column * 4 + row)]);
        joints[i] = joints[i] * inverseBind;
    }
    return joints;
}

void applySkin(Primitive& primitive, const GltfAttributes& attributes, const std::vector<dmat4>& joints,
               const std::string& item, const LoadReport& report)
{
    const Influences influences = readInfluences(attributes, item, report);
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        const dmat4 worldFromBind = blended(influences, i, joints, item, report);
        const dmat3 linear(worldFromBind);
        primitive.positions[i] = vec3(dvec3(worldFromBind * dvec4(dvec3(primitive.positions[i]), 1.0)));
        if (!std::isfinite(glm::length(dvec3(primitive.positions[i]))))
            report.fail(item, "has a skinned position that overflows", "use smaller joint transforms");
        if (!primitive.normals.empty())
            primitive.normals[i] = vec3(normalTransform(linear) * dvec3(primitive.normals[i]));
        if (!primitive.tangents.empty())
            primitive.tangents[i] = vec4(vec3(linear * dvec3(primitive.tangents[i])), primitive.tangents[i].w);
    }
}

} // namespace torrance
