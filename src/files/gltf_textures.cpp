#include "files/gltf_textures.h"

#include "core/cancelled.h"
#include "files/encoded_image.h"
#include "files/gltf_items.h"
#include "files/gltf_model.h"
#include "files/gltf_uri.h"
#include "files/read_file.h"
#include "files/texture_file.h"

namespace torrance {
namespace {

using nlohmann::json;

constexpr int kUndefined = -1; // tinygltf: the file says nothing

Wrap wrapOf(int value, const std::string& item, const LoadReport& report)
{
    switch (value) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
        return Wrap::repeat;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        return Wrap::mirroredRepeat;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        return Wrap::clampToEdge;
    default:
        report.fail(item, "has the unknown wrap mode " + std::to_string(value), "use 10497, 33071 or 33648");
    }
}

Filter magnifyOf(int value, const std::string& item, const LoadReport& report)
{
    if (value == TINYGLTF_TEXTURE_FILTER_NEAREST)
        return Filter::nearest;
    if (value == TINYGLTF_TEXTURE_FILTER_LINEAR || value == kUndefined)
        return Filter::linear;
    report.fail(item, "has the unknown magFilter " + std::to_string(value), "use 9728 or 9729");
}

void setMinify(Sampler& sampler, int value, const std::string& item, const LoadReport& report)
{
    struct Row
    {
        int value;
        Filter minify;
        MipFilter mip;
    };
    constexpr Row kRows[] = {
        {kUndefined, Filter::linear, MipFilter::linear},
        {TINYGLTF_TEXTURE_FILTER_NEAREST, Filter::nearest, MipFilter::none},
        {TINYGLTF_TEXTURE_FILTER_LINEAR, Filter::linear, MipFilter::none},
        {TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST, Filter::nearest, MipFilter::nearest},
        {TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST, Filter::linear, MipFilter::nearest},
        {TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR, Filter::nearest, MipFilter::linear},
        {TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR, Filter::linear, MipFilter::linear},
    };
    for (const Row& row : kRows)
        if (row.value == value) {
            sampler.minify = row.minify;
            sampler.mip = row.mip;
            return;
        }
    report.fail(item, "has the unknown minFilter " + std::to_string(value), "use 9728, 9729 or 9984 to 9987");
}

Sampler samplerOf(const tinygltf::Model& model, int index, const LoadReport& report)
{
    Sampler sampler;
    if (index < 0)
        return sampler;
    const tinygltf::Sampler& source = model.samplers[static_cast<std::size_t>(index)];
    const std::string item = itemName("samplers", static_cast<std::size_t>(index));
    sampler.wrapS = wrapOf(source.wrapS, item, report);
    sampler.wrapT = wrapOf(source.wrapT, item, report);
    sampler.magnify = magnifyOf(source.magFilter, item, report);
    setMinify(sampler, source.minFilter, item, report);
    return sampler;
}

int imageOf(const tinygltf::Texture& texture, const std::string& item, const LoadReport& report)
{
    const auto webp = texture.extensions.find("EXT_texture_webp");
    if (webp != texture.extensions.end() && webp->second.Has("source"))
        return webp->second.Get("source").GetNumberAsInt();
    if (texture.source < 0)
        report.fail(item, "has no image in a format that is supported", "use PNG, JPEG or WebP");
    return texture.source;
}

EncodedImage readImage(const json& image, std::size_t index, const GltfBuffers& buffers, const GltfOrigin& origin,
                       const LoadReport& report)
{
    EncodedImage encoded;
    encoded.file = report.file;
    const std::string item = itemName("images", index);
    const std::string name = image.value("name", std::string());
    encoded.name = name.empty() ? item : item + " (" + name + ")";
    if (const auto view = image.find("bufferView"); view != image.end()) {
        encoded.bytes = buffers.views[view->get<std::size_t>()].bytes;
        return encoded;
    }
    const auto uri = image.find("uri");
    if (uri == image.end())
        report.fail(item, "has neither a bufferView nor a URI", kRepair);
    const auto& text = uri->get_ref<const std::string&>();
    if (auto data = dataOfUri(text, report.file, item))
        encoded.storage = std::move(*data);
    else {
        const auto path = pathOfUri(text, origin.folder, origin.allowExternal, report.file, item);
        encoded.name = item + " (" + path.string() + ")";
        encoded.storage = readFile(path, report.file, encoded.name);
    }
    encoded.bytes = encoded.storage;
    return encoded;
}

/// Where `known` is asked, `hashes` are those of the encoded bytes.
std::vector<TextureImage> decodeUnknown(std::vector<EncodedImage> encoded, const std::vector<ContentHash>& hashes,
                                        const KnownImages& known, const std::stop_token& stop)
{
    std::vector<TextureImage> images(encoded.size());
    std::vector<EncodedImage> unknown;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        if (const auto image = known ? known(hashes[i]) : std::nullopt) {
            images[i] = {encoded[i].name, image->width, image->height, image->format, {}};
            continue;
        }
        unknown.push_back(std::move(encoded[i]));
        places.push_back(i);
    }
    std::vector<TextureImage> decoded = decodeAll(unknown, stop);
    for (std::size_t i = 0; i < places.size(); ++i)
        images[places[i]] = std::move(decoded[i]);
    return images;
}

} // namespace

GltfTextures readTextures(const tinygltf::Model& model, const json& document, const GltfBuffers& buffers,
                          const GltfOrigin& origin, const std::set<int>& used, std::uint64_t maxTexelBytes,
                          const std::stop_token& stop, const KnownImages& known, const LoadReport& report)
{
    GltfTextures result;
    result.textureOfFile.assign(model.textures.size(), -1);
    const json& images = itemsOf(document, "images");
    std::vector<int> imageOfFile(images.size(), -1);
    std::vector<EncodedImage> encoded;
    std::uint64_t encodedBytes = 0;
    for (const int index : used) {
        const tinygltf::Texture& source = model.textures[static_cast<std::size_t>(index)];
        const auto image =
            static_cast<std::size_t>(imageOf(source, itemName("textures", static_cast<std::size_t>(index)), report));
        if (imageOfFile[image] < 0) {
            endWhereStopped(stop);
            imageOfFile[image] = static_cast<int>(encoded.size());
            result.fileImages.push_back(static_cast<int>(image));
            encoded.push_back(readImage(images[image], image, buffers, origin, report));
            encodedBytes += encoded.back().storage.size();
            if (encodedBytes > kMaxFileBytes)
                report.fail(encoded.back().name, "brings the images of the file to more than 4 GiB",
                            "use smaller images");
        }
        result.textureOfFile[static_cast<std::size_t>(index)] = static_cast<int>(result.textures.size());
        result.textures.push_back({imageOfFile[image], samplerOf(model, source.sampler, report)});
    }
    checkTotalSize(encoded, maxTexelBytes);
    if (known)
        for (const EncodedImage& image : encoded)
            result.encoded.push_back(hashBytes(image.bytes));
    result.images = decodeUnknown(std::move(encoded), result.encoded, known, stop);
    return result;
}

} // namespace torrance
