// An OBJ file is the mesh and the maps that it was written from: drawn, it agrees with rays cast at those.
#include "files/image_write.h"
#include "files/scene_file.h"
#include "image/srgb.h"
#include "mesh_truth.h"
#include "scene/camera_fit.h"
#include "scenes.h"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace torrance::test {
namespace {

namespace fs = std::filesystem;

constexpr double kTolerance = 2e-3; // as for the textured mesh

class ObjFolder
{
public:
    ObjFolder() : path(fs::path(testing::TempDir()) / ("torrance_obj_" + std::to_string(::getpid())))
    {
        fs::create_directories(path);
    }
    ~ObjFolder() { fs::remove_all(path); }
    const fs::path path;
};

/// The codes of one channel, or of three, as a PNG: what the writer encodes again is decoded first.
void writeMap(const fs::path& path, const TextureImage& codes, std::array<std::size_t, 3> channels)
{
    Image picture(codes.width, codes.height, 3);
    for (std::size_t texel = 0; texel < codes.texels.size() / 4; ++texel)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto code = std::to_integer<int>(codes.texels[4 * texel + channels[c]]);
            picture.texels[3 * texel + c] = static_cast<float>(srgbDecode(code / 255.0));
        }
    writePicture(path.string(), picture, {}, {.tone = findToneCurve("none")});
}

void writeMesh(const fs::path& path, const Primitive& mesh)
{
    std::ofstream file(path);
    file.precision(9); // enough to tell floats apart
    file << "mtllib torus.mtl\no torus\nusemtl clay\n";
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const vec3 &p = mesh.positions[i], &n = mesh.normals[i];
        const vec2& uv = mesh.uvs[0][i];
        file << "v " << p.x << ' ' << p.y << ' ' << p.z << "\nvn " << n.x << ' ' << n.y << ' ' << n.z << "\nvt " << uv.x
             << ' ' << 1.0 - uv.y << '\n';
    }
    const auto corner = [&](std::size_t i) {
        const std::string number = std::to_string(mesh.indices[i] + 1);
        return ' ' + number + '/' + number + '/' + number;
    };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        file << 'f' << corner(i) << corner(i + 1) << corner(i + 2) << '\n';
}

void writeScene(const fs::path& folder, const Scene& scene)
{
    const Material& m = scene.materials[0];
    const auto image = [&](const TextureUse& use) -> const TextureImage& {
        return scene.images[static_cast<std::size_t>(scene.textures[static_cast<std::size_t>(use.texture)].image)];
    };
    writeMap(folder / "color.png", image(m.baseColor), {0, 1, 2});
    writeMap(folder / "rough.png", image(m.metallicRoughness), {1, 1, 1});
    writeMap(folder / "metal.png", image(m.metallicRoughness), {2, 2, 2});
    writeMap(folder / "normal.png", image(m.normal), {0, 1, 2});
    writeMap(folder / "emission.png", image(m.emissive), {0, 1, 2});
    writeMesh(folder / "torus.obj", scene.primitives[0]);
    std::ofstream file(folder / "torus.mtl");
    file.precision(9);
    file << "newmtl clay\nKd " << m.baseColorFactor.r << ' ' << m.baseColorFactor.g << ' ' << m.baseColorFactor.b
         << "\nPr " << m.roughnessFactor << "\nPm " << m.metallicFactor << "\nKe " << m.emissiveFactor.r << ' '
         << m.emissiveFactor.g << ' ' << m.emissiveFactor.b << "\nmap_Kd color.png\nmap_Pr rough.png\n"
         << "map_Pm metal.png\nnorm -bm " << m.normalScale << " normal.png\nmap_Ke emission.png\n";
}

TEST(ObjFiles, AreDrawnAsTheMeshTheyWereWrittenFrom)
{
    Scene truth = texturedTorus();
    truth.materials[0].occlusion = {}; // of which the format knows nothing
    truth.materials[0].doubleSided = true;
    truth.lights.push_back(testLight(Light::Kind::point));
    const ObjFolder folder;
    writeScene(folder.path, truth);
    LoadedScene loaded = loadScene(folder.path / "torus.obj");
    EXPECT_TRUE(loaded.warnings.empty());
    loaded.scene.lights = truth.lights;
    for (Texture& texture : loaded.scene.textures)
        texture.sampler = levelZero(Filter::linear);

    const Settings settings = settingsOf("gltf", 96);
    const Camera camera = fitCamera(truth, {0.4, 1.0}, 1.0, 0.7, 0.05);
    const Picture picture = draw(loaded.scene, camera, settings);
    const std::vector<CastPixel> cast =
        castPicture(truth, plannedMethods(truth, settings, 0), camera, settings.width, settings.height);
    const Agreement agreement = compareToCast(picture, cast, kTolerance);
    EXPECT_GT(agreement.compared, 96 * 96 / 10);
    EXPECT_EQ(agreement.coverageErrors, 0);
    EXPECT_LE(agreement.percentile99, kTolerance) << agreement.worst.text();
}

} // namespace
} // namespace torrance::test
