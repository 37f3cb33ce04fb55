#include "plan/view_scale.h"

#include "image/linear_scale.h"

namespace torrance {

ViewScale scaleOf(const View& view, const Image& drawn)
{
    if (view.scale)
        return *view.scale;
    const double greatest = greatestValue(drawn);
    return {.factor = greatest > 0.0 ? 1.0 / greatest : 1.0};
}

} // namespace torrance
