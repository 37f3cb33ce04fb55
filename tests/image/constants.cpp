// The reference repeats the shaders' documented guards in double.
#include "shared/constants.h"
#include "brdf/area_light.h"
#include "brdf/pixel_sampling.h"
#include "reference/material_point.h"
#include "reference/punctual_light.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(Constants, ReferenceAndDeviceShareTheirGuards)
{
    EXPECT_EQ(static_cast<float>(kMinNoV), shared::kMinNoV);
    EXPECT_EQ(static_cast<float>(kMinLightDistance), shared::kMinLightDistance);
    EXPECT_EQ(static_cast<float>(brdf::kPixelFlatness), shared::kPixelFlatness);
    EXPECT_EQ(brdf::kLeastLightDistance, kMinLightDistance);
}

} // namespace
} // namespace torrance::test
