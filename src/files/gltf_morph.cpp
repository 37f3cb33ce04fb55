#include "files/gltf_morph.h"

#include "files/gltf_model.h"
#include "files/gltf_primitive.h"

#include <cmath>

namespace torrance {
namespace {

/// Sums in double whatever the number of targets; rounded to float once.
template <typename Vector>
class Sum
{
public:
    explicit Sum(std::vector<Vector>& values) : target(values), sums(values.size())
    {
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] = dvec3(values[i]);
    }

    void add(const std::vector<vec3>& differences, double weight)
    {
        if (!differences.empty())
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i] += weight * dvec3(differences[i]);
    }

    /// False where a sum is more than a float can hold.
    bool store() const
    {
        bool finite = true;
        for (std::size_t i = 0; i < sums.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                target[i][k] = static_cast<float>(sums[i][k]);
                finite = finite && std::isfinite(target[i][k]);
            }
        return finite;
    }

private:
    std::vector<Vector>& target;
    std::vector<dvec3> sums;
};

void warnOfOtherAttributes(const std::map<std::string, int>& target, const std::string& item, LoadReport& report)
{
    for (const auto& [semantic, accessor] : target)
        if (semantic.starts_with("TEXCOORD_") || semantic.starts_with("COLOR_"))
            report.warn(item, "morphs " + semantic + ", which is left out");
}

} // namespace

void applyMorphTargets(Primitive& primitive, const tinygltf::Primitive& source, const std::vector<double>& weights,
                       const GltfGeometry& geometry, const std::string& item, LoadReport& report)
{
    if (weights.size() != source.targets.size())
        report.fail(item,
                    "has " + std::to_string(source.targets.size()) + " morph targets where " +
                        std::to_string(weights.size()) + " weights are given",
                    kRepair);
    Sum positions(primitive.positions);
    Sum normals(primitive.normals);
    Sum tangents(primitive.tangents);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const std::string targetItem = item + "/targets/" + std::to_string(i);
        const GltfAttributes target(source.targets[i], geometry.accessors, primitive.positions.size(),
                                    geometry.quantizationDeclared, targetItem, report);
        if (weights[i] == 0.0)
            continue;
        warnOfOtherAttributes(source.targets[i], item, report);
        positions.add(target.read<3>("POSITION"), weights[i]);
        if (!primitive.normals.empty())
            normals.add(target.read<3>("NORMAL"), weights[i]);
        if (!primitive.tangents.empty())
            tangents.add(target.read<3>("TANGENT"), weights[i]);
    }
    if (!positions.store() || !normals.store() || !tangents.store())
        report.fail(item, "overflows when its morph targets are added", "use smaller weights");
}

} // namespace torrance
