// Materials known by name.
#include "scene/named_material.h"

#include "scene/material.h"
#include "scene/phong.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(NamedMaterial, ReflectsAtNormalIncidenceWhatItsTableSays)
{
    for (const NamedMaterial& named : namedMaterials()) {
        const Material material = materialOf(named);
        EXPECT_EQ(material.name, named.name);
        // glTF 2.0, Appendix B: F0 is the base colour of a metal, that of the index for a dielectric.
        const dvec3 f0 =
            material.metallicFactor == 1.0 ? dvec3(material.baseColorFactor) : dvec3(reflectanceOfIor(material.ior));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(f0[c], named.f0[c], 1e-15) << named.name;
    }
}

TEST(NamedMaterial, IndicesAreNearThoseOfTheSubstances)
{
    // Handbook values at 589 nm: water 1.333, diamond 2.417. The table's reflectances have one or two digits.
    EXPECT_NEAR(materialOf(*findNamedMaterial("water")).ior, 1.333, 0.01);
    EXPECT_NEAR(materialOf(*findNamedMaterial("diamond")).ior, 2.417, 0.02);
    EXPECT_NEAR(materialOf(*findNamedMaterial("plastic")).ior, 1.5, 1e-12);
    EXPECT_EQ(findNamedMaterial("gould"), nullptr);
}

} // namespace
} // namespace torrance
