#include "study/timed_frame.h"

#include "plan/pixel_sampling_plan.h"

namespace torrance {

TimeUse timeOfFrame(Renderer& renderer, const DeviceScene& scene, const Camera& camera)
{
    const TimeUse start = timeUse();
    if (pictureCount(scene.plan.settings) == 1) {
        renderer.drawFrame(scene, camera);
        return timeUse() - start;
    }
    TimeUse drawn = start; // what follows the last sample is reading back
    renderer.render(scene, camera, [&](int, int) { drawn = timeUse(); });
    return drawn - start;
}

} // namespace torrance
