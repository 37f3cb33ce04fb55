// Edited materials come back as they were edited, and nothing else of the document changes.
#include "gltf_save_cases.h"

#include "files/material_difference.h"

#include <functional>

namespace torrance {
namespace {

using test::changedPlaces;
using test::joined;
using test::liesIn;
using test::readSaved;
using test::richModel;

/// The rich model saved with one edit, and what was read back.
struct Saved
{
    TestFolder folder;
    LoadedScene before;
    Scene edited;
    std::vector<std::string> remarks;
    LoadedScene after;
    test::SavedFile source, target;

    explicit Saved(const std::function<void(Scene&)>& edit, const GltfSaveOptions& options = {},
                   const GltfBuilder& builder = richModel())
    {
        const auto from = folder.write("model.glb", builder.glb());
        const auto to = folder.path / "saved.glb";
        before = loadScene(from, options.load);
        edited = before.scene;
        edit(edited);
        remarks = saveGltf(from, before.scene, edited, to, options);
        after = loadScene(to, options.load);
        source = readSaved(from);
        target = readSaved(to);
    }

    std::vector<std::string> changes() const { return changedPlaces(source.json, target.json); }
};

TEST(GltfSave, OfNothingIsTheSameDocument)
{
    const Saved saved([](Scene&) {});
    EXPECT_EQ(saved.source.json, saved.target.json);
    EXPECT_EQ(saved.source.binary, saved.target.binary);
    EXPECT_TRUE(saved.remarks.empty()) << joined(saved.remarks);
}

/// The same document with the members of every object the other way round.
nlohmann::ordered_json reversed(const nlohmann::json& json)
{
    if (!json.is_structured())
        return json;
    nlohmann::ordered_json copy = json.is_array() ? nlohmann::ordered_json::array() : nlohmann::ordered_json::object();
    if (json.is_array())
        for (const nlohmann::json& element : json)
            copy.push_back(reversed(element));
    else
        for (auto member = json.end(); member != json.begin();) {
            --member;
            copy[member.key()] = reversed(*member);
        }
    return copy;
}

TEST(GltfSave, KeepsTheOrderOfMembers)
{
    const TestFolder folder;
    const GltfBuilder builder = richModel();
    const auto path = folder.write("model.glb", GltfBuilder::glbOf(reversed(builder.json).dump(), builder.binary));
    const LoadedScene loaded = loadScene(path);
    const std::vector<std::byte> before = readSaved(path).bytes;
    saveGltf(path, loaded.scene, loaded.scene, path);
    EXPECT_EQ(readSaved(path).bytes, before) << "written by the same library, to the byte";
    Scene edited = loaded.scene;
    edited.materials[0].roughnessFactor = 0.125;
    saveGltf(path, loaded.scene, edited, path);
    nlohmann::json changed = builder.json;
    changed["materials"][1]["pbrMetallicRoughness"]["roughnessFactor"] = 0.125;
    EXPECT_EQ(readSaved(path).json.dump(), reversed(changed).dump());
}

struct Row
{
    const char* name;
    std::function<void(Material&)> change;
    std::function<bool(const Material&, const Material&)> same;
    std::vector<std::string> full;  // where the document changes for the material with everything
    std::vector<std::string> empty; // and for the one with nothing; none = there is nothing to change
};

template <typename Member>
Row row(const char* name, Member Material::*member, const Member& value, std::vector<std::string> full,
        std::vector<std::string> empty)
{
    return {name, [=](Material& material) { material.*member = value; },
            [=](const Material& a, const Material& b) { return a.*member == b.*member; }, std::move(full),
            std::move(empty)};
}

const char* const kPbr = "/pbrMetallicRoughness";
const char* const kPbrBase = "/pbrMetallicRoughness/baseColorTexture";

std::vector<Row> rows()
{
    const std::string pbr = kPbr;
    const std::string base = kPbrBase;
    const double third = 1.0 / 3.0; // 16 digits would not do
    std::vector<Row> rows = {
        row<std::string>("name", &Material::name, "\"new\" \xc3\xa9\n\x01", {"/name"}, {"/name"}),
        row<dvec4>("base colour", &Material::baseColorFactor, dvec4(third, 0.0, 1.0, 0.1 + 0.2),
                   {pbr + "/baseColorFactor"}, {pbr}),
        row<double>("metallic", &Material::metallicFactor, third, {pbr + "/metallicFactor"}, {pbr}),
        row<double>("roughness", &Material::roughnessFactor, 5e-324, {pbr + "/roughnessFactor"}, {pbr}),
        row<double>("normal scale", &Material::normalScale, -third, {"/normalTexture/scale"}, {}),
        row<double>("occlusion strength", &Material::occlusionStrength, third, {"/occlusionTexture/strength"}, {}),
        row<dvec3>("emission of less than 1", &Material::emissiveFactor, dvec3(third, 0.0, 1.0),
                   {"/emissiveFactor", "/extensions/KHR_materials_emissive_strength"}, {"/emissiveFactor"}),
        row<dvec3>("emission", &Material::emissiveFactor, dvec3(third, 7.1, 4.3),
                   {"/emissiveFactor", "/extensions/KHR_materials_emissive_strength"},
                   {"/emissiveFactor", "/extensions"}),
        row<AlphaMode>("alpha mode", &Material::alphaMode, AlphaMode::blend, {"/alphaMode"}, {"/alphaMode"}),
        row<double>("alpha cutoff", &Material::alphaCutoff, third, {"/alphaCutoff"}, {"/alphaCutoff"}),
        row<bool>("unlit", &Material::unlit, true, {"/extensions/KHR_materials_unlit"}, {"/extensions"}),
        row<double>("ior", &Material::ior, 1.0 + third, {"/extensions/KHR_materials_ior/ior"}, {"/extensions"}),
        row<double>("infinite ior", &Material::ior, 0.0, {"/extensions/KHR_materials_ior/ior"}, {"/extensions"}),
    };
    const auto useRow = [&](const char* name, auto change, std::vector<std::string> full,
                            std::vector<std::string> empty) {
        rows.push_back({name, [=](Material& material) { change(material.baseColor); },
                        [](const Material& a, const Material& b) {
                            return a.baseColor.texture == b.baseColor.texture &&
                                   a.baseColor.uvSet == b.baseColor.uvSet &&
                                   a.baseColor.transform == b.baseColor.transform;
                        },
                        std::move(full), std::move(empty)});
    };
    useRow("texture", [](TextureUse& use) { use.texture = 1; }, {base + "/index"}, {pbr});
    useRow("no texture", [](TextureUse& use) { use = {}; }, {base}, {});
    const std::string transform = base + "/extensions/KHR_texture_transform";
    useRow("offset",
           [](TextureUse& use) {
               use.texture = 0;
               use.transform[2] = dvec2(1.0 / 3.0, 0.0);
           },
           {transform + "/offset"}, {pbr});
    useRow("scale",
           [](TextureUse& use) {
               use.texture = 0;
               use.transform = glm::dmat3x2(-3.0, 0.0, 0.0, 1.0 / 3.0, 0.1, 0.2);
           },
           {transform + "/scale", transform + "/rotation"}, {pbr});
    useRow("no transform", [](TextureUse& use) { use.transform = TextureUse{}.transform; }, {base + "/extensions"}, {});
    return rows;
}

TEST(GltfSave, WritesEveryFieldAloneAndReadsItBack)
{
    for (const Row& row : rows())
        for (const std::size_t material : {std::size_t(0), std::size_t(1)}) {
            const std::vector<std::string>& where = material == 0 ? row.full : row.empty;
            if (where.empty())
                continue;
            const Saved saved([&](Scene& scene) { row.change(scene.materials[material]); });
            const std::string name = row.name + std::string(" of material ") + std::to_string(material);
            const Material& after = saved.after.scene.materials.at(material);
            EXPECT_TRUE(row.same(after, saved.edited.materials[material])) << name;
            EXPECT_FALSE(row.same(after, saved.before.scene.materials[material])) << name << " was changed";
            EXPECT_EQ(differingField(saved.after.scene.materials.at(1 - material),
                                     saved.before.scene.materials[1 - material]),
                      "")
                << name;
            std::vector<std::string> expected;
            for (const std::string& place : where)
                expected.push_back("/materials/" + std::to_string(material + 1) + place);
            std::vector<std::string> changes = saved.changes();
            std::erase_if(changes, [](const std::string& place) { return place.starts_with("/extensionsUsed"); });
            EXPECT_TRUE(liesIn(changes, expected)) << name << ": " << joined(changes);
            EXPECT_EQ(saved.source.binary, saved.target.binary) << name;
        }
}

TEST(GltfSave, LeavesOutWhatIsAtItsDefault)
{
    const Saved saved([](Scene& scene) {
        const std::string name = scene.materials[0].name;
        scene.materials[0] = Material{};
        scene.materials[0].name = name;
    });
    const nlohmann::ordered_json& material = saved.target.json["materials"][1];
    std::vector<std::string> members;
    for (const auto& [name, member] : material.items())
        members.push_back(name);
    EXPECT_EQ(members, (std::vector<std::string>{"extensions", "extras", "name"})) << material.dump();
    EXPECT_EQ(material["extensions"].size(), 1u) << "the one that is not ours: " << material.dump();
    EXPECT_TRUE(material["extensions"].contains("KHR_materials_clearcoat"));
}

TEST(GltfSave, ListsTheExtensionsThatAreInUse)
{
    GltfBuilder plain = richModel();
    plain.json["materials"] = {nlohmann::json::object(), nlohmann::json::object(), nlohmann::json::object()};
    plain.json.erase("extensionsUsed");
    const auto usedAfter = [&](const GltfBuilder& builder, const std::function<void(Scene&)>& edit) {
        const nlohmann::ordered_json json = Saved(edit, {}, builder).target.json;
        return json.value("extensionsUsed", nlohmann::ordered_json::array()).get<std::vector<std::string>>();
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(usedAfter(plain, [](Scene& scene) { scene.materials[0].roughnessFactor = 0.5; }), Names{})
        << "glTF allows no empty list";
    EXPECT_EQ(usedAfter(plain, [](Scene& scene) { scene.materials[0].unlit = true; }), Names{"KHR_materials_unlit"});
    EXPECT_EQ(usedAfter(plain, [](Scene& scene) { scene.materials[0].ior = 1.2; }), Names{"KHR_materials_ior"});
    EXPECT_EQ(usedAfter(plain, [](Scene& scene) { scene.materials[0].emissiveFactor.x = 1.5; }),
              Names{"KHR_materials_emissive_strength"});

    // The only uses go; unlit stays with the material that is not drawn, and names without a use stay where they are.
    const Names rest = usedAfter(richModel(), [](Scene& scene) {
        scene.materials[0].baseColor.transform = TextureUse{}.transform;
        scene.materials[0].ior = 1.5;
        scene.materials[0].emissiveFactor = dvec3(1.0);
    });
    EXPECT_EQ(rest,
              (Names{"EXT_nobody_knows", "KHR_materials_variants", "KHR_materials_clearcoat", "KHR_materials_unlit"}))
        << joined(rest);
    GltfBuilder required = richModel();
    required.json["extensionsRequired"] = {"KHR_materials_ior"};
    const Saved saved([](Scene& scene) { scene.materials[0].ior = 1.5; }, {}, required);
    EXPECT_FALSE(saved.target.json.contains("extensionsRequired"));
}

// What is read is factor * strength: three products, each of which has to be the double that was edited.
TEST(GltfSave, KeepsEveryBitOfEmission)
{
    std::uint64_t state = 1;
    const auto random = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u; // Knuth's MMIX
        return static_cast<double>(state >> 11) / 9007199254740992.0;
    };
    for (int i = 0; i < 50; ++i) {
        const dvec3 emission = std::exp2(20.0 * random()) * dvec3(random(), random(), random());
        const Saved saved([&](Scene& scene) { scene.materials[1].emissiveFactor = emission; });
        EXPECT_EQ(saved.after.scene.materials.at(1).emissiveFactor, emission);
        const nlohmann::ordered_json& json = saved.target.json["materials"][2];
        for (const double factor : json["emissiveFactor"])
            EXPECT_LE(factor, 1.0) << "glTF 2.0, 5.19: emissiveFactor lies in 0 to 1";
    }
}

TEST(GltfSave, KeepsTheFilesEmissiveStrengthWhereItServes)
{
    const Saved saved([](Scene& scene) { scene.materials[0].emissiveFactor = dvec3(1.0, 2.0, 3.0); });
    const nlohmann::ordered_json& json = saved.target.json["materials"][1];
    EXPECT_EQ(json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 4);
    EXPECT_EQ(json["emissiveFactor"], (nlohmann::ordered_json{0.25, 0.5, 0.75}));
}

TEST(GltfSave, WritesOnlyTheOffsetWhereOnlyItChanged)
{
    const Saved saved([](Scene& scene) { scene.materials[0].baseColor.transform[2].x += 1.0; });
    const nlohmann::ordered_json& json =
        saved.target.json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"];
    EXPECT_EQ(json["KHR_texture_transform"]["rotation"], 0.3) << "the file's number, not one computed from sines";
    EXPECT_EQ(json["KHR_texture_transform"]["offset"], (nlohmann::ordered_json{1.1, 0.2}));
}

TEST(GltfSave, MovesTheSetOfCoordinatesOutOfATransform)
{
    GltfBuilder builder = richModel();
    nlohmann::json& use = builder.json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"];
    use["extensions"]["KHR_texture_transform"]["texCoord"] = 1;
    const Saved saved([](Scene& scene) { scene.materials[0].baseColor.uvSet = 0; }, {}, builder);
    EXPECT_EQ(saved.before.scene.materials[0].baseColor.uvSet, 1);
    EXPECT_EQ(saved.after.scene.materials.at(0).baseColor.uvSet, 0);
    const auto& json = saved.target.json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"];
    EXPECT_FALSE(json["extensions"]["KHR_texture_transform"].contains("texCoord"));
}

TEST(GltfSave, AppendsNewMaterialsAndDuplicates)
{
    GltfSaveOptions options;
    options.duplicateOf = {-1, 0};
    const Saved saved(
        [](Scene& scene) {
            Material fresh;
            fresh.name = "fresh";
            fresh.metallicFactor = 0.25;
            Material copy = scene.materials[0];
            copy.name = "copy";
            scene.materials.push_back(fresh);
            scene.materials.push_back(copy);
            scene.primitives[1].material = 3;
        },
        options);
    const auto& materials = saved.target.json["materials"];
    ASSERT_EQ(materials.size(), 5u);
    EXPECT_EQ(materials[3].dump(), R"({"name":"fresh","pbrMetallicRoughness":{"metallicFactor":0.25}})")
        << "written, though no primitive has it";
    nlohmann::ordered_json copy = saved.source.json["materials"][1];
    copy["name"] = "copy";
    EXPECT_EQ(materials[4], copy) << "with what only other programs know";
    EXPECT_EQ(saved.target.json["meshes"][1]["primitives"][0]["material"], 4);
    const Primitive& primitive = saved.after.scene.primitives.at(1);
    EXPECT_EQ(saved.after.scene.materials.at(static_cast<std::size_t>(primitive.material)).name, "copy");
    EXPECT_TRUE(liesIn(saved.changes(), {"/materials/-", "/meshes/1/primitives/0/material"}))
        << joined(saved.changes());
}

TEST(GltfSave, GivesAndTakesMaterials)
{
    const Saved saved([](Scene& scene) {
        scene.primitives[1].material = -1;
        scene.primitives[2].material = 0;
    });
    EXPECT_FALSE(saved.target.json["meshes"][1]["primitives"][0].contains("material"));
    EXPECT_EQ(saved.target.json["meshes"][1]["primitives"][1]["material"], 1);
    EXPECT_TRUE(liesIn(saved.changes(), {"/meshes/1/primitives/0/material", "/meshes/1/primitives/1/material"}))
        << joined(saved.changes());
    EXPECT_TRUE(saved.remarks.empty()) << joined(saved.remarks);
}

TEST(GltfSave, SaysWhenSeveralNodesShowAMesh)
{
    const Saved saved([](Scene& scene) { scene.primitives[0].material = 1; });
    EXPECT_EQ(saved.target.json["meshes"][0]["primitives"][0]["material"], 2);
    ASSERT_EQ(saved.remarks.size(), 1u);
    EXPECT_TRUE(contains(saved.remarks[0], "/meshes/0 (twice) is shown by 2 nodes")) << saved.remarks[0];
}

/// Two nodes show one mesh in two poses: two primitives of the scene, and one of the file.
GltfBuilder posedTwice()
{
    GltfBuilder builder = richModel();
    nlohmann::json& primitive = builder.json["meshes"][0]["primitives"][0];
    const int moved = builder.addFloats({1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
    primitive["targets"] = {{{"POSITION", moved}}};
    builder.json["nodes"][0]["weights"] = {0.5};
    builder.json["nodes"][1]["weights"] = {1.0};
    builder.json["buffers"][0]["byteLength"] = builder.binary.size();
    return builder;
}

TEST(GltfSave, GivesAllPosesOfAMeshTheMaterialOfOne)
{
    const Saved saved(
        [](Scene& scene) {
            ASSERT_EQ(scene.primitives.size(), 4u);
            scene.primitives[1].material = 1;
        },
        {}, posedTwice());
    EXPECT_EQ(saved.after.scene.primitives.at(0).material, saved.after.scene.primitives.at(1).material);
    EXPECT_EQ(saved.target.json["meshes"][0]["primitives"][0]["material"], 2);
    EXPECT_EQ(saved.remarks.size(), 1u) << joined(saved.remarks);

    const TestFolder folder;
    const auto path = folder.write("model.glb", posedTwice().glb());
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    edited.primitives[0].material = 1;
    edited.primitives[1].material = -1;
    EXPECT_TRUE(contains(test::saveError(path, loaded.scene, edited, folder.path / "a.glb", ExitCode::usage),
                         "several poses, and they were given different materials"));
}

TEST(GltfSave, KnowsWhichSetsOfCoordinatesAreMeant)
{
    GltfBuilder builder = richModel();
    nlohmann::json& primitive = builder.json["meshes"][1]["primitives"][0];
    primitive["attributes"]["TEXCOORD_3"] = primitive["attributes"]["TEXCOORD_0"];
    builder.json["materials"][2] = {{"emissiveTexture", {{"index", 0}, {"texCoord", 3}}},
                                    {"normalTexture", {{"index", 0}}}};
    const Saved saved(
        [](Scene& scene) {
            scene.materials[1].occlusion = scene.materials[1].emissive;
            Material fresh;
            fresh.emissive = {0, 1, TextureUse{}.transform};
            scene.materials.push_back(fresh);
        },
        {}, builder);
    EXPECT_EQ(saved.target.json["materials"][2]["occlusionTexture"].dump(), R"({"index":0,"texCoord":3})");
    EXPECT_EQ(saved.target.json["materials"][3]["emissiveTexture"]["texCoord"], 1);

    const Saved assigned(
        [](Scene& scene) {
            Material fresh;
            fresh.emissive = {0, 1, TextureUse{}.transform};
            scene.materials.push_back(fresh);
            scene.primitives[1].material = 2;
        },
        {}, builder);
    EXPECT_EQ(assigned.target.json["materials"][3]["emissiveTexture"]["texCoord"], 3) << "as its primitive has them";

    const TestFolder folder;
    const auto path = folder.write("model.glb", builder.glb());
    const LoadedScene loaded = loadScene(path);
    Scene edited = loaded.scene;
    edited.primitives[0].material = 1;
    EXPECT_TRUE(contains(test::saveError(path, loaded.scene, edited, folder.path / "a.glb", ExitCode::usage),
                         "samples TEXCOORD_3, and twice was loaded with TEXCOORD_1"));
}

TEST(GltfSave, RefusesWhatWouldNotReadBack)
{
    const TestFolder folder;
    const auto path = folder.write("model.glb", richModel().glb());
    const LoadedScene loaded = loadScene(path);
    const std::vector<std::pair<std::string, std::function<void(Material&)>>> bad = {
        {"baseColorFactor", [](Material& m) { m.baseColorFactor.y = 1.5; }},
        {"metallicFactor", [](Material& m) { m.metallicFactor = -0.1; }},
        {"emissiveFactor", [](Material& m) { m.emissiveFactor.x = -1.0; }},
        {"alphaCutoff", [](Material& m) { m.alphaCutoff = -1.0; }},
        {"ior", [](Material& m) { m.ior = 0.5; }},
        {"name", [](Material& m) { m.name = "\xff"; }},
        {"baseColorTexture/transform", [](Material& m) { m.baseColor.transform[1] = dvec2(0.5, 1.0); }},
    };
    for (const auto& [field, change] : bad) {
        Scene edited = loaded.scene;
        change(edited.materials[0]);
        const ExitCode code = ExitCode::cannotWrite;
        const std::string message = test::saveError(path, loaded.scene, edited, folder.path / "a.glb", code);
        EXPECT_TRUE(contains(message, field)) << field << ": " << message;
        EXPECT_TRUE(message.starts_with((folder.path / "a.glb").string() + ": /materials/1")) << message;
        EXPECT_EQ(test::filesIn(folder.path), 1u) << field;
    }
}

TEST(GltfSave, RefusesScenesThatAreNoEdit)
{
    const TestFolder folder;
    const auto path = folder.write("model.glb", richModel().glb());
    const LoadedScene loaded = loadScene(path);
    const std::vector<std::function<void(Scene&)>> edits = {
        [](Scene& scene) { scene.materials.pop_back(); },
        [](Scene& scene) { scene.primitives.pop_back(); },
        [](Scene& scene) { scene.textures.pop_back(); },
        [](Scene& scene) { scene.textures[0].sampler.wrapS = Wrap::mirroredRepeat; },
        [](Scene& scene) { scene.images.push_back(scene.images[0]); },
        [](Scene& scene) { scene.primitives[0].material = 2; },
        [](Scene& scene) { scene.primitives[0].material = -2; },
        [](Scene& scene) { scene.materials[1].normal.texture = 2; },
        [](Scene& scene) { scene.materials[0].normal.uvSet = 2; },
        [](Scene& scene) { scene.materials[0].roughnessFactor = std::numeric_limits<double>::quiet_NaN(); },
        [](Scene& scene) { scene.materials[0].baseColor.transform[2].x = std::numeric_limits<double>::quiet_NaN(); },
    };
    for (const auto& edit : edits) {
        Scene edited = loaded.scene;
        edit(edited);
        const std::string message = test::saveError(path, loaded.scene, edited, folder.path / "a.glb", ExitCode::usage);
        EXPECT_TRUE(contains(message, "the edited scene")) << message;
    }
}

} // namespace
} // namespace torrance
