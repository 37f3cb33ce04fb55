// Makes what the project ships: the demo scene, three environments and a set of maps. The same program writes the same
// bytes each time.
#include "core/error.h"
#include "core/log.h"
#include "make_assets/demo.h"
#include "make_assets/environments.h"
#include "make_assets/studio.h"
#include "make_assets/worn_copper.h"

#include <exception>
#include <filesystem>

int main(int argc, char** argv)
{
    if (argc != 2) {
        torrance::logError("usage: make_assets FOLDER");
        return static_cast<int>(torrance::ExitCode::usage);
    }
    try {
        const std::filesystem::path folder = argv[1];
        torrance::assets::writeEnvironments(folder / "environments");
        // Shadows as soft as these need no finer light.
        torrance::assets::writeDemo(folder / "demo", torrance::assets::studioPanorama(128, 64));
        torrance::assets::writeWornCopper(folder / "maps" / "worn_copper");
    } catch (const torrance::Error& error) {
        torrance::logError(error.what());
        return static_cast<int>(error.exitCode);
    } catch (const std::exception& error) {
        torrance::logError(error.what());
        return static_cast<int>(torrance::ExitCode::cannotWrite);
    }
    return 0;
}
