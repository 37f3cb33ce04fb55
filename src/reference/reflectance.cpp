#include "reference/reflectance.h"

#include "brdf/brdf.h"

namespace torrance {

Reflectance::Reflectance(const Yardstick& yardstick, const MaterialPoint& material, const dvec3& v, ResponsePart p,
                         bool ofTable)
    : surface(make(yardstick, material)), view(v), part(p), albedosOfTable(ofTable)
{
}

std::variant<Reflectance::Model, PhysicalSurface> Reflectance::make(const Yardstick& yardstick,
                                                                    const MaterialPoint& material)
{
    if (const auto* albedo = std::get_if<const InterfaceAlbedo*>(&yardstick))
        return PhysicalSurface(**albedo, material);
    return Model{std::get<const brdf::Preset*>(yardstick), material.baseColor, material.metallic,
                 material.perceptualRoughness, material.ior};
}

dvec3 Reflectance::operator()(const dvec3& l, std::uint64_t key) const
{
    if (const auto* physical = std::get_if<PhysicalSurface>(&surface)) {
        NumberStream numbers(key);
        return physical->response(view, l, numbers);
    }
    const Model& model = std::get<Model>(surface);
    brdf::ShadingPoint point = brdf::makeShadingPoint(dvec3(0, 0, 1), view, l, model.perceptualRoughness);
    point.baseColor = model.baseColor;
    point.metallic = model.metallic;
    point.ior = model.ior;
    point.albedosOfTable = albedosOfTable;
    const brdf::BrdfTerms terms = brdf::evaluateTerms(*model.preset, point);
    switch (part) {
    case ResponsePart::body:
        return terms.diffuse * terms.weight;
    case ResponsePart::lobe:
        return terms.specular * terms.weight;
    case ResponsePart::whole:
        break;
    }
    return terms.response();
}

} // namespace torrance
