#include "plan/shading_plan.h"

#include "brdf/dfg.h"
#include "brdf/environment.h"
#include "brdf/selection.h"
#include "brdf/texture_filter.h"
#include "plan/attribute_plan.h"

namespace torrance {
namespace {

void define(std::string& text, const char* name, bool set)
{
    if (set)
        text.append("#define ").append(name).append("\n");
}

// A texture's coordinates as one expression of the fragment's inputs: `#define NORMAL_UV inUv0`, or, transformed,
// `#define NORMAL_UV inNormalUv` with `#define NORMAL_UV_SOURCE inUv0` for the vertex shader that makes them.
void defineUv(std::string& text, const TextureKey& key, const std::string& macro, const std::string& transformed)
{
    if (!key.used)
        return;
    const std::string uv = "inUv" + std::to_string(key.uvSet);
    text += "#define " + macro + " " + (key.transformed ? transformed : uv) + "\n";
    if (key.transformed)
        text += "#define " + macro + "_SOURCE " + uv + "\n";
}

// By TextureRole.
struct UvNames
{
    TextureKey ShaderKey::*texture;
    const char* macro;
    const char* input;
};
constexpr UvNames kUvNames[] = {
    {&ShaderKey::baseColor, "BASE_COLOR_UV", "inBaseColorUv"}, {&ShaderKey::material, "MATERIAL_UV", "inMaterialUv"},
    {&ShaderKey::normal, "NORMAL_UV", "inNormalUv"},           {&ShaderKey::occlusion, "OCCLUSION_UV", "inOcclusionUv"},
    {&ShaderKey::emissive, "EMISSIVE_UV", "inEmissiveUv"},     {&ShaderKey::words, "WORDS_UV", "inWordsUv"}};

void defineUvs(std::string& text, const ShaderKey& key)
{
    for (const UvNames& names : kUvNames)
        defineUv(text, key.*names.texture, names.macro, names.input);
}

// Which texel's channel a scalar is, as a member of Texels (shaders/material/texels.glsl).
void definePlace(std::string& text, ScalarPlace place, const char* macro, const char* inMaterial)
{
    const auto member = [&]() -> const char* {
        switch (place) {
        case ScalarPlace::material:
        case ScalarPlace::words:
            return inMaterial;
        case ScalarPlace::own:
            return "occlusion.r";
        case ScalarPlace::baseColorAlpha:
            return "baseColor.a";
        case ScalarPlace::normalAlpha:
            return "normal.a";
        case ScalarPlace::emissiveAlpha:
            return "emissive.a";
        case ScalarPlace::constant:
            break;
        }
        return nullptr;
    };
    if (const char* name = member())
        text.append("#define ").append(macro).append(" ").append(name).append("\n");
}

// Which functions of shaders/environment are called.
void defineEnvironment(std::string& text, const brdf::Preset& methods)
{
    const std::string_view diffuse = methods.environmentDiffuse ? methods.environmentDiffuse->id : "";
    const brdf::Method& specular = *methods.environmentSpecular;
    define(text, "IRRADIANCE_NONE", diffuse.empty());
    define(text, "IRRADIANCE_SH9", diffuse == "sh9" || diffuse == "sh9_windowed");
    define(text, "IRRADIANCE_SH4", diffuse == "sh4");
    define(text, "IRRADIANCE_EVEN", diffuse == "even");
    define(text, "IRRADIANCE_SAMPLED", diffuse == "sampled");
    define(text, "SPECULAR_EVEN", specular.id == "even");
    define(text, "SPECULAR_DOMINANT", specular.id == "split_sum_dominant");
    define(text, "SPECULAR_PHONG_LEVELS", specular.id == "phong_levels");
    define(text, "SPECULAR_GGX_LEVELS", specular.id == "ggx_levels");
    define(text, "SPECULAR_MIRROR", specular.id == "mirror");
    define(text, "READS_RADIANCE", diffuse == "sampled" || brdf::drawsSamples(specular));
    if (brdf::drawsSamples(specular))
        text += "#include \"" + brdf::glslPath(specular) + "\"\n#define SPECULAR_SAMPLER " +
                brdf::functionName(specular) + "\n";
}

// What a source's model makes of the light that those functions return; it reads the model's parameters.
std::string modelEnvironment(const brdf::Method& model)
{
    const std::string id(model.id);
    return "#include \"environment/model/" + id + ".glsl\"\n#define SELECTED_environment environment_" + id + "\n";
}

// toksvig reads a normal map; tokuyoshi how normals turn, of whatever surface.
void defineAntialiasing(std::string& text, const brdf::Preset& methods, bool normalMap)
{
    const brdf::Method& method = *methods.specularAntialiasing;
    define(text, "AA_TOKUYOSHI", method.id == "tokuyoshi");
    define(text, "AA_TOKSVIG", method.id == "toksvig" && normalMap);
}

// Of what reads textures alone: other shaders are the same for every filter.
void defineFilter(std::string& text, const brdf::Preset& methods, const ShaderKey& key)
{
    define(text, "EXACT_LEVEL", brdf::computesLevel(methods) && (key.usesUv(0) || key.usesUv(1)));
    define(text, "ONE_LEVEL", brdf::readsOneLevel(methods) && key.words.used);
}

const char* surfaceMacro(SurfaceKind kind)
{
    switch (kind) {
    case SurfaceKind::triangles:
        return "SURFACE_TRIANGLES";
    case SurfaceKind::lines:
        return "SURFACE_LINES";
    case SurfaceKind::points:
        return "SURFACE_POINTS";
    case SurfaceKind::sphere:
        return "SURFACE_SPHERE";
    case SurfaceKind::plane:
        return "SURFACE_PLANE";
    }
    return "";
}

bool isMesh(SurfaceKind kind)
{
    return kind != SurfaceKind::sphere && kind != SurfaceKind::plane;
}

// Of a triangle the shaders always ask which side is seen: the answer costs less than a percent, and surfaces of one
// side and of two share their shaders.
ShaderKey textKey(const ShaderKey& key)
{
    ShaderKey rest = key;
    rest.doubleSided &= !isMesh(key.surface);
    rest.choice = 0;
    return rest;
}

bool viewsTable(const ShadingPlan& plan)
{
    return plan.settings.view && plan.settings.view->subject == ViewSubject::table;
}

} // namespace

std::string selectedText(const ShadingPlan& plan, const ShaderKey& key)
{
    std::string text = "// " + textKey(key).name() + "\n";
    const bool lit = !key.unlit && key.normals;
    const brdf::Preset& own = choiceOf(plan, key).methods;
    const bool spheres = lit && plan.areaLights && drawsAreaLights(own);
    define(text, surfaceMacro(key.surface), true);
    define(text, "NORMALS", key.normals && isMesh(key.surface));
    define(text, "VANISHING_NORMALS", key.vanishingNormals);
    define(text, "TANGENTS", key.tangents());
    define(text, "UV0", key.usesUv(0));
    define(text, "UV1", key.usesUv(1));
    define(text, "COLORS", key.colors);
    define(text, "ALPHA_MASK", key.alphaMode == AlphaMode::mask);
    define(text, "ALPHA_BLEND", key.alphaMode == AlphaMode::blend);
    define(text, "ONE_PLACE", key.onePlace);
    define(text, "SIDES", key.surface == SurfaceKind::triangles);
    define(text, "DOUBLE_SIDED", textKey(key).doubleSided);
    define(text, "UNLIT", key.unlit);
    define(text, "LIT", lit);
    define(text, "PUNCTUAL_LIGHTS", lit && !plan.lights.empty());
    define(text, "AREA_LIGHTS", spheres);
    define(text, "AREA_SAMPLED", spheres && own.areaLight->id == "sampled");
    defineAntialiasing(text, own, lit && key.normal.used);
    define(text, "ENVIRONMENT_LIGHT", lit && plan.environmentLight);
    if (lit && plan.environmentLight)
        defineEnvironment(text, own);
    const bool lightsReadAlbedo = lit && readsAlbedo(own, key.compensates) && !plan.lights.empty();
    const bool table =
        lit && ((plan.environmentLight && environmentReadsTable(own)) || lightsReadAlbedo || viewsTable(plan));
    define(text, "DFG_TABLE", table);
    if (const brdf::Method* dfg = own.dfg; table && dfg && !brdf::findDfgTable(dfg->id))
        text += "#include \"" + brdf::glslPath(*dfg) + "\"\n#define DFG_FIT " + brdf::functionName(*dfg) + "\n";
    define(text, "READS_LIGHT_ALBEDO", lightsReadAlbedo && key.compensates && own.multipleScattering->readsLightAlbedo);
    defineFilter(text, own, key);
    defineUvs(text, key);
    definePlace(text, key.roughness, "ROUGHNESS_TEXEL", "material.g");
    definePlace(text, key.metallic, "METALLIC_TEXEL", "material.b");
    definePlace(text, key.ambient, "OCCLUSION_TEXEL", "material.r");
    if (lit) {
        brdf::Preset methods = own;
        if (brdf::isComposed(methods) && !key.compensates)
            methods.multipleScattering = brdf::findMethod(brdf::Slot::multipleScattering, "none");
        text += brdf::selectedGlsl(methods);
        if (plan.environmentLight && !brdf::isComposed(methods))
            text += modelEnvironment(*methods.model);
    }
    return text;
}

std::string attributesText(const ShadingPlan& plan, const Batch& batch)
{
    const ShaderKey& key = batch.key;
    std::string text = "// attributes of " + textKey(key).name() + "\n";
    define(text, surfaceMacro(key.surface), true);
    define(text, "NORMALS", key.normals);
    define(text, "VANISHING_NORMALS", key.vanishingNormals);
    define(text, "TANGENTS", key.tangents());
    define(text, "UV0", key.usesUv(0));
    define(text, "UV1", key.usesUv(1));
    define(text, "ALPHA_MASK", key.alphaMode == AlphaMode::mask);
    define(text, "ONE_PLACE", key.onePlace);
    define(text, "SIDES", true);
    defineFilter(text, plan.settings.methods, key);
    defineUvs(text, key);
    define(text, "ATTRIBUTES_HAVE_UV", attributePictures(plan) == 2);
    if (const auto role = levelRole(plan, batch.textures))
        text.append("#define ATTRIBUTE_UV ").append(kUvNames[static_cast<std::size_t>(*role)].macro).append("\n");
    return text;
}

std::string resolveText(const ShadingPlan& plan, const ShadingClass& shadingClass)
{
    std::string text = selectedText(plan, shadingClass.key);
    define(text, "ATTRIBUTE_UV", shadingClass.key.usesUv(0));
    define(text, "MATERIAL_LIST", shadingClass.blocks.size() > 1);
    define(text, "POSITION", !shadingClass.key.unlit && plan.lightCounts[1] + plan.lightCounts[2] > 0);
    return text;
}

} // namespace torrance
