#include "brdf/specular_antialiasing.h"

namespace torrance::brdf {

double AA_none(const NormalFootprint& footprint)
{
    return footprint.alpha;
}

} // namespace torrance::brdf
