// Every intermediate of a BRDF at one point: what a slot-`model` formula returns.
#pragma once

#include "math/vector.h"

namespace torrance::brdf {

/// All zero where the model reflects nothing. What a model does not have (phong: everything between h and specular)
/// stays zero.
struct BrdfTerms
{
    dvec3 h = dvec3(0);        // half vector, unit
    double D = 0;              // 1/sr
    double G1 = 0;             // masking of the view direction alone: G with the light at the normal
    double G = 0;              // masking and shadowing
    double V = 0;              // what D and F are multiplied by: G over the denominator, with the source's guard
    dvec3 F0 = dvec3(0);       // reflectance at normal incidence
    dvec3 F = dvec3(0);        // at v.h
    dvec3 specular = dvec3(0); // 1/sr, with F and all weights
    dvec3 diffuse = dvec3(0);  // 1/sr, with base colour and all weights
    dvec3 brdf = dvec3(0);     // specular + diffuse, as the model mixes them
    double weight = 0;         // n.l; 1 where a source's own formula holds its cosines already, or forgets them

    /// Radiance per irradiance of a surface that faces the light.
    dvec3 response() const { return brdf * weight; }
};

} // namespace torrance::brdf
