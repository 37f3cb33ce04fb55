#include "make_assets/demo.h"

#include "core/atomic_write.h"
#include "files/image_encoders.h"
#include "make_assets/gltf_file.h"
#include "make_assets/occlusion.h"
#include "make_assets/textures.h"

namespace torrance::assets {
namespace {

void writePng(const std::filesystem::path& path, const Image& picture)
{
    writeFile(path, encodePng(picture, 8));
}

} // namespace

void writeDemo(const std::filesystem::path& folder, const Image& panorama)
{
    std::filesystem::create_directories(folder);
    writePng(folder / "terrazzo.png", terrazzoColor(1024));
    writePng(folder / "wood.png", woodColor(1024));
    writePng(folder / "wood_roughness.png", woodRoughness(512));
    writePng(folder / "hammered_normal.png", hammeredNormal(512));
    writePng(folder / "brushed_roughness.png", brushedRoughness(512));
    writePng(folder / "perforated.png", perforatedAlpha(64));
    writePng(folder / "leaf.png", leafColor(256));
    writePng(folder / "numerals.png", numerals(256));
    writePng(folder / "glaze.png", glazeColor(512));

    const DemoScene scene = demoScene();
    const std::vector<std::vector<Chart>> charts = layOutCharts(scene.objects);
    writePng(folder / "occlusion.png", bakeOcclusion(scene, charts, panorama));
    writeGltf(folder / "demo.gltf", scene, charts, "occlusion.png");
}

} // namespace torrance::assets
