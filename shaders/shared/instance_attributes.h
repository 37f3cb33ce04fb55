// Locations of an Instance's members as attributes of a vertex shader.
#ifndef TORRANCE_SHARED_INSTANCE_ATTRIBUTES_H
#define TORRANCE_SHARED_INSTANCE_ATTRIBUTES_H

#include "shared/language.h"

SHARED_BEGIN

SHARED_UINT(kInstanceLinear, 6);           // three columns
SHARED_UINT(kInstanceTranslation, 9);
SHARED_UINT(kInstanceNormal, 10);          // three columns, the last with the handedness
SHARED_UINT(kInstanceIds, 13);             // material, object

SHARED_END

#endif
