// What a surface point does with light from one direction, by either yardstick.
#pragma once

#include "brdf/method.h"
#include "reference/physical_surface.h"

#include <variant>

namespace torrance {

/// The model that was asked for, integrated exactly; or `physics`.
using Yardstick = std::variant<const brdf::Preset*, const InterfaceAlbedo*>;

/// Which part of a BRDF counts: for telling what of a pixel's light comes by which way.
enum class ResponsePart
{
    whole,
    body, // diffuse
    lobe, // specular
};

/// Radiance per irradiance of a surface that faces the light, at a point whose normal is +Z. `view` is above the
/// surface, `key` chooses the random numbers where it takes some: an unbiased estimate of `physics`, exact otherwise.
class Reflectance
{
public:
    /// Parts are known of methods, not of `physics`, which counts whole.
    /// `albedosOfTable` as of brdf::ShadingPoint: for points that few directions are asked of.
    Reflectance(const Yardstick& yardstick, const MaterialPoint& material, const dvec3& view,
                ResponsePart part = ResponsePart::whole, bool albedosOfTable = false);

    dvec3 operator()(const dvec3& l, std::uint64_t key) const;

private:
    struct Model
    {
        const brdf::Preset* preset;
        dvec3 baseColor;
        double metallic;
        double perceptualRoughness;
        double ior;
    };
    static std::variant<Model, PhysicalSurface> make(const Yardstick& yardstick, const MaterialPoint& material);

    std::variant<Model, PhysicalSurface> surface;
    dvec3 view;
    ResponsePart part;
    bool albedosOfTable;
};

} // namespace torrance
