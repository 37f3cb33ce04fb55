#include "plan/shading_plan.h"

#include "brdf/dfg.h"
#include "brdf/texture_filter.h"
#include "core/error.h"
#include "plan/attribute_plan.h"
#include "plan/compensation.h"
#include "plan/culling_plan.h"
#include "plan/deferred_plan.h"
#include "plan/light_plan.h"
#include "plan/method_checks.h"
#include "plan/path_plan.h"
#include "plan/pixel_sampling_plan.h"
#include "plan/primitive_facts.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

namespace torrance {
namespace {

class Planner
{
public:
    Planner(const Scene& s, std::span<const TexelFacts> f, const Settings& settings) : scene(s), facts(f)
    {
        plan.settings = settings;
    }

    ShadingPlan run()
    {
        checkMaterialMethods();
        planMaterials();
        planSurfaces();
        if (plan.choices.empty()) // nothing is lit
            plan.choices.push_back(withLightMethods(plan.settings, lightMethodsOf(plan.settings)));
        planLighting();
        checkPixelSampling(plan);
        choosePath(scene, plan);
        planCulling(scene, plan);
        if (plan.path == RenderPath::deferred)
            planDeferred(plan);
        if (plan.path == RenderPath::attributes)
            planAttributes(plan);
        return std::move(plan);
    }

private:
    void planMaterials();
    void planSurfaces();
    void planLighting();
    void planAreaLights();
    void addPrimitives();
    void addShapes();
    void add(const ShaderKey& key, const TextureSet& textures, Draw draw);
    int blockIndex(int material, const TextureSet& textures);
    int choiceIndex(std::size_t material);
    void checkMaterialMethods() const;

    std::size_t materialIndex(int material) const
    {
        return material < 0 ? scene.materials.size() : static_cast<std::size_t>(material);
    }
    std::pair<ShaderKey, TextureSet> keyOf(const PlannedMaterial& planned, const Primitive& primitive);
    int textureIndex(const PlannedTexture& texture);
    TextureKey textureKey(const TextureUse& use, const Primitive& primitive, const char* what);

