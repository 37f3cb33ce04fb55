// How four channels of a file become their fields of texel words: shaders/shared/texel_words.h.
#pragma once

#include "prepare/texel_codec.h"

namespace torrance {

/// Which four channels of texel words: base colour and metallic, normal and roughness, emission and occlusion.
enum class WordPart
{
    baseColor,
    normal,
    emissive,
};

/// For texels of 8 bits. Of a texture's parts the first to write a texel sets its words, and the others add their
/// fields. Means of scalars and normals are rounded to the fields' steps.
const TexelCodec& wordCodec(WordPart part, bool first);

} // namespace torrance
