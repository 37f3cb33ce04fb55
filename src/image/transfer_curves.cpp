#include "image/transfer_curves.h"

#include "image/srgb.h"

#include <cmath>

namespace torrance {
namespace {

template <typename T>
T gamma22(T x)
{
    return x > T(0) ? std::pow(x, T(1.0 / 2.2)) : T(0); // a NaN compares false
}

template <typename T>
T unchanged(T x)
{
    return x > T(0) ? x : T(0);
}

} // namespace

dvec3 transfer_gamma22(const dvec3& linear)
{
    return {gamma22(linear.x), gamma22(linear.y), gamma22(linear.z)};
}

dvec3 transfer_linear(const dvec3& linear)
{
    return {unchanged(linear.x), unchanged(linear.y), unchanged(linear.z)};
}

std::span<const TransferCurve> allTransferCurves()
{
    static constexpr TransferCurve kCurves[] = {
        {"srgb", transfer_srgb, srgbEncode},
        {"gamma22", transfer_gamma22, gamma22<float>},
        {"linear", transfer_linear, unchanged<float>},
    };
    return kCurves;
}

const TransferCurve* findTransferCurve(std::string_view id)
{
    for (const TransferCurve& curve : allTransferCurves())
        if (curve.id == id)
            return &curve;
    return nullptr;
}

} // namespace torrance
