// glTF 2.0, Appendix B: light that meets a second microfacet is lost.
vec3 M_none(vec3 single, vec3 spread, vec3 f0, float bias, float E, float ELight, float EAverage)
{
    return single;
}
