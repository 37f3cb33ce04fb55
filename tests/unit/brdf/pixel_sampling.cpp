// The formulas of a pixel's mean over its samples, on pixels whose answer is known.
#include "brdf/pixel_sampling.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

constexpr double kWidth = 1e-3; // a pixel's width, in depth
const dvec4 kRed(1, 0, 0, 1), kBlue(0, 0, 1, 1), kNothing(0);

/// What lies at a place, in pixels from the pixel's centre.
struct Seen
{
    double depth;
    dvec4 color;
};

template <typename Scene>
PixelQuery lookAt(const Scene& scene)
{
    PixelQuery query;
    for (std::size_t i = 0; i < query.sampleDepths.size(); ++i)
        query.sampleDepths[i] = scene(kSamplePlaces[i]).depth;
    for (std::size_t i = 0; i < query.depths.size(); ++i)
        query.depths[i] = scene(dvec2(double(i % 7) - 3.0, double(i / 7) - 3.0)).depth;
    for (std::size_t i = 0; i < query.colors.size(); ++i)
        query.colors[i] = scene(dvec2(double(i % 3) - 1.0, double(i / 3) - 1.0)).color;
    query.widthInDepth = [](double) { return kWidth; };
    return query;
}

TEST(PixelSampling, SupersampledIsTheMean)
{
    PixelQuery query;
    query.sampleColors = {kRed, kRed, kRed, kBlue};
    EXPECT_EQ(PS_supersampled(query), dvec4(0.75, 0, 0.25, 1));
}

// A plane at any slope is one surface: the pixel keeps the colour that it was shaded with.
TEST(PixelSampling, APlaneKeepsItsColour)
{
    for (const double slope : {0.0, 0.3, 30.0})
        EXPECT_EQ(PS_reconstructed(lookAt([&](const dvec2& p) {
                      return Seen{0.5 + slope * kWidth * (p.x - 0.5 * p.y), p == dvec2(0.0) ? kRed : kBlue};
                  })),
                  kRed)
            << slope;
    EXPECT_EQ(PS_reconstructed(lookAt([](const dvec2&) { return Seen{0.0, kNothing}; })), kNothing);
}

// A surface that ends at x = edge, before nothing or before another surface: each sample takes the side that it lies
// on.
TEST(PixelSampling, AnEdgeIsTheShareOfItsSamples)
{
    for (const bool before : {false, true}) // a surface far behind, or nothing
        for (const double edge : {-0.45, -0.25, -0.05, 0.05, 0.25, 0.45})
            for (const double slope : {0.0, 5.0}) {
                const dvec4 behind = before ? kBlue : kNothing;
                const auto scene = [&](const dvec2& p) {
                    return p.x < edge ? Seen{0.5 + slope * kWidth * p.x, kRed} : Seen{before ? 0.2 : 0.0, behind};
                };
                int left = 0;
                for (const dvec2& place : kSamplePlaces)
                    left += place.x < edge;
                EXPECT_EQ(PS_reconstructed(lookAt(scene)), 0.25 * (double(left) * kRed + double(4 - left) * behind))
                    << edge << ' ' << slope << ' ' << before;
            }
}

// Two planes that meet in the pixel, as the sides of a box: depth has no step there, only a bend.
TEST(PixelSampling, ACreaseIsTheShareOfItsSides)
{
    const auto scene = [](const dvec2& p) {
        const double x = p.x - 0.2;
        return x < 0.0 ? Seen{0.5 + 2.0 * kWidth * x, kRed} : Seen{0.5 - 3.0 * kWidth * x, kBlue};
    };
    EXPECT_EQ(PS_reconstructed(lookAt(scene)), 0.25 * (3.0 * kRed + kBlue));
}

// A bend that no eye sees is no edge, and one just above the bound is.
TEST(PixelSampling, FlatIsATenthOfAPixel)
{
    for (const double bend : {0.9 * kPixelFlatness, 1.1 * kPixelFlatness}) {
        PixelQuery query = lookAt([](const dvec2& p) { return Seen{0.5, p.x > 0.0 ? kBlue : kRed}; });
        query.sampleDepths[1] += 2.0 * bend * kWidth;
        query.depths[25] += 2.0 * bend * kWidth; // the pixel to the right is the one that sample 1 lies on
        EXPECT_EQ(PS_reconstructed(query) == kRed, bend < kPixelFlatness) << bend;
    }
}

// What no pixel nearby was shaded for keeps the pixel's own colour: a gap between two surfaces narrower than a pixel.
TEST(PixelSampling, WhatWasNotShadedIsNotInvented)
{
    const auto scene = [](const dvec2& p) {
        return std::abs(p.x - 0.375) < 0.1 ? Seen{0.0, kNothing} : Seen{0.5, kRed};
    };
    EXPECT_EQ(PS_reconstructed(lookAt(scene)), kRed);
}

} // namespace
} // namespace torrance::brdf
