// Pictures in formats of which this program has no reader of its own: TIFF, TGA, PSD, ...
#pragma once

#include "files/image_read.h"

namespace torrance {

/// Opens the module torrance_openimageio on the first call: 0.2 to 0.5 s and 118 MiB, once. An Error (input) where the
/// file cannot be read, or where the module is not there (the program was built without OpenImageIO).
ReadImage readThroughOpenImageIo(const std::string& path);

} // namespace torrance
