#include "study/transport_part.h"

#include "../reference/closed_forms.h"
#include "brdf/brdf.h"
#include "scene/camera_fit.h"
#include "scene/shape_mesh.h"
#include "study/analytic_scenes.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

/// A floor in an even sky, and over it a closed black dome, a cube, that lets `through` of the light pass. The camera
/// is inside.
Scene domedFloor(double through)
{
    Scene scene;
    scene.materials = {plainMaterial(dvec3(0.8, 0.5, 0.3), 0.0, 1.0), plainMaterial(dvec3(0.0), 0.0, 1.0)};
    scene.materials[1].alphaMode = AlphaMode::blend;
    scene.materials[1].baseColorFactor.a = 1.0 - through;
    Primitive floor = planeMesh(), dome = cubeMesh();
    floor.material = 0;
    dome.material = 1;
    scene.primitives = {floor, dome};
    scene.instances = {{0, 0, dmat4(1.0)}, {1, 1, dmat4(dmat3(5.0))}};
    scene.environment = uniformEnvironment(dvec3(1.0, 2.0, 0.5));
    return scene;
}

TransportPart partOf(double through, const dvec3& drawnShare)
{
    const Scene scene = domedFloor(through);
    const Camera camera = lookAtCamera(dvec3(0.3, 0.2, 3.0), dvec3(0.0), dvec3(0, 1, 0), 0.8);
    Settings settings;
    settings.methods = test::lambertPreset(); // black absorbs all
    settings.width = settings.height = 12;
    settings.samples = 1;
    const CertificateRequest request = {.pixels = 32, .transport = true, .directions = 1024};
    const ReferenceSettings exact = exactSettings(settings, request);
    const PixelEstimator estimator(scene, camera, exact);
    const std::vector<CoveredPixel> covered = coveredPixels(estimator, 12, 12);
    const std::vector<PixelStratum> strata = drawSample(covered.size(), 32, 0);
    std::vector<Replicates> own;
    CertifiedSample sample = {strata, {}, {}, {}};
    for (const PixelStratum& stratum : strata)
        for (const std::size_t i : stratum.drawn) {
            sample.pixels.push_back(covered[i]);
            own.push_back(estimator.replicates(covered[i].x, covered[i].y, exact.directions, request.seed).colors);
            sample.drawn.push_back(own.back().mean() * drawnShare);
        }
    sample.own = own;
    return transportPart(scene, camera, settings, request, sample);
}

TEST(TransportPart, IsTheShareOfTheLightThatADomeTakes)
{
    // Own light c, traced 3/4 c: the error is c / 4 over 3/4 c, everywhere.
    const ErrorNumbers numbers = partOf(0.75, dvec3(1.0)).transport;
    for (const Bounded& number : {numbers.mean, numbers.median}) {
        EXPECT_LE(number.low, 1.0 / 3.0);
        EXPECT_GE(number.high, 1.0 / 3.0);
        EXPECT_LT(number.high - number.low, 0.1);
    }
}

TEST(TransportPart, IsNothingWhereNothingIsInTheWay)
{
    const TransportPart part = partOf(1.0, dvec3(1.0));
    EXPECT_EQ(part.transport.mean.low, 0.0);
    EXPECT_LT(part.transport.mean.high, 0.02);
}

TEST(TransportPart, WhatWasDrawnIsHeldAgainstTheTracedLight)
{
    const ErrorNumbers right = partOf(0.75, dvec3(0.75)).both, half = partOf(0.75, dvec3(0.375)).both;
    EXPECT_LT(right.mean.high, 0.05);
    EXPECT_LE(half.mean.low, 0.5);
    EXPECT_GE(half.mean.high, 0.5);
    EXPECT_GT(half.mean.low, 0.45);
}

} // namespace
} // namespace torrance
