// How a picture is shown in a window.
#ifndef TORRANCE_SHARED_DISPLAY_H
#define TORRANCE_SHARED_DISPLAY_H

#include "shared/language.h"

SHARED_BEGIN

struct Display
{
    ivec2 origin; // of the picture's first pixel, in the window's
    float gain;   // shown = gain * drawn + shift, before the curves
    float shift;
};

SHARED_UINT(kCheckPixels, 8); // a side of the squares that are seen where nothing covers a pixel

SHARED_END

#endif
