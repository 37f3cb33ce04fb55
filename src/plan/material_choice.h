// Cheaper methods for the materials of a picture that can do with them, out of what was measured on the way to the
// methods that all of them were found to be within a tolerance with.
#pragma once

#include "plan/light_methods.h"

#include <map>
#include <span>

namespace torrance {

/// By number of a material, as Settings::ofMaterials counts.
struct MaterialError
{
    double error = 0.0;  // of its pixels, sum |d - c|_1 over sum |c|_1 of the whole picture
    double pixels = 0.0; // share of the covered ones
};
using MaterialErrors = std::map<int, MaterialError>;

/// One picture, all of whose materials have these methods.
struct MaterialTrial
{
    LightMethods methods;
    double cost = 0.0; // ns a pixel
    MaterialErrors errors;
};

/// Less than this share of the frame's cost is not worth the pipelines of another choice.
inline constexpr double kLeastMaterialSaving = 0.05;

/// Materials that take the methods of another trial than `found`, so that the errors of all add up to `most` at most:
/// a surface is drawn alike whatever others are drawn with. Always that change next which saves most for the error that
/// it adds. Only materials of `free` change. Empty where nothing can be saved, or less than kLeastMaterialSaving.
std::map<int, LightMethods> cheaperMaterials(const MaterialTrial& found, std::span<const MaterialTrial> others,
                                             std::span<const int> free, double most);

} // namespace torrance
