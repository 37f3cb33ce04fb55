// What can be looked at by itself: one method of the registry, or the whole BRDF. In double here, in GLSL on the
// device.
#pragma once

#include "brdf/method.h"

#include <functional>
#include <string>
#include <string_view>

namespace torrance {

struct ProbeTerm
{
    std::function<dvec3(const brdf::ShadingPoint&)> formula; // scalars in all three channels
    std::string selected;                                    // text of selected.glsl for shaders/passes/probe.frag
    bool readsAlbedo = false;         // the device is given E, bias, ELight, EAverage of the point: setLobeAlbedo
    bool readsInterface = false;      // and what else setInterface sets (brdf/lobe_albedo.h)
    std::string_view table = "table"; // the row of slot dfg that is looked up
    bool readsTable = false;          // the device looks up the table of directional albedos
};

/// A method with a shading function (of a model: the whole BRDF), or the table of slot dfg (scale, bias, w). An Error
/// (usage) for a slot that is judged by image.
ProbeTerm makeProbeTerm(const brdf::Method& method);

/// The whole BRDF of a preset, without the cosine.
ProbeTerm makeBrdfTerm(const brdf::Preset& preset);

/// E, the directional albedo of the specular lobe with F = 1, looked up in the table.
ProbeTerm makeAlbedoTerm();

} // namespace torrance
