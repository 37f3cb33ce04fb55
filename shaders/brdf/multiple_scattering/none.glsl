// glTF 2.0, Appendix B: light that meets a second microfacet is lost.
vec3 M_none(vec3 f0, float E)
{
    return vec3(1.0);
}
