#include "shared/constants.h"

// The mean over the hemisphere, weighted by the cosine, of the directional albedo of ggx with smith_corr and F = 1. 1 - mean = r^4 / P(r), P
// fitted to src/brdf/lobe_albedo.h: within 2e-4 of itself for r >= 0.1, where it is 5e-4, and within 4e-5 of the truth everywhere.
float averageAlbedo(float perceptualRoughness)
{
    float r = max(perceptualRoughness, sqrt(kMinAlpha)); // below it, alpha is kMinAlpha
    float P = 0.109911352 +
              r * (1.01307622 +
                   r * (-2.07825005 + r * (6.92988832 + r * (-11.8204142 + r * (12.8769433 + r * (-6.89960051 + r * 1.56098882))))));
    float r2 = r * r;
    return 1.0 - r2 * r2 / P;
}
