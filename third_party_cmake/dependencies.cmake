# Every dependency, once: what it is for, its least version, its Debian 12 package (tools/packages.sh reads the package names from here).
#
#   torrance_needs(<CMake package> <version> <Debian package>...)
macro(torrance_needs NAME VERSION)
  find_package(${NAME} ${VERSION} REQUIRED)
endmacro()

find_package(PkgConfig REQUIRED)                            # debian: pkg-config
find_package(Threads REQUIRED)                              # before glslang, or its configuration fails

find_package(Vulkan 1.3.239 REQUIRED)                       # debian: libvulkan-dev mesa-vulkan-drivers vulkan-validationlayers
find_package(glslang CONFIG REQUIRED)                       # debian: glslang-dev glslang-tools spirv-tools
find_package(glm CONFIG REQUIRED)                           # debian: libglm-dev
find_package(nlohmann_json 3.11 REQUIRED)                   # debian: nlohmann-json3-dev
find_package(fmt 9 REQUIRED)                                # debian: libfmt-dev
find_package(CLI11 2.1 REQUIRED)                            # debian: libcli11-dev
find_package(PNG 1.6 REQUIRED)                              # debian: libpng-dev
find_package(libjpeg-turbo 2.1 REQUIRED)                    # debian: libturbojpeg0-dev libjpeg62-turbo-dev
find_package(OpenEXR 3.1 CONFIG REQUIRED)                   # debian: libopenexr-dev
find_package(embree 3.13 REQUIRED)                          # debian: libembree-dev libtbb-dev
pkg_check_modules(libwebp REQUIRED IMPORTED_TARGET libwebp) # debian: libwebp-dev
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash) # debian: libxxhash-dev
find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h REQUIRED)        # debian: libtinygltf-dev
if(TORRANCE_TESTS)
  find_package(GTest 1.12 REQUIRED)                         # debian: libgtest-dev
endif()

# GLM with one set of switches everywhere: clip depth runs 0..1 as Vulkan has it.
add_library(torrance_glm INTERFACE)
target_link_libraries(torrance_glm INTERFACE glm::glm)
target_compile_definitions(torrance_glm INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_EXPLICIT_CTOR)
