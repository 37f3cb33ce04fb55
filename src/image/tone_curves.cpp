#include "image/tone_curves.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace torrance {
namespace {

// The float curves are those of the double ones instantiated again: both are held against independent values by the
// tests, and GLSL, the second writing of each formula, against the double ones.
template <typename T>
using Color = glm::vec<3, T>;

template <typename T>
Color<T> admitted(Color<T> c)
{
    for (int i = 0; i < 3; ++i)
        c[i] = c[i] > T(0) ? std::min(c[i], T(kMaxToneInput)) : T(0); // a NaN compares false
    return c;
}

template <typename T>
T highest(const Color<T>& c)
{
    return std::max({c.x, c.y, c.z});
}

template <typename T>
Color<T> clipped(const Color<T>& c)
{
    return glm::clamp(c, Color<T>(T(0)), Color<T>(T(1)));
}

// A matrix written by rows, as the sources print it.
template <typename T>
Color<T> product(const double (&rows)[3][3], const Color<T>& c)
{
    Color<T> result;
    for (int i = 0; i < 3; ++i)
        result[i] = T(rows[i][0]) * c.x + T(rows[i][1]) * c.y + T(rows[i][2]) * c.z;
    return result;
}

template <typename T>
Color<T> reinhard(const Color<T>& color)
{
    const Color<T> c = admitted(color);
    return c / (c + T(1));
}

template <typename T>
T constant(double value)
{
    return T{} + static_cast<std::conditional_t<std::is_same_v<T, double>, double, float>>(value);
}

template <typename T>
T admittedChannel(T c)
{
    return c > T{} ? least(c, constant<T>(kMaxToneInput)) : T{}; // a NaN compares false
}

// The specification's names: F90 = 0.04 is removed (it is what a dielectric reflects at normal incidence), so that base
// colours come out as they were put in; above Ks the peak is compressed towards 1 and Kd desaturates what was
// compressed. For one colour or, T being Float4, for four: of these each keeps or compresses for itself.
template <typename T>
void khronosNeutral(T& red, T& green, T& blue)
{
    const T one = constant<T>(1), two = constant<T>(2), four = constant<T>(4);
    const T kF90 = constant<T>(0.04), kKs = constant<T>(0.8) - kF90, kKd = constant<T>(0.15);
    T channels[] = {admittedChannel(red), admittedChannel(green), admittedChannel(blue)};
    const T x = least(least(channels[0], channels[1]), channels[2]);
    const T offset = x <= two * kF90 ? x - x * x / (four * kF90) : kF90;
    for (T& c : channels)
        c = c - offset;
    const T peak = greatest(greatest(channels[0], channels[1]), channels[2]);
    if (!all(peak <= kKs)) {
        const T compressed = one - (one - kKs) * (one - kKs) / (peak + one - two * kKs);
        const T keep = one / (kKd * (peak - compressed) + one);
        for (T& c : channels)
            c = peak <= kKs ? c : c * (compressed / peak) * keep + compressed * (one - keep);
    }
    red = channels[0];
    green = channels[1];
    blue = channels[2];
}

template <typename T>
Color<T> khronosNeutral(Color<T> color)
{
    khronosNeutral(color.x, color.y, color.z);
    return color;
}

void noneOfFour(Float4& red, Float4& green, Float4& blue)
{
    for (Float4* c : {&red, &green, &blue})
        *c = admittedChannel(*c);
}

/// The curves that few pictures are shown by: colour for colour.
template <vec3 (*kSingle)(const vec3&)>
void oneByOne(Float4& red, Float4& green, Float4& blue)
{
    for (int i = 0; i < 4; ++i) {
        const vec3 toned = kSingle({red[i], green[i], blue[i]});
        red[i] = toned.x;
        green[i] = toned.y;
        blue[i] = toned.z;
    }
}

template <typename T>
Color<T> acesHill(const Color<T>& color)
{
    static constexpr double kInput[3][3] = {
        {0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}};
    static constexpr double kOutput[3][3] = {
        {1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605}, {-0.00327, -0.07276, 1.07602}};
    const Color<T> v = product(kInput, admitted(color));
    const Color<T> above = v * (v + T(0.0245786)) - T(0.000090537);
    const Color<T> below = v * (T(0.983729) * v + T(0.4329510)) + T(0.238081);
    return clipped(product(kOutput, above / below));
}

template <typename T>
Color<T> acesNarkowicz(const Color<T>& color)
{
    const Color<T> c = admitted(color);
    const Color<T> above = c * (c * T(2.51) + T(0.03));
    const Color<T> below = c * (c * T(2.43) + T(0.59)) + T(0.14);
    return clipped(above / below);
}

template <typename T>
T agxContrast(T x)
{
    constexpr double kCoefficients[] = {15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.00232};
    T sum = 0;
    for (const double coefficient : kCoefficients)
        sum = sum * x + T(coefficient);
    return sum;
}

template <typename T>
Color<T> agx(const Color<T>& color)
{
    static constexpr double kInset[3][3] = {{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                                            {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                                            {0.0423756549057051, 0.0784336, 0.879142973793104}};
    static constexpr double kOutset[3][3] = {{1.19687900512017, -0.0980208811401368, -0.0990297440797205},
                                             {-0.0528968517574562, 1.15190312990417, -0.0989611768448433},
                                             {-0.0529716355144438, -0.0980434501171241, 1.15107367264116}};
    constexpr T kMinExposure = T(-12.47393), kMaxExposure = T(4.026069);
    Color<T> c = product(kInset, admitted(color));
    for (int i = 0; i < 3; ++i) {
        const T stops = std::clamp(std::log2(c[i]), kMinExposure, kMaxExposure); // log2(0) is -Inf
        c[i] = agxContrast((stops - kMinExposure) / (kMaxExposure - kMinExposure));
    }
    c = clipped(product(kOutset, c)); // the polynomial is -0.00232 at its lower end
    for (int i = 0; i < 3; ++i)
        c[i] = std::pow(c[i], T(2.2));
    return c;
}

} // namespace

dvec3 tone_none(const dvec3& color)
{
    return admitted(color);
}

vec3 tone_none(const vec3& color)
{
    return admitted(color);
}

dvec3 tone_reinhard(const dvec3& color)
{
    return reinhard(color);
}

vec3 tone_reinhard(const vec3& color)
{
    return reinhard(color);
}

dvec3 tone_khronos_neutral(const dvec3& color)
{
    return khronosNeutral(color);
}

vec3 tone_khronos_neutral(const vec3& color)
{
    return khronosNeutral(color);
}

dvec3 tone_aces_hill(const dvec3& color)
{
    return acesHill(color);
}

vec3 tone_aces_hill(const vec3& color)
{
    return acesHill(color);
}

dvec3 tone_aces_narkowicz(const dvec3& color)
{
    return acesNarkowicz(color);
}

vec3 tone_aces_narkowicz(const vec3& color)
{
    return acesNarkowicz(color);
}

dvec3 tone_agx(const dvec3& color)
{
    return agx(color);
}

vec3 tone_agx(const vec3& color)
{
    return agx(color);
}

std::span<const ToneCurve> allToneCurves()
{
    static constexpr ToneCurve kCurves[] = {
        {"khronos_neutral", tone_khronos_neutral, tone_khronos_neutral, khronosNeutral<Float4>},
        {"aces_hill", tone_aces_hill, tone_aces_hill, oneByOne<tone_aces_hill>},
        {"aces_narkowicz", tone_aces_narkowicz, tone_aces_narkowicz, oneByOne<tone_aces_narkowicz>},
        {"agx", tone_agx, tone_agx, oneByOne<tone_agx>},
        {"reinhard", tone_reinhard, tone_reinhard, oneByOne<tone_reinhard>},
        {"none", tone_none, tone_none, noneOfFour},
    };
    return kCurves;
}

const ToneCurve* findToneCurve(std::string_view id)
{
    for (const ToneCurve& curve : allToneCurves())
        if (curve.id == id)
            return &curve;
    return nullptr;
}

} // namespace torrance
