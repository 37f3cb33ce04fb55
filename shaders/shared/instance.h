#ifndef TORRANCE_SHARED_INSTANCE_H
#define TORRANCE_SHARED_INSTANCE_H

#include "shared/language.h"

SHARED_BEGIN

// Of meshes an attribute of each instance, of analytic shapes a uniform block.
struct Instance
{
    mat3 linear;      // object to eye-relative, world axes
    vec3 translation; // of the object's origin, or of the centre that was taken out of its vertices
    mat3 normal;      // cofactors of `linear`, times the sign of its determinant, scaled to about 1
    float handedness; // sign of the determinant
    uint material;
    uint object;
};

SHARED_END

#endif
