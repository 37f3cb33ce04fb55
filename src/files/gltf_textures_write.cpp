#include "files/gltf_textures_write.h"

#include "core/error.h"
#include "files/gltf_extensions_used.h"
#include "files/gltf_uri_write.h"
#include "files/read_file.h"
#include "files/texture_file.h"

#include <algorithm>

namespace torrance {
namespace {

constexpr const char* kWebp = "image/webp";
constexpr const char* kWebpExtension = "EXT_texture_webp";

// glTF 2.0, 5.26: OpenGL's numbers.
constexpr int kRepeat = 10497;
constexpr int kNearest = 9728;
constexpr int kLinear = 9729;
constexpr int kTrilinear = 9987;

int numberOf(Wrap wrap)
{
    return wrap == Wrap::repeat ? kRepeat : wrap == Wrap::mirroredRepeat ? 33648 : 33071;
}

int numberOf(Filter filter)
{
    return filter == Filter::nearest ? kNearest : kLinear;
}

int minFilterOf(const Sampler& sampler)
{
    if (sampler.mip == MipFilter::none)
        return numberOf(sampler.minify);
    return 9984 + (sampler.minify == Filter::linear ? 1 : 0) + (sampler.mip == MipFilter::linear ? 2 : 0);
}

OrderedJson samplerJson(const Sampler& sampler)
{
    return {{"magFilter", numberOf(sampler.magnify)},
            {"minFilter", minFilterOf(sampler)},
            {"wrapS", numberOf(sampler.wrapS)},
            {"wrapT", numberOf(sampler.wrapT)}};
}

bool isSame(const OrderedJson& a, const OrderedJson& wanted)
{
    return a.value("magFilter", kLinear) == wanted["magFilter"] &&
           a.value("minFilter", kTrilinear) == wanted["minFilter"] && a.value("wrapS", kRepeat) == wanted["wrapS"] &&
           a.value("wrapT", kRepeat) == wanted["wrapT"];
}

/// One that the document has, or a new one.
std::size_t samplerNumber(OrderedJson& document, const Sampler& sampler)
{
    const OrderedJson wanted = samplerJson(sampler);
    OrderedJson& samplers = arrayOf(document, "samplers");
    for (std::size_t i = 0; i < samplers.size(); ++i)
        if (isSame(samplers[i], wanted))
            return i;
    samplers.push_back(wanted);
    return samplers.size() - 1;
}

OrderedJson imageJson(GltfDraft& draft, const std::filesystem::path& picture, const std::filesystem::path& folder)
{
    const std::vector<std::byte> bytes = readFile(picture, picture.string(), "");
    const std::string mimeType = textureMimeType(bytes);
    if (mimeType.empty())
        throw inputError(picture.string(), "", "is no picture that glTF takes", "use PNG, JPEG or WebP");
    OrderedJson image = {{"name", picture.stem().string()}};
    if (draft.isBinary) {
        image.update(embeddedImage(draft, bytes, mimeType));
        return image;
    }
    image["uri"] = relativeUri(picture, folder);
    image["mimeType"] = mimeType;
    return image;
}

/// WebP by its type, or because a texture of the file says so.
bool isWebp(const OrderedJson& document, int image)
{
    if (document["images"][static_cast<std::size_t>(image)].value("mimeType", std::string()) == kWebp)
        return true;
    const OrderedJson::json_pointer source = OrderedJson::json_pointer("/extensions") / kWebpExtension / "source";
    const OrderedJson textures = document.value("textures", OrderedJson::array());
    return std::any_of(textures.begin(), textures.end(), [&](const OrderedJson& texture) {
        return texture.contains(source) && texture[source] == image;
    });
}

OrderedJson textureJson(OrderedJson& document, const Texture& texture, int image)
{
    OrderedJson json = OrderedJson::object();
    if (texture.sampler != Sampler{})
        json["sampler"] = samplerNumber(document, texture.sampler);
    if (!isWebp(document, image)) {
        json["source"] = image;
        return json;
    }
    json["extensions"][kWebpExtension]["source"] = image;
    requireExtension(document, kWebpExtension);
    return json;
}

} // namespace

void appendTextures(GltfDraft& draft, GltfNumbers& numbers, const Scene& edited,
                    const std::vector<std::filesystem::path>& pictures, const std::filesystem::path& folder)
{
    for (const std::filesystem::path& picture : pictures) {
        OrderedJson image = imageJson(draft, picture, folder);
        OrderedJson& images = arrayOf(draft.document, "images");
        numbers.images.push_back(static_cast<int>(images.size()));
        images.push_back(std::move(image));
    }
    for (std::size_t i = numbers.textures.size(); i < edited.textures.size(); ++i) {
        const Texture& texture = edited.textures[i];
        OrderedJson json =
            textureJson(draft.document, texture, numbers.images[static_cast<std::size_t>(texture.image)]);
        OrderedJson& textures = arrayOf(draft.document, "textures");
        numbers.textures.push_back(static_cast<int>(textures.size()));
        textures.push_back(std::move(json));
    }
}

} // namespace torrance
