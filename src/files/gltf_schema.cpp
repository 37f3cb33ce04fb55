#include "files/gltf_schema.h"

#include "core/error.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace torrance {
namespace {

using nlohmann::json;

enum class Kind
{
    boolean,
    text,
    texts,
    integer,    // 0 to kMaxInteger
    number,     // a finite double
    numbers,    // `least` to `most` of them
    reference,  // an index into `target`
    references, // an array of them
    attributes, // an object whose values are indices into `target`
    targets,    // an array of such objects
    object,     // of shape `shape`
    objects,    // an array of them
    extras,     // the same as an object; of another type, which glTF allows, it counts as empty
    map,        // kept unread: only its names count
};

struct Property;
using Shape = std::span<const Property>;

struct Property
{
    const char* name;
    Kind kind;
    bool required = false;
    const char* target = nullptr;
    Shape shape = {};
    std::size_t least = 0;
    std::size_t most = std::numeric_limits<std::size_t>::max();
};

constexpr bool kRequired = true;
constexpr bool kOptional = false;

/// Exactly representable in a double, and far from overflow in sums and products with small factors.
constexpr double kMaxInteger = 9007199254740992.0; // 2^53

constexpr Property numbersOf(const char* name, std::size_t count)
{
    return {name, Kind::numbers, kOptional, nullptr, {}, count, count};
}

constexpr Property objectOf(const char* name, Shape shape, bool required = kOptional)
{
    return {name, Kind::object, required, nullptr, shape};
}

constexpr Property objectsOf(const char* name, Shape shape, bool required = kOptional)
{
    return {name, Kind::objects, required, nullptr, shape};
}

constexpr const char* kLights = "/extensions/KHR_lights_punctual/lights";

// From the leaves up; glTF 2.0, appendix "JSON Schema Reference", and the schemas of the extensions.
constexpr Property kAsset[] = {{"version", Kind::text, kRequired},
                               {"minVersion", Kind::text},
                               {"generator", Kind::text},
                               {"copyright", Kind::text}};

constexpr Property kBuffer[] = {
    {"uri", Kind::text}, {"byteLength", Kind::integer, kRequired}, {"name", Kind::text}, {"extensions", Kind::map}};

constexpr Property kBufferView[] = {{"buffer", Kind::reference, kRequired, "/buffers"},
                                    {"byteOffset", Kind::integer},
                                    {"byteLength", Kind::integer, kRequired},
                                    {"byteStride", Kind::integer},
                                    {"name", Kind::text}};

constexpr Property kSparseIndices[] = {{"bufferView", Kind::reference, kRequired, "/bufferViews"},
                                       {"byteOffset", Kind::integer},
                                       {"componentType", Kind::integer, kRequired}};
constexpr Property kSparseValues[] = {{"bufferView", Kind::reference, kRequired, "/bufferViews"},
                                      {"byteOffset", Kind::integer}};
constexpr Property kSparse[] = {{"count", Kind::integer, kRequired},
                                objectOf("indices", kSparseIndices, kRequired),
                                objectOf("values", kSparseValues, kRequired)};
constexpr Property kAccessor[] = {{"bufferView", Kind::reference, kOptional, "/bufferViews"},
                                  {"byteOffset", Kind::integer},
                                  {"componentType", Kind::integer, kRequired},
                                  {"normalized", Kind::boolean},
                                  {"count", Kind::integer, kRequired},
                                  {"type", Kind::text, kRequired},
                                  objectOf("sparse", kSparse),
                                  {"name", Kind::text}};

constexpr Property kImage[] = {{"uri", Kind::text},
                               {"mimeType", Kind::text},
                               {"bufferView", Kind::reference, kOptional, "/bufferViews"},
                               {"name", Kind::text}};
constexpr Property kSampler[] = {{"magFilter", Kind::integer},
                                 {"minFilter", Kind::integer},
                                 {"wrapS", Kind::integer},
                                 {"wrapT", Kind::integer},
                                 {"name", Kind::text}};
constexpr Property kWebp[] = {{"source", Kind::reference, kOptional, "/images"}};
constexpr Property kTextureExtensions[] = {objectOf("EXT_texture_webp", kWebp)};
constexpr Property kTexture[] = {{"sampler", Kind::reference, kOptional, "/samplers"},
                                 {"source", Kind::reference, kOptional, "/images"},
                                 {"name", Kind::text},
                                 objectOf("extensions", kTextureExtensions)};

constexpr Property kTransform[] = {
    numbersOf("offset", 2), {"rotation", Kind::number}, numbersOf("scale", 2), {"texCoord", Kind::integer}};
constexpr Property kTextureInfoExtensions[] = {objectOf("KHR_texture_transform", kTransform)};
constexpr Property kTextureInfo[] = {{"index", Kind::reference, kRequired, "/textures"},
                                     {"texCoord", Kind::integer},
                                     {"scale", Kind::number},    // of a normal map
                                     {"strength", Kind::number}, // of an occlusion map
                                     objectOf("extensions", kTextureInfoExtensions)};
constexpr Property kMetallicRoughness[] = {numbersOf("baseColorFactor", 4),
                                           objectOf("baseColorTexture", kTextureInfo),
                                           {"metallicFactor", Kind::number},
                                           {"roughnessFactor", Kind::number},
                                           objectOf("metallicRoughnessTexture", kTextureInfo)};
constexpr Property kEmissiveStrength[] = {{"emissiveStrength", Kind::number}};
constexpr Property kIor[] = {{"ior", Kind::number}};
constexpr Property kMaterialExtensions[] = {objectOf("KHR_materials_unlit", {}),
                                            objectOf("KHR_materials_emissive_strength", kEmissiveStrength),
                                            objectOf("KHR_materials_ior", kIor)};
constexpr Property kMaterial[] = {{"name", Kind::text},
                                  objectOf("pbrMetallicRoughness", kMetallicRoughness),
                                  objectOf("normalTexture", kTextureInfo),
                                  objectOf("occlusionTexture", kTextureInfo),
                                  objectOf("emissiveTexture", kTextureInfo),
                                  numbersOf("emissiveFactor", 3),
                                  {"alphaMode", Kind::text},
                                  {"alphaCutoff", Kind::number},
                                  {"doubleSided", Kind::boolean},
                                  objectOf("extensions", kMaterialExtensions)};

constexpr Property kPrimitive[] = {{"attributes", Kind::attributes, kRequired, "/accessors"},
                                   {"indices", Kind::reference, kOptional, "/accessors"},
                                   {"material", Kind::reference, kOptional, "/materials"},
                                   {"mode", Kind::integer},
                                   {"targets", Kind::targets, kOptional, "/accessors"}};
constexpr Property kMesh[] = {
    {"name", Kind::text}, objectsOf("primitives", kPrimitive, kRequired), {"weights", Kind::numbers}};

constexpr Property kPerspective[] = {{"aspectRatio", Kind::number},
                                     {"yfov", Kind::number, kRequired},
                                     {"zfar", Kind::number},
                                     {"znear", Kind::number, kRequired}};
constexpr Property kOrthographic[] = {{"xmag", Kind::number, kRequired},
                                      {"ymag", Kind::number, kRequired},
                                      {"zfar", Kind::number, kRequired},
                                      {"znear", Kind::number, kRequired}};
constexpr Property kCamera[] = {{"name", Kind::text},
                                {"type", Kind::text, kRequired},
                                objectOf("perspective", kPerspective),
                                objectOf("orthographic", kOrthographic)};

constexpr Property kSkin[] = {{"name", Kind::text},
                              {"inverseBindMatrices", Kind::reference, kOptional, "/accessors"},
                              {"skeleton", Kind::reference, kOptional, "/nodes"},
                              {"joints", Kind::references, kRequired, "/nodes"}};

constexpr Property kNodeLight[] = {{"light", Kind::reference, kRequired, kLights}};
constexpr Property kNodeInstancing[] = {{"attributes", Kind::attributes, kRequired, "/accessors"}};
constexpr Property kNodeExtensions[] = {objectOf("KHR_lights_punctual", kNodeLight),
                                        objectOf("EXT_mesh_gpu_instancing", kNodeInstancing)};
constexpr Property kNode[] = {{"name", Kind::text},
                              {"camera", Kind::reference, kOptional, "/cameras"},
                              {"children", Kind::references, kOptional, "/nodes"},
                              {"skin", Kind::reference, kOptional, "/skins"},
                              {"mesh", Kind::reference, kOptional, "/meshes"},
                              numbersOf("matrix", 16),
                              numbersOf("rotation", 4),
                              numbersOf("scale", 3),
                              numbersOf("translation", 3),
                              {"weights", Kind::numbers},
                              objectOf("extensions", kNodeExtensions)};
constexpr Property kScene[] = {{"name", Kind::text}, {"nodes", Kind::references, kOptional, "/nodes"}};

constexpr Property kSpot[] = {{"innerConeAngle", Kind::number}, {"outerConeAngle", Kind::number}};
constexpr Property kLightExtras[] = {{"radius", Kind::number}};
constexpr Property kLight[] = {{"name", Kind::text},
                               {"type", Kind::text, kRequired},
                               numbersOf("color", 3),
                               {"intensity", Kind::number},
                               {"range", Kind::number},
                               objectOf("spot", kSpot),
                               {"extras", Kind::extras, kOptional, nullptr, kLightExtras}};
constexpr Property kPunctual[] = {objectsOf("lights", kLight)};
constexpr Property kRootExtensions[] = {objectOf("KHR_lights_punctual", kPunctual)};
constexpr Property kAnimation[] = {{"name", Kind::text}};

constexpr Property kRoot[] = {objectOf("asset", kAsset, kRequired),
                              {"extensionsUsed", Kind::texts},
                              {"extensionsRequired", Kind::texts},
                              {"scene", Kind::reference, kOptional, "/scenes"},
                              objectsOf("accessors", kAccessor),
                              objectsOf("animations", kAnimation),
                              objectsOf("buffers", kBuffer),
                              objectsOf("bufferViews", kBufferView),
                              objectsOf("cameras", kCamera),
                              objectsOf("images", kImage),
                              objectsOf("materials", kMaterial),
                              objectsOf("meshes", kMesh),
                              objectsOf("nodes", kNode),
                              objectsOf("samplers", kSampler),
                              objectsOf("scenes", kScene),
                              objectsOf("skins", kSkin),
                              objectsOf("textures", kTexture),
                              objectOf("extensions", kRootExtensions)};

class Checker
{
public:
    Checker(const json& document, const std::string& fileName) : file(fileName)
    {
        for (const char* array : {"/accessors", "/buffers", "/bufferViews", "/cameras", "/images", "/materials",
                                  "/meshes", "/nodes", "/samplers", "/scenes", "/skins", "/textures", kLights})
            sizes[array] = arraySize(document, array);
    }

