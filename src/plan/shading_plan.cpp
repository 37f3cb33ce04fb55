#include "plan/shading_plan.h"

#include "brdf/environment.h"
#include "core/error.h"
#include "plan/compensation.h"
#include "plan/deferred_plan.h"
#include "plan/light_plan.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <tuple>

namespace torrance {
namespace {

struct Box
{
    dvec3 least = dvec3(std::numeric_limits<double>::infinity());
    dvec3 greatest = dvec3(-std::numeric_limits<double>::infinity());

    void include(const dvec3& p)
    {
        least = glm::min(least, p);
        greatest = glm::max(greatest, p);
    }
};

Box boxOf(const dmat4& m, const dvec3& least, const dvec3& greatest)
{
    Box bounds;
    for (int corner = 0; corner < 8; ++corner)
        bounds.include(dvec3(m * dvec4(corner & 1 ? greatest.x : least.x, corner & 2 ? greatest.y : least.y,
                                       corner & 4 ? greatest.z : least.z, 1.0)));
    return bounds;
}

SurfaceKind surfaceOf(Topology topology)
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

class Planner
{
public:
    Planner(const Scene& s, std::span<const TexelFacts> f, const Settings& settings) : scene(s), facts(f)
    {
        plan.settings = settings;
    }

    ShadingPlan run()
    {
        planMaterials();
        planSurfaces();
        planLighting();
        if (plan.settings.path == RenderPath::deferred)
            planDeferred(plan);
        return std::move(plan);
    }

private:
    void planMaterials();
    void planSurfaces();
    void planLighting();
    void planAreaLights();
    void addPrimitives();
    void addShapes();
    void add(const ShaderKey& key, const TextureSet& textures, const Draw& draw);

    std::size_t materialIndex(int material) const
    {
        return material < 0 ? scene.materials.size() : static_cast<std::size_t>(material);
    }
    ShaderKey keyOf(const PlannedMaterial& planned, const Primitive& primitive);
    TextureKey textureKey(const TextureUse& use, const Primitive& primitive, const char* what);

    const Scene& scene;
    std::span<const TexelFacts> facts;
    ShadingPlan plan;
    Box bounds;
    std::map<std::pair<ShaderKey, TextureSet>, Batch> batches; // ordered: the same scene gives the same batches
};

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

ShaderKey Planner::keyOf(const PlannedMaterial& planned, const Primitive& primitive)
{
    const Material& m = planned.material;
    ShaderKey key = {.surface = surfaceOf(primitive.topology),
                     .normals = !primitive.normals.empty(),
                     .colors = !primitive.colors.empty()};
    key.baseColor = textureKey(m.baseColor, primitive, "base colour");
    key.alphaMode = m.alphaMode;
    key.doubleSided = m.doubleSided && key.surface == SurfaceKind::triangles;
    key.unlit = m.unlit;
    key.emissive = textureKey(m.emissive, primitive, "emissive");
    if (key.unlit || !key.normals)
        return key;
    key.metallicRoughness = textureKey(m.metallicRoughness, primitive, "metallic-roughness");
    if (key.surface == SurfaceKind::triangles)
        key.normal = textureKey(m.normal, primitive, "normal");
    key.occlusion = textureKey(m.occlusion, primitive, "occlusion");
    key.compensates = planned.compensates;
    return key;
}

void Planner::add(const ShaderKey& key, const TextureSet& textures, const Draw& draw)
{
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

TextureSet textureSet(const Material& m, const ShaderKey& key)
{
    const auto pick = [](const TextureKey& k, const TextureUse& use) { return k.used ? use.texture : -1; };
    return {pick(key.baseColor, m.baseColor), pick(key.metallicRoughness, m.metallicRoughness),
            pick(key.normal, m.normal), pick(key.occlusion, m.occlusion), pick(key.emissive, m.emissive)};
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
                     .mirrored = placed[first].mirrored};
        for (; first < placed.size() && placed[first].instance->primitive == primitiveIndex &&
               placed[first].mirrored == draw.mirrored;
             ++first)
        {
            const Instance& instance = *placed[first].instance;
            const Box box = boxOf(instance.worldFromObject, primitive.boundsMin, primitive.boundsMax);
            bounds.include(box.least);
            bounds.include(box.greatest);
            plan.instances.push_back({static_cast<int>(material), instance.object, instance.worldFromObject,
                                      0.5 * (box.least + box.greatest)});
            ++draw.instanceCount;
        }
        const ShaderKey key = keyOf(plan.materials[material], primitive);
        add(key, textureSet(plan.materials[material].material, key), draw);
    }
}

void Planner::addShapes()
{
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const AnalyticShape& shape = scene.shapes[i];
        const std::size_t material = materialIndex(shape.material);
        const Material& m = plan.materials[material].material;
        const Box box = boxOf(shape.worldFromObject, dvec3(-1.0), dvec3(1.0));
        bounds.include(box.least);
        bounds.include(box.greatest);
        const ShaderKey key = {.surface =
                                   shape.kind == AnalyticShape::Kind::sphere ? SurfaceKind::sphere : SurfaceKind::plane,
                               .alphaMode = m.alphaMode,
                               .doubleSided = m.doubleSided,
                               .unlit = m.unlit,
                               .compensates = plan.materials[material].compensates && !m.unlit};
        for (const TextureUse* use : {&m.baseColor, &m.metallicRoughness, &m.normal, &m.occlusion, &m.emissive})
            if (use->used())
                plan.remarks.push_back(
                    {"shape '" + shape.name + "'", "no textures", "analytic shapes have no texture coordinates"});
        plan.instances.push_back(
            {static_cast<int>(material), static_cast<int>(i), shape.worldFromObject, dvec3(shape.worldFromObject[3])});
        add(key, {-1, -1, -1, -1, -1},
            {.primitive = -1,
             .shape = static_cast<int>(i),
             .firstInstance = static_cast<int>(plan.instances.size()) - 1});
    }
}