    const Scene& scene;
    std::span<const TexelFacts> facts;
    ShadingPlan plan;
    Box bounds;
    std::map<PlannedTexture, int> numbers;                     // in ShadingPlan::textures
    std::map<std::pair<int, TextureSet>, int> blocks;          // ShadingPlan::blocks by material and textures
    std::map<std::pair<ShaderKey, TextureSet>, Batch> batches; // ordered: the same scene gives the same batches
};

void Planner::checkMaterialMethods() const
{
    for (const auto& [material, methods] : plan.settings.ofMaterials)
        if (material < 0 || static_cast<std::size_t>(material) > scene.materials.size())
            throw usageError(
                "--material-methods: there is no material " + std::to_string(material) + ", but " +
                    std::to_string(scene.materials.size()),
                "torrance inspect lists them, the first is 0; the number behind the last is glTF's default");
}

// Of a lit surface: the first that is lit alike, or a new one.
int Planner::choiceIndex(std::size_t material)
{
    const LightMethods own = lightMethodsOf(plan.settings, static_cast<int>(material));
    const auto alike = [&](const Settings& choice) { return lightMethodsOf(choice) == own; };
    const auto found = std::ranges::find_if(plan.choices, alike);
    const auto index = static_cast<int>(found - plan.choices.begin());
    if (found == plan.choices.end())
        plan.choices.push_back(withLightMethods(plan.settings, own));
    return index;
}

void Planner::planMaterials()
{
    std::vector<Material> materials = scene.materials;
    materials.emplace_back().name = "default";
    const bool mayCompensate =
        brdf::isComposed(plan.settings.methods) && plan.settings.methods.multipleScattering->id != "none";
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const std::string subject =
            "material " + (materials[i].name.empty() ? std::to_string(i) : "'" + materials[i].name + "'");
        PlannedMaterial planned = planMaterial(scene, materials[i], facts, subject, plan.remarks);
        if (mayCompensate && !planned.material.unlit) {
            planned.compensates = compensationGain(planned.range) > kCompensationThreshold;
            plan.remarks.push_back(
                planned.compensates
                    ? Remark{subject, "multiple scattering compensated", "its lobe loses more than 0.1 % of its light"}
                    : Remark{subject, "no multiple scattering", "it would change less than 0.1 % of its light"});
        }
        plan.materials.push_back(std::move(planned));
    }
}

TextureKey Planner::textureKey(const TextureUse& use, const Primitive& primitive, const char* what)
{
    if (!use.used())
        return {};
    if (primitive.uvs[static_cast<std::size_t>(use.uvSet)].empty()) {
        plan.remarks.push_back({"primitive '" + primitive.name + "'", std::string("no ") + what + " texture",
                                "the primitive has no texture coordinates " + std::to_string(use.uvSet)});
        return {};
    }
    return {.used = true, .uvSet = use.uvSet, .transformed = use.transform != glm::dmat3x2(1, 0, 0, 1, 0, 0)};
}

std::pair<ShaderKey, TextureSet> Planner::keyOf(const PlannedMaterial& planned, const Primitive& primitive)
{
    const Material& m = planned.material;
    ShaderKey key = {.surface = surfaceKindOf(primitive.topology),
                     .normals = !primitive.normals.empty(),
                     .colors = !primitive.colors.empty()};
    key.alphaMode = m.alphaMode;
    key.doubleSided = m.doubleSided && key.surface == SurfaceKind::triangles;
    key.unlit = m.unlit;
    TextureNeeds needs;
    needs.baseColor = textureKey(m.baseColor, primitive, "base colour");
    needs.emissive = textureKey(m.emissive, primitive, "emissive");
    if (!key.unlit && key.normals) {
        needs.metallicRoughness = textureKey(m.metallicRoughness, primitive, "metallic-roughness");
        needs.roughness = needs.metallicRoughness.used && planned.roughnessVaries;
        needs.metallic = needs.metallicRoughness.used && planned.metallicVaries;
        if (key.surface == SurfaceKind::triangles)
            needs.normal = textureKey(m.normal, primitive, "normal");
        needs.occlusion = textureKey(m.occlusion, primitive, "occlusion");
        needs.lengthInAlpha = plan.settings.methods.specularAntialiasing->id == "toksvig";
        key.compensates = planned.compensates;
    }
    needs.words = brdf::readsWords(plan.settings.methods);
    needs.nearestLevel = brdf::readsOneLevel(plan.settings.methods);
    const RoleTextures textures = planTextures(scene, m, needs, key);
    TextureSet set;
    std::ranges::transform(textures, set.begin(), [&](const auto& t) { return t ? textureIndex(*t) : -1; });
    if (sharedPlace(m, set)) {
        key.onePlace = true;
        for (TextureKey* texture :
             {&key.baseColor, &key.material, &key.normal, &key.occlusion, &key.emissive, &key.words})
            *texture = {.used = texture->used};
    }
    return {key, set};
}

// The same texture is uploaded once.
int Planner::textureIndex(const PlannedTexture& texture)
{
    const auto [found, isNew] = numbers.try_emplace(texture, static_cast<int>(plan.textures.size()));
    if (isNew)
        plan.textures.push_back(texture);
    return found->second;
}

int Planner::blockIndex(int material, const TextureSet& textures)
{
    const auto [found, isNew] = blocks.try_emplace({material, textures}, static_cast<int>(plan.blocks.size()));
    if (isNew)
        plan.blocks.push_back({.material = material, .slot = 0, .textures = textures});
    return found->second;
}

void Planner::add(const ShaderKey& key, const TextureSet& textures, Draw draw)
{
    draw.block = blockIndex(plan.instances[static_cast<std::size_t>(draw.firstInstance)].material, textures);
    if (key.alphaMode == AlphaMode::blend) {
        for (int i = 0; i < draw.instanceCount; ++i) {
            Draw one = draw;
            one.firstInstance += i;
            one.instanceCount = 1;
            plan.blended.push_back({key, textures, {one}});
        }
        return;
    }
    Batch& batch = batches.try_emplace({key, textures}, Batch{key, textures, {}}).first->second;
    batch.draws.push_back(draw);
}

void Planner::addPrimitives()
{
    struct Placed
    {
        const Instance* instance;
        bool mirrored;
    };
    std::vector<Placed> placed;
    for (const Instance& instance : scene.instances)
        if (!scene.primitives[static_cast<std::size_t>(instance.primitive)].indices.empty())
            placed.push_back({&instance, glm::determinant(dmat3(instance.worldFromObject)) < 0.0});
    std::ranges::stable_sort(placed, {}, [](const Placed& p) { return std::tuple(p.instance->primitive, p.mirrored); });
    for (std::size_t first = 0; first < placed.size();) {
        const int primitiveIndex = placed[first].instance->primitive;
        const Primitive& primitive = scene.primitives[static_cast<std::size_t>(primitiveIndex)];
        const std::size_t material = materialIndex(primitive.material);
        Draw draw = {.primitive = primitiveIndex,
                     .firstInstance = static_cast<int>(plan.instances.size()),
                     .instanceCount = 0,
                     .mirrored = placed[first].mirrored,
                     .bounds = {}};
        const Box own = {primitive.boundsMin, primitive.boundsMax};
        bool singular = false;
        for (; first < placed.size() && placed[first].instance->primitive == primitiveIndex &&
               placed[first].mirrored == draw.mirrored;
             ++first)
        {
            const Instance& instance = *placed[first].instance;
            const Box box = transformed(instance.worldFromObject, own);
            draw.bounds.include(box);
            singular |= glm::determinant(dmat3(instance.worldFromObject)) == 0.0;
            plan.instances.push_back({static_cast<int>(material), instance.object, instance.worldFromObject,
                                      0.5 * (box.least + box.greatest)});
            ++draw.instanceCount;
        }
        bounds.include(draw.bounds);
        auto [key, textures] = keyOf(plan.materials[material], primitive);
        if (!key.unlit && key.normals)
            key.choice = choiceIndex(material);
        key.vanishingNormals =
            key.surface == SurfaceKind::triangles && key.normals && (singular || normalsMayVanish(primitive));
        draw.starBody = key.doubleSided && !singular && isStarBody(primitive);
        if (const TextureUse* place = sharedPlace(plan.materials[material].material, textures))
            draw.uvSet = place->uvSet;
        add(key, textures, draw);
    }
}

void Planner::addShapes()
{
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const AnalyticShape& shape = scene.shapes[i];
        const std::size_t material = materialIndex(shape.material);
        const Material& m = plan.materials[material].material;
        const Box box = transformed(shape.worldFromObject, {dvec3(-1.0), dvec3(1.0)});
        bounds.include(box);
        const ShaderKey key = {.surface =
                                   shape.kind == AnalyticShape::Kind::sphere ? SurfaceKind::sphere : SurfaceKind::plane,
                               .alphaMode = m.alphaMode,
                               .doubleSided = m.doubleSided,
                               .unlit = m.unlit,
                               .compensates = plan.materials[material].compensates && !m.unlit,
                               .choice = m.unlit ? 0 : choiceIndex(material)};
        for (const TextureUse* use : {&m.baseColor, &m.metallicRoughness, &m.normal, &m.occlusion, &m.emissive})
            if (use->used())
                plan.remarks.push_back(
                    {"shape '" + shape.name + "'", "no textures", "analytic shapes have no texture coordinates"});
        plan.instances.push_back(
            {static_cast<int>(material), static_cast<int>(i), shape.worldFromObject, dvec3(shape.worldFromObject[3])});
        add(key, kNoTextures,
            {.primitive = -1,
             .shape = static_cast<int>(i),
             .firstInstance = static_cast<int>(plan.instances.size()) - 1,
             .bounds = box});
    }
}

