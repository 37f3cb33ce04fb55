#include "passes/probe_row.h"

#include <cassert>

namespace torrance {
namespace {

class Row
{
public:
    void add(double scalar) { scalars[count++] = scalar; }
    void add(const dvec3& vector)
    {
        for (int i = 0; i < 3; ++i)
            add(vector[i]);
    }
    std::array<double, kProbeScalars> all() const
    {
        assert(count == scalars.size()); // a member of ProbeRow is missing below
        return scalars;
    }

private:
    std::array<double, kProbeScalars> scalars = {};
    std::size_t count = 0;
};

} // namespace

std::array<double, kProbeScalars> probeScalars(const brdf::ShadingPoint& point)
{
    Row row;
    for (const dvec3& direction : {point.n, point.v, point.l})
        row.add(direction);
    for (const double scalar :
         {point.NoV, point.NoL, point.VoL, point.NoH, point.VoH, point.oneLessVoH, point.sin2H, point.ToH, point.BoH,
          point.perceptualRoughness, point.alpha, point.alphaT, point.alphaB})
        row.add(scalar);
    row.add(point.f0);
    row.add(point.f90);
    row.add(point.ior);
    for (const dvec3& color : {point.eta, point.k, point.f82, point.baseColor})
        row.add(color);
    for (const double scalar : {point.metallic, point.E, point.bias, point.ELight, point.EAverage})
        row.add(scalar);
    for (const dvec3& color : {point.single, point.spread, point.F, point.FNoV, point.FNoL, point.lobeAlbedo})
        row.add(color);
    return row.all();
}

} // namespace torrance
