// tinygltf's implementation, compiled here and not taken from the system's library, so that sanitizers see it and so
// that it comes without image decoders and without access to files.
#include <fstream>
#include <nlohmann/json.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define TINYGLTF_IMPLEMENTATION
#include "files/gltf_model.h"
#pragma GCC diagnostic pop
