// A texel of all of a material's textures in four words of 32 bits, each a row of unsigned fields from the lowest bit on. Colours are the
// square roots of linear light; of normals, roughness, metallic and occlusion a file's codes of 8 bits lie here exactly, as multiples.
//   word 0: base colour r, base colour g, roughness
//   word 1: base colour b, emission r, emission b
//   word 2: normal x, normal y, metallic
//   word 3: normal z, emission g, occlusion
#ifndef TORRANCE_SHARED_TEXEL_WORDS_H
#define TORRANCE_SHARED_TEXEL_WORDS_H

#include "shared/language.h"

SHARED_BEGIN

// The greatest value of a field, which stands for 1, and the bits that it takes.
SHARED_UINT(kColorField, 2047);        // 11 bits
SHARED_UINT(kBlueField, 1023);         // 10 bits: blue of the emission
SHARED_UINT(kNormalField, 16 * 255);   // 12 bits
SHARED_UINT(kRoughnessField, 4 * 255); // 10 bits
SHARED_UINT(kMetallicField, 255);      // 8 bits
SHARED_UINT(kOcclusionField, 2 * 255); // 9 bits

SHARED_UINT(kColorBits, 11);
SHARED_UINT(kNormalBits, 12);
SHARED_UINT(kRoughnessShift, 2u * kColorBits);           // of word 0
SHARED_UINT(kBlueShift, 2u * kColorBits);                // of word 1
SHARED_UINT(kMetallicShift, 2u * kNormalBits);           // of word 2
SHARED_UINT(kGreenShift, kNormalBits);                   // of word 3: the emission's
SHARED_UINT(kOcclusionShift, kNormalBits + kColorBits); // of word 3

SHARED_END

#endif
