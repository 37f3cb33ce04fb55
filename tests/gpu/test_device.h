// The device that all tests of an executable share, with validation on.
#pragma once

#include "gpu/device.h"
#include "gpu/shader_library.h"

namespace torrance::test {

/// Made on first use: --device is taken from TORRANCE_TEST_DEVICE. Any validation message fails the test in which it
/// came.
gpu::Device& device();

/// The shaders of the source tree, without a cache on disk.
gpu::ShaderLibrary& shaders();

} // namespace torrance::test
