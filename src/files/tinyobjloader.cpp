// tinyobjloader's implementation, compiled here and not taken from the system's library, so that sanitizers see it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define TINYOBJLOADER_IMPLEMENTATION
#include "files/tinyobjloader.h"
#pragma GCC diagnostic pop