void Planner::planSurfaces()
{
    addPrimitives();
    addShapes();
    for (auto& [key, batch] : batches)
        plan.batches.push_back(std::move(batch));
}

void Planner::planAreaLights()
{
    const bool points =
        std::ranges::none_of(plan.choices, [](const Settings& choice) { return drawsAreaLights(choice.methods); });
    for (const Light& light : plan.lights) {
        if (light.radius <= 0.0)
            continue;
        plan.areaLights |= !points;
        if (points)
            plan.remarks.push_back({"light '" + light.name + "'", "drawn as a point", "area_light is point"});
    }
}

void Planner::planLighting()
{
    bool lit = false, compensates = false;
    for (const auto* list : {&plan.batches, &plan.blended})
        for (const Batch& batch : *list) {
            lit |= !batch.key.unlit && batch.key.normals;
            compensates |= batch.key.compensates;
        }
    LightPlan lights = planLights(scene, bounds.least, bounds.greatest, plan.remarks);
    if (!lit && !lights.lights.empty()) {
        plan.remarks.push_back({"lights", "left out", "no surface is lit"});
        lights = {};
    }
    plan.lights = std::move(lights.lights);
    plan.lightCounts = lights.counts;
    planAreaLights();

    const bool hasEnvironment = scene.environment && scene.environment->intensity > 0.0;
    plan.environmentLight = hasEnvironment && lit;
    plan.panorama = hasEnvironment && plan.settings.background == BackgroundKind::environment;
    const bool viewsTable = plan.settings.view && plan.settings.view->subject == ViewSubject::table;
    const auto readsTable = [](const Settings& choice) { return environmentReadsTable(choice.methods); };
    plan.dfgTable = (plan.environmentLight && std::ranges::any_of(plan.choices, readsTable)) ||
                    (lit && readsAlbedo(plan.settings.methods, compensates) && !plan.lights.empty()) ||
                    (lit && viewsTable);
    if (hasEnvironment && !lit)
        plan.remarks.push_back({"environment", "not prefiltered", "no surface is lit"});
    if (hasEnvironment && !plan.panorama)
        plan.remarks.push_back({"environment", "not drawn", "another background was asked for"});
    checkMethods(plan);
    if (plan.environmentLight && brdf::isComposed(plan.settings.methods) &&
        plan.settings.methods.diffuse->id != "lambert")
        plan.remarks.push_back({"environment", "its diffuse light is Lambert's",
                                std::string(plan.settings.methods.diffuse->id) + " has no table"});
    if (plan.environmentLight && brdf::isComposed(plan.settings.methods) &&
        plan.settings.methods.fresnel->id != "schlick")
        plan.remarks.push_back({"environment", "its Fresnel term is Schlick's",
                                std::string(plan.settings.methods.fresnel->id) + " has no table"});
    std::set<std::string_view> formulas;
    for (const Settings& choice : plan.choices)
        if (const brdf::Method* dfg = choice.methods.dfg; dfg && !brdf::findDfgTable(dfg->id))
            formulas.insert(dfg->id);
    for (const std::string_view id : formulas)
        if (plan.dfgTable)
            plan.remarks.push_back({"directional albedo table", "left out", std::string(id) + " is a formula"});
    if (!plan.dfgTable)
        plan.remarks.push_back({"directional albedo table", "left out", "no shader reads it"});
}

} // namespace

