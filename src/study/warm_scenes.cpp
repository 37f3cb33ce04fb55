#include "study/warm_scenes.h"

#include "scene/shape_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace torrance {
namespace {

constexpr int kSide = 16; // of the pictures, pixels
/// A scene takes a second or two on one core, so that cores have equal shares.
constexpr std::size_t kMaterialsPerScene = 6;
/// Low enough that no light is lost between facets: the plan leaves their interreflection out.
constexpr double kSmooth = 0.05;

enum class Gloss // which channels of metallicRoughness vary
{
    none,
    roughness,
    metallic,
    both,
};

enum class Ambient
{
    none,
    own,    // a picture of its own
    shared, // the channel R of metallicRoughness
};

/// A material that a file may have, and how its primitive is made.
struct Kind
{
    bool baseColor = false, normal = false, emissive = false;
    Gloss gloss = Gloss::none;
    Ambient ambient = Ambient::none;
    bool glossOfOtherSize = false; // its picture is smaller than the others
    double roughness = 1.0;
    AlphaMode alphaMode = AlphaMode::opaque;
    Sampler sampler = {};
    int side = 8; // of the pictures, texels: a power of two or not
    bool unlit = false, colors = false, normals = true, vanishing = false;
    Topology topology = Topology::triangles;
};

/// A picture each of whose channels varies but for those that are `fixed`, which are one.
int addPicture(Scene& scene, const Kind& kind, int side, std::array<bool, 4> fixed)
{
    TextureImage image = {.name = "picture", .width = side, .height = side};
    for (int i = 0; i < side * side; ++i)
        for (std::size_t c = 0; c < 4; ++c)
            image.texels.push_back(std::byte(fixed[c] ? 255 : 16 + (i * 13 + int(c) * 50) % 200));
    scene.images.push_back(std::move(image));
    scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1, .sampler = kind.sampler});
    return static_cast<int>(scene.textures.size()) - 1;
}

Material makeMaterial(Scene& scene, const Kind& kind)
{
    Material m;
    m.name = "material";
    m.alphaMode = kind.alphaMode;
    m.unlit = kind.unlit;
    m.roughnessFactor = kind.roughness;
    m.baseColorFactor.a = kind.alphaMode == AlphaMode::opaque ? 1.0 : 0.6;
    const bool opaque = kind.alphaMode == AlphaMode::opaque;
    if (kind.baseColor)
        m.baseColor.texture = addPicture(scene, kind, kind.side, {false, false, false, opaque});
    if (kind.normal)
        m.normal.texture = addPicture(scene, kind, kind.side, {false, false, false, true});
    if (kind.emissive) {
        m.emissive.texture = addPicture(scene, kind, kind.side, {false, false, false, true});
        m.emissiveFactor = dvec3(1.0);
    }
    if (kind.gloss != Gloss::none) {
        const int side = kind.glossOfOtherSize ? kind.side / 2 : kind.side;
        m.metallicRoughness.texture =
            addPicture(scene, kind, side, {false, kind.gloss == Gloss::metallic, kind.gloss == Gloss::roughness, true});
    }
    if (kind.ambient == Ambient::shared)
        m.occlusion = m.metallicRoughness;
    if (kind.ambient == Ambient::own)
        m.occlusion.texture = addPicture(scene, kind, kind.side, {false, true, true, true});
    return m;
}

void addPrimitive(Scene& scene, const Kind& kind)
{
    Primitive mesh = planeMesh();
    mesh.topology = kind.topology;
    mesh.material = static_cast<int>(scene.materials.size());
    if (kind.colors)
        mesh.colors.assign(mesh.positions.size(), vec4(0.5f));
    if (!kind.normals)
        mesh.normals.clear();
    if (kind.vanishing)
        mesh.normals.back() = vec3(0.0f);
    if (kind.topology == Topology::lines)
        mesh.indices = {0, 1};
    if (kind.topology == Topology::points)
        mesh.indices = {0};
    scene.materials.push_back(makeMaterial(scene, kind));
    scene.instances.push_back({.primitive = static_cast<int>(scene.primitives.size())});
    scene.primitives.push_back(std::move(mesh));
}

