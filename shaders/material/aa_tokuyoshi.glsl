// Tokuyoshi & Kaplanyan 2019, Improved Geometric Specular Antialiasing: the lobe is widened by the normals' variance within the
// pixel, of which dndx and dndy are the derivatives. In squares of alpha; at most kKernelCap is added.
float AA_tokuyoshi(vec3 dndx, vec3 dndy, float alpha)
{
    const float kFilterVariance = 0.15915494; // 1 / (2 pi), of the pixel filter
    const float kKernelCap = 0.18;            // of the paper: beyond it, derivatives are those of silhouettes and not of curvature
    const float kFlat = 1e-12;                // a turn of 1e-6 per pixel is the rounding of a flat face's normals
    float turn2 = dot(dndx, dndx) + dot(dndy, dndy);
    return turn2 > kFlat ? sqrt(min(alpha * alpha + min(2.0 * kFilterVariance * turn2, kKernelCap), 1.0)) : alpha;
}
