#include "brdf/method.h"

#include "brdf/diffuse.h"
#include "brdf/distribution.h"
#include "brdf/fresnel.h"
#include "brdf/multiple_scattering.h"
#include "brdf/visibility.h"

#include <algorithm>

namespace torrance::brdf {
namespace {

struct SlotNames
{
    Slot slot;
    std::string_view name;
    std::string_view prefix;
    bool shadingFunction;
};

constexpr SlotNames kSlotNames[] = {
    {Slot::distribution, "distribution", "D", true},
    {Slot::visibility, "visibility", "V", true},
    {Slot::fresnel, "fresnel", "F", true},
    {Slot::diffuse, "diffuse", "Fd", true},
    {Slot::multipleScattering, "multiple_scattering", "M", true},
    {Slot::environmentDiffuse, "environment_diffuse", "Ed", false},
    {Slot::environmentSpecular, "environment_specular", "Es", false},
    {Slot::dfg, "dfg", "DFG", false},
    {Slot::tone, "tone", "tone", false},
    {Slot::transfer, "transfer", "transfer", false},
};

constexpr Slot kSlots[] = {
    Slot::distribution,       Slot::visibility,          Slot::fresnel, Slot::diffuse, Slot::multipleScattering,
    Slot::environmentDiffuse, Slot::environmentSpecular, Slot::dfg,     Slot::tone,    Slot::transfer,
};

constexpr Method kMethods[] = {
    {.slot = Slot::distribution,
     .id = "ggx",
     .citation = "Trowbridge & Reitz 1975; Walter et al. 2007, eq. 33",
     .approximates = "",
     .domain = "alpha >= 1e-4, NoH >= 0",
     .reciprocal = true,
     .formula = ScalarFormula(&D_ggx)},
    {.slot = Slot::distribution,
     .id = "ggx_textbook",
     .citation = "Walter et al. 2007, eq. 33, as transcribed in glTF 2.0, Appendix B",
     .approximates = "ggx; cancels near the mirror direction of smooth surfaces",
     .domain = "alpha >= 0.05 in 32 bits, NoH >= 0",
     .reciprocal = true,
     .formula = ScalarFormula(&D_ggx_textbook)},
    {.slot = Slot::distribution,
     .id = "beckmann",
     .citation = "Beckmann & Spizzichino 1963; Walter et al. 2007, eq. 25",
     .approximates = "",
     .domain = "alpha >= 1e-4, NoH >= 0",
     .reciprocal = true,
     .formula = ScalarFormula(&D_beckmann)},
    {.slot = Slot::distribution,
     .id = "blinn",
     .citation = "Blinn 1977; Walter et al. 2007, eq. 30, with alpha_p = 2/alpha^2 - 2",
     .approximates = "beckmann",
     .domain = "alpha >= 1e-4, NoH >= 0",
     .reciprocal = true,
     .formula = ScalarFormula(&D_blinn)},

    {.slot = Slot::visibility,
     .id = "smith_corr",
     .citation = "Heitz 2014, eqs. 72 and 99",
     .approximates = "",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_smith_corr)},
    {.slot = Slot::visibility,
     .id = "smith_uncorr",
     .citation = "Smith 1967; Walter et al. 2007, eqs. 23 and 34",
     .approximates = "smith_corr, with masking and shadowing independent",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_smith_uncorr)},
    {.slot = Slot::visibility,
     .id = "hammon",
     .citation = "Hammon 2017, approximate G2 / (4 NoL NoV) (slides without equation numbers)",
     .approximates = "smith_corr",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_hammon)},
    {.slot = Slot::visibility,
     .id = "schlick_half",
     .citation = "Schlick 1994, eq. 19, with k = alpha/2 (Karis 2013)",
     .approximates = "smith_uncorr",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_schlick_half)},
    {.slot = Slot::visibility,
     .id = "schlick_direct",
     .citation = "Karis 2013, eq. 4: k = (r + 1)^2/8",
     .approximates = "smith_uncorr, made darker by choice at low roughness",
     .domain = "punctual and area lights only",
     .reciprocal = true,
     .formula = ScalarFormula(&V_schlick_direct)},
    {.slot = Slot::visibility,
     .id = "vcavity",
     .citation = "Torrance & Sparrow 1967; Cook & Torrance 1982, G in section 3 (equations unnumbered)",
     .approximates = "",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_vcavity)},
    {.slot = Slot::visibility,
     .id = "kelemen",
     .citation = "Kelemen & Szirmay-Kalos 2001, section 2 (G / (NoV NoL) replaced by 1 / VoH^2)",
     .approximates = "vcavity",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_kelemen)},
    {.slot = Slot::visibility,
     .id = "neumann",
     .citation = "Neumann, Neumann & Szirmay-Kalos 1999, denominator max(NoL, NoV)",
     .approximates = "vcavity",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_neumann)},
    {.slot = Slot::visibility,
     .id = "implicit",
     .citation = "Hoffman 2013, Background: Physics and Math of Shading, the implicit geometry term G = NoL NoV",
     .approximates = "vcavity",
     .domain = "all",
     .reciprocal = true,
     .formula = ScalarFormula(&V_implicit)},

    {.slot = Slot::fresnel,
     .id = "schlick",
     .citation = "Schlick 1994, eq. 15",
     .approximates = "exact_dielectric, exact_conductor",
     .domain = "ior >= 1",
     .reciprocal = true,
     .formula = ColorFormula(&F_schlick)},
    {.slot = Slot::fresnel,
     .id = "exact_dielectric",
     .citation = "Fresnel 1823; Born & Wolf, section 1.5.2; Walter et al. 2007, eq. 22",
     .approximates = "",
     .domain = "ior >= 0, where 0 means infinite",
     .reciprocal = true,
     .formula = ColorFormula(&F_exact_dielectric)},
    {.slot = Slot::fresnel,
     .id = "exact_conductor",
     .citation = "Fresnel 1823; Born & Wolf, section 14.2",
     .approximates = "",
     .domain = "eta > 0, k >= 0",
     .reciprocal = true,
     .formula = ColorFormula(&F_exact_conductor)},

    {.slot = Slot::diffuse,
     .id = "lambert",
     .citation = "Lambert 1760; glTF 2.0, Appendix B, diffuse_brdf",
     .approximates = "",
     .domain = "all",
     .reciprocal = true,
     .formula = ColorFormula(&Fd_lambert)},
    {.slot = Slot::diffuse,
     .id = "burley",
     .citation = "Burley 2012, section 5.3",
     .approximates = "",
     .domain = "all; returns more than it receives at grazing view and high roughness",
     .reciprocal = true,
     .formula = ColorFormula(&Fd_burley)},
    {.slot = Slot::diffuse,
     .id = "eon",
     .citation = "Portsmouth, Kutz & Hill 2025, section 3, exact albedo",
     .approximates = "",
     .domain = "all",
     .reciprocal = true,
     .formula = ColorFormula(&Fd_eon)},
    {.slot = Slot::diffuse,
     .id = "eon_approx",
     .citation = "Portsmouth, Kutz & Hill 2025, section 3, quartic fit of the albedo",
     .approximates = "eon",
     .domain = "all",
     .reciprocal = true,
     .formula = ColorFormula(&Fd_eon_approx)},

    {.slot = Slot::multipleScattering,
     .id = "none",
     .citation = "glTF 2.0, Appendix B: light that meets a second microfacet is lost",
     .approximates = "scale",
     .domain = "all",
     .reciprocal = true,
     .formula = ColorFormula(&M_none)},
    {.slot = Slot::multipleScattering,
     .id = "scale",
     .citation = "Turquin 2019, eq. 16",
     .approximates = "a random walk between microfacets",
     .domain = "E of the lobe's own D and V",
     .reciprocal = false, // E is taken at NoV alone
     .formula = ColorFormula(&M_scale)},

    {.slot = Slot::environmentDiffuse,
     .id = "irradiance_cube",
     .citation = "Lambert's integral of the environment, per direction of a cube map",
     .approximates = "",
     .domain = "distant environments",
     .reciprocal = false,
     .formula = NoFormula{}},
    {.slot = Slot::environmentDiffuse,
     .id = "sh9",
     .citation = "Ramamoorthi & Hanrahan 2001, eq. 13",
     .approximates = "irradiance_cube",
     .domain = "distant environments",
     .reciprocal = false,
     .formula = NoFormula{}},
    {.slot = Slot::environmentSpecular,
     .id = "split_sum",
     .citation = "Karis 2013, eq. 7",
     .approximates = "the integral of BRDF and environment",
     .domain = "distant environments; N = V = R",
     .reciprocal = false,
     .formula = NoFormula{}},
    {.slot = Slot::dfg,
     .id = "table",
     .citation = "Karis 2013, eq. 8",
     .approximates = "the integrals of albedo.h, between the table's nodes",
     .domain = "alpha >= 1e-4, NoV > 0",
     .reciprocal = false,
     .formula = NoFormula{}},
};

} // namespace

std::string_view slotName(Slot slot)
{
    return kSlotNames[static_cast<int>(slot)].name;
}

std::string_view slotPrefix(Slot slot)
{
    return kSlotNames[static_cast<int>(slot)].prefix;
}

bool hasShadingFunction(Slot slot)
{
    return kSlotNames[static_cast<int>(slot)].shadingFunction;
}

std::span<const Slot> allSlots()
{
    return kSlots;
}

std::optional<Slot> findSlot(std::string_view name)
{
    const auto* found = std::ranges::find(kSlotNames, name, &SlotNames::name);
    return found == std::end(kSlotNames) ? std::nullopt : std::optional(found->slot);
}

std::span<const Method> allMethods()
{
    return kMethods;
}

const Method* findMethod(Slot slot, std::string_view id)
{
    const auto* found =
        std::ranges::find_if(kMethods, [&](const Method& method) { return method.slot == slot && method.id == id; });
    return found == std::end(kMethods) ? nullptr : found;
}

} // namespace torrance::brdf
