#include "plan/shader_key.h"

namespace torrance {
namespace {

const char* surfaceName(SurfaceKind kind)
{
    switch (kind) {
    case SurfaceKind::triangles:
        return "triangles";
    case SurfaceKind::lines:
        return "lines";
    case SurfaceKind::points:
        return "points";
    case SurfaceKind::sphere:
        return "sphere";
    case SurfaceKind::plane:
        return "plane";
    }
    return "";
}

const char* placeName(ScalarPlace place)
{
    switch (place) {
    case ScalarPlace::material:
        return "material";
    case ScalarPlace::baseColorAlpha:
        return "baseColor";
    case ScalarPlace::normalAlpha:
        return "normal";
    case ScalarPlace::emissiveAlpha:
        return "emissive";
    case ScalarPlace::words:
        return "words";
    case ScalarPlace::constant:
    case ScalarPlace::own:
        break;
    }
    return "";
}

} // namespace

SurfaceKind surfaceKindOf(Topology topology)
{
    switch (topology) {
    case Topology::points:
        return SurfaceKind::points;
    case Topology::lines:
        return SurfaceKind::lines;
    case Topology::triangles:
        break;
    }
    return SurfaceKind::triangles;
}

bool ShaderKey::usesUv(int set) const
{
    for (const TextureKey* texture : {&baseColor, &material, &normal, &occlusion, &emissive, &words})
        if (texture->used && texture->uvSet == set)
            return true;
    return false;
}

std::string ShaderKey::name() const
{
    std::string text = surfaceName(surface);
    const auto texture = [&](const TextureKey& key, const char* label) {
        if (key.used)
            text.append(" ").append(label);
        if (key.used && !onePlace)
            text.append(std::to_string(key.uvSet)).append(key.transformed ? "t" : "");
    };
    const auto flag = [&](bool set, const char* label) {
        if (set)
            text.append(" ").append(label);
    };
    const auto place = [&](ScalarPlace p, const char* label) {
        if (p != ScalarPlace::constant && p != ScalarPlace::own) // those have a texture's own name, or none
            text.append(" ").append(label).append("@").append(placeName(p));
    };
    flag(!normals, "no-normals");
    flag(vanishingNormals, "vanishing-normals");
    flag(colors, "colors");
    texture(baseColor, "baseColor");
    texture(material, "material");
    texture(normal, "normal");
    texture(occlusion, "occlusion");
    texture(emissive, "emissive");
    texture(words, "words");
    place(roughness, "roughness");
    place(metallic, "metallic");
    place(ambient, "occlusion");
    flag(alphaMode == AlphaMode::mask, "mask");
    flag(alphaMode == AlphaMode::blend, "blend");
    flag(doubleSided, "double-sided");
    flag(unlit, "unlit");
    flag(compensates, "compensated");
    if (choice > 0)
        text.append(" choice").append(std::to_string(choice));
    return text;
}

} // namespace torrance
