#include "files/gltf_nodes.h"

#include "files/gltf_items.h"
#include "files/gltf_model.h"
#include "files/gltf_transform.h"

#include <cmath>

namespace torrance {
namespace {

/// Rotations come as floats or as 16-bit integers (error up to 2^-15 a component): beyond this they were not meant as
/// unit.
constexpr double kUnitTolerance = 1e-3;

/// The bottom row of a matrix written with float rounding differs from 0 0 0 1 by no more than this.
constexpr double kAffineTolerance = 1e-6;

dmat4 matrixOf(const std::vector<double>& values, const std::string& item, const LoadReport& report)
{
    dmat4 matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix[column][row] = values[static_cast<std::size_t>(column * 4 + row)];
    const dvec4 bottom(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3] - 1.0);
    if (glm::dot(bottom, bottom) > kAffineTolerance * kAffineTolerance)
        report.fail(item + "/matrix", "is no affine transform (its last row is not 0 0 0 1)", kRepair);
    matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
    matrix[3][3] = 1.0;
    return matrix;
}

dvec4 rotationOf(const std::vector<double>& values, const std::string& item, LoadReport& report)
{
    const dvec4 quaternion(values[0], values[1], values[2], values[3]);
    const double length = glm::length(quaternion);
    if (!(length > 0.0) || !std::isfinite(length))
        report.fail(item + "/rotation", "is a quaternion without a direction", "write 0 0 0 1 for no rotation");
    if (std::abs(length - 1.0) > kUnitTolerance)
        report.warn(item + "/rotation", "is not of unit length and was normalised");
    return quaternion / length;
}

dvec3 vectorOf(const std::vector<double>& values, const dvec3& otherwise)
{
    return values.empty() ? otherwise : dvec3(values[0], values[1], values[2]);
}

bool isFinite(const dmat4& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row]))
                return false;
    return true;
}

} // namespace

GltfNodeTree checkNodeTree(const nlohmann::json& document, const LoadReport& report)
{
    const nlohmann::json& nodes = itemsOf(document, "nodes");
    GltfNodeTree tree;
    tree.parents.assign(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const nlohmann::json& child : itemsOf(nodes[i], "children")) {
            int& parent = tree.parents[child.get<std::size_t>()];
            if (parent >= 0)
                report.fail(itemName("nodes", child.get<std::size_t>()),
                            "is a child of nodes " + std::to_string(parent) + " and " + std::to_string(i), kRepair);
            parent = static_cast<int>(i);
        }

    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (tree.parents[i] < 0)
            tree.parentFirst.push_back(static_cast<int>(i));
    for (std::size_t i = 0; i < tree.parentFirst.size(); ++i) // grows while it is walked
        for (const nlohmann::json& child : itemsOf(nodes[static_cast<std::size_t>(tree.parentFirst[i])], "children"))
            tree.parentFirst.push_back(child.get<int>());
    if (tree.parentFirst.size() == nodes.size())
        return tree;

    // With at most one parent each, what no root reaches hangs below itself.
    std::vector<bool> reached(nodes.size(), false);
    for (const int node : tree.parentFirst)
        reached[static_cast<std::size_t>(node)] = true;
    const auto first = std::find(reached.begin(), reached.end(), false);
    report.fail(itemName("nodes", static_cast<std::size_t>(first - reached.begin())),
                "stands in a cycle: it is its own ancestor or hangs below one that is", kRepair);
}

dmat4 localTransform(const tinygltf::Node& node, const std::string& item, LoadReport& report)
{
    if (!node.matrix.empty())
        return matrixOf(node.matrix, item, report);
    const dvec4 rotation = node.rotation.empty() ? dvec4(0, 0, 0, 1) : rotationOf(node.rotation, item, report);
    return composeTransform(vectorOf(node.translation, dvec3(0.0)), rotation, vectorOf(node.scale, dvec3(1.0)));
}

std::vector<dmat4> worldTransforms(const tinygltf::Model& model, const GltfNodeTree& tree, LoadReport& report)
{
    std::vector<dmat4> worlds(model.nodes.size(), dmat4(1.0));
    for (const int index : tree.parentFirst) {
        const auto i = static_cast<std::size_t>(index);
        const std::string item = itemName("nodes", i);
        const dmat4 local = localTransform(model.nodes[i], item, report);
        worlds[i] = tree.parents[i] < 0 ? local : worlds[static_cast<std::size_t>(tree.parents[i])] * local;
        if (!isFinite(worlds[i]))
            report.fail(item, "has a world transform that overflows", "use smaller scales and translations");
    }
    return worlds;
}

std::vector<int> nodesOfScene(const tinygltf::Model& model, const std::vector<int>& roots)
{
    std::vector<bool> listed(model.nodes.size(), false);
    std::vector<int> pending(roots.rbegin(), roots.rend());
    std::vector<int> nodes;
    while (!pending.empty()) {
        const auto node = static_cast<std::size_t>(pending.back());
        pending.pop_back();
        if (listed[node])
            continue;
        listed[node] = true;
        nodes.push_back(static_cast<int>(node));
        const std::vector<int>& children = model.nodes[node].children;
        pending.insert(pending.end(), children.rbegin(), children.rend());
    }
    return nodes;
}

} // namespace torrance
