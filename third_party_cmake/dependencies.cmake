# Every dependency, once: its least version and its Debian 12 packages. tools/packages.sh reads the packages from here, as
# the words that end a line after the mark "debian:".

# What builds it: a C++20 compiler (g++ 12) and CMake 3.25.
# debian: g++ cmake ninja-build ccache python3 git ca-certificates
find_package(PkgConfig REQUIRED)                              # debian: pkg-config
find_package(Threads REQUIRED)                                # before glslang, or its configuration fails

# The device. mesa-vulkan-drivers is lavapipe, for machines without a GPU and for the tests.
find_package(Vulkan 1.3.239 REQUIRED)                         # debian: libvulkan-dev mesa-vulkan-drivers vulkan-validationlayers
find_package(glslang 12 CONFIG REQUIRED)                      # debian: glslang-dev glslang-tools spirv-tools

# Numbers, text, command line
find_package(glm 0.9.9.8 CONFIG REQUIRED)                     # debian: libglm-dev
find_package(nlohmann_json 3.11 REQUIRED)                     # debian: nlohmann-json3-dev
find_package(fmt 9 REQUIRED)                                  # debian: libfmt-dev
find_package(CLI11 2.1 REQUIRED)                              # debian: libcli11-dev
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash>=0.8) # debian: libxxhash-dev

# Files
find_package(TinyGLTFHeader 2.7 REQUIRED)                     # debian: libtinygltf-dev
find_package(TinyObjLoaderHeader 2.0 REQUIRED)                # debian: libtinyobjloader-dev
find_package(ZLIB 1.2 REQUIRED)                               # debian: zlib1g-dev
find_package(PNG 1.6 REQUIRED)                                # debian: libpng-dev
pkg_check_modules(libdeflate REQUIRED IMPORTED_TARGET libdeflate>=1.14) # debian: libdeflate-dev
find_package(libjpeg-turbo 2.1 REQUIRED)                      # debian: libturbojpeg0-dev libjpeg62-turbo-dev
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)                          # its configuration notes a Python module that Debian packs apart
find_package(OpenEXR 3.1 CONFIG REQUIRED)                     # debian: libopenexr-dev
unset(CMAKE_MESSAGE_LOG_LEVEL)
pkg_check_modules(libwebp REQUIRED IMPORTED_TARGET libwebp>=1.2) # debian: libwebp-dev
# Optional, Debian package libopenimageio-dev: TIFF, TGA, PSD and the like for `compare` and environments. It brings 261 libraries.
find_package(OpenImageIO 2.4 CONFIG QUIET)

# Charts in HTML. Without it `torrance chart` writes SVG, CSV and JSON only.
find_path(VEGA_FOLDER vega-view.min.js PATHS /usr/share/javascript/vega) # debian: libjs-vega
mark_as_advanced(VEGA_FOLDER)

# Rays on the processor
find_package(embree 3.13 REQUIRED)                            # debian: libembree-dev libtbb-dev

# The window. Without them there is no `torrance view`; what draws pictures links neither.
find_package(glfw3 3.3 CONFIG QUIET)                          # debian: libglfw3-dev
pkg_check_modules(imgui QUIET IMPORTED_TARGET imgui>=1.86)    # debian: libimgui-dev

# Times of the kernels beside the frames'. Without it there is no bench_kernels, and tools/bench.sh leaves that part out.
find_package(benchmark 1.7 QUIET)                             # debian: libbenchmark-dev

if(TORRANCE_TESTS)
  find_package(GTest 1.12 REQUIRED)                           # debian: libgtest-dev
  find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)   # the checks of the tree itself
  # The window's tests need a virtual screen, and hands.     # debian: xvfb xdotool libx11-dev
endif()

# GLM with one set of switches everywhere: clip depth runs 0..1 as Vulkan has it.
add_library(torrance_glm INTERFACE)
target_link_libraries(torrance_glm INTERFACE glm::glm)
target_compile_definitions(torrance_glm INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_EXPLICIT_CTOR)