/// Which of the three pictures that have no channel to spare but their alpha a material has.
Kind withPictures(unsigned bits)
{
    return {.baseColor = (bits & 1u) != 0, .normal = (bits & 2u) != 0, .emissive = (bits & 4u) != 0};
}

/// What scenes of physically based materials are made of.
void addCommon(std::vector<Kind>& kinds, double roughness)
{
    for (unsigned bits = 0; bits < 8; ++bits)
        for (const Gloss gloss : {Gloss::none, Gloss::both})
            for (const Ambient ambient : {Ambient::none, Ambient::own, Ambient::shared})
                for (const bool otherSize : {false, true}) {
                    if (gloss == Gloss::none && (otherSize || ambient == Ambient::shared))
                        continue;
                    Kind kind = withPictures(bits);
                    kind.gloss = gloss;
                    kind.ambient = ambient;
                    kind.glossOfOtherSize = otherSize;
                    kind.roughness = roughness;
                    kinds.push_back(kind);
                }
}

/// One channel of two varies; low roughness.
void addUncommon(std::vector<Kind>& kinds)
{
    for (unsigned bits = 0; bits < 8; ++bits) {
        for (const Gloss gloss : {Gloss::roughness, Gloss::metallic})
            for (const double roughness : {1.0, kSmooth}) {
                Kind kind = withPictures(bits);
                kind.gloss = gloss;
                kind.roughness = roughness;
                kinds.push_back(kind);
            }
        for (const Gloss gloss : {Gloss::none, Gloss::both}) {
            Kind smooth = withPictures(bits);
            smooth.gloss = gloss;
            smooth.roughness = kSmooth;
            kinds.push_back(smooth);
        }
    }
}

/// The materials that most files have: plain, coloured by a picture, and with a set of maps.
std::vector<Kind> commonest()
{
    return {Kind{}, Kind{.baseColor = true}, Kind{.baseColor = true, .gloss = Gloss::both},
            Kind{.baseColor = true, .normal = true, .gloss = Gloss::both}};
}

void addSampled(std::vector<Kind>& kinds)
{
    constexpr Sampler kNearest = {.minify = Filter::nearest}; // exporters' NEAREST_MIPMAP_LINEAR
    constexpr Sampler kClamped = {.wrapS = Wrap::clampToEdge, .wrapT = Wrap::clampToEdge};
    constexpr Sampler kMirrored = {.wrapS = Wrap::mirroredRepeat, .wrapT = Wrap::mirroredRepeat};
    constexpr Sampler kOneLevel = {.mip = MipFilter::none};
    constexpr int kOdd = 6; // no power of two
    std::vector<Kind> all = {Kind{.baseColor = true, .roughness = kSmooth}};
    for (const Kind& kind : commonest())
        if (kind.baseColor)
            all.push_back(kind);
    for (const bool emissive : {false, true})
        all.push_back({.baseColor = true,
                       .normal = true,
                       .emissive = emissive,
                       .gloss = Gloss::both,
                       .ambient = Ambient::shared});
    for (Kind kind : all)
        for (const int side : {8, kOdd})
            for (const Sampler& sampler : {Sampler{}, kNearest, kClamped, kMirrored, kOneLevel}) {
                const bool isCommon = side == 8 && sampler == Sampler{}, isRare = side == kOdd && sampler != kNearest;
                if (isCommon || (isRare && sampler != Sampler{}))
                    continue;
                kind.sampler = sampler;
                kind.side = side;
                kinds.push_back(kind);
            }
}

void addTranslucent(std::vector<Kind>& kinds)
{
    for (Kind kind : commonest())
        for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend})
            for (const double roughness : {1.0, kSmooth})
                for (const bool emissive : {false, true}) {
                    kind.alphaMode = mode;
                    kind.roughness = roughness;
                    kind.emissive = emissive;
                    kinds.push_back(kind);
                }
}

