// w(NoV) = (1/pi) int (1 - VoH)^5 NoL dl of src/brdf/albedo.h as the polynomial of degree 5 in u = 1 - NoV that meets it at
// the six Chebyshev nodes of [0, 1]: within 6e-6 of it. What the fits of slot dfg, which lack it, take. NoV in [0, 1].
float fittedDiffuseWeight(float NoV)
{
    float u = 1.0 - NoV;
    return 8.308367095e-5 +
           u * (1.988666338e-3 + u * (9.588099758e-3 + u * (6.968876477e-3 + u * (9.961015328e-3 - 4.288209645e-4 * u))));
}
