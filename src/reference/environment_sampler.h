// The environment as the light that it is: radiance in every direction, and directions drawn from where it is bright.
#pragma once

#include "reference/directed_light.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace torrance {

/// Radiance is the bilinear interpolation of the panorama's texels, which stand for the directions of their centres:
/// periodic in u, constant beyond the first and the last row's centres. It is what the device draws behind the scene
/// and what its prefilter reads; suns included, which the prefilter spreads over their texel's area: the energy is the
/// same.
///
/// The density that directions are drawn from is, over (u, v), the bilinear interpolation of texel weights: luminance
/// (mean of the channels) times the sine of the row's polar angle. A point is drawn exactly from it by taking a texel
/// by its weight and moving by a triangular distribution, mirrored at the poles.
class EnvironmentSampler
{
public:
    /// Copies what it needs. The picture's values are finite and not negative.
    explicit EnvironmentSampler(const Environment& environment);

    /// No light from anywhere: nothing can be drawn.
    bool dark() const { return !(total > 0.0); }

    /// `direction` is unit, in the world. The density is infinite at the poles.
    DirectedLight at(const dvec3& direction) const;

    /// A unit direction in the world. Not for a dark environment.
    dvec3 draw(const dvec2& u) const;

private:
    struct Texel
    {
        float r, g, b, weight;
    };
    const Texel& texel(int x, int y) const
    {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }

    int width = 0;
    int height = 0;
    double intensity = 1.0;
    dmat3 worldFromEnvironment = dmat3(1.0);
    std::vector<Texel> texels;
    std::vector<double> columns; // per row, running sums of its weights, starting after the first texel
    std::vector<double> rows;    // running sums of whole rows
    std::vector<std::uint32_t> columnGuides, rowGuide; // math/guided_choice.h
    double total = 0.0;
};

} // namespace torrance
