// Conty & Kulla 2017: the "Charlie" distribution and its masking.
#ifndef TORRANCE_BRDF_CHARLIE
#define TORRANCE_BRDF_CHARLIE

#include "brdf/extended.glsl"
#include "shared/constants.h"

// Section 2: factor * (2 + 1/alpha) sin^(1/alpha) / (2 pi), as exp(log(sin^2) / (2 alpha)), the exponent in extended precision:
// 1 / alpha reaches 1e4. sin^2 comes from whichever of sin2H and NoH was rounded less in it. The factor goes in before the exponential
// can leave the range of floats.
float charlieDistribution(float NoH, float sin2H, float alpha, float factor)
{
    const float kLeastSquare = 1e-37; // extendedLog's least
    vec2 square = sin2H < 0.5 ? vec2(sin2H, 0.0) : extendedSum(vec2(1.0, 0.0), -exactProduct(NoH, NoH));
    if (square.x < kLeastSquare)
        return 0.0;
    vec2 exponent = extendedProduct(extendedQuotient(vec2(0.5, 0.0), vec2(alpha, 0.0)), -extendedLog(square));
    if (!(exponent.x < kExponentUnderflow))
        return 0.0;
    return scaledExp(factor * ((1.0 + 0.5 / alpha) / PI), exponent);
}

// Section 3: a / (1 + b x^c) + d x + e, with (a, b, c) and (d, e) between their values at alpha = 1 and alpha = 0.
float charlieLogLambda(float x, float smoothness)
{
    vec3 abc = vec3(21.5473, 3.82987, 0.19823) + smoothness * vec3(3.7772, -0.50552, -0.03022);
    vec2 de = vec2(-1.97760, -4.32054) + smoothness * vec2(0.70367, -0.53913);
    return abc.x / (1.0 + abc.y * pow(x, abc.z)) + (de.x * x + de.y);
}

// smoothness = (1 - alpha)^2
float charlieLambda(float cosine, float smoothness)
{
    if (cosine < 0.5)
        return exp(charlieLogLambda(cosine, smoothness));
    return exp(2.0 * charlieLogLambda(0.5, smoothness) - charlieLogLambda(1.0 - min(cosine, 1.0), smoothness));
}

#endif
