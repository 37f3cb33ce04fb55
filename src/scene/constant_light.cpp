#include "scene/constant_light.h"

namespace torrance {

Light constantLight(const dvec3& towards, double distance, double intensity)
{
    Light light;
    light.kind = Light::Kind::directional;
    light.name = "constant";
    light.direction = -glm::normalize(towards);
    light.intensity = intensity / (distance * distance);
    return light;
}

} // namespace torrance
