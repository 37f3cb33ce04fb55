#include "app/version.h"

#include "app/revision.h"

namespace torrance {

std::string versionText()
{
    return "torrance " TORRANCE_VERSION " (" TORRANCE_REVISION ", " TORRANCE_BUILD_TYPE ", g++ " __VERSION__ ")";
}

} // namespace torrance
