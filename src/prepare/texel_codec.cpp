#include "prepare/texel_codec.h"

#include "prepare/texel_kinds.h"

#include <cassert>

namespace torrance {
namespace {

using namespace texels;

template <typename Kind>
const TexelCodec& codecOf()
{
    using Of = Rows<Kind>;
    static constexpr TexelCodec kCodec = {
        Kind::kStorage, 4 * sizeof(typename Kind::Code), Of::decode, Of::halve, Of::store, Of::encode};
    return kCodec;
}

template <typename Code>
void unitNormalsOf(const std::byte* codes, std::size_t count, std::byte* wide)
{
    using To = Normals<std::uint16_t, true>;
    const Normals<Code, false> from;
    for (std::size_t i = 0; i < count; ++i) {
        const Float4 normal = from.value(codesAt<Code>(codes, i));
        Float4 x = splat(normal[0]), y = splat(normal[1]), z = splat(normal[2]);
        makeUnit(x, y, z);
        const Float4 unit = {x[0], y[0], z[0], 1.0f};
        Rows<To>::encode(&unit, 1, wide + i * Rows<To>::kTexelBytes);
    }
}

template <typename Code, typename ColorStorage>
const TexelCodec& codecOf(const MipRule& rule)
{
    switch (rule.content) {
    case TexelContent::color:
        return rule.weighByAlpha ? codecOf<Colors<ColorStorage, true>>() : codecOf<Colors<ColorStorage, false>>();
    case TexelContent::normal:
        return codecOf<Normals<Code, false>>();
    case TexelContent::data:
        break;
    }
    return codecOf<Data<Code>>();
}

} // namespace

const TexelCodec& texelCodec(TexelFormat format, const MipRule& rule)
{
    assert(!rule.weighByAlpha || rule.content == TexelContent::color);
    assert(!rule.lengthInAlpha || rule.content == TexelContent::normal);
    if (rule.lengthInAlpha)
        return codecOf<Normals<std::uint16_t, true>>();
    return format == TexelFormat::rgba8 ? codecOf<std::uint8_t, Color8Storage>(rule)
                                        : codecOf<std::uint16_t, Color16Storage>(rule);
}

void unitNormals(TexelFormat format, const std::byte* codes, std::size_t count, std::byte* wide)
{
    format == TexelFormat::rgba8 ? unitNormalsOf<std::uint8_t>(codes, count, wide)
                                 : unitNormalsOf<std::uint16_t>(codes, count, wide);
}

} // namespace torrance
