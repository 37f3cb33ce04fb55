// Points of a dense grid over directions and roughness, for whatever must hold everywhere.
#pragma once

#include "brdf/method.h"

#include <cmath>
#include <vector>

namespace torrance::brdf {

/// A direction at `cosine` from +Z, turned by `azimuth` (radians).
inline dvec3 directionAt(double cosine, double azimuth)
{
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

inline ShadingPoint pointAt(double NoV, double NoL, double azimuth, double perceptualRoughness)
{
    return makeShadingPoint(dvec3(0, 0, 1), directionAt(NoV, 0.0), directionAt(NoL, azimuth), perceptualRoughness);
}

/// 8 x 8 cosines from grazing to normal, 5 azimuths from retroreflection to mirror, 7 roughnesses.
inline std::vector<ShadingPoint> gridOfPoints()
{
    std::vector<ShadingPoint> points;
    for (const double roughness : {0.0, 0.01, 0.1, 0.3, 0.5, 0.8, 1.0})
        for (const double NoV : {0.001, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0})
            for (const double NoL : {0.001, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0})
                for (const double azimuth : {0.0, 0.7, 1.6, 2.9, kPi})
                    points.push_back(pointAt(NoV, NoL, azimuth, roughness));
    return points;
}

/// The value of any shading formula, scalars in all channels.
inline dvec3 valueOf(const Method& method, const ShadingPoint& point)
{
    if (const auto* scalar = std::get_if<ScalarFormula>(&method.formula))
        return dvec3((*scalar)(point));
    return std::get<ColorFormula>(method.formula)(point);
}

} // namespace torrance::brdf
