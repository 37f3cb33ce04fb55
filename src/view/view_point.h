// From where the picture is seen: the whole scene along a direction, a camera of the file, or a camera that is free.
#pragma once

#include "view/orbit_pose.h"

#include <variant>

namespace torrance {

/// The whole scene in the picture, seen along a direction: what `torrance render` does by itself.
struct FittedView
{
    double theta = kDefaultTheta; // degrees, as of OrbitPose
    double phi = kDefaultPhi;
};

/// One of the file's cameras, as it stands there.
struct FileView
{
    int index = 0;
};

using ViewPoint = std::variant<FittedView, FileView, OrbitPose>;

/// The whole scene from where it is seen now; along the default direction where that has no angles about +Y.
inline FittedView wholeSceneFrom(const ViewPoint& now)
{
    if (const auto* fitted = std::get_if<FittedView>(&now))
        return *fitted;
    const auto* pose = std::get_if<OrbitPose>(&now);
    return pose && pose->up == OrbitPose().up ? FittedView{pose->theta, pose->phi} : FittedView{};
}

} // namespace torrance
