// The white furnace: src/study/furnace_cases.cpp has the cases and says what is allowed.
#include "study/furnace_cases.h"

#include "drawing.h"

#include <gtest/gtest.h>

namespace torrance::test {
namespace {

TEST(Furnace, MetalReturnsWhatTheModelSays)
{
    expectDrawnAsComputed(furnaceCases("gltf", 1.0));
}

TEST(Furnace, HalfMetalReturnsWhatTheModelSays)
{
    expectDrawnAsComputed(furnaceCases("gltf", 0.5));
}

TEST(Furnace, DielectricReturnsWhatTheModelSays)
{
    expectDrawnAsComputed(furnaceCases("gltf", 0.0));
}

TEST(Furnace, CompensatedWhiteMetalReturnsAll)
{
    expectDrawnAsComputed(furnaceCases("standard", 1.0));
}

} // namespace
} // namespace torrance::test
