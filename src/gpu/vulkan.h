// The one place where Vulkan's C++ header is included and set up: designated initialisers, no constructors.
#pragma once

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>
