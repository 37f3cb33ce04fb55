#ifndef TORRANCE_SURROUNDINGS
#define TORRANCE_SURROUNDINGS

// What a source's model is given of the light on a surface. What its preset has no method for is 0.
struct Surroundings
{
    vec3 mirrored;         // light about the mirror direction, by the method of environment_specular
    vec3 refracted;        // likewise of refract(-v, n, 0.8)
    vec3 irradianceOverPi; // by the method of environment_diffuse
    vec3 integrals;        // x, y, z of source B's integration map (src/brdf/integration_map.h)
    vec3 lit;              // what the lights make of the surface
};

#endif
