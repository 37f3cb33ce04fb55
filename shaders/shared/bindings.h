// Binding numbers of the one descriptor set.
#ifndef TORRANCE_SHARED_BINDINGS_H
#define TORRANCE_SHARED_BINDINGS_H

#include "shared/language.h"

SHARED_BEGIN

SHARED_UINT(kBindFrame, 0);    // and the lights, behind it
SHARED_UINT(kBindInstance, 1); // of the analytic shape that is drawn
SHARED_UINT(kBindMaterial, 2); // of what is drawn
SHARED_UINT(kBindBaseColor, 4);
SHARED_UINT(kBindScalars, 5); // occlusion, roughness, metallic
SHARED_UINT(kBindNormal, 6);
SHARED_UINT(kBindOcclusion, 7);
SHARED_UINT(kBindEmissive, 8);
SHARED_UINT(kBindEnvironmentSpecular, 9);
SHARED_UINT(kBindEnvironmentDiffuse, 10);
SHARED_UINT(kBindDfg, 11);
SHARED_UINT(kBindPanorama, 12);
SHARED_UINT(kBindSource, 13); // the picture that an image pass reads
SHARED_UINT(kBindProbeRows, 14);
SHARED_UINT(kBindGBuffer, 15);             // the first of the four pictures of shaders/passes/gbuffer.frag
SHARED_UINT(kBindEnvironmentRadiance, 19); // with mips, for methods that draw samples

SHARED_UINT(kBindAttributes, 20); // the first of the two pictures of shaders/passes/attributes.frag
SHARED_UINT(kBindDepth, 22);
SHARED_UINT(kBindSampleDepth, 23);      // of four samples a pixel
SHARED_UINT(kBindLevel, 24);            // the texture whose level of detail is kept
SHARED_UINT(kBindEnvironmentLamps, 25); // with mips: what src/prepare/environment_lamps.h takes out of the radiance
SHARED_UINT(kBindTexelWords, 27);      // of all of a material's textures
SHARED_UINT(kBindBackground, 26);       // the chain whose level is seen behind the scene

SHARED_END

#endif
