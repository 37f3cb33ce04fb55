// A sphere light by one point of it: Karis 2013, section "Area Lights". `toCenter` leads to the sphere's centre, `r` is the mirror
// direction of the view. Where the point lies on or in the sphere, every mirror ray meets it.

// The direction of the sphere's point that is nearest to the mirror ray. Unit.
vec3 representativeDirection(vec3 toCenter, float radius, vec3 r)
{
    if (dot(toCenter, toCenter) <= radius * radius)
        return r;
    vec3 centerToRay = dot(toCenter, r) * r - toCenter;
    return normalize(toCenter + centerToRay * min(radius / max(length(centerToRay), kLeastDenominator), 1.0));
}

// By how much the lobe of that point outshines the sphere's: (alpha / alpha')^2 of a lobe widened to alpha' by the sphere.
float representativeEnergy(float alpha, float radius, float distance)
{
    float widened = alpha / min(alpha + radius / (3.0 * max(distance, kMinLightDistance)), 1.0);
    return widened * widened;
}