void Planner::planSurfaces()
{
    addPrimitives();
    addShapes();
    for (auto& [key, batch] : batches)
        plan.batches.push_back(std::move(batch));
}

// The levels of source E belong to its model, which has no part for any others.
void checkLevels(const ShadingPlan& plan)
{
    const brdf::Preset& methods = plan.settings.methods;
    if (!plan.environmentLight || brdf::isComposed(methods) == (methods.environmentSpecular->id != "phong_levels"))
        return;
    throw usageError("the model " + std::string(methods.model->id) + " cannot be lit by an environment through " +
                         std::string(methods.environmentSpecular->id),
                     "leave out --environment-specular: each preset has one that goes with its model");
}

// What is tabulated and prefiltered is the lobe of ggx with smith_corr: another lobe would be lit by the wrong one. A
// source system that says nothing of environments is lit by none.
void checkLobe(const ShadingPlan& plan)
{
    const brdf::Preset& methods = plan.settings.methods;
    if (plan.environmentLight && !methods.environmentSpecular)
        throw usageError("the preset " + std::string(methods.id) + " defines no light from an environment",
                         "leave it out: --environment none");
    checkLevels(plan);
    if (!plan.dfgTable || !brdf::isComposed(methods))
        return;
    const std::string_view D = methods.distribution->id;
    if ((D == "ggx" || D == "ggx_aniso") && methods.visibility->id == "smith_corr") // glTF's anisotropy is 0: the same
        return;
    throw usageError("light from the environment, multiple scattering and weights by albedo are made for ggx with "
                     "smith_corr, not for " +
                         std::string(D) + " with " + std::string(methods.visibility->id),
                     "leave them out: --environment none --multiple-scattering none --diffuse-weight fresnel_voh");
}

void Planner::planAreaLights()
{
    const bool points = plan.settings.methods.areaLight->id == "point";
    for (const Light& light : plan.lights) {
        if (light.radius <= 0.0)
            continue;
        plan.areaLights |= !points;
        if (points)
            plan.remarks.push_back({"light '" + light.name + "'", "drawn as a point", "area_light is point"});
    }
}

[[noreturn]] void refuseView(const View& view, const std::string& lack, const std::string& remedy)
{
    throw usageError("the view of " + std::string(view.id) + " needs " + lack, remedy);
}

// A view of what the scene or the preset does not have is no black picture but an error.
void checkView(const ShadingPlan& plan)
{
    const View* view = plan.settings.view;
    if (!view)
        return;
    const brdf::Preset& methods = plan.settings.methods;
    const bool ofLight = view->subject == ViewSubject::light || view->subject == ViewSubject::model;
    if (ofLight && plan.settings.viewLight >= static_cast<int>(plan.lights.size()))
        refuseView(*view,
                   "light " + std::to_string(plan.settings.viewLight) + ", and there are " +
                       std::to_string(plan.lights.size()),
                   "add one with --light, or choose another with --view-light");
    if (view->subject == ViewSubject::model && methods.model->id == "phong")
        refuseView(*view, "a microfacet model, which phong is not", "look at specular, diffuse or brdf");
    if (view->subject == ViewSubject::environment && !plan.environmentLight)
        refuseView(*view, "light from an environment", "give --environment, and a preset that defines it");
    if (view->id == "prefiltered" && brdf::drawsSamples(*methods.environmentSpecular))
        refuseView(*view, "prefiltered light, which " + std::string(methods.environmentSpecular->id) + " does without",
                   "use --environment-specular split_sum");
    if (view->subject == ViewSubject::table && !methods.dfg)
        refuseView(*view, "a preset with directional albedos", "use --preset standard");
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
    plan.dfgTable = (plan.environmentLight && brdf::isComposed(plan.settings.methods)) ||
                    (lit && readsAlbedo(plan.settings.methods, compensates) && !plan.lights.empty()) ||
                    (lit && viewsTable);
    if (hasEnvironment && !lit)
        plan.remarks.push_back({"environment", "not prefiltered", "no surface is lit"});
    if (hasEnvironment && !plan.panorama)
        plan.remarks.push_back({"environment", "not drawn", "another background was asked for"});
    checkView(plan);
    checkLobe(plan);
    if (plan.environmentLight && brdf::isComposed(plan.settings.methods) &&
        plan.settings.methods.diffuse->id != "lambert")
        plan.remarks.push_back({"environment", "its diffuse light is Lambert's",
                                std::string(plan.settings.methods.diffuse->id) + " has no table"});
    if (plan.environmentLight && brdf::isComposed(plan.settings.methods) &&
        plan.settings.methods.fresnel->id != "schlick")
        plan.remarks.push_back({"environment", "its Fresnel term is Schlick's",
                                std::string(plan.settings.methods.fresnel->id) + " has no table"});
    if (!plan.dfgTable)
        plan.remarks.push_back({"directional albedo table", "left out", "no shader reads it"});
}

} // namespace

bool readsAlbedo(const brdf::Preset& methods, bool compensates)
{
    return brdf::isComposed(methods) && (compensates || methods.diffuseWeight->readsAlbedo);
}

ShadingPlan makePlan(const Scene& scene, const Settings& settings)
{
    return makePlan(scene, texelFacts(scene), settings);
}

ShadingPlan makePlan(const Scene& scene, std::span<const TexelFacts> facts, const Settings& settings)
{
    assert(facts.size() == scene.images.size());
    return Planner(scene, facts, settings).run();
}

} // namespace torrance
