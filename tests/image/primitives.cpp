// Primitives with the maps of a folder on them, against rays and against theory.
#include "files/image_write.h"
#include "files/map_folder.h"
#include "mesh_truth.h"
#include "scene/camera_fit.h"
#include "scene/shape_mesh.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

namespace torrance::test {
namespace {

namespace fs = std::filesystem;

constexpr double kTolerance = 2e-3; // as for the textured mesh

class MapFolder
{
public:
    MapFolder() : path(fs::path(testing::TempDir()) / ("torrance_maps_" + std::to_string(::getpid())))
    {
        fs::create_directories(path);
    }
    ~MapFolder() { fs::remove_all(path); }

    /// Values as they are to stand in the file, 0 to 1.
    void write(const std::string& name, int size, int bits, const std::function<dvec3(int, int)>& value) const
    {
        Image picture(size, size, 3);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (int c = 0; c < 3; ++c)
                    picture.at(x, y)[c] = static_cast<float>(value(x, y)[c]);
        writePicture((path / name).string(), picture, {},
                     {.tone = findToneCurve("none"), .transfer = findTransferCurve("linear"), .bitsPerChannel = bits});
    }

    Scene on(Primitive mesh) const
    {
        Scene scene;
        LoadReport report;
        report.file = path.string();
        scene.materials.push_back(readMapFolder(path, {}, SceneLimits{}, scene, report));
        for (Texture& texture : scene.textures)
            texture.sampler = levelZero(Filter::linear);
        mesh.material = 0;
        addInstance(scene, std::move(mesh), dmat4(1.0));
        return scene;
    }

    const fs::path path;
};

double wave(int x, int y, double phase)
{
    return 0.5 + 0.5 * std::sin(2.0 * kPi * (x + 2 * y) / 32.0 + phase);
}

TEST(Primitives, ASphereWithMapsAgreesWithRays)
{
    const MapFolder folder;
    folder.write("T_1K_Color.png", 32, 8,
                 [](int x, int y) { return dvec3(wave(x, y, 0.0), wave(x, y, 1.0), wave(x, y, 2.0)); });
    folder.write("T_1K_Roughness.png", 32, 16, [](int x, int y) { return dvec3(0.3 + 0.6 * wave(x, y, 0.5)); });
    folder.write("T_1K_Metalness.png", 32, 16, [](int x, int y) { return dvec3(wave(y, x, 0.2)); });
    folder.write("T_1K_NormalGL.png", 32, 16, [](int x, int y) {
        return 0.5 + 0.5 * glm::normalize(dvec3(0.6 * wave(x, y, 0.3) - 0.3, 0.6 * wave(y, x, 1.1) - 0.3, 1.0));
    });
    folder.write("T_1K_AmbientOcclusion.png", 32, 8, [](int x, int y) { return dvec3(wave(x, -y, 0.9)); });
    Scene scene = folder.on(sphereMesh());
    scene.lights.push_back(testLight(Light::Kind::point));
    const Camera camera = fitCamera(scene, {0.4, 1.0}, 1.0, 0.7, 0.05);
    expectDrawnAsCast(scene, camera, settingsOf("gltf", 96), kTolerance, "sphere-maps");
}

TEST(Primitives, SixteenBitCodesAreToldApartOnTheDevice)
{
    // Roughness that rises by one code of 16 bits from texel to texel, in the middle of the range. Every texel covers
    // several pixels; nearest filtering shows the codes themselves, through the device's texture and the layer of
    // roughness.
    constexpr int kSize = 16;
    constexpr int kFirst = 30000;
    const MapFolder folder;
    folder.write("T_Color.png", kSize, 8, [](int, int) { return dvec3(0.5); });
    folder.write("T_Roughness.png", kSize, 16, [](int x, int y) { return dvec3((kFirst + x + kSize * y) / 65535.0); });
    Scene scene = folder.on(planeMesh());
    for (Texture& texture : scene.textures)
        texture.sampler = levelZero(Filter::nearest);
    scene.lights.push_back(testLight(Light::Kind::directional));
    Settings settings = settingsOf("gltf", 64);
    settings.layers = true;
    Camera camera = orbitCamera({0.0, kPi / 2.0}, 3.0, dvec3(0.0), 0.7);
    camera.kind = Camera::Kind::orthographic;
    camera.ymag = 1.0;
    camera.farPlane = 10.0;
    const Picture picture = draw(scene, camera, settings);
    const auto layer = std::find_if(picture.layers.begin(), picture.layers.end(),
                                    [](const Layer& l) { return l.name == "roughness"; });
    ASSERT_NE(layer, picture.layers.end());
    std::set<long> codes;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const double code = layer->image.at(x, y)[0] * 65535.0;
            const int expected = kFirst + x / 4 + kSize * (y / 4);
            // A float holds code / 65535 to 2^-25 of it, 0.001 of a code here; the device's division may double that.
            EXPECT_NEAR(code, expected, 0.004) << "at " << x << ", " << y;
            codes.insert(std::lround(code));
        }
    EXPECT_EQ(codes.size(), 256u);
}

} // namespace
} // namespace torrance::test
