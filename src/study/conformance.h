// Everything that can be said of a device by comparing what it draws with what the processor computes.
#pragma once

#include "passes/renderer.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace torrance {

struct ConformanceResult
{
    std::string name;
    double excess = 0.0; // error over what is allowed, at its worst; at most 1 passes
    std::string place;   // where that is, in a few words
    std::string worst;   // the same with all numbers
    std::string fault;   // what is wrong beside that; empty: nothing
    Image drawn, exact;  // RGBA, scene-linear; empty where the case is no picture
    Image difference;    // one channel: error over what is allowed

    bool passed() const { return fault.empty() && excess <= 1.0; }
};

struct ConformanceGroup
{
    std::string name;
    std::string expectation; // what must hold in every case, and how nearly
    std::vector<ConformanceResult> results;

    bool passed() const;
};

/// "methods", "brdf", "furnace", "shapes", "presets".
std::vector<std::string> conformanceGroupNames();

/// The named groups in the order of the list above, `done` after each. A case that the device or its compiler refuses
/// fails with the message; with validation on, so does one during which the layer had something to say.
std::vector<ConformanceGroup> runConformance(const gpu::Device& device, gpu::ShaderLibrary& shaders, Renderer& renderer,
                                             std::span<const std::string> names,
                                             const std::function<void(const ConformanceGroup&)>& done);

} // namespace torrance