void addShapes(std::vector<Kind>& kinds)
{
    for (const bool textured : {false, true})
        for (const double roughness : {1.0, kSmooth}) {
            kinds.push_back({.baseColor = textured, .roughness = roughness, .colors = true});
            kinds.push_back({.baseColor = textured, .roughness = roughness, .vanishing = true});
        }
    kinds.push_back({.baseColor = true, .normal = true, .gloss = Gloss::both, .vanishing = true});
    kinds.push_back({.baseColor = true, .normal = true, .emissive = true, .gloss = Gloss::both, .vanishing = true});
}

/// What no light reaches: the plan has a path for scenes of nothing else.
void addUnlit(std::vector<Kind>& kinds)
{
    for (const bool textured : {false, true})
        kinds.push_back({.baseColor = textured, .unlit = true});
    for (const Topology topology : {Topology::lines, Topology::points})
        for (const bool colors : {false, true})
            kinds.push_back({.colors = colors, .normals = false, .topology = topology});
}

Light sun()
{
    return {.name = "sun", .intensity = 1.0, .direction = glm::normalize(dvec3(-0.3, -0.5, -1.0))};
}

class Writer
{
public:
    /// Without a path the plan chooses.
    void add(const std::string& name, std::optional<RenderPath> path, bool lit, const std::vector<Kind>& kinds)
    {
        for (std::size_t first = 0; first < kinds.size(); first += kMaterialsPerScene) {
            WarmScene& warm = scenes.emplace_back();
            warm.name = name + ": " + std::to_string(++numbers[name]);
            warm.settings.methods = *brdf::findPreset("standard");
            warm.settings.width = kSide;
            warm.settings.height = kSide;
            warm.settings.path = path;
            for (std::size_t i = first; i < std::min(kinds.size(), first + kMaterialsPerScene); ++i)
                addPrimitive(warm.scene, kinds[i]);
            if (lit)
                warm.scene.lights.push_back(sun());
        }
    }

    std::vector<WarmScene> scenes;

private:
    std::map<std::string, int> numbers; // of scenes of one name
};

} // namespace

std::vector<WarmScene> warmScenes()
{
    Writer writer;
    std::vector<Kind> maps, rare, sampled, translucent, shapes, unlit;
    addCommon(maps, 1.0);
    addUncommon(rare);
    addSampled(sampled);
    addTranslucent(translucent);
    addShapes(shapes);
    addUnlit(unlit);
    writer.add("maps", RenderPath::prepass, false, maps);
    writer.add("maps, sun", RenderPath::prepass, true, maps);
    writer.add("one channel", RenderPath::prepass, false, rare);
    writer.add("samplers", RenderPath::prepass, false, sampled);
    writer.add("alpha", RenderPath::prepass, false, translucent);
    writer.add("shapes", RenderPath::prepass, false, shapes);
    // One by one: lavapipe's vertex code depends on what else its context draws, points or lines or neither.
    for (const Kind& kind : unlit)
        writer.add("unlit", {}, false, {kind});
    writer.add("unlit among lit", RenderPath::prepass, false, unlit);
    // Dense meshes are shaded from attributes; those without pictures have a shader that reads no coordinates, and one
    // for many materials at once.
    const std::vector<Kind> plain = {Kind{}, Kind{.roughness = 0.5}, Kind{.roughness = kSmooth},
                                     Kind{.roughness = 0.5 * kSmooth}};
    for (const bool lit : {false, true}) {
        writer.add(lit ? "dense, sun" : "dense", RenderPath::attributes, lit, plain);
        writer.add(lit ? "dense, sun, one" : "dense, one", RenderPath::attributes, lit, {Kind{}});
        writer.add(lit ? "dense maps, sun" : "dense maps", RenderPath::attributes, lit, maps);
    }
    std::vector<Kind> others = shapes;
    others.insert(others.end(), translucent.begin(), translucent.end());
    others.insert(others.end(), unlit.begin(), unlit.end());
    writer.add("dense others", RenderPath::attributes, false, others);
    return std::move(writer.scenes);
}

Camera warmCamera()
{
    Camera camera;
    camera.worldFromCamera[3] = dvec4(0.0, 0.0, 4.0, 1.0);
    return camera;
}

} // namespace torrance
