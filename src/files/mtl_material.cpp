#include "files/mtl_material.h"

#include "scene/phong.h"

#include <algorithm>
#include <limits>

namespace torrance {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

class MaterialConverter
{
public:
    MaterialConverter(const MtlMaterial& material, LoadReport& messages) : from(material), report(messages) {}

    Material convert()
    {
        Material material = plainMaterial();
        material.name = from.name;
        if (from.has("Kd"))
            material.baseColorFactor = dvec4(color(from.values.diffuse, 1.0, "Kd"), 1.0);
        else if (from.has("map_Kd"))
            material.baseColorFactor = dvec4(1.0);
        material.roughnessFactor = roughness();
        material.metallicFactor = value("Pm", from.values.metallic, 1.0, from.has("map_Pm") ? 1.0 : 0.0);
        if (from.has("Ke"))
            material.emissiveFactor = color(from.values.emission, kNoLimit, "Ke");
        else if (from.has("map_Ke"))
            material.emissiveFactor = dvec3(1.0);
        if (from.has("Ni") && from.values.ior > 1.0)
            material.ior = from.values.ior;
        setOpacity(material);
        warnOfUndrawn();
        return material;
    }

private:
    double clamped(double number, double most, const char* key)
    {
        if (number >= 0.0 && number <= most)
            return number;
        warn(std::string("has ") + key +
             (most == kNoLimit ? " below 0, which was set to 0" : " outside 0 to 1, which was clamped"));
        return std::clamp(number, 0.0, most);
    }

    double value(const char* key, double stated, double most, double otherwise)
    {
        return from.has(key) ? clamped(stated, most, key) : otherwise;
    }

    dvec3 color(const tinyobj::real_t (&stated)[3], double most, const char* key)
    {
        return {clamped(stated[0], most, key), clamped(stated[1], most, key), clamped(stated[2], most, key)};
    }

    double roughness()
    {
        if (from.has("Pr"))
            return clamped(from.values.roughness, 1.0, "Pr");
        if (from.has("map_Pr") || from.has("map_Ns")) // which become a texture of roughness
            return 1.0;
        const bool isBlack = from.has("Ks") && from.values.specular[0] == 0.0 && from.values.specular[1] == 0.0 &&
                             from.values.specular[2] == 0.0;
        const bool isMatte = from.has("illum") && from.values.illum < 2;
        if (!from.has("Ns") || isBlack || isMatte)
            return 1.0;
        return perceptualRoughnessOfShininess(clamped(from.values.shininess, kNoLimit, "Ns"));
    }

    /// tinyobjloader has turned Tr into 1 - Tr and given d precedence.
    void setOpacity(Material& material)
    {
        if (!from.has("d") && !from.has("Tr"))
            return;
        material.baseColorFactor.a = clamped(from.values.dissolve, 1.0, from.has("d") ? "d" : "Tr");
        if (material.baseColorFactor.a < 1.0)
            material.alphaMode = AlphaMode::blend;
    }

    void warnOfUndrawn()
    {
        const tinyobj::material_t& v = from.values;
        const auto check = [&](const char* key, double amount, const char* meaning) {
            if (from.has(key) && amount != 0.0)
                warn(std::string("has ") + key + " (" + meaning + "), which is not drawn");
        };
        check("Ps", v.sheen, "sheen");
        check("Pc", v.clearcoat_thickness, "clear coat");
        check("aniso", v.anisotropy, "anisotropy");
        check("map_Ps", 1.0, "sheen");
        check("map_Ks", 1.0, "specular colour");
    }

    void warn(const std::string& text) { report.warn("material " + from.name, text); }

    const MtlMaterial& from;
    LoadReport& report;
};

} // namespace

Material plainMaterial()
{
    Material material;
    material.baseColorFactor = dvec4(dvec3(kPlainBaseColor), 1.0);
    material.metallicFactor = 0.0;
    material.doubleSided = true;
    return material;
}

Material materialOfMtl(const MtlMaterial& from, LoadReport& report)
{
    return MaterialConverter(from, report).convert();
}

} // namespace torrance
