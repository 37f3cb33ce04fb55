// The terms that can be drawn by themselves (src/plan/view.h has their names).
#ifndef TORRANCE_SHARED_VIEW_H
#define TORRANCE_SHARED_VIEW_H

#include "shared/language.h"

SHARED_BEGIN

SHARED_UINT(kViewAlbedo, 0);
SHARED_UINT(kViewRoughness, 1);
SHARED_UINT(kViewMetallic, 2);
SHARED_UINT(kViewLightIntensity, 3);
SHARED_UINT(kViewHalfVector, 4);
SHARED_UINT(kViewNoL, 5);
SHARED_UINT(kViewD, 6);
SHARED_UINT(kViewG1, 7);
SHARED_UINT(kViewG, 8);
SHARED_UINT(kViewV, 9);
SHARED_UINT(kViewF0, 10);
SHARED_UINT(kViewF, 11);
SHARED_UINT(kViewSpecular, 12);
SHARED_UINT(kViewDiffuse, 13);
SHARED_UINT(kViewBrdf, 14);
SHARED_UINT(kViewIrradiance, 15);
SHARED_UINT(kViewPrefiltered, 16);
SHARED_UINT(kViewDfg, 17);

SHARED_END

#endif
