// What a scene is, as a number: two scenes that differ anywhere have different hashes. The
// names of a scene and of its environment say where they came from, and are no part of it.
#pragma once

#include "core/content_hash.h"
#include "scene/scene.h"

namespace torrance {

void addToHash(ContentHasher& hasher, const Scene& scene);
void addToHash(ContentHasher& hasher, const Camera& camera);

} // namespace torrance
