#include "make_assets/environments.h"

#include "core/atomic_write.h"
#include "files/hdr_file.h"
#include "make_assets/sky.h"
#include "make_assets/studio.h"

namespace torrance::assets {

void writeEnvironments(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    writeFile(folder / "studio.hdr", encodeHdr(studioPanorama(1024, 512)));
    writeFile(folder / "sky.hdr", encodeHdr(skyPanorama(1024, 512)));
    writeFile(folder / "furnace.hdr", encodeHdr(Image(64, 32, 3, 1.0f)));
}

} // namespace torrance::assets
