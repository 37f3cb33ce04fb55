// Analytic shapes under every light, pixel by pixel against the double formulas: src/study/shape_cases.cpp has the
// cases and says what is allowed.
#include "study/shape_cases.h"

#include "drawing.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

using Shape = AnalyticShape::Kind;

TEST(SphereImage, DirectionalLight)
{
    expectDrawnAsComputed(shapeCases(Shape::sphere, Light::Kind::directional));
}

TEST(SphereImage, PointLight)
{
    expectDrawnAsComputed(shapeCases(Shape::sphere, Light::Kind::point));
}

TEST(SphereImage, SpotLight)
{
    expectDrawnAsComputed(shapeCases(Shape::sphere, Light::Kind::spot));
}

TEST(SphereImage, UniformEnvironment)
{
    expectDrawnAsComputed(shapeCasesInUniformLight(Shape::sphere));
}

TEST(PlaneImage, DirectionalLight)
{
    expectDrawnAsComputed(shapeCases(Shape::plane, Light::Kind::directional));
}

TEST(PlaneImage, PointLight)
{
    expectDrawnAsComputed(shapeCases(Shape::plane, Light::Kind::point));
}

TEST(PlaneImage, SpotLight)
{
    expectDrawnAsComputed(shapeCases(Shape::plane, Light::Kind::spot));
}

TEST(PlaneImage, UniformEnvironment)
{
    expectDrawnAsComputed(shapeCasesInUniformLight(Shape::plane));
}

} // namespace
} // namespace torrance::test