    void checkObject(json& value, Shape shape, const std::string& path) const
    {
        if (!value.is_object())
            fail(path, "is not an object");
        for (auto member = value.begin(); member != value.end();)
            member = known(member.key(), shape) ? std::next(member) : value.erase(member);
        for (const Property& property : shape) {
            const auto member = value.find(property.name);
            const std::string place = path + "/" + property.name;
            if (member != value.end())
                checkProperty(*member, property, place);
            else if (property.required)
                fail(place, "is missing");
        }
    }

private:
    static std::size_t arraySize(const json& document, const char* pointer)
    {
        const json::json_pointer place(pointer);
        return document.contains(place) ? document.at(place).size() : 0;
    }

    static bool known(const std::string& name, Shape shape)
    {
        for (const Property& property : shape)
            if (name == property.name)
                return true;
        return false;
    }

    void checkProperty(json& value, const Property& property, const std::string& path) const
    {
        switch (property.kind) {
        case Kind::boolean:
            return value.is_boolean() ? void() : fail(path, "is neither true nor false");
        case Kind::text:
            return value.is_string() ? void() : fail(path, "is not a string");
        case Kind::integer:
            return checkInteger(value, path);
        case Kind::number:
            return checkNumber(value, path);
        case Kind::reference:
            return checkReference(value, property.target, path);
        case Kind::attributes:
            return checkAttributes(value, property.target, path);
        case Kind::object:
            return checkObject(value, property.shape, path);
        case Kind::extras:
            return value.is_object() ? checkObject(value, property.shape, path) : void(value = json::object());
        case Kind::map:
            return value.is_object() ? void() : fail(path, "is not an object");
        default:
            return checkArray(value, property, path);
        }
    }

