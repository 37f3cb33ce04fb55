// Is there anything in the way? Rays against the demo scene's triangles (Embree).
#pragma once

#include "make_assets/demo_scene.h"

namespace torrance::assets {

class ShadowRays
{
public:
    /// Takes the objects that cast shadows.
    explicit ShadowRays(const DemoScene& scene);
    ~ShadowRays();
    ShadowRays(const ShadowRays&) = delete;
    ShadowRays& operator=(const ShadowRays&) = delete;

    bool blocked(const dvec3& from, const dvec3& direction) const;

private:
    void* device;
    void* scene;
};

} // namespace torrance::assets
