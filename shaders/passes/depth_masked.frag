// The depth of a masked surface: where its alpha says that it is there.
#include "selected.glsl"
#include "passes/surface_inputs.glsl"

void main()
{
    if (baseColorOf(readTexels()).a < material.alphaCutoff)
        discard;
}
