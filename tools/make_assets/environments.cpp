#include "make_assets/environments.h"

#include "make_assets/hdr_file.h"
#include "make_assets/sky.h"
#include "make_assets/studio.h"

namespace torrance::assets {

void writeEnvironments(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    writeHdr(folder / "studio.hdr", studioPanorama(1024, 512));
    writeHdr(folder / "sky.hdr", skyPanorama(1024, 512));
    writeHdr(folder / "furnace.hdr", Image(64, 32, 3, 1.0f));
}

} // namespace torrance::assets