    void checkArray(json& value, const Property& property, const std::string& path) const
    {
        if (!value.is_array())
            fail(path, "is not an array");
        if (value.size() < property.least || value.size() > property.most)
            fail(path, "has " + std::to_string(value.size()) + " elements where " + std::to_string(property.least) +
                           " are due");
        for (std::size_t i = 0; i < value.size(); ++i)
            checkElement(value[i], property, path + "/" + std::to_string(i));
    }

    void checkElement(json& value, const Property& property, const std::string& path) const
    {
        switch (property.kind) {
        case Kind::texts:
            return value.is_string() ? void() : fail(path, "is not a string");
        case Kind::numbers:
            return checkNumber(value, path);
        case Kind::references:
            return checkReference(value, property.target, path);
        case Kind::targets:
            return checkAttributes(value, property.target, path);
        default:
            return checkObject(value, property.shape, path);
        }
    }

    void checkInteger(json& value, const std::string& path) const
    {
        const double number = value.is_number() ? value.get<double>() : -1.0;
        if (!(number >= 0.0 && number < kMaxInteger && std::floor(number) == number))
            fail(path, "is not a whole number from 0 up");
        value = static_cast<std::int64_t>(number);
    }

    void checkNumber(json& value, const std::string& path) const
    {
        if (!value.is_number())
            fail(path, "is not a number");
        value = value.get<double>();
    }

    void checkReference(json& value, const char* target, const std::string& path) const
    {
        checkInteger(value, path);
        const std::size_t size = sizes.at(target);
        const auto index = value.get<std::int64_t>();
        if (static_cast<std::size_t>(index) >= size)
            fail(path,
                 "refers to " + std::string(target + 1) + "/" + std::to_string(index) + " of " + std::to_string(size));
    }

    void checkAttributes(json& value, const char* target, const std::string& path) const
    {
        if (!value.is_object())
            fail(path, "is not an object");
        for (auto& [name, index] : value.items())
            checkReference(index, target, path + "/" + name);
    }

    [[noreturn]] void fail(const std::string& path, const std::string& problem) const
    {
        throw inputError(file, path.empty() ? "the document" : path, problem, "repair or export the file again");
    }

    const std::string& file;
    std::map<std::string_view, std::size_t> sizes;
};

} // namespace

void checkSchema(json& document, const std::string& file)
{
    Checker(document, file).checkObject(document, kRoot, "");
}

} // namespace torrance
