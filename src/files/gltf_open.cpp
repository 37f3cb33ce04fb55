#include "files/gltf_open.h"

#include "files/gltf_schema.h"
#include "files/gltf_version.h"
#include "files/json_read.h"
#include "files/read_file.h"

namespace torrance {

OpenedGltf openGltf(const std::filesystem::path& path, const std::string& file)
{
    OpenedGltf opened;
    opened.bytes = readFile(path, file, "");
    opened.container = splitContainer(opened.bytes, file);
    opened.document = readJson(opened.container.json, file);
    checkVersion(opened.document, file);
    checkSchema(opened.document, file);
    return opened;
}

} // namespace torrance
