#include "scene/phong.h"

#include <algorithm>
#include <cmath>

namespace torrance {

double perceptualRoughnessOfShininess(double shininess)
{
    const double alpha2 = 2.0 / (std::max(shininess, 0.0) + 2.0);
    return std::sqrt(std::sqrt(alpha2));
}

double shininessOfPerceptualRoughness(double perceptualRoughness)
{
    const double alpha = perceptualRoughness * perceptualRoughness;
    return 2.0 / (alpha * alpha) - 2.0;
}

double reflectanceOfIor(double ior)
{
    const double root = (ior - 1.0) / (ior + 1.0);
    return root * root;
}

double iorOfReflectance(double reflectance)
{
    const double root = std::sqrt(reflectance);
    return (1.0 + root) / (1.0 - root);
}

} // namespace torrance
