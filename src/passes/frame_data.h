// Scene, plan and camera as the numbers that shaders read: double here, float there, relative to the eye.
#pragma once

#include "passes/mesh_buffers.h"
#include "plan/shading_plan.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/instance.h"
#include "shaders/shared/light.h"
#include "shaders/shared/material.h"

#include <span>
#include <vector>

namespace torrance {

/// The frame for a picture whose samples lie `offset` pixels from the pixels' centres. `environmentLevels` and
/// `panoramaWidth` are 0 where there is none.
shared::Frame makeFrame(const Scene& scene, const ShadingPlan& plan, const Camera& camera, const dvec2& offset,
                        int environmentLevels, int panoramaWidth);

std::vector<shared::Instance> makeInstances(const ShadingPlan& plan, const MeshBuffers& meshes, const dvec3& eye);
/// By ShadingPlan::blocks.
std::vector<shared::Material> makeMaterials(const ShadingPlan& plan, std::span<const int> finestLevels);
/// The plan's lights, and behind them the points of the environment's lamps, in the environment's axes.
std::vector<shared::Light> makeLights(const ShadingPlan& plan, std::span<const brdf::LampPoint> lamps,
                                      const dvec3& eye);

} // namespace torrance
