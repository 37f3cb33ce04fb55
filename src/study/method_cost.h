// What a pixel costs with each method of a slot.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"
#include "plan/method_table.h"
#include "scene/scene.h"
#include "study/bench_frames.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace torrance {

/// A device and what is needed to draw with it.
struct TrialDevice
{
    const gpu::Device& device;
    gpu::ShaderLibrary& shaders;
    std::filesystem::path cacheFolder;

    BenchClock clock() const { return device.description.isProcessor() ? BenchClock::processor : BenchClock::wall; }
};

/// Pictures all covered by one surface, of half a metal under the light of the slot's trial, drawn with each of
/// `methods` in turn, the slot's reference method first of all; tone and transfer curves of such a picture on the
/// processor. The methods can be drawn and are of one slot. `checkpoint` is called before each frame and may throw.
std::vector<MethodCost> measureCosts(const TrialDevice& on, const std::vector<const brdf::Method*>& methods,
                                     const Environment& environment, const BenchBounds& bounds,
                                     const std::function<void()>& checkpoint);

} // namespace torrance
