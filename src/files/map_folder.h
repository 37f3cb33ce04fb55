// A folder of maps, as free texture libraries publish them, as one material.
#pragma once

#include "files/load_report.h"
#include "files/scene_file.h"

namespace torrance {

/// What the folder need not hold, because something else says it.
struct MapFolderNeeds
{
    bool color = true;
    bool roughness = true;
};

/// The material of the pictures in `folder` (PNG, JPEG, WebP; not in folders below it); its images and textures are
/// appended to the scene, its factors are 1 where there is a map. Roles are told by the last words of a name, the
/// resolution aside: ambientCG's NAME_1K-PNG_Color, _Roughness, _Metalness, _NormalGL, _NormalDX, _AmbientOcclusion,
/// _Opacity, _Emission; Poly Haven's NAME_diff_1k, _rough, _metal, _nor_gl, _nor_dx, _ao, _arm; plain albedo,
/// basecolor, roughness, metallic, normal, ... Without a map of metalness metallic is 0. A NormalDX has its green
/// turned round, where there is no NormalGL. Separate maps win over _arm. Displacement is left out with a warning.
/// Errors (input): no such folder, no map in it, no colour or roughness where needed, two pictures for one role,
/// pictures of different proportions, damaged or too large ones.
Material readMapFolder(const std::filesystem::path& folder, const MapFolderNeeds& needs, const SceneLimits& limits,
                       Scene& scene, LoadReport& report);

} // namespace torrance
