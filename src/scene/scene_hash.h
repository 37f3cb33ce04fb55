// What a scene is, as a number: two scenes that differ anywhere have different hashes.
#pragma once

#include "core/content_hash.h"
#include "scene/scene.h"

namespace torrance {

void addToHash(ContentHasher& hasher, const Scene& scene);
void addToHash(ContentHasher& hasher, const Camera& camera);

} // namespace torrance