const Settings& choiceOf(const ShadingPlan& plan, const ShaderKey& key)
{
    return plan.choices[static_cast<std::size_t>(key.choice)];
}

bool environmentReadsTable(const brdf::Preset& methods)
{
    if (!methods.environmentSpecular)
        return false;
    return brdf::isComposed(methods) || methods.environmentSpecular->id == "ggx_levels";
}

bool drawsAreaLights(const brdf::Preset& methods)
{
    return methods.areaLight->id != "point";
}

bool readsAlbedo(const brdf::Preset& methods, bool compensates)
{
    return brdf::isComposed(methods) && (compensates || methods.diffuseWeight->readsAlbedo);
}

double triangleCount(const Scene& scene, const Draw& draw)
{
    if (draw.primitive < 0)
        return 0.0;
    const Primitive& primitive = scene.primitives[static_cast<std::size_t>(draw.primitive)];
    return primitive.topology == Topology::triangles
               ? static_cast<double>(primitive.indices.size()) / 3.0 * draw.instanceCount
               : 0.0;
}

ShadingPlan makePlan(const Scene& scene, const Settings& settings)
{
    return makePlan(scene, texelFacts(scene), settings);
}

ShadingPlan makePlan(const Scene& scene, std::span<const TexelFacts> facts, const Settings& settings)
{
    return Planner(scene, facts, settings).run();
}

} // namespace torrance
