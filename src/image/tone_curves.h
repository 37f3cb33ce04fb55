// Tone curves: scene-linear colour (linear Rec. 709, exposed) to display-linear. Rows of the method registry, slot
// `tone`.
#pragma once

#include "math/float4.h"
#include "math/vector.h"

#include <span>
#include <string_view>

namespace torrance {

/// What every curve does with an input that is no radiance: NaN and negative count as 0, and nothing counts for more
/// than kMaxToneInput, at which all curves but `none` have reached their limit in double (1/x is below half an ulp of
/// 1). It keeps squares finite in float and turns Inf into a number.
inline constexpr double kMaxToneInput = 0x1p60;

/// Identity: what lies above 1 is clipped when it is stored.
dvec3 tone_none(const dvec3& color);
vec3 tone_none(const vec3& color);

/// c / (1 + c) per channel. Reinhard et al., Photographic Tone Reproduction for Digital Images, 2002, eq. 3. In [0, 1].
dvec3 tone_reinhard(const dvec3& color);
vec3 tone_reinhard(const vec3& color);

/// Khronos PBR Neutral Tone Mapper, specification 1.0 (github.com/KhronosGroup/ToneMapping). In [0, 1].
dvec3 tone_khronos_neutral(const dvec3& color);
vec3 tone_khronos_neutral(const vec3& color);

/// Stephen Hill's fit of the ACES reference and output transforms (sRGB, D65, 100 nits), with both of its matrices and
/// no exposure of its own: BakingLab, ACES.hlsl, 2016. In [0, 1].
dvec3 tone_aces_hill(const dvec3& color);
vec3 tone_aces_hill(const vec3& color);

/// Krzysztof Narkowicz's rational fit of ACES per channel, without the 0.6 of exposure that his comparison puts before
/// it: ACES Filmic Tone Mapping Curve, 2015. In [0, 1].
dvec3 tone_aces_narkowicz(const dvec3& color);
vec3 tone_aces_narkowicz(const vec3& color);

/// Troy Sobotka's AgX, base look, in Benjamin Wrensch's minimal form (Minimal AgX Implementation, 2023): inset in Rec.
/// 709 primaries, log2 over [-12.47393, 4.026069], the polynomial of sixth order, outset, 2.2 power. In [0, 1].
dvec3 tone_agx(const dvec3& color);
vec3 tone_agx(const vec3& color);

/// A curve by the id of its registry row, in both precisions, and the float one for four colours at a time: the same
/// bits.
struct ToneCurve
{
    std::string_view id;
    dvec3 (*exact)(const dvec3&);
    vec3 (*single)(const vec3&);
    void (*four)(Float4& red, Float4& green, Float4& blue);
};

std::span<const ToneCurve> allToneCurves();
/// Null where the id is not known.
const ToneCurve* findToneCurve(std::string_view id);

} // namespace torrance
